"""Rules for the specification."""

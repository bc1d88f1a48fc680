"""Rules over the specification."""

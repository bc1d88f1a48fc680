"""Reads the YAML of the specification into a checked model."""

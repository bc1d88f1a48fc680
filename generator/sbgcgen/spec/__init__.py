"""Reading the specification: YAML in, a checked model out."""

"""From the YAML's words to the model: every reference, size and offset decided."""

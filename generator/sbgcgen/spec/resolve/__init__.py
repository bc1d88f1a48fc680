"""Resolves the YAML to the model, with all references, sizes and offsets."""

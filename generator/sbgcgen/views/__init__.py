"""What several targets show beyond the model."""

"""Facts derived from the model that several targets show."""

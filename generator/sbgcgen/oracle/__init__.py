"""An independent codec, and the values for examples and tests."""

"""An independent implementation of the protocol, and the values that show and test it."""

"""Compares two versions of the protocol."""

"""sbgcgen: turns the protocol written down in spec/ into code, data and documentation."""

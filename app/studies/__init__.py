"""Studies that come with the server, as data."""

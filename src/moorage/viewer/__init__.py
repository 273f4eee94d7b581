"""The viewer of results in a browser; not built yet."""

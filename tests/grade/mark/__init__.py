"""mark - from a submission's texts to its record. __main__.py of grade starts it."""

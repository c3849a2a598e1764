class KeySeer:
    """A node in Python alone."""

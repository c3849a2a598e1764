// Never compiled: only its place is checked.

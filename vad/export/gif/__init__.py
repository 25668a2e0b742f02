"""A film as GIF: `gif` writes the file, `image` one picture of it."""

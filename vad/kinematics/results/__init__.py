"""What a solved motion tells: links, points and slides in the user's units, as numbers and text."""

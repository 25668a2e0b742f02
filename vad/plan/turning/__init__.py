"""A mechanism in motion: the page of a turn, with labels that glide and numbers that keep still."""

"""A mechanism in motion: the page of a turn, its hodographs and curves, and labels that glide."""

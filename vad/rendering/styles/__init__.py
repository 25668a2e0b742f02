"""One file per style; its name is the style's name."""

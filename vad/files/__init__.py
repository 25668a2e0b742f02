"""Mechanisms from files: a text becomes a mechanism, its dyads found in the order of drawing."""

"""Mechanisms that leave the plane: axes that meet in a point, and axes that miss each other."""

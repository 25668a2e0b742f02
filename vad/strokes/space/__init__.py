"""Mechanisms in space: what a teacher draws of each, in views and in polygons."""

"""Balancing: the masses of a shaft, and the inertia forces of an engine."""

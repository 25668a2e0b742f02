"""Figures of merit: what a mechanism is worth, in numbers that hold for its whole motion."""

"""The results over a range of the input: `sweep` writes the table, `plot` the curves."""

"""How it looks: the page, the labels and the board that paints strokes."""

"""A lesson as a page: figures are SVG of the board's own marks, words are HTML in its own type.

A lesson becomes the parts of a page, and the data with which its player moves them.  Python does
the layout; the browser knows no mechanism and places nothing.  What is visible, and which panel is
large, depends on the step alone.
"""

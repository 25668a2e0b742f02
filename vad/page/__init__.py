"""A lesson as a page: figures are SVG of the board's own marks, words are HTML in its own type.

In comes a lesson, out go the parts of a page and what its player needs to move them.  Python lays
out; the browser knows no mechanism and places nothing.
"""

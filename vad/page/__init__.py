"""A lesson as a page: figures are SVG of the board's own marks, words are HTML in its own type.

In comes a lesson, out go the parts of a page and what its player needs to move them.  Python lays
out; the browser knows no mechanism and places nothing.  The opening shot is left to films: every
panel of a page has its place, on a phone it fills the window anyhow, and what shows depends on the
step alone.
"""

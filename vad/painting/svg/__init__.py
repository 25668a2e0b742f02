"""How SVG writes shapes, looks and text: the parts of the painter of `vad.painting.svg_painter`.

Classes, glyphs and texts are named by what they hold, so that two pictures on one page of a browser
never disturb each other.
"""

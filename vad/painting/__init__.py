"""Painters of a plan: pixels, SVG and PDF, and the frames of films.

A painter begins a page, is handed marks group by group with the look that a style gives them, and
ends; `vad.painting.painter.play` is the one place that puts items in their order.
"""

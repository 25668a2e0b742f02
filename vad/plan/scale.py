"""Scales: how a panel's coordinates become places on the page.

In come points and the room for them, out go the scale at which they fill it, and round numbers
for scales that are stated.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from vad.plan.geometry import Rect

SIDE_PADDING = 0.075
TOP_PADDING = 0.055
BOTTOM_PADDING = 0.060
BOTTOM_PADDING_POSITION = 0.090
TALL = 1.5  # height over width


@dataclass(frozen=True, slots=True)
class Scale:
    """From panel coordinates to the page: ``origin + factor * z``.

    A panel with a single point has no scale to state: it is ``bare``.
    """

    origin: complex
    factor: float
    bare: bool = False

    def __call__(self, z: complex) -> complex:
        """Return where on the page is the panel's point ``z``."""
        return self.origin + self.factor * z


def fill(
    points: Iterable[complex],
    drawing: Rect,
    position: bool,
    centimetre: float | None = None,
    factor: float | None = None,
) -> Scale:
    """Return the scale at which ``points`` fill the drawing less its padding, centred.

    Where the length of a ``centimetre`` is given, it stands for a round number; a ``factor`` that
    is given is kept.
    """
    inner = padded(drawing, position)
    all_points = list(points) or [0j]
    xs = [p.real for p in all_points]
    ys = [p.imag for p in all_points]
    wide, high = max(xs) - min(xs), max(ys) - min(ys)
    if not wide and not high:
        return Scale(inner.centre, 1.0, bare=True)
    if factor is None:
        factor = min(
            inner.width / wide if wide else math.inf, inner.height / high if high else math.inf
        )
        if centimetre:
            factor = centimetre / round_up(centimetre / factor)
    middle = complex(min(xs) + wide / 2, min(ys) + high / 2)
    return Scale(inner.centre - factor * middle, factor)


def padded(drawing: Rect, position: bool) -> Rect:
    """Return the drawing less its padding, which takes no more than half of a small one."""
    bottom = BOTTOM_PADDING_POSITION if position else BOTTOM_PADDING
    across = min(1.0, drawing.width / (4 * SIDE_PADDING))
    upright = min(1.0, drawing.height / (2 * (bottom + TOP_PADDING)))
    return Rect(
        drawing.left + across * SIDE_PADDING,
        drawing.bottom + upright * bottom,
        drawing.right - across * SIDE_PADDING,
        drawing.top - upright * TOP_PADDING,
    )


def is_tall(points: Iterable[complex]) -> bool:
    """Tell whether ``points`` need clearly more height than width."""
    all_points = list(points) or [0j]
    xs, ys = [p.real for p in all_points], [p.imag for p in all_points]
    return max(ys) - min(ys) > TALL * (max(xs) - min(xs))


def round_up(value: float) -> float:
    """Return the smallest 1, 2, 2.5 or 5 × 10ⁿ that is not less than ``value``.

    Examples
    --------
    >>> round_up(2.1), round_up(20.0), round_up(0.03), round_up(700.0)
    (2.5, 20.0, 0.05, 1000.0)
    """
    power = math.floor(math.log10(value))
    steps = (float(f"{step}e{power}") for step in (1, 2, 2.5, 5, 10))
    return next(step for step in steps if step >= value * (1 - 1e-9))


def scale_bar(factor: float, longest: float) -> float:
    """Return the largest 1, 2 or 5 × 10ⁿ whose bar is no longer than ``longest``.

    Examples
    --------
    >>> scale_bar(factor=1.7 / 720, longest=0.12)
    50.0
    """
    most = longest / factor * (1 + 1e-9)
    power = 10.0 ** math.floor(math.log10(most))
    for step in (5.0, 2.0):
        if step * power <= most:
            return step * power
    return power

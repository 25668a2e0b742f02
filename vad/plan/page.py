"""Layout of the page: where title, panels, equations, results and caption go.

In come the frame's size and the counts that need room, out go rectangles and baselines in
pixels (y up).  All sizes are fractions of `Page.unit`, the frame's height (less on a tall page).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vad.strokes.sheet import PanelName

MARGIN = 0.05
GUTTER = 0.045
GUTTER_TWO = 0.05
NARROWEST_COLUMN = 0.436  # three columns from W/H = 1.5 on
ROW_PITCH = 0.040
ROW_PITCH_TWO = 0.050
EQUATION_PITCH = 0.043
CAPTION_PITCH = 0.046
LONGEST_BAR = 0.12


@dataclass(frozen=True, slots=True)
class Rect:
    """A rectangle in pixels, y up."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """Right less left."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Top less bottom."""
        return self.top - self.bottom

    @property
    def centre(self) -> complex:
        """The middle."""
        return complex((self.left + self.right) / 2, (self.bottom + self.top) / 2)

    def moved(self, by: complex) -> Rect:
        """Return the rectangle shifted."""
        return Rect(
            self.left + by.real, self.bottom + by.imag, self.right + by.real, self.top + by.imag
        )

    def inside(self, by: float) -> Rect:
        """Return the rectangle less a margin."""
        return Rect(self.left + by, self.bottom + by, self.right - by, self.top - by)

    def holds(self, point: complex, slack: float = 0.0) -> bool:
        """Tell whether ``point`` lies inside, or outside by at most ``slack``."""
        return (
            self.left - slack <= point.real <= self.right + slack
            and self.bottom - slack <= point.imag <= self.top + slack
        )


@dataclass(frozen=True, slots=True)
class PanelPlace:
    """Where one panel stands: its rule and title, its drawing, its equation lines."""

    rule: float
    title: float
    drawing: Rect
    equations: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Page:
    """Where everything stands.

    Attributes
    ----------
    unit
        What sizes are fractions of: the frame's height.
    columns
        True for side-by-side panels with the results beneath, False for two by two.
    rows
        Baselines of the results rows (columns only).
    hairline
        Height of the rule above them (columns only).
    results
        The quarter that holds the results table (two by two only).
    captions
        Baselines of the caption's lines, none in a still.
    """

    width: float
    height: float
    unit: float
    columns: bool
    title: float
    panels: dict[PanelName, PanelPlace]
    rows: tuple[float, ...]
    hairline: float
    results: Rect | None
    captions: tuple[float, ...]

    @property
    def left(self) -> float:
        """The left margin's edge."""
        return MARGIN * self.unit

    @property
    def right(self) -> float:
        """The right margin's edge."""
        return self.width - MARGIN * self.unit


def unit_of(size: tuple[float, float]) -> float:
    """Return what sizes are fractions of on a page that is seen as a whole."""
    return min(float(size[1]), 0.75 * size[0])


def lay_out(
    size: tuple[float, float],
    equations: dict[PanelName, int],
    rows: int,
    caption_lines: int,
    unit: float | None = None,
) -> Page:
    """Return the page for the panels named in ``equations`` (their numbers of foot lines).

    ``unit`` is that of `unit_of`, or less where type and lines are to be small on a large page.
    """
    whole = unit_of(size)
    unit = unit or whole
    gaps = 2 * MARGIN + (len(equations) - 1) * GUTTER
    if (size[0] - gaps * whole) / len(equations) >= NARROWEST_COLUMN * whole:
        room = (size[0] - gaps * unit) / len(equations)
        return _side_by_side(size, unit, room, equations, rows, caption_lines)
    return _two_by_two(size, unit, equations, caption_lines)


def _captions(unit: float, lines: int) -> tuple[float, ...]:
    return tuple((0.036 + CAPTION_PITCH * (lines - 1 - i)) * unit for i in range(lines))


def _foot(lowest: float, lines: int, unit: float) -> tuple[float, ...]:
    return tuple(lowest + EQUATION_PITCH * unit * (lines - 1 - i) for i in range(lines))


def _drawing(left: float, right: float, title: float, foot: Sequence[float], unit: float) -> Rect:
    return Rect(left, max(foot) + 0.028 * unit, right, title - 0.015 * unit)


def _side_by_side(
    size: tuple[float, float],
    unit: float,
    room: float,
    equations: dict[PanelName, int],
    rows: int,
    caption_lines: int,
) -> Page:
    height = size[1]
    last = (0.051 if not caption_lines else 0.111 + CAPTION_PITCH * (caption_lines - 1)) * unit
    baselines = tuple(last + ROW_PITCH * unit * (rows - 1 - i) for i in range(rows))
    hairline = baselines[0] + 0.034 * unit
    rule, title = height - 0.115 * unit, height - 0.155 * unit
    panels: dict[PanelName, PanelPlace] = {}
    for index, (name, lines) in enumerate(equations.items()):
        left = MARGIN * unit + index * (room + GUTTER * unit)
        foot = _foot(hairline + 0.030 * unit, max(lines, 1), unit)
        drawing = _drawing(left, left + room, title, foot, unit)
        panels[name] = PanelPlace(rule, title, drawing, foot)
    return Page(
        *size,
        unit=unit,
        columns=True,
        title=height - 0.075 * unit,
        panels=panels,
        rows=baselines,
        hairline=hairline,
        results=None,
        captions=_captions(unit, caption_lines),
    )


def _two_by_two(
    size: tuple[float, float],
    unit: float,
    equations: dict[PanelName, int],
    caption_lines: int,
) -> Page:
    width, height = size
    room = (width - 2 * MARGIN * unit - GUTTER_TWO * unit) / 2
    floor = (0.051 if not caption_lines else 0.103 + CAPTION_PITCH * (caption_lines - 1)) * unit
    # Captions take from both rows of panels alike.
    second = height * (1 - 0.522) + (floor - 0.051 * unit) / 2
    lefts = (MARGIN * unit, MARGIN * unit + room + GUTTER_TWO * unit)
    slots = (
        (lefts[0], height - 0.115 * unit, second + 0.040 * unit),
        (lefts[1], height - 0.115 * unit, second + 0.040 * unit),
        (lefts[1], second, floor),
    )
    panels: dict[PanelName, PanelPlace] = {}
    for (name, lines), (left, rule, lowest) in zip(equations.items(), slots, strict=False):
        foot = _foot(lowest, max(lines, 1), unit)
        title = rule - 0.040 * unit
        drawing = _drawing(left, left + room, title, foot, unit)
        panels[name] = PanelPlace(rule, title, drawing, foot)
    return Page(
        width,
        height,
        unit=unit,
        columns=False,
        title=height - 0.075 * unit,
        panels=panels,
        rows=(),
        hairline=0.0,
        results=Rect(lefts[0], floor, lefts[0] + room, second),
        captions=_captions(unit, caption_lines),
    )

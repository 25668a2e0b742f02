"""The shapes of strokes as frozen data, and the small drawings beside a polygon.

Shapes are points, vectors, lines, curves and parts of machines.  Coordinates are complex numbers in
the panel's own unit, x to the right and y up.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vad.kinematics.numbers import ray


@dataclass(frozen=True, slots=True)
class Dot:
    """A point with a letter: a pole, a fixed pivot or a crossing."""

    at: complex


@dataclass(frozen=True, slots=True)
class Arrow:
    """A vector from ``start`` to ``end``; in the position panel, the bar of a link.

    ``tail`` and ``head`` are its letters.  ``cylinder`` is the length from ``start`` of the
    cylinder of a strut, out of which its rod comes; 0 for every other bar.
    """

    start: complex
    end: complex
    tail: str
    head: str
    cylinder: float = 0.0

    @property
    def foot(self) -> complex:
        """Where the rod of a strut comes out of its cylinder."""
        span = self.end - self.start
        return self.start + self.cylinder * span / abs(span) if span else self.start


@dataclass(frozen=True, slots=True)
class Line:
    """A construction line of unknown length through a known point.

    It is drawn from ``through`` past ``until``, where it will be crossed; ``direction`` is a
    unit vector that points that way.  ``square_to`` names the link that it is perpendicular
    to ("BC"), or is None for a line parallel to a guide or a slot.
    """

    through: complex
    direction: complex
    until: complex
    square_to: str | None = None


@dataclass(frozen=True, slots=True)
class Arc:
    """A circular arc: the compass about ``centre``, or the angle of the driven link.

    ``start`` and ``sweep`` are degrees, counter-clockwise positive.  ``through`` is the point that
    a compass arc finds.  It is None for the arc of an angle: ``radius`` is then the length of the
    driven link, and the radius of the arc is chosen where it is drawn.
    """

    centre: complex
    radius: float
    start: float
    sweep: float
    through: complex | None = None


@dataclass(frozen=True, slots=True)
class Guide:
    """The straight frame line through ``through``, hatched on its ``side`` away from the rod.

    ``side`` is a unit vector, and None where the line is a slot in a moving link.
    """

    through: complex
    direction: complex
    side: complex | None = None


@dataclass(frozen=True, slots=True)
class Block:
    """A sliding block at ``at``, its long side along ``direction``.

    ``on`` is the turning link that it slides on, or None on a guide of the frame or of a yoke.
    ``travel`` is how far it gets from here along its line, back (negative) and ahead, over all
    poses of the mechanism.
    """

    at: complex
    direction: complex
    on: str | None = None
    travel: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Plate:
    """A link of three points or more in the position panel: its ``corners`` with their letters."""

    corners: tuple[complex, ...]
    letters: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Curve:
    """A line through ``points``: a bent link, the axis of a shaft, a projector.

    It is dashed if it lies ``far``: behind the rest.  ``breaks`` has the numbers of those points to
    which no line is drawn from the point before.
    """

    points: tuple[complex, ...]
    far: bool = False
    breaks: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Ellipse:
    """The projection of a circle in space, or of an arc of it.

    ``first`` and ``second`` are the projections of two radii at right angles.  The arc begins at
    the angle ``start`` and turns by ``sweep``, in degrees; positive angles turn from the first
    radius towards the second.  Between the angles of ``far`` it lies behind the rest, and is
    dashed.
    """

    centre: complex
    first: complex
    second: complex
    start: float = 0.0
    sweep: float = 360.0
    far: tuple[tuple[float, float], ...] = ()

    def at(self, degrees: float) -> complex:
        """Return the point at an angle."""
        turn: complex = ray(degrees)
        return self.centre + turn.real * self.first + turn.imag * self.second

    @property
    def outermost(self) -> list[complex]:
        """Its ends, and where it turns back to the right or left, up or down."""
        low, high = sorted((self.start, self.start + self.sweep))
        x, y = (
            math.degrees(math.atan2(one, other))
            for one, other in (
                (self.second.real, self.first.real),
                (self.second.imag, self.first.imag),
            )
        )
        turns = (low + (angle - low) % 360.0 for angle in (x, x + 180.0, y, y + 180.0))
        return [self.at(angle) for angle in (low, high, *turns) if angle <= high]


@dataclass(frozen=True, slots=True)
class Bearing:
    """A bearing in the frame at ``at``, hatched on either side of a shaft along ``direction``."""

    at: complex
    direction: complex


@dataclass(frozen=True, slots=True)
class Fold:
    """A plane in space that is rotated into the paper, in the view of the mechanism.

    It turns by ``turn`` degrees about the line through ``centre`` along the unit vector ``axis``.
    ``arms`` are the places in the paper that its points have then.  ``rim``, a circle about the
    centre, shows the plane before it is rotated.
    """

    centre: complex
    axis: complex
    turn: float
    arms: tuple[complex, ...]
    rim: Ellipse


@dataclass(frozen=True, slots=True)
class KennedyCircle:
    """The bodies of a mechanism round a circle beside it, with an edge for every centre.

    Attributes
    ----------
    names
        What stands at the bodies: their numbers.
    rows
        The row of the results that each body has; empty for the frame.
    edges
        The places of two bodies, and the name of the stroke that finds their centre.  An edge is
        dashed until that stroke, and one whose stroke is not drawn is left out.
    """

    names: tuple[str, ...]
    rows: tuple[str, ...]
    edges: tuple[tuple[int, int, str], ...]


Shape = (
    Dot
    | Arrow
    | Line
    | Arc
    | Guide
    | Block
    | Plate
    | Curve
    | Ellipse
    | Bearing
    | Fold
    | KennedyCircle
)


@dataclass(frozen=True, slots=True)
class Turned:
    """The polygon of another panel, as a figure upon a mechanism shows it.

    ``panel`` is the polygon's.  The figure is turned by so many ``degrees``, counter-clockwise, and
    its lengths are multiplied by ``rate``, to become the polygon: |ω| for velocities, ω² for
    accelerations.  ``pole`` is where the polygon's pole lies upon the mechanism.
    """

    panel: str
    degrees: float
    rate: float
    pole: complex


@dataclass(frozen=True, slots=True)
class CoriolisInset:
    """The rule of the Coriolis component in true directions (unit vectors).

    ``slot`` is the direction of the turning link, ``sliding`` that of the block relative to
    it, ``coriolis`` the result; ``sense`` is +1 for a counter-clockwise ω.  It is shown from
    the stroke called ``stroke`` on.
    """

    link: str
    slide: str
    slot: complex
    sliding: complex
    coriolis: complex
    sense: int
    stroke: str


@dataclass(frozen=True, slots=True)
class PolarInset:
    """Speeds over a turn of the driver, each laid off along the driver's direction.

    ``circle`` is the radius on which ``driver`` runs, ``curve`` that of ``driven``, which begins
    with the driver at 0°; ``ray`` is the present one.  Both agree at the ``dots``.  ``title`` and
    ``range`` are written above and below.  It is shown from the stroke called ``stroke`` on.
    """

    driver: str
    driven: str
    circle: float
    curve: tuple[complex, ...]
    ray: complex
    dots: tuple[complex, ...]
    title: str
    range: str
    stroke: str


Inset = CoriolisInset | PolarInset

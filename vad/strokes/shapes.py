"""The shapes of strokes: points, vectors, lines, curves and parts of machines, as frozen data.

Coordinates are complex numbers in the panel's own unit, x to the right and y up.
"""

from __future__ import annotations

from dataclasses import dataclass


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

    ``start`` and ``sweep`` are degrees, counter-clockwise positive.  ``through`` is the point
    on a compass arc that the construction is after; None for an angle, whose radius is the
    painter's affair (``radius`` is then the length of the driven link).
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
    """A line through ``points``: a circle in space as it is seen, a bent link, a projector.

    ``far`` are the stretches that lie behind, by the numbers of their first and last points:
    they are dashed.  To the points whose numbers are in ``breaks`` the pencil is lifted over.
    """

    points: tuple[complex, ...]
    far: tuple[tuple[int, int], ...] = ()
    breaks: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Bearing:
    """A bearing in the frame at ``at``, hatched on either side of a shaft along ``direction``."""

    at: complex
    direction: complex


@dataclass(frozen=True, slots=True)
class Fold:
    """A plane in space that is laid over into the paper, in the view of the mechanism.

    It swings by ``turn`` degrees about the line through ``centre`` along the unit vector ``axis``;
    then its points ``arms`` lie in the paper, where they are stated.  ``rim`` shows the plane
    before.
    """

    centre: complex
    axis: complex
    turn: float
    arms: tuple[complex, ...]
    rim: tuple[complex, ...]


Shape = Dot | Arrow | Line | Arc | Guide | Block | Plate | Curve | Bearing | Fold

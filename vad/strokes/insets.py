"""Small drawings beside a polygon, as frozen data: a rule, and the speeds over a turn."""

from __future__ import annotations

from dataclasses import dataclass


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
    ``range`` are said above and below, and it is shown from the stroke called ``stroke`` on.
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

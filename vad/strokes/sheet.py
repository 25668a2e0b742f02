"""What a teacher draws, as frozen data: strokes, panels and the sheet that holds them.

Nothing here knows colours, times or pixels; the shapes are those of `vad.strokes.shapes`.
Coordinates are complex numbers in the panel's own unit (mm, mm/s, mm/s² …) with x to the right and
y up; the pole of a polygon is the origin.

Every stroke has a name, unique in its panel and the same in every pose: the ends of a step of the
linkage and what is drawn of it, or a point's letter and how it is found.

=========================  ====================================================================
position                   ``A.fixed``, ``C.found``; ``DC.guide``, ``CB.slot``, ``DC.block``,
                           ``AB.bar``, ``AB.angle``, ``BC.compass``, ``DQ.line``, ``BCE.plate``
velocity and acceleration  ``pole``, ``C.crossing``, ``C.image``; ``AB.normal``,
                           ``AB.tangential``, ``AB.whole``, ``QB.sliding``, ``QB.coriolis``,
                           ``BC.line``
=========================  ====================================================================

Beyond its panel a stroke is called ``velocity:BC.line``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from vad.displayed import Displayed
from vad.strokes.insets import CoriolisInset, Inset, PolarInset
from vad.strokes.notation import Notation
from vad.strokes.shapes import (
    Arc,
    Arrow,
    Bearing,
    Block,
    Curve,
    Dot,
    Ellipse,
    Fold,
    Guide,
    Line,
    Plate,
    Shape,
)

__all__ = [
    "Arc",
    "Arrow",
    "Bearing",
    "Block",
    "Cell",
    "Component",
    "CoriolisInset",
    "Curve",
    "Dot",
    "Ellipse",
    "Equation",
    "Fold",
    "Guide",
    "ImageTriangle",
    "Inset",
    "Kind",
    "Line",
    "Note",
    "Panel",
    "Picture",
    "Plate",
    "PolarInset",
    "Row",
    "Shape",
    "Sheet",
    "Stroke",
    "Term",
]

Kind = Literal[
    "fixed",  # mechanisms only: a pivot of the frame
    "guide",  # mechanisms only: the line along which a block slides, or the axis of a shaft
    "angle",  # mechanisms only: the arc of the driven link's angle; in views, of any
    "pole",
    "known",
    "construction",
    "intersection",
    "result",
]
Component = Literal["normal", "tangential", "coriolis", "sliding", "relative", "absolute", "link"]
#: Names the angle in the title that goes with the length before it.
TWIST = "∠"
#: Ends the name of a polygon that stands below another.
BELOW = ".below"
#: A mechanism in the plane, vectors from a pole, or a mechanism in space as it is seen.
Picture = Literal["skeleton", "vectors", "views"]


@dataclass(frozen=True, slots=True)
class Stroke:
    """One thing drawn, with the sentence that goes with it.

    Attributes
    ----------
    kind
        What is done: a known vector is laid, a construction line drawn, a result inked.
    label
        What is written beside it: a letter, two letters, ``⟂ BC``, ``∥ guide`` …
    shape
        Its geometry.
    caption
        What the teacher says, with symbols, numbers, result and unit.
    link
        The link or slide that it belongs to, whose ink it takes; None for the frame.
    component
        Which part of which vector a known or result stroke is.
    image
        True for the vector to a point found by the velocity or acceleration image.
    reveals
        The rows of the results table whose cell in this panel is measured by this stroke.
    name
        What it is called in its panel, in every pose: ``BC.line``.
    """

    kind: Kind
    label: str
    shape: Shape
    caption: str
    link: str | None = None
    component: Component | None = None
    image: bool = False
    reveals: tuple[str, ...] = ()
    name: str = ""


@dataclass(frozen=True, slots=True)
class Term:
    """One vector of a loop equation: ``bc``, ``ω₄₂τ̇``.

    ``stroke`` is the name of the stroke that draws it in its panel, None where none does.
    """

    label: str
    link: str | None
    stroke: str | None


@dataclass(frozen=True, slots=True)
class Equation:
    """The loop equation under a panel: the sum of ``left`` equals the sum of ``right``."""

    left: tuple[Term, ...]
    right: tuple[Term, ...]


@dataclass(frozen=True, slots=True)
class ImageTriangle:
    """The image of three ``points`` of a link, in its ink from the stroke called ``stroke`` on."""

    link: str
    points: tuple[str, ...]
    corners: tuple[complex, ...]
    stroke: str


@dataclass(frozen=True, slots=True)
class Note:
    """What is said near the point ``at``, which no stroke draws: "seen along shaft 2"."""

    at: complex
    text: str


@dataclass(frozen=True, slots=True)
class Panel:
    """One diagram of one pose: its strokes in drawing order.

    ``zeros`` holds what is not drawn in this pose, with its name, letters and place but without
    a caption: vectors of length zero, whole vectors that are no more than one of their parts,
    and, where nothing moves, the lines and crossings of the polygon.  Strokes and zeros together
    have the same names in every pose.  ``title`` is its heading, ``picture`` how it is painted,
    ``triangles`` are images of links, ``loops`` the numbers of the strokes that begin each loop.
    ``notes`` say from which sides a mechanism in space is seen, the ``remark`` stands under a
    polygon.  ``below`` is a second polygon under the first, drawn after it, in a unit of its own;
    it is called ``velocity.below``.
    """

    name: str
    unit: str
    strokes: tuple[Stroke, ...]
    equations: tuple[Equation, ...] = ()
    inset: Inset | None = None
    zeros: tuple[Stroke, ...] = ()
    title: str = ""
    picture: Picture = "vectors"
    triangles: tuple[ImageTriangle, ...] = ()
    loops: tuple[int, ...] = ()
    notes: tuple[Note, ...] = ()
    remark: str = ""
    below: Panel | None = None

    @property
    def halves(self) -> tuple[Panel, ...]:
        """The panel and what is below it, in drawing order."""
        return (self, self.below) if self.below else (self,)

    @property
    def column(self) -> str:
        """The name of the panel that it is, or that it stands below."""
        return self.name.removesuffix(BELOW)

    def measures(self, row: Row) -> tuple[tuple[Panel, tuple[Cell, ...]], ...]:
        """Return what each half measures of a row: the one below, what bears its unit."""
        cells = row.cells.get(self.name, ())
        lower = self.below.unit if self.below else None
        above = self, tuple(cell for cell in cells if cell.unit != lower)
        if self.below is None:
            return (above,)
        return above, (self.below, tuple(cell for cell in cells if cell.unit == lower))

    def full(self, name: str) -> str:
        """Return the full name of a stroke of this panel: ``velocity:BC.line``."""
        return f"{self.name}:{name}"

    def number(self, name: str) -> int:
        """Return the place of a stroke in drawing order, from 0.

        Raises
        ------
        KeyError
            If no stroke of that name is drawn.
        """
        for number, stroke in enumerate(self.strokes):
            if stroke.name == name:
                return number
        raise KeyError(name)


@dataclass(frozen=True, slots=True)
class Cell:
    """One quantity of the results table: θ₃ = 338.2°, with the value in full."""

    symbol: str
    value: float
    unit: str
    given: bool = False


@dataclass(frozen=True, slots=True)
class Row:
    """One link or slide of the results table; ``cells`` holds a panel's cells by its name.

    ``title`` and ``letters`` make its heading: "crank" and "AB", "slider" and "C".
    """

    key: str
    title: str
    letters: str
    cells: Mapping[str, tuple[Cell, ...]]


@dataclass(frozen=True, slots=True)
class Sheet(Displayed):
    """Everything that is drawn for one pose of one mechanism: pure data, in drawing order.

    ``parameters`` are (name, value, unit) in the title, where a `TWIST` joins the length before it;
    ``rows`` are the links, then the slides: their order gives inks.  ``notation`` says how numbers
    are written that are not so already.
    """

    mechanism: str
    title: str
    parameters: tuple[tuple[str, float, str], ...]
    rows: tuple[Row, ...]
    panels: tuple[Panel, ...]
    language: str = "en"
    notation: Notation = field(default_factory=Notation)

    @property
    def halves(self) -> tuple[Panel, ...]:
        """All panels, each followed by the one below it."""
        return tuple(half for panel in self.panels for half in panel.halves)

    def panel(self, name: str) -> Panel:
        """Return the panel called ``name``, which may stand below another."""
        return next(panel for panel in self.halves if panel.name == name)

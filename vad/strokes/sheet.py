"""What a teacher draws, as frozen data: strokes, panels and the sheet that holds them.

The shapes are those of `vad.strokes.shapes`.  Coordinates are complex numbers in the panel's unit
(mm, mm/s, mm/s² …) with x to the right and y up; the pole of a polygon is the origin.

Every stroke has a name, unique in its panel and alike in all poses: the ends of a step and what is
drawn of it, or a point's letter and how it is found.

=========================  ====================================================================
position                   ``A.fixed``, ``C.found``; ``DC.guide``, ``CB.slot``, ``DC.block``,
                           ``AB.bar``, ``AB.angle``, ``BC.compass``, ``DQ.line``, ``BCE.plate``
velocity and acceleration  ``pole``, ``C.crossing``, ``C.image``; ``AB.normal``, ``QB.coriolis``,
                           ``AB.tangential``, ``AB.whole``, ``QB.sliding``, ``BC.line``
=========================  ====================================================================

Beyond its panel a stroke is called ``velocity:BC.line``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from vad.displayed import Displayed
from vad.strokes.notation import Notation
from vad.strokes.sentences import Sentence
from vad.strokes.shapes import (
    Arc,
    Arrow,
    Bearing,
    Block,
    CoriolisInset,
    Curve,
    Dot,
    Ellipse,
    Fold,
    Guide,
    Inset,
    KennedyCircle,
    Line,
    Plate,
    PolarInset,
    Shape,
    Turned,
)
from vad.written import numbered

__all__ = [
    "LOADS",
    "POLE",
    "Arc",
    "Arrow",
    "Bearing",
    "Block",
    "Body",
    "Cell",
    "Coincidence",
    "Component",
    "CoriolisInset",
    "Curve",
    "Dot",
    "Driver",
    "Ellipse",
    "Equation",
    "Fold",
    "Guide",
    "ImageTriangle",
    "Inset",
    "KennedyCircle",
    "Kind",
    "Line",
    "Note",
    "Panel",
    "PictureKind",
    "Plate",
    "PolarInset",
    "Ride",
    "Row",
    "Shape",
    "Sheet",
    "Stroke",
    "StrokePart",
    "Term",
    "driver_of",
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
Component = Literal[
    "normal",
    "tangential",
    "coriolis",
    "sliding",
    "relative",
    "absolute",
    "link",  # in mechanisms
    "figure",  # what is drawn upon a mechanism, and stays
    "force",  # and what follows: in panels of forces
    "load",
    "couple",
    "action",
]
#: The name, in the title, of the angle that belongs to the length before it.
TWIST = "∠"
#: The row of the results that has all loads.
LOADS = "loads"
#: The ending of the name of a polygon that stands below another.
BELOW = ".below"
#: A mechanism in the plane, vectors from a pole, or a mechanism in space as it is seen.
PictureKind = Literal["skeleton", "vectors", "views"]
#: Why points have one place: all of them stand still, one lies under the pin of a block in every
#: pose, or the vector between them has no length in this pose.
Reason = Literal["fixed", "under", "zero"]


class StrokePart(NamedTuple):
    """Which part of what a stroke draws: the bar of step AB, the crossing at point C.

    Attributes
    ----------
    of
        The letters of the step, link or point; empty for what belongs to the whole panel.
    which
        The part: "bar", "block", "slot", "guide", "found", "line", "whole", "image" …
    """

    of: str
    which: str

    @property
    def name(self) -> str:
        """The name of the stroke: ``AB.bar``, ``pole``."""
        return f"{self.of}.{self.which}" if self.of else self.which

    @classmethod
    def named(cls, name: str) -> StrokePart:
        """Return the part that has a name.

        Examples
        --------
        >>> StrokePart.named("AB.bar"), StrokePart.named("pole").of
        (StrokePart(of='AB', which='bar'), '')
        """
        of, _, which = name.rpartition(".")
        return cls(of, which)


#: The point from which a polygon begins, or which a first crossing finds.
POLE = StrokePart("", "pole")
_UNNAMED = StrokePart("", "")


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
    said
        What the teacher says, with symbols, numbers, result and unit: a sentence as data.
    link
        The link or slide that it belongs to, whose ink it takes; None for the frame.
    component
        Which part of which vector a known or result stroke is.
    image
        True for the vector to a point found by the velocity or acceleration image.
    reveals
        The rows of the results whose cell this stroke measures; ``shaft:A`` is in another panel.
    part
        Which part of what it draws.  The stroke's name is made of it, and is the same in every
        pose.
    """

    kind: Kind
    label: str
    shape: Shape
    said: str | Sentence
    link: str | None = None
    component: Component | None = None
    image: bool = False
    reveals: tuple[str, ...] = ()
    part: StrokePart = _UNNAMED

    @property
    def name(self) -> str:
        """What it is called in its panel: ``BC.line``."""
        return self.part.name

    @property
    def caption(self) -> str:
        """What the teacher says, as a string."""
        return str(self.said)


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
    """A text near ``at``: "seen along D".  It comes with the stroke ``comes``, if that is named."""

    at: complex
    text: str
    comes: str = ""


@dataclass(frozen=True, slots=True)
class Ride:
    """A block that slides on a body.

    ``block`` is the name of the stroke that draws it, ``along`` that of the guide, slot or bar on
    which it slides, None where it has none of its own.  ``slot`` tells a slot of a moving body.
    """

    block: str
    along: str | None
    slot: bool = False


@dataclass(frozen=True, slots=True)
class Body:
    """A body of a mechanism: a link, what slides, or the frame.

    Attributes
    ----------
    row
        The row of the results that it has; None for the frame.
    points
        The letters of its points that other bodies may share.
    carries
        The blocks that slide on it.
    """

    row: str | None
    points: tuple[str, ...] = ()
    carries: tuple[Ride, ...] = ()


@dataclass(frozen=True, slots=True)
class Coincidence:
    """Points of a panel, by their letters, that have one place, and the reason."""

    letters: tuple[str, ...]
    reason: Reason


class Source(NamedTuple):
    """A mechanism, its inputs, what it bears (None without forces), and diameters of its pins."""

    mechanism: Any
    inputs: Mapping[str, float]
    burden: Any = None
    pins: Any = None


@dataclass(frozen=True, slots=True)
class Driver:
    """What drives the mechanism.

    Attributes
    ----------
    row
        The row of its link or slide.
    turns
        Whether a link is turned; otherwise something is slid.
    rate
        Its ω or its velocity as given; 0 where it rests, and where the sheet does not state it.
    stroke, angle
        The names of the strokes of the mechanism's panel that draw it, and its angle: None where
        there are none.
    """

    row: str = ""
    turns: bool = True
    rate: float = 0.0
    stroke: str | None = None
    angle: str | None = None

    @property
    def omega(self) -> float:
        """The given ω of a link, 0 for what slides."""
        return self.rate if self.turns else 0.0

    @property
    def speed(self) -> float:
        """The given velocity of what slides, 0 for a link."""
        return 0.0 if self.turns else self.rate


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
    it is called ``velocity.below``.  ``bodies`` are those of a mechanism, ``coincident`` the points
    that have one place.  So many strokes as ``given`` says, the first, are there when the panel is
    begun.  From the one that ``resumes`` names on, strokes are told after the accelerations, if
    there are any.  ``turned`` are the polygons that it holds upon its mechanism.
    """

    name: str
    unit: str
    strokes: tuple[Stroke, ...]
    equations: tuple[Equation, ...] = ()
    inset: Inset | None = None
    zeros: tuple[Stroke, ...] = ()
    title: str = ""
    picture: PictureKind = "vectors"
    triangles: tuple[ImageTriangle, ...] = ()
    loops: tuple[int, ...] = ()
    notes: tuple[Note, ...] = ()
    remark: str = ""
    below: Panel | None = None
    bodies: tuple[Body, ...] = ()
    coincident: tuple[Coincidence, ...] = ()
    given: int = 0
    turned: tuple[Turned, ...] = ()
    resumes: str = ""

    @property
    def halves(self) -> tuple[Panel, ...]:
        """The panel and what is below it, in drawing order."""
        return (self, self.below) if self.below else (self,)

    @property
    def column(self) -> str:
        """The name of the panel that it is, or that it stands below."""
        return self.name.removesuffix(BELOW)

    def measures(self, row: Row) -> tuple[tuple[Panel, tuple[Cell, ...]], ...]:
        """Return what each half measures of a row."""
        cells = row.cells.get(self.name, ())
        if self.below is None:
            return ((self, cells),)
        above, below = (tuple(c for c in cells if c.below is lower) for lower in (False, True))
        return (self, above), (self.below, below)

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

    def find(self, name: str | None) -> int | None:
        """Return the place of a stroke in drawing order; None where it is not drawn."""
        numbers = (number for number, stroke in enumerate(self.strokes) if stroke.name == name)
        return next(numbers, None)

    def body(self, row: str | None) -> Body:
        """Return the body of a row of the results, or the frame; one without points if none is."""
        return next((body for body in self.bodies if body.row == row), Body(row))


@dataclass(frozen=True, slots=True)
class Cell:
    """One quantity of the results table: θ₃ = 338.2°, with the value in full.

    The ``symbol`` is a letter and an index: the number of a body (ω₃) or a point (ψ_P).  What is
    ``below`` is measured in the polygon below the first.
    """

    symbol: str
    value: float
    unit: str
    given: bool = False
    below: bool = False

    @property
    def quantity(self) -> str:
        """The symbol without its index: ω, ψ."""
        return numbered(self.symbol)[0].partition("_")[0]

    @property
    def body(self) -> str:
        """The number of the body in its symbol: 3; empty where there is none."""
        return numbered(self.symbol)[1]


@dataclass(frozen=True, slots=True)
class Row:
    """One link or slide of the results table; ``cells`` holds a panel's cells by its name.

    ``title`` and ``letters`` make its heading; not ``inked`` is one of which nothing is drawn.
    """

    key: str
    title: str
    letters: str
    cells: Mapping[str, tuple[Cell, ...]]
    inked: bool = True


@dataclass(frozen=True, slots=True, repr=False)
class Sheet(Displayed):
    """Everything that is drawn for one pose, in drawing order.

    ``parameters`` are (name, value, unit) in the title, where a `TWIST` joins the length before it;
    ``rows`` are the links, then the slides: their order decides their colours.  ``notation`` says
    how numbers are written, ``names`` are a file's; ``output`` is the letter of the point whose
    motion matters, if there is one; no ``source`` from JSON.
    """

    mechanism: str
    title: str
    parameters: tuple[tuple[str, float, str], ...]
    rows: tuple[Row, ...]
    panels: tuple[Panel, ...]
    language: str = "en"
    notation: Notation = field(default_factory=Notation)
    names: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    driver: Driver = Driver()
    source: Source | None = field(default=None, compare=False)
    subtitle: str = ""
    output: str = ""

    def __repr__(self) -> str:
        """Return a line: what is drawn, and in how many strokes."""
        panels = ", ".join(f"{half.name} {len(half.strokes)}" for half in self.halves)
        return f"<Sheet of {self.mechanism}: strokes {panels}>"

    @property
    def halves(self) -> tuple[Panel, ...]:
        """All panels, each followed by the one below it."""
        return tuple(half for panel in self.panels for half in panel.halves)

    def panel(self, name: str) -> Panel:
        """Return the panel called ``name``, which may stand below another."""
        return next(panel for panel in self.halves if panel.name == name)


def driver_of(key: str, turns: bool, rows: Sequence[Row], panels: Sequence[Panel]) -> Driver:
    """Return the driver of a row, with its strokes, and its rate where there are velocities."""
    cells = (c for row in rows if row.key == key for c in row.cells.get("velocity", ()) if c.given)
    own = [s for p in panels if p.picture != "vectors" for s in p.strokes if s.link == key]
    return Driver(
        key,
        turns,
        next((cell.value for cell in cells), 0.0),
        next((stroke.name for stroke in own if stroke.component == "link"), None),
        next((stroke.name for stroke in own if stroke.kind == "angle"), None),
    )

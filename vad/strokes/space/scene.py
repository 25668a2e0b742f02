"""One pose of a mechanism in space, and the pens with which a script draws it.

A mechanism in space names the module that draws it.  Its class `Script` has the rows of the table,
and draws the views and the polygons.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property, partial
from importlib import import_module
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from vad.errors import UsageError
from vad.kinematics.linkage import Scalar
from vad.kinematics.numbers import ray, traced
from vad.kinematics.space.instant_axis import Z
from vad.kinematics.space.numbers import Vector3
from vad.strokes.arithmetic import Calculation, Figure
from vad.strokes.diagram import POSITION, Drawing, Order, Spot
from vad.strokes.sentences import CaptionedMotion, Sentence, Text, Unit
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Cell,
    Component,
    Curve,
    Equation,
    Kind,
    Note,
    Row,
    Shape,
    Stroke,
    StrokePart,
    Term,
)
from vad.strokes.space.view import circle
from vad.words import gaps
from vad.written import subscript

if TYPE_CHECKING:
    from vad.kinematics.motion import MotionInSpace
    from vad.strokes.diagram import Diagram


@dataclass(frozen=True)
class SceneInSpace(CaptionedMotion):
    """A motion in space, and the language of its captions; its script draws it."""

    motion: MotionInSpace[Any, Any]
    #: Those in the plane alone are found.
    forces: ClassVar[None] = None

    @cached_property
    def script(self) -> Script:
        """The script that draws its mechanism.

        Raises
        ------
        vad.errors.UsageError
            If the mechanism names no script.
        """
        mechanism: Any = self.motion.mechanism
        if not hasattr(mechanism, "script"):
            raise UsageError(f"{mechanism.name}: it can be solved, but names no script to draw it")
        script: type[Script] = import_module(mechanism.script).Script
        return script(self)

    @property
    def unit(self) -> str:
        """The unit of lengths."""
        return self.motion.mechanism.length_unit

    @property
    def driver(self) -> Scalar:
        """The scalar that drives the mechanism."""
        return self.motion.solver.driver

    @property
    def output(self) -> str:
        """The row of the output of the mechanism: the last one."""
        return [*self.script.rows][-1]

    def drawing(self, order: Order) -> Drawing:
        """Return the views, or the polygon of an order."""
        if order.number:
            return self.script.polygon(order)
        self.script.begin()
        return self.script.views()

    def unit_of(self, order: Order) -> str:
        """Return the unit of the coordinates in its diagram."""
        return self.script.unit(order)

    def cells(self, order: Order, key: str, slides: bool = False) -> tuple[Cell, ...]:
        """Return what the diagram of an order adds to a row of the results."""
        return self.script.cells(order, key)

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points of a diagram are."""
        return self.script.tracks(order)

    def rows(self, diagrams: Sequence[Diagram]) -> list[Row]:
        """Return the rows of the results."""
        titles = self.script.titles
        return [
            Row(
                key,
                self.name(titles.get(key, key)),
                letters,
                {diagram.name: diagram.cells(self, key, False) for diagram in diagrams},
            )
            for key, letters in self.script.rows.items()
        ]


#: The kinds of strokes that views have.
KINDS: tuple[Kind, ...] = (
    "fixed",
    "guide",
    "known",
    "construction",
    "intersection",
    "result",
    "angle",
)


class Script(ABC):
    """The drawings of a mechanism in space; each has a subclass in a module of its own.

    Attributes
    ----------
    topic
        The first word of the keys of its phrases.
    rows
        The letters of every row of the results, by its key; the last row is the output.
    titles
        The titles of rows whose title is not their key.
    numbers
        The numbers of the bodies whose rotation a row shows: 2, or 32 for 3 relative to 2.
    sphere
        Whether it lies on a sphere of radius 1: then its views have no unit.
    sizes
        The parameters of the mechanism.
    """

    topic: ClassVar[str]
    rows: ClassVar[Mapping[str, str]]
    titles: ClassVar[Mapping[str, str]] = {}
    numbers: ClassVar[Mapping[str, int]]
    sphere: ClassVar[bool] = False

    def __init__(self, scene: SceneInSpace) -> None:
        self.scene, self.motion = scene, scene.motion
        self.sizes = scene.motion.mechanism.parameters()
        self.begin()

    @abstractmethod
    def views(self) -> Drawing:
        """Return the construction of the position, in its views."""

    @abstractmethod
    def polygon(self, order: Order) -> Drawing:
        """Return the polygon of velocities or accelerations."""

    @abstractmethod
    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points are, of one pose or of many."""

    def unit(self, order: Order) -> str:
        """Return the unit of the views (order 0) or of a polygon."""
        return order.unit if order.number else "" if self.sphere else self.scene.unit

    def cells(self, order: Order, key: str) -> tuple[Cell, ...]:
        """Return the cells of a row: the angle or the rate of its link or joint.

        The angle of a joint has the letter of the joint: θ_B.
        """
        joints = self.motion.solver.joints
        part: Any = self.motion.joint(key) if key in joints else self.motion.link(key)
        cell = self.cell(order, key, getattr(part, order.rate))
        if order is POSITION and key in joints:
            cell = replace(cell, symbol=f"{order.symbol}_{key}")
        return (cell,)

    def cell(self, order: Order, key: str, value: Any) -> Cell:
        """Return a cell with an angle, ω or α, by the number of the body: θ₂."""
        symbol = order.symbol + subscript(self.numbers[key])
        return Cell(symbol, value, order.unit, key == self.scene.driver.name)

    @property
    def driven(self) -> Figure:
        """The angle of the driver."""
        return Figure(self.motion.link(self.scene.driver.name).angle, "°", given=True)

    def place(self, letter: str, order: Order = POSITION) -> Vector3:
        """Return a point's place, velocity or acceleration, as three numbers or arrays."""
        return self._parts(getattr(self.motion.point(letter), order.panel))

    def axis(self, letter: str) -> Vector3:
        """Return the unit vector along the axis at a joint, or along the instant axis I."""
        solver: Any = self.motion.solver
        fixed: dict[str, Vector3] = {"A": Z, "D": solver.d}
        if letter in fixed:
            return fixed[letter]
        return self._parts(self.motion.read(("axis", letter, "position")))

    def _parts(self, vector: Any) -> Vector3:
        x, y, z = np.moveaxis(vector, -1, 0) if self.motion.many else vector.tolist()
        return x, y, z

    def spots(self) -> dict[str, complex]:
        """Return where lettered points are in the views of one pose, as ``C`` or ``C.top``."""
        return {
            f"{letter}.{view}" if view else letter: at
            for (letter, view, *_), at in self.tracks(POSITION).items()
        }

    @property
    def settled(self) -> Any:
        """The mechanism with ordinary dimensions: where views stand is chosen for these alone."""
        mechanism, own = self.motion.mechanism, self.sizes
        if not traced(own.values()):
            return mechanism
        return mechanism.with_dimensions({name: float(value) for name, value in own.items()})

    @property
    def growth(self) -> float:
        """How many times as long its lengths are as those for which the views stand."""
        settled = self.settled
        if settled is self.motion.mechanism:
            return 1.0
        quantities = {each.name: each.metadata["quantity"] for each in fields(settled)}
        lengths = [abs(x) for name, x in self.sizes.items() if quantities[name] == "length"]
        return sum(lengths) / sum(map(float, lengths))

    def begin(self) -> None:
        """Begin the views without any stroke."""
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []
        self._told: str | Sentence = ""

    # --- the pen ------------------------------------------------------------------------------

    def tell(self, phrase: str, *calculations: Calculation, **parts: Any) -> None:
        """Say a phrase of all strokes from here to the next one: they are one step of a lecture."""
        key = f"{self.topic} {phrase}"
        given = {"unit": Unit(self.scene.unit), **parts}
        told = {part: value for part, value in given.items() if part in gaps(key)}
        self._told = self.scene.say(key, *calculations, **told)

    def draw(
        self,
        kind: Kind,
        name: str,
        shape: Shape,
        link: str | None = None,
        label: str = "",
        body: bool = False,
        reveals: tuple[str, ...] = (),
    ) -> None:
        """Draw a stroke, a ``body`` as thick as a link."""
        component: Component | None = "link" if body else None
        part = StrokePart.named(name)
        self.strokes.append(
            Stroke(kind, label, shape, self._told, link, component, reveals=reveals, part=part)
        )

    @property
    def pens(self) -> tuple[Callable[..., None], ...]:
        """The functions that draw each of `KINDS`, with the arguments of `draw` from its name on.

        A pen for bodies is last: it draws a result as thick as a link.
        """
        plain = (partial(self.draw, kind) for kind in KINDS)
        return *plain, partial(self.draw, "result", body=True)

    def rose(
        self,
        names: Sequence[str],
        at: complex,
        sizes: tuple[float, float, float],
        angle: Figure,
        link: str,
        label: str = "",
    ) -> None:
        """Draw an angle in true size beside a view: rim, line of reference, arm and arc.

        ``sizes`` are the radius of the rim, the length of the reference and the radius of the arc.
        Without the name of a rim, none is drawn.  With a label of its own the angle is a result.
        """
        (rim, reference, arm, arc), (radius, length, inner) = names, sizes
        end = at + ray(angle.value) * radius
        kinds: tuple[Kind, Kind] = ("construction", "result") if label else ("known", "known")
        reveals = (link,) if label else ()
        if rim:
            self.draw(kinds[0], rim, circle(at, radius), link)
        self.draw("guide", reference, Curve((at, at + length)))
        self.draw(kinds[1], arm, Arrow(at, end, "", ""), link, body=True, reveals=reveals)
        self.arc(arc, at, inner, angle, link, label)

    def arc(
        self,
        name: str,
        at: complex,
        radius: float,
        angle: Figure,
        link: str,
        label: str = "",
        start: float = 0.0,
        reveals: tuple[str, ...] = (),
    ) -> None:
        """Draw the arc of an angle about a point, with its value or a symbol beside it."""
        shape, label = Arc(at, radius, start, angle.value), label or self.degrees(angle)
        self.draw("angle", name, shape, link, label, reveals=reveals)

    def shaft(
        self,
        name: str,
        ends: tuple[complex, complex],
        bearing: complex,
        way: complex,
        link: str,
        label: str = "",
    ) -> None:
        """Draw a shaft between two ends, and its bearing at a place and in a direction."""
        self.draw("known", f"{name}.shaft", Curve(ends), link, label, body=True)
        self.draw("fixed", f"{name}.bearing", Bearing(bearing, way))

    def note(self, at: complex, phrase: str, comes: str, **parts: Any) -> Note:
        """Return a note beside a view, which comes with its first stroke."""
        return Note(at, self.scene.write(f"{self.topic} {phrase}", **parts), comes)

    def leave_out(self) -> None:
        """Record the last stroke as one that is not drawn in this pose."""
        self.zeros.append(replace(self.strokes.pop(), said="", reveals=()))

    def finished(
        self, left: tuple[str | Term, ...], right: tuple[str | Term, ...], *notes: Note
    ) -> Drawing:
        """Return all strokes with the equation below them and the notes beside the views.

        Its terms are the names of strokes; letters alone stand for a vector that is not drawn.
        """
        strokes, zeros = tuple(self.strokes), tuple(self.zeros)
        equation = Equation(*(tuple(self._terms(side)) for side in (left, right)))
        return Drawing(strokes, zeros, (equation,), picture="views", notes=notes)

    def _terms(self, names: tuple[str | Term, ...]) -> Iterator[Term]:
        drawn = {stroke.name: stroke for stroke in self.strokes}
        for name in names:
            if isinstance(name, Term):
                yield name
            elif "." not in name:
                yield Term(name, None, None)
            elif stroke := drawn.get(name):
                yield Term(stroke.label or stroke.part.of, stroke.link, name)

    # --- numbers ------------------------------------------------------------------------------

    def given(self, name: str) -> Figure:
        """Return a parameter that is an angle."""
        return Figure(self.sizes[name], "°", given=True)

    def length(self, name: str) -> Figure:
        """Return a parameter that is a length."""
        return Figure(self.sizes[name], self.scene.unit, given=True)

    def angle(self, of: str | float) -> Figure:
        """Return an angle that is found: of a link or joint, or in degrees."""
        if isinstance(of, str):
            joints = self.motion.solver.joints
            part: Any = self.motion.joint(of) if of in joints else self.motion.link(of)
            return Figure(part.angle, "°")
        return Figure(of, "°")

    def degrees(self, angle: Figure) -> Text:
        """Write an angle beside its arc."""
        return self.scene.write("degrees", angle=angle)

"""One pose of a mechanism in space as the board sees it, and the pen with which a script draws it.

A mechanism in space names the module that draws it.  Its class `Script` says what stands in the
table, and draws the views and the polygons.
"""

from __future__ import annotations

import cmath
import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from vad.kinematics.linkage import Scalar
from vad.kinematics.space.instant_axis import Z
from vad.kinematics.space.numbers import Vector3
from vad.strokes.arithmetic import Calculation, Figure
from vad.strokes.diagram import POSITION, Drawing, Order, Spot
from vad.strokes.sentences import Saying, SentencePart, Text, Unit
from vad.strokes.sheet import (
    Arc,
    Arrow,
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
class SceneInSpace(Saying):
    """A motion in space, and the language of its captions; its script draws it."""

    motion: MotionInSpace[Any, Any]

    @cached_property
    def script(self) -> Script:
        """What draws its mechanism."""
        mechanism: Any = self.motion.mechanism
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
        """The row of what the mechanism is there for: the last one."""
        return [*self.script.rows][-1]

    def drawing(self, order: Order) -> Drawing:
        """Return the views, or the polygon of an order."""
        return self.script.polygon(order) if order.number else self.script.views()

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


class Script(ABC):
    """What is drawn of a mechanism in space; a subclass for each, in a module of its own.

    Attributes
    ----------
    topic
        What the phrases of its mechanism begin with.
    rows
        The letters of every row of the results, by its key; the last is what the mechanism is there
        for.
    titles
        What rows are called, where they are not called by their keys.
    numbers
        The numbers of the bodies whose turning a row shows: 2, or 32 for 3 against 2.
    numbered
        Whether its angles bear these numbers, too.
    sphere
        Whether it lies on a sphere of radius 1: then its views have no unit.
    sizes
        The parameters of the mechanism.
    """

    topic: ClassVar[str]
    rows: ClassVar[Mapping[str, str]]
    titles: ClassVar[Mapping[str, str]] = {}
    numbers: ClassVar[Mapping[str, int]]
    numbered: ClassVar[bool] = True
    sphere: ClassVar[bool] = False

    def __init__(self, scene: SceneInSpace) -> None:
        self.scene, self.motion = scene, scene.motion
        self.sizes = scene.motion.mechanism.parameters()
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []

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
        """Return what a row measures: how its link or joint turns."""
        joints = self.motion.solver.joints
        part: Any = self.motion.joint(key) if key in joints else self.motion.link(key)
        return (self.cell(order, key, getattr(part, order.rate)),)

    def cell(self, order: Order, key: str, value: Any) -> Cell:
        """Return a cell with an angle, ω or α."""
        number = subscript(self.numbers[key]) if order.number or self.numbered else ""
        return Cell(order.symbol + number, value, order.unit, key == self.scene.driver.name)

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
            f"{letter}.{view}" if view else letter: complex(at)
            for (letter, view, _), at in self.tracks(POSITION).items()
        }

    # --- the pen ------------------------------------------------------------------------------

    def draw(
        self,
        name: str,
        kind: Kind,
        shape: Shape,
        phrase: str,
        link: str | None = None,
        label: str = "",
        body: bool = False,
        reveals: tuple[str, ...] = (),
        calculations: tuple[Calculation, ...] = (),
        **parts: SentencePart,
    ) -> None:
        """Draw a stroke, a ``body`` as thick as links are; ``parts`` fill in its phrase."""
        key = f"{self.topic} {phrase}"
        if "unit" in gaps(key):
            parts["unit"] = Unit(self.scene.unit)
        said = self.scene.say(key, *calculations, **parts)
        component: Component | None = "link" if body else None
        part = StrokePart.named(name)
        self.strokes.append(
            Stroke(kind, label, shape, said, link, component, reveals=reveals, part=part)
        )

    def rose(
        self,
        names: Sequence[str],
        phrases: Sequence[str],
        at: complex,
        sizes: tuple[float, float, float],
        kinds: tuple[Kind, Kind],
        degrees: float,
        link: str,
        label: str,
        reveals: tuple[str, ...] = (),
        **parts: Any,
    ) -> None:
        """Draw an angle in true size beside a view: rim, line of reference, arm and arc.

        ``sizes`` are the radius of the rim, the length of the reference and the radius of the arc;
        ``kinds`` are those of the rim and of the arm.
        """
        rim, reference, arm, arc = names
        radius, length, inner = sizes
        end = at + radius * cmath.exp(1j * math.radians(degrees))
        self.draw(rim, kinds[0], circle(at, radius), phrases[0], link, **parts)
        self.draw(reference, "guide", Curve((at, at + length)), phrases[1])
        shape = Arrow(at, end, "", "")
        self.draw(arm, kinds[1], shape, phrases[2], link, body=True, reveals=reveals, **parts)
        self.draw(arc, "angle", Arc(at, inner, 0.0, degrees), phrases[3], link, label, **parts)

    def leave_out(self) -> None:
        """Keep the last stroke among those that are not drawn in this pose."""
        self.zeros.append(replace(self.strokes.pop(), said="", reveals=()))

    def finished(
        self, left: tuple[str | Term, ...], right: tuple[str | Term, ...], *notes: Note
    ) -> Drawing:
        """Return all strokes with the equation below them and the notes beside the views.

        Its terms are named by their strokes; letters alone are a vector that is not drawn.
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

    def angle(self, value: float) -> Figure:
        """Return an angle that is found."""
        return Figure(float(value), "°")

    def degrees(self, angle: Figure) -> Text:
        """Write an angle beside its arc."""
        return self.scene.write("degrees", angle=angle)

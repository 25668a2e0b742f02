"""One pose of a mechanism in the plane, in the user's letters and units."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vad.kinematics.linkage import (
    Bar,
    Scalar,
    Slide,
    angle_of,
    length_of,
)
from vad.kinematics.numbers import minimum
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import ORDERS, Spot
from vad.strokes.members import Members, members_of
from vad.strokes.pin_rows import pin_rows
from vad.strokes.sentences import CaptionedMotion, Noun
from vad.strokes.sheet import LOADS, Cell, Row
from vad.written import PRIME, base_name, per_second

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.kinematics.state import Pose, Rates
    from vad.merits.pins import Rubbing
    from vad.statics.forces import Forces
    from vad.strokes.diagram import Diagram, Drawing, Order
    from vad.strokes.force_names import ForceNames


#: A point lies in line with two others if the sine of the angle between them is below this.
IN_LINE = 1e-9
#: A link whose rate is below this share of the fastest link's rate does not turn: it translates.
STILL = 1e-9


@dataclass(frozen=True)
class Scene(CaptionedMotion, ABC):
    """A motion, the language of its captions, and the names of everything in it.

    Attributes
    ----------
    forces
        The forces in it, where there are any.
    poles
        The poles of the force polygons by the numbers of their dyads, where they are the same over
        a whole turn; empty where each polygon stands beside the last one.
    largest
        The largest force on the driven body over a whole turn, by which its arrows are measured; 0
        where it is that of the pose.
    superpose
        Whether forces are drawn load by load, and then their sums.
    centrode
        The body whose centrodes are drawn, as `vad.strokes.centrodes.pair_of` reads it; None where
        none are.
    pins
        The diameters of pins by their points, whose velocities of rubbing stand in the table.
    """

    motion: Motion
    forces: Forces[Any, Any, Any] | None = field(default=None, kw_only=True)
    poles: Mapping[int, complex] = field(default_factory=dict, kw_only=True)
    largest: float = field(default=0.0, kw_only=True)
    superpose: bool = field(default=False, kw_only=True)
    centrode: str | None = field(default=None, kw_only=True)
    pins: Mapping[str, Any] = field(default_factory=dict, kw_only=True)
    # The places and images that were read before.
    _places: dict[str, complex] = field(default_factory=dict, init=False, compare=False)
    _images: dict[tuple[str, int], complex] = field(default_factory=dict, init=False, compare=False)

    @cached_property
    def members(self) -> Members:
        """The links, slides and points of the mechanism."""
        return members_of(self.motion.mechanism)

    @cached_property
    def force_names(self) -> ForceNames:
        """The forces of the pose with their names.

        Raises
        ------
        vad.errors.InputError
            If there is nothing that makes forces.
        """
        from vad.strokes.force_names import ForceNames  # most drawings have none

        return ForceNames(self)

    @cached_property
    def force_parts(self) -> list[tuple[str, ForceNames]]:
        """The forces of each load alone by its name, where several loads are superposed."""
        from vad.strokes.force_names import ForceNames  # most drawings have none

        if not self.superpose or self.forces is None:
            return []
        found = self.forces.superposed()
        parts = enumerate(found.items(), start=1)
        named = [(name, ForceNames(self, part, number)) for number, (name, part) in parts]
        return named if len(named) > 1 else []

    @cached_property
    def rubs(self) -> list[Rubbing]:
        """How fast the pins rub whose diameters are given."""
        from vad.merits.pins import rubbing  # most drawings have none

        return rubbing(self.motion, self.pins)

    @property
    def unit(self) -> str:
        """The unit of lengths."""
        return self.members.unit

    @abstractmethod
    def drawing(self, order: Order) -> Drawing:
        """Return the construction of the mechanism, or a polygon."""

    def unit_of(self, order: Order) -> str:
        """Return the unit of positions, velocities or accelerations."""
        return order.unit_of(self.unit)

    def cells(self, order: Order, key: str, slides: bool) -> tuple[Cell, ...]:
        """Return what is measured of a link or a slide; of a slide its Coriolis part, too."""
        if not slides:
            symbol, given = self.members.symbol(order.symbol, key), angle_of(key) == self.driver
            return (Cell(symbol, getattr(self.motion.link(key), order.rate), order.unit, given),)
        slide, unit = self.motion.slide(key), self.unit_of(order)
        members = self.members
        symbol = members.rate_symbol(key, order) if order.number else members.slide_symbol(key)
        cell = Cell(symbol, getattr(slide, order.panel), unit, length_of(key) == self.driver)
        if order.number < 2 or slide.coriolis is None:
            return (cell,)
        return cell, Cell("2ωv", slide.coriolis, unit)

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the points of the mechanism are, or their images in a polygon."""
        motion = self.motion
        return {
            Spot(image_letter(point, order.number)): getattr(motion.point(point), order.panel)
            for point in motion.points
        }

    def rows(self, diagrams: Sequence[Diagram]) -> list[Row]:
        """Return the rows of the results: the links, then the slides."""
        mechanism, say = self.motion.mechanism, self.name
        rows = []
        cells: dict[str, tuple[Cell, ...]]
        for name in self.members.links:
            cells = {diagram.name: diagram.cells(self, name, False) for diagram in diagrams}
            rows.append(Row(name, say(name), mechanism.links[name], cells))
        for name in self.members.slides:
            cells = {diagram.name: diagram.cells(self, name, True) for diagram in diagrams}
            strut = mechanism.links.get(name)  # a strut: its slide has its letters
            title = say("length" if strut else base_name(name))
            rows.append(Row(name, title, strut or mechanism.slides[name], cells, not strut))
        of_loads = [each for each in diagrams if each.name in ("position", "force", "drive")]
        if self.forces is not None and of_loads:
            cells = dict.fromkeys([each.name for each in diagrams], ())
            for each in of_loads:
                if each.name != "position":
                    cells[each.name] = each.cells(self, LOADS, False)
            rows.append(Row(LOADS, say(LOADS), "", cells))
        return rows + pin_rows(self, diagrams)

    @property
    def output(self) -> str:
        """The row of the output of the mechanism.

        That is the last slide on a guide of the frame, else the last link that turns.
        """
        import numpy as np  # a list of mechanisms does not need it

        motion, driver = self.motion, self.driver.name
        guided = {slide.name for slide in self.members.guides}
        slides = [name for name in motion.slides if name in guided and name != driver]
        rates = {name: np.nanmax(np.abs(motion.link(name).omega)) for name in motion.links}
        turning = [name for name, rate in rates.items() if rate > STILL * max(rates.values())]
        links = [name for name in turning if name != driver]
        return (slides or links or [driver])[-1]

    def outward(self, vector: complex) -> complex:
        """Turn a vector of the solver into the user's frame and unit."""
        frame = self.members.frame
        turned: complex = vector * frame.turn * frame.scale
        return turned

    def heading(self, direction: complex) -> complex:
        """Turn a unit vector of the solver into the user's frame."""
        turned: complex = direction * self.members.frame.turn
        return turned

    def at(self, point: str) -> complex:
        """Return where a point is, in the user's frame and unit."""
        if point not in self._places:
            self._places[point] = self.motion.read(("point", point, "position"))
        return self._places[point]

    def image(self, point: str, order: int) -> complex:
        """Return the velocity (1) or acceleration (2) of a point, in the user's frame and unit."""
        place = point, order
        if place not in self._images:
            rate = self.motion.plane.routes.rate(point, self.pose, self.orders(order))
            self._images[place] = self.outward(rate)
        return self._images[place]

    def measured(self, value: float, unit: str, power: int = 1) -> Figure:
        """Return a measure of the shape of a link: one with few digits counts as given."""
        given = abs(value - float(f"{value:.6g}")) <= 1e-12 * abs(value)
        return Figure(value, unit, given, power)

    def span(self, point: str, other: str) -> float:
        """Return the distance of two points."""
        return abs(self.at(other) - self.at(point))

    def size(self, bar: Bar) -> float:
        """Return the length of a bar in the user's unit, without its sign."""
        frame = self.members.frame
        size: float = abs(frame.size(bar, self.pose)) * frame.scale
        return size

    def in_line(self, link: str, point: str) -> bool:
        """Tell whether a point of a link lies in line with the two that its loop finds."""
        base = self.members.base(link)
        one, other, third = map(self.at, (base.tail, base.head, point))
        across = ((other - one).conjugate() * (third - one)).imag
        return abs(across) <= IN_LINE * abs(other - one) * abs(third - one)

    def backward(self, bar: Bar) -> bool:
        """Tell whether a bar, whose length is a slide's position, points against its link."""
        return isinstance(bar.length, str) and self.motion.slide(bar.length).position < 0.0

    def against(self, bar: Bar) -> bool:
        """Tell whether a bar points against the base of its link."""
        base = self.members.base(bar.link)
        known, own = (self.at(each.head) - self.at(each.tail) for each in (base, bar))
        return (own * known.conjugate()).real < 0.0

    def travel(self, name: str) -> tuple[float, float]:
        """Return how far a slide gets from where it is, back (negative) and ahead."""
        slide = self.motion.slide(name)
        least, most = (end - slide.position for end in slide.travel)
        return min(0.0, least), max(0.0, most)  # the 0.0 first: NaN is ignored

    def cylinder(self, bar: Bar) -> float:
        """Return the length of a strut's cylinder, with room for its rod; 0 for other links."""
        if bar.length != bar.link:
            return 0.0
        _, longest = self.motion.slide(str(bar.length)).travel
        length: float = minimum(0.9 * self.size(bar), longest / 2)  # a NaN travel is ignored
        return length

    @property
    def driver(self) -> Scalar:
        """The scalar that drives the mechanism."""
        return self.members.driver

    def figure(self, scalar: Scalar, value: float, unit: str = "", power: int = 1) -> Figure:
        """Return the value of a scalar or of its rate; the numbers of the driver count as given."""
        return Figure(value, unit, scalar == self.driver, power)

    def spin(self, link: str, order: int, power: int = 1) -> Figure:
        """Return ω (1) or α (2) of a link, without its sign."""
        rate, unit = abs(self.rate(link, order)), ORDERS[order].unit
        return self.figure(angle_of(link), rate, unit, power)

    def length(self, bar: Bar, scale: str = "", power: int = 1) -> Figure:
        """Return the length of a bar, a given one unless a slide that is found determines it.

        ``scale`` is the unit of the rate that is calculated from it: it is written in metres if
        that is.
        """
        given = isinstance(bar.length, float) or length_of(bar.length) == self.driver
        return Figure(self.size(bar), self.unit, given, power, scale)

    @cached_property
    def pose(self) -> Pose:
        """The position of everything, in the solver's unit and frame."""
        return self.motion.pose

    @cached_property
    def _velocity(self) -> Rates:
        return self.motion.velocity

    @cached_property
    def _acceleration(self) -> Rates:
        return self.motion.acceleration

    def orders(self, order: int) -> tuple[Rates, ...]:
        """Return the rates up to an order, solved for no further than that."""
        return (self._velocity,) if order == 1 else (self._velocity, self._acceleration)

    def rate(self, name: str, order: int) -> float:
        """Return ω or α of a link."""
        rate: float = self.orders(order)[-1].turning[name]
        return rate

    def speed(self, name: str, order: int) -> float:
        """Return the velocity or acceleration of a slide in the user's unit."""
        rate: float = self.orders(order)[-1].sliding[name] * self.members.frame.scale
        return rate

    def line(self, slide: Slide) -> Noun:
        """Name the line of a slide."""
        return self.members.line(slide)

    def rate_unit(self, order: int) -> str:
        """Return the unit of a velocity (1) or acceleration (2)."""
        return per_second(self.unit, order)


def image_letter(letter: str, order: int) -> str:
    """Return the letter of a point's image: b in the velocity polygon, b′ in the next."""
    return letter.lower() + PRIME * (order - 1) if order else letter


def point_of(image: str) -> str:
    """Return the point whose image a vertex is: B of b′."""
    return image.rstrip(PRIME).upper()

"""Instantaneous centres upon the mechanism, with the circle of its bodies.

The pins are known, and so is where the centres of slides lie.  Of every other centre that is
wanted, two lines are drawn, by the theorem of Kennedy, and it lies where they cross.  What lies far
beyond the mechanism would shrink it to a dot: there the lines end, and an arrow says how far away
the centre is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.bodies import FRAME
from vad.kinematics.centres import Centres
from vad.kinematics.kennedy import Found, Pair
from vad.kinematics.numbers import ray
from vad.strokes.arithmetic import Calculation, Figure, product
from vad.strokes.body_names import BodyNames
from vad.strokes.centrodes import Centrodes, pair_of
from vad.strokes.diagram import POSITION, VELOCITY, Drawing, Spot
from vad.strokes.figure import FigurePencil
from vad.strokes.sentences import Listed, Sentence, SentencePart, Unit
from vad.strokes.sheet import Arrow, Cell, Curve, Dot, KennedyCircle, Line, Stroke, StrokePart
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.strokes.scene import Scene

#: A centre is shown that is no farther from the mechanism than this share of its size; the arrow to
#: one that is ends at the other share.  With more than four bodies centres are many, and nearer.
REACH, REACH_OF_MANY = (0.9, 0.45), (0.35, 0.25)
#: The centre of centrodes is shown within this share of the mechanism's size, in all its poses; its
#: curves go on as far as the page has room.
ROLLING, ROLLED = 0.4, 3.0
#: The length of the arrow to a centre beyond that.
ARROW = 0.16
#: Of a mechanism with more bodies than so many only the centre of driver and output is sought.
MANY = 6
#: Where a centre is followed over a turn, no place is farther than this times the largest length.
FARTHEST = 1e3
#: The most pins that a caption names.
PINS = 5


def centres_drawing(scene: Any) -> Drawing:
    """Return the instantaneous centres of a pose."""
    return _Drawn(scene).drawing()


def centres_cells(scene: Any, key: str, slides: bool) -> tuple[Cell, ...]:
    """Return the rate that follows from centres, in the row of a link or of a slide."""
    drawn = _Drawn(scene)
    rate = drawn.rates.get((key, slides))
    if rate is not None:
        return (Cell(rate.symbol, rate.value, rate.unit, rate.given),)
    return ()


def centres_tracks(scene: Any) -> Mapping[Spot, Any]:
    """Return where the points of the mechanism are, and the centres that are drawn.

    A centre that is far away is put at the end of what may lie on the way there.
    """
    drawn = _Drawn(scene)
    spots: dict[Spot, Any] = dict(scene.tracks(POSITION))
    rolling = drawn.rolls and drawn.kennedy.pair(*drawn.rolls)
    for found in drawn.sought:
        if not drawn.kennedy.alike(*found.pair):
            numbered = found.pair == rolling and FRAME in found.pair
            path: Any = "numbered" if numbered else "none"
            letter, arrow = drawn.names.centre(found.pair), drawn.stroke(found.pair)
            row = drawn.names.row(found.pair[1])
            spot = Spot(letter, row=row, path=path, arrow=arrow)
            spots[spot] = drawn.kept(drawn.at(found.pair))
    return spots


@dataclass(frozen=True)
class _Rate:
    """A rate that follows from centres: of a link that turns, or of a slide of the frame."""

    body: str
    symbol: str
    value: float
    unit: str
    given: bool = False


class _Drawn:
    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.centres: Centres[Any, Any, Any] = Centres(scene.motion)
        self.kennedy = self.centres.kennedy
        self.names = BodyNames(scene, self.kennedy.bodies.bodies)
        self.driver = self.kennedy.bodies.driver.name
        #: The barrel of a driven cylinder: the other rates follow from its ω.
        self.barrel = (
            self.scene.driver.name if self.driver in self.kennedy.bodies.rods.values() else ""
        )
        self.first = self.barrel or self.driver

    @cached_property
    def rolls(self) -> Pair | None:
        """The body that rolls and that on which it rolls, where centrodes are drawn."""
        words = self.scene.centrode
        return pair_of(self.scene.motion, words) if words is not None else None

    @cached_property
    def centrodes(self) -> Centrodes | None:
        """The curves on which the body rolls."""
        return Centrodes(self.scene.motion, self.rolls) if self.rolls else None

    # --- which centres ------------------------------------------------------------------------

    @cached_property
    def output(self) -> str:
        """The body of the output of the mechanism."""
        row = self.scene.output
        if row in self.kennedy.bodies.rods and row not in self.scene.members.links:
            return self.kennedy.bodies.rods[row]
        return row if row in self.kennedy.names else self.kennedy.names[-1]

    @cached_property
    def sought(self) -> list[Found]:
        """The centres that are drawn, each after those by which it is found.

        With centrodes it is the centre that runs on them.
        """
        kennedy = self.kennedy
        wanted = [] if self.first == self.output else [kennedy.pair(self.first, self.output)]
        if self.barrel:
            wanted.append(kennedy.pair(FRAME, self.driver))
        if self.rolls:
            wanted = [kennedy.pair(*self.rolls)]
        elif len(kennedy.names) <= MANY:
            wanted += [pair for pair in kennedy.found if FRAME in pair and not kennedy.alike(*pair)]
        needed: set[Pair] = set()
        # Each round takes a centre away, and adds those by which it is found, each once.
        while wanted:
            pair = wanted.pop()
            if pair in needed or pair not in kennedy.found:
                continue
            needed.add(pair)
            wanted += [self.kennedy.pair(over, b) for over in self.over(pair) for b in pair]
        return [found for pair, found in kennedy.found.items() if pair in needed]

    def over(self, pair: Pair) -> tuple[str, ...]:
        """Return the bodies over which the lines to a centre are drawn: two, or one if it is far.

        They are the same in all poses in which their lines cross.
        """
        over = self.kennedy.found[pair].over
        return over[:1] if self.kennedy.alike(*pair) else over[:2]

    def at(self, pair: Pair) -> complex | None:
        """Return the place of a centre; None if it is far away."""
        found: complex | None = self.centres.at(*pair)
        return found

    def kept(self, places: Any) -> Any:
        """Return places of many poses, none of them farther than so many times the size."""
        size = self.scene.motion.plane.scale
        far = ~(np.abs(places) < FARTHEST * size)
        return np.where(far, FARTHEST * size * (1 + 1j), places)

    def way(self, pair: Pair) -> complex:
        """Return the direction in which a centre lies far away."""
        return complex(ray(self.centres.far(*pair)))

    # --- where they are drawn -----------------------------------------------------------------

    def box(self, beyond: float) -> tuple[complex, complex]:
        """Return the lower left and the upper right corner of a frame about the mechanism."""
        low, high = self.extent
        by = beyond * max(high.real - low.real, high.imag - low.imag) * (1 + 1j)
        return low - by, high + by

    @cached_property
    def extent(self) -> tuple[complex, complex]:
        """The corners of the mechanism: with centrodes, of all its poses."""
        if self.centrodes:
            return self.centrodes.extent
        places = [complex(self.scene.at(point)) for point in self.scene.members.points]
        xs, ys = [z.real for z in places], [z.imag for z in places]
        return complex(min(xs), min(ys)), complex(max(xs), max(ys))

    def near(self, z: complex | None) -> bool:
        """Tell whether a place is shown."""
        return z is not None and self._holds(z, ROLLING if self.rolls else self.reach[0])

    @cached_property
    def reach(self) -> tuple[float, float]:
        """How far a centre may be that is shown, and the end of the arrow to one that is not."""
        return REACH_OF_MANY if len(self.kennedy.names) > 4 else REACH

    def _holds(self, z: complex, beyond: float) -> bool:
        low, high = self.box(beyond)
        return bool(low.real <= z.real <= high.real and low.imag <= z.imag <= high.imag)

    def edge(self, start: complex, way: complex) -> complex:
        """Return where a ray from a place that is shown ends with an arrow."""
        shown, ended = self.reach
        low, high = self.box(ended if self._holds(start, ended) else shown + ended)
        if self.rolls:
            low, high = self.box(ROLLING)
        steps = []
        for ahead, least, most, here in (
            (way.real, low.real, high.real, start.real),
            (way.imag, low.imag, high.imag, start.imag),
        ):
            if abs(ahead) > NOTHING:
                steps.append(((most if ahead > 0.0 else least) - here) / ahead)
        return start + max(0.0, min(steps)) * way

    # --- the strokes --------------------------------------------------------------------------

    def drawing(self) -> Drawing:
        self.pencil = FigurePencil(self.scene)
        if not self.rolls:  # one centre alone is no matter of all bodies
            self._bodies()
        self._known()
        for found in self.sought:
            self._find(found)
        for rate in self.rates.values():
            if not rate.given:
                self._measure(rate)
        self._roll()
        return self.pencil.drawing()

    def _bodies(self) -> None:
        """Draw the circle of bodies."""
        names = sorted(self.kennedy.names, key=self.names.numbers.__getitem__)
        count = len(names)
        places = {name: number for number, name in enumerate(names)}
        edges = []
        for pair in (*self.kennedy.pins, *self.kennedy.slides, *(f.pair for f in self.sought)):
            one, other = sorted(places[name] for name in pair)
            edges.append((one, other, self.stroke(pair)))
        rows = tuple("" if name == FRAME else self.names.row(name) for name in names)
        shape = KennedyCircle(
            tuple(str(self.names.numbers[name]) for name in names), rows, tuple(edges)
        )
        said = self.scene.say(
            "centre bodies",
            count=Figure(count, given=True),
            all=Figure(count * (count - 1) // 2, given=True),
        )
        self.pencil.add("bodies", "circle", "guide", "", shape, said)

    def stroke(self, pair: Pair) -> str:
        """Return the name of the stroke with which a centre is known."""
        if pair in self.kennedy.pins:
            return "pins.known"
        return (
            f"{self.names.plain_centre(pair)}.{'known' if pair in self.kennedy.slides else 'found'}"
        )

    def _known(self) -> None:
        """Say which centres are known: the pins, and those of slides, which lie far away."""
        pins = self.kennedy.pins
        named: list[SentencePart] = [
            self.scene.say("centre in", letter=self.names.centre(pair), point=point)
            for pair, point in pins.items()
        ]
        said = self.scene.say("centre pins", centres=Listed(tuple(named), ", "))
        if len(pins) > PINS:
            said = self.scene.say("centre all pins")
        self.pencil.add("pins", "known", "pole", "", Curve(()), said)
        for pair, slide in self.kennedy.slides.items():
            said = self.scene.say(
                "centre slide", letter=self.names.centre(pair), line=self.scene.line(slide)
            )
            row = self.names.row(next(name for name in reversed(pair) if name != FRAME))
            self.pencil.add(
                self.names.plain_centre(pair), "known", "pole", "", Curve(()), said, row
            )

    def _find(self, found: Found) -> None:
        """Draw the lines on which a centre lies, and mark it or say how far away it is."""
        pair, letter = found.pair, self.names.centre(found.pair)
        row = self.names.row(pair[1])
        drawn = [
            line
            for number, over in enumerate(self.over(pair))
            if (line := self._line(found, over, ("first", "second")[number], row))
        ]
        at, of = self.at(pair), self.names.plain_centre(pair)
        if self.near(at):
            assert at is not None
            said = self.scene.say("centre found", letter=letter)
            self.pencil.add(of, "found", "intersection", letter, Dot(at), said, row)
            return
        origin, way, name = drawn[-1] if drawn else (sum(self.box(0.0)) / 2, self.way(pair), "")
        end = self.edge(origin, way)
        arrow = Arrow(end - ARROW * self.pencil.size * way, end, "", "")
        label: Any = self.scene.write("centre far label", letter=letter)
        said = self.scene.say(
            "centre alike" if self.kennedy.alike(*pair) else "centre far", letter=letter
        )
        if at is not None:
            size = Figure(abs(at - origin), self.scene.unit)
            parts: dict[str, SentencePart] = {"size": size, "unit": Unit(self.scene.unit)}
            parts |= {"letter": letter, "other": name}
            label = self.scene.write("centre away label", **parts)
            said = self.scene.say("centre away", **parts)
        self.pencil.add(of, "found", "intersection", label, arrow, said, row)

    def _line(
        self, found: Found, over: str, which: str, row: str
    ) -> tuple[complex, complex, str] | None:
        """Draw the line over a third body.

        Return a centre on it that is shown, the direction to the centre that is sought from there,
        and the name of the first.  None for the line at infinity, which is not drawn.
        """
        pair, of = found.pair, self.names.plain_centre(found.pair)
        known = [self.kennedy.pair(over, name) for name in pair]
        letters = [self.names.centre(each) for each in known]
        points = [self.kennedy.pins.get(each, self.names.centre(each)) for each in known]
        places = [self.at(each) for each in known]
        target = self.at(pair)
        finite = [(z, each) for z, each in zip(places, points, strict=True) if z is not None]
        shown = [(z, each) for z, each in finite if self.near(z)]
        if not finite:
            shape = Line(0j, 1.0 + 0j, 0j)
            part = StrokePart(of, which)
            self.pencil.zeros.append(
                Stroke("construction", "", shape, "", row, "figure", part=part)
            )
            return None
        origin, name = (shown or finite)[0]
        assert origin is not None
        way = self._along(places, known)
        if target is not None and abs(target - origin) > NOTHING * self.pencil.size:
            ahead = target - origin
            way = way if (ahead * way.conjugate()).real >= 0.0 else -way
        # From the centre that is farthest behind to the one that is farthest ahead.
        steps = [0.0]
        for z in (*places, target):
            if z is not None and self.near(z):
                steps.append(float(((z - origin) * way.conjugate()).real))
        until = origin + max(steps) * way
        if not self.near(target) and self.near(origin):
            until = self.edge(origin, way) - ARROW * self.pencil.size * way
        through = origin + min(steps) * way
        far = [each for each, z in zip(letters, places, strict=True) if z is None]
        phrase = "centre line far" if far else "centre line"
        near = [each for each, z in zip(letters, places, strict=True) if z is not None]
        ends = (near[0], far[0]) if far else tuple(letters)
        said = self.scene.say(phrase, letter=self.names.centre(pair), one=ends[0], other=ends[1])
        if abs(until - through) <= NOTHING * self.pencil.size:
            until = self.edge(origin, way)
        self.pencil.line(of, which, through, until, way, said, row)
        return (origin, way, name) if self.near(origin) else None

    def _along(self, places: list[complex | None], known: list[Pair]) -> complex:
        """Return the direction of the line through two centres."""
        one, other = places
        if one is None or other is None:
            return self.way(known[0] if one is None else known[1])
        across = other - one
        size = abs(across)
        return across / size if size else 1.0 + 0j

    def _roll(self) -> None:
        """Draw the curves on which a body rolls."""
        if not self.rolls or not self.centrodes:
            return
        body, other = self.rolls
        pair = self.kennedy.pair(body, other)
        fixed, moving = self.centrodes.curves(*self.box(ROLLED))
        letter: Any = self.names.centre(pair)
        under = "centrode fixed" if other == FRAME else "centrode under"
        said = self.scene.say(under, letter=letter, link=self.names.noun(other))
        of, row = self.names.plain_centre(pair), None if other == FRAME else self.names.row(other)
        self.pencil.add(of, "fixed", "construction", "", fixed, said, row)
        said = self.scene.say("centrode moving", letter=letter, link=self.names.noun(body))
        self.pencil.add(of, "moving", "construction", "", moving, said, self.names.row(body))

    # --- what follows from them ---------------------------------------------------------------

    @cached_property
    def rates(self) -> dict[tuple[str, bool], _Rate]:
        """The rates that follow from the centres that are drawn, by row and whether of a slide."""
        scene, members = self.scene, self.scene.members
        turns = scene.driver.kind == "angle"
        given = scene.motion.inputs["omega" if turns else "velocity"]
        found: dict[tuple[str, bool], _Rate] = {}
        name = scene.driver.name
        symbol = members.symbol("ω", name) if turns else members.rate_symbol(name, VELOCITY)
        unit = "rad/s" if turns else scene.rate_unit(1)
        found[name, not turns] = _Rate(self.driver, symbol, given, unit, True)
        for link in members.links:
            if link in self.kennedy.names and self._knows(link):
                value = scene.motion.link(link).omega
                found.setdefault(
                    (link, False), _Rate(link, members.symbol("ω", link), value, "rad/s")
                )
        for slide in members.guides:
            body = self.kennedy.bodies.rods.get(slide.name, slide.name)
            if body in self.kennedy.names and self._knows(body):
                value = scene.motion.slide(slide.name).velocity
                symbol = members.rate_symbol(slide.name, VELOCITY)
                found.setdefault((slide.name, True), _Rate(body, symbol, value, scene.rate_unit(1)))
        return found

    def _knows(self, body: str) -> bool:
        """Tell whether the centres of a body with the frame and with the driver are drawn."""
        pairs = [self.kennedy.pair(body, other) for other in (FRAME, self.first) if body != other]
        sought = {found.pair for found in self.sought}
        known = {*self.kennedy.pins, *self.kennedy.slides, *sought}
        return all(pair in known for pair in pairs)

    def _measure(self, rate: _Rate) -> None:
        """Ink the distances of the centres that give a rate, and calculate it."""
        body, driver = rate.body, self.first
        if body == self.barrel:  # its ω follows from the speed of the rod
            driver = self.driver
        own, its, both = (
            self.kennedy.pair(*pair) for pair in ((FRAME, body), (FRAME, driver), (driver, body))
        )
        places = [self.at(pair) for pair in (own, its, both)]
        key = next(key for key, each in self.rates.items() if each is rate)
        shown = [z for z in places if z is not None and self.near(z)]
        ends = tuple(sorted(shown, key=lambda z: (float(z.real), float(z.imag))))
        shape = Curve((ends[0], ends[-1])) if len(ends) > 1 else Curve(())
        said = self._calculated(rate, own, its, both, places)
        row = self.names.row(body)
        self.pencil.add(
            self.names.plain_centre(both), "rate", "known", "", shape, said, row, (key[0],)
        )

    def _calculated(
        self,
        rate: _Rate,
        own: Pair,
        its: Pair,
        both: Pair,
        places: list[complex | None],
    ) -> Sentence:
        """Return the sentence that calculates a rate of a body from that of the driver."""
        scene = self.scene
        start, pivot, common = places
        driven = next(each for each in self.rates.values() if each.given)
        if self.barrel and rate.body != self.barrel:
            driven = next(each for each in self.rates.values() if each.body == self.barrel)
        unit = rate.unit
        linear = scene.rate_unit(1)
        parts: dict[str, SentencePart] = {
            "symbol": rate.symbol,
            "omega": driven.symbol,
            "link": self.names.noun(rate.body),
            "letter": self.names.centre(own),
            "both": self.names.centre(both),
            "rate": Figure(abs(driven.value), driven.unit, driven.given),
            "value": Figure(abs(rate.value), unit),
            "unit": Unit(unit),
            "sense": scene.say("counter-clockwise" if rate.value > 0 else "clockwise"),
            "first": self.names.centre(its) + self.names.centre(both),
            "second": self.names.centre(own) + self.names.centre(both),
        }
        calculations: list[Calculation] = []

        def arm(name: str, one: complex, power: int = 1) -> None:
            assert common is not None
            length = abs(common - one)
            scale = linear if linear in (unit, driven.unit) else ""
            parts[name] = Figure(length, scene.unit, power=power, scale=scale)

        if rate.unit == "rad/s" and start is None:
            phrase = "centre still"
        elif rate.body == self.barrel and start is not None and pivot is not None:
            parts["other"] = Figure(abs(start - pivot), scene.unit, power=-1, scale=linear)
            parts["second"] = self.names.centre(own) + self.names.centre(its)
            phrase = "centre cylinder"
            calculations.append(product("value", "rate", "other"))
        elif common is None:
            phrase = "centre same"
        elif start is not None and pivot is not None:
            arm("one", pivot)
            arm("other", start, -1)
            phrase = "centre ratio"
            calculations.append(product("value", "rate", "one", "other"))
        elif pivot is not None:
            arm("one", pivot)
            phrase = "centre speed"
            calculations.append(product("value", "rate", "one"))
        elif start is not None:
            arm("other", start, -1)
            phrase = "centre turning"
            calculations.append(product("value", "rate", "other"))
        else:
            phrase = "centre same"
        return scene.say(phrase, *calculations, **parts)

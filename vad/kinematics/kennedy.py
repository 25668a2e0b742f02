"""Instantaneous centres of two bodies by the theorem of Aronhold and Kennedy.

The centre of two bodies is the point at which both have the same velocity.  Three bodies have three
centres, and these lie on one line.  So a pin is known, the centre of a slide lies far away, square
to the slide, and every other centre is where two such lines cross.

A point far away is a point like any other: places are homogeneous coordinates (x, y, w) of the
point (x/w, y/w), and w is zero far away.  The formulas go for floats and for recorded numbers.

Sources: S. H. Aronhold (1872); A. B. W. Kennedy, The Mechanics of Machinery (1886); R. S. Khurmi
and J. K. Gupta, Theory of Machines, ch. 6.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations

from vad.kinematics.any_solver import Evaluation
from vad.kinematics.bodies import FRAME, Bodies, bodies_of
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.linkage import Slide
from vad.kinematics.numbers import Number, across, select, sqrt, times
from vad.kinematics.solver import Solver

#: Two bodies, by their names, in the order of `Kennedy.names`.
Pair = tuple[str, str]
#: A point or a line in homogeneous coordinates.
Homogeneous = tuple[Number, Number, Number]

#: Two lines of which this share is left do not cross at a place: they coincide.
COINCIDE = 1e-12
#: The most lines of which the best two are chosen.
MOST_LINES = 3
#: Lines that are drawn cross at least as well as this; those that coincide but for rounding do not
#: reach the other share.
WELL, CROSS = 1e-3, 1e-9
#: In so many poses it is seen which lines cross, at these shares of a turn or of the way.
TRIALS = 4
SHARES = [(0.137 + 0.618034 * number) % 1.0 for number in range(24)]
#: The line at infinity, on which the centre of two bodies lies that turn alike.
FAR_LINE: Homogeneous = (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Found:
    """A centre that two lines find.

    Attributes
    ----------
    pair
        Its two bodies.
    over
        The third bodies of the lines on which it lies, the best ones for drawing first: that of
        ``b`` leads through the centres of b and each of the two.  Where both bodies turn alike, the
        centre is far away, and one line is enough.
    """

    pair: Pair
    over: tuple[str, ...]


class Kennedy:
    """The centres of a linkage: which are known, and the order in which lines find the others.

    Parameters
    ----------
    bodies
        The bodies of the linkage.

    Attributes
    ----------
    names
        All bodies, the frame first.
    pins
        The point at which two bodies are pinned.
    slides
        The slide by which two bodies touch.
    found
        All other centres, each after those by which it is found.
    unknown
        The pairs of which no centre can be found so.
    """

    def __init__(self, bodies: Bodies) -> None:
        self.bodies = bodies
        self.names = (FRAME, *bodies.bodies)
        self._order = {name: number for number, name in enumerate(self.names)}
        self._named: dict[str, Pair] = {}
        self.pins: dict[Pair, str] = {}
        self.slides: dict[Pair, Slide] = {}
        self._find_joints()
        self.found: dict[Pair, Found] = {}
        self._find_others()
        self.unknown = [pair for pair in combinations(self.names, 2) if not self.knows(*pair)]

    def pair(self, one: str, other: str) -> Pair:
        """Return two bodies in the order of their names."""
        return (one, other) if self._order[one] < self._order[other] else (other, one)

    def knows(self, one: str, other: str) -> bool:
        """Tell whether a centre is known, or found by now."""
        pair = self.pair(one, other)
        return pair in self.pins or pair in self.slides or pair in self.found

    def alike(self, one: str, other: str) -> bool:
        """Tell whether two bodies turn alike in every pose, so that their centre is far away."""
        links = [self.bodies.bodies[n].link if n != FRAME else None for n in (one, other)]
        return links[0] == links[1]

    def always_far(self, one: str, other: str) -> bool:
        """Tell whether the centre of two bodies is far away in every pose, as in a parallelogram.

        It is seen from a few poses.
        """
        if self.alike(one, other):
            return True
        pair = self.pair(one, other)
        return all(abs(float(self.centre(pair, each)[2])) < COINCIDE for each in self._trials)

    def _find_joints(self) -> None:
        pinned: dict[str, set[str]] = {}
        for joint in self.bodies.joints:
            if joint.slide:
                self.slides.setdefault(self.pair(joint.one, joint.other), joint.slide)
            else:
                pinned.setdefault(joint.point, set()).update((joint.one, joint.other))
        for point, names in pinned.items():
            for one, other in combinations(sorted(names, key=self._order.__getitem__), 2):
                self.pins.setdefault((one, other), point)

    def _find_others(self) -> None:
        """Find the order, in rounds: what is found last is not used in its own round.

        Lines may coincide in all poses of a mechanism, as in a rhombus.  So its centres are found
        in a few poses first, to see which lines cross.
        """
        depth = dict.fromkeys((*self.pins, *self.slides), 0)
        for step in range(1, len(self.names)):  # each round finds one centre more at least
            new: dict[Pair, Found] = {}
            for pair in (each for each in combinations(self.names, 2) if not self.knows(*each)):
                ways = [name for name in self.names if self._leads(pair, name, depth)]
                ways.sort(key=lambda name: self._cost(pair, name, depth))
                chosen = self._chosen(pair, ways)
                if chosen:
                    new[pair] = Found(pair, chosen)
            self.found.update(new)
            depth.update(dict.fromkeys(new, step))
            if not new:
                return

    def _leads(self, pair: Pair, over: str, depth: Mapping[Pair, int]) -> bool:
        """Tell whether the centres of a third body with each of two others are known."""
        return over not in pair and all(self.pair(over, name) in depth for name in pair)

    def _cost(self, pair: Pair, over: str, depth: Mapping[Pair, int]) -> int:
        return sum(depth[self.pair(over, name)] for name in pair)

    def _chosen(self, pair: Pair, ways: Sequence[str]) -> tuple[str, ...]:
        """Return the bodies over which lines find a centre; none if these do not cross."""
        lines = {over: [self.line(pair, over, trial) for trial in self._trials] for over in ways}
        far = [(FAR_LINE, 1.0)] * len(self._trials)
        if self.alike(*pair):
            sure = {over: _surely(far, lines[over]) for over in ways}
            return tuple(over for over in ways if sure[over] > CROSS)[:MOST_LINES]
        couples = list(combinations(ways, 2))
        shares = [_surely(lines[one], lines[other]) for one, other in couples]
        good = [couple for couple, share in zip(couples, shares, strict=True) if share > WELL]
        if not good and max(shares, default=0.0) > CROSS:
            good = [couples[shares.index(max(shares))]]
        if not good:
            return ()
        rest = [over for couple in good[1:] for over in couple]
        return tuple(dict.fromkeys([*good[0], *rest]))[:MOST_LINES]

    @cached_property
    def _trials(self) -> list[Evaluation]:
        """A few poses that close, of no special kind."""
        plane, found = self.bodies.solver, list[Evaluation]()
        places = [360.0 * share for share in SHARES]
        if plane.driver.kind == "length":
            ends = [float(limit) for limit in plane.limits()] or [-plane.scale, plane.scale]
            low, high = min(ends), max(ends)
            places = [low + share * (high - low) for share in SHARES]
        for place in places:
            evaluation = plane.evaluation((place, 0.0, 0.0))
            try:
                evaluation.pose  # noqa: B018  # raises where the links do not close
            except OpenLoopError:
                continue
            found.append(evaluation)
            if len(found) == TRIALS:
                break
        return found

    def name(self, pair: Pair) -> str:
        """Return the name that the centre of two bodies has as a result of the solver."""
        return f"{pair[0]} {pair[1]}"

    def named(self, name: str, evaluation: Evaluation) -> Homogeneous:
        """Return the centre of such a name."""
        if not self._named:
            self._named = {self.name(pair): pair for pair in combinations(self.names, 2)}
        return self.centre(self._named[name], evaluation)

    def centre(self, pair: Pair, evaluation: Evaluation) -> Homogeneous:
        """Return a centre, of which x² + y² + w² is 1; NaN where its lines coincide.

        x and y are seen from the pivot of the linkage, in the unit of the solver and along the axes
        of the user.
        """
        kept: dict[Pair, Homogeneous] = evaluation.kept
        if pair not in kept:
            kept[pair] = self._centre(pair, evaluation)
        return kept[pair]

    def _centre(self, pair: Pair, evaluation: Evaluation) -> Homogeneous:
        plane = evaluation.solver.plane
        if pair in self.pins:
            at = plane.evaluate(("point", self.pins[pair], "position"), evaluation)
            seen = (at - plane.linkage.place) * (1.0 / plane.scale)
            return _unit((seen.real, seen.imag, 1.0))[0]
        if pair in self.slides:
            line = plane.frame.line(self.slides[pair], evaluation.pose)
            turn = plane.frame.turn
            square = across(line if turn == 1 else times(line, turn))
            return (square.real, square.imag, 0.0)
        if pair not in self.found:
            return (math.nan, math.nan, math.nan)
        lines = [self.line(pair, over, evaluation) for over in self.found[pair].over[:MOST_LINES]]
        if self.alike(*pair):
            lines = [(FAR_LINE, 1.0), *lines]
        best, worth = _crossing(*lines[0], *lines[1])
        for one, other in list(combinations(lines, 2))[1:]:
            found, share = _crossing(*one, *other)
            better = share > worth
            best = tuple(select(better, new, old) for new, old in zip(found, best, strict=True))
            worth = select(better, share, worth)
        x, y, w = (select(worth < COINCIDE, math.nan, part) for part in best)
        return x, y, w

    def line(self, pair: Pair, over: str, evaluation: Evaluation) -> tuple[Homogeneous, Number]:
        """Return the line on which a centre lies with two others, and how far these are apart.

        Of the line a² + b² + c² is 1; the distance is 0 where it is undetermined, 1 at most.
        """
        one, other = (self.centre(self.pair(over, name), evaluation) for name in pair)
        return _unit(_cross(one, other))


def _surely(
    one: Sequence[tuple[Homogeneous, Number]], other: Sequence[tuple[Homogeneous, Number]]
) -> float:
    """Return how well two lines cross, from 0 to 1: in the second worst of some poses."""
    shares = [_crossing(*a, *b)[1] for a, b in zip(one, other, strict=True)]
    return float(sorted(shares)[min(1, len(shares) - 1)]) if shares else 0.0


def _crossing(
    one: Homogeneous, sure: Number, other: Homogeneous, certain: Number
) -> tuple[Homogeneous, Number]:
    """Return where two lines cross, and how well that is determined, from 0 to 1."""
    point, share = _unit(_cross(one, other))
    return point, share * sure * certain


def _cross(a: Homogeneous, b: Homogeneous) -> Homogeneous:
    """Return the line through two points, or the point on two lines."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def _unit(a: Homogeneous) -> tuple[Homogeneous, Number]:
    """Return homogeneous coordinates of length 1, and the length that they had; 0 gives NaN."""
    size = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])
    least = select(size == 0.0, 1.0, size)
    return (a[0] / least, a[1] / least, a[2] / least), size


@lru_cache(maxsize=64)
def kennedy_of(plane: Solver) -> Kennedy:
    """Return the centres of a linkage; their order is found once."""
    return Kennedy(bodies_of(plane))

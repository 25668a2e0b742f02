"""Which of two places each dyad takes: words such as "upper" become signs.

The signs are found once, with the numbers of the file.  They are kept for all values that the
parameters take later, so that no value makes a dyad jump to its other place.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from vad.errors import InputError
from vad.files.description import Description, Values
from vad.files.linkage import fixed_points, linkage_of
from vad.files.places import PARALLEL, SAME, Place, ahead, words_for
from vad.files.structure import Dyad
from vad.kinematics.any_solver import Evaluation
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.numbers import bearing
from vad.kinematics.solver import Solver


@dataclass(frozen=True)
class Assembly:
    """How the dyads are assembled.

    Attributes
    ----------
    sides
        The sign of each dyad that has two places, by its point.
    words
        The place that it takes, in a word, by its point.
    places
        Where its point is, and its other place, with the numbers of the file.
    parallel
        The points of parallelograms that stay parallelograms.
    """

    sides: Mapping[str, float]
    words: Mapping[str, str]
    places: Mapping[str, tuple[complex, complex]]
    parallel: frozenset[str]


class UnplacedError(InputError):
    """A point that cannot take its place."""

    def __init__(self, point: str, message: str, hint: str | None = None) -> None:
        super().__init__(message, hint)
        self.point = point


def assemble(
    description: Description, dyads: Sequence[Dyad], values: Values, wanted: Mapping[str, Place]
) -> Assembly:
    """Find the sides of all dyads.

    Parameters
    ----------
    description, dyads
        The mechanism and its dyads.
    values
        The numbers of the file.
    wanted
        The place that a point takes: a word, or coordinates near it.  A point that is left out is
        where the pose of the file has it, or else on the positive side.

    Raises
    ------
    UnplacedError
        For a point that cannot be reached, or whose place is not told apart by its word.
    """
    return _Assembling(description, dyads, values).assembly(wanted)


class _Assembling:
    """The dyads with the numbers of the file, assembled one by one."""

    def __init__(self, description: Description, dyads: Sequence[Dyad], values: Values) -> None:
        self.description = description
        self.dyads = dyads
        self.values = values
        self.value = next(iter(description.driver.inputs.values()))
        self.parallel: frozenset[str] = frozenset()
        self.pose = {
            point: complex(at.x(values), at.y(values)) for point, at in description.pose.items()
        }

    def assembly(self, wanted: Mapping[str, Place]) -> Assembly:
        """Return the signs, dyad by dyad."""
        self.parallel = frozenset(point for point in wanted if wanted[point] == PARALLEL)
        sides: dict[str, float] = {}
        words: dict[str, str] = {}
        places: dict[str, tuple[complex, complex]] = {}
        for count, dyad in enumerate(self.dyads, start=1):
            asked = {point: wanted[point] for point in dyad.points if point in wanted}
            sides[dyad.point] = self._side(count, sides, asked)
            there = self._places(count, sides, self.value)
            if not (asked or dyad.two_places):
                continue
            away = self._places(count, {**sides, dyad.point: -sides[dyad.point]}, self.value)
            for point in asked or [dyad.points[0]]:
                want = asked.get(point)
                known = [want] if isinstance(want, str) else words_for(there[point], away[point])
                places[point] = there[point], away[point]
                words |= dict.fromkeys([point], *known[:1]) if known else {}
        return Assembly(sides, words, places, self.parallel)

    def _side(self, count: int, sides: Mapping[str, float], asked: Mapping[str, Place]) -> float:
        """Return the side on which the last of ``count`` dyads is in the places that are wanted."""
        dyad, value = self.dyads[count - 1], self.value
        if not asked and dyad.two_places:
            point = dyad.points[0]
            posed = self._pose_value(point)
            if posed is not None:
                asked, value = {point: self.pose[point]}, posed
        asked = {point: want for point, want in asked.items() if want != PARALLEL}
        if not asked:
            return 1.0
        one, other = (
            self._places(count, {**sides, dyad.point: side}, value) for side in (1.0, -1.0)
        )
        chosen = {p: _choose(p, want, (one[p], other[p])) for p, want in asked.items()}
        if len(set(chosen.values())) > 1:
            point, *others = chosen
            message = f"{point}: cannot be so while {others[0]} is {asked[others[0]]}"
            raise UnplacedError(point, message, "one of them is enough")
        return (1.0, -1.0)[next(iter(chosen.values()))]

    def _pose_value(self, point: str) -> float | None:
        """Return the driver's angle in the pose of the file; None if the pose does not tell it."""
        driver = self.description.driver
        link = self.description.links.get(driver.name)
        if point not in self.pose or link is None or driver.kind != "angle":
            return None
        known = self.pose | fixed_points(self.description, self.values)
        if not set(link.base) <= set(known):
            return None
        return bearing(known[link.base[1]] - known[link.base[0]])

    def _places(self, count: int, sides: Mapping[str, float], value: float) -> dict[str, complex]:
        """Return where the points of the last of ``count`` dyads are."""
        dyad, solver = self.dyads[count - 1], self._solver(count, sides)
        motion = Evaluation(solver, (value, 0.0, 0.0))
        try:
            motion.pose  # noqa: B018  # raises where the links do not close
        except OpenLoopError as gap:
            miss = f"{gap.miss * solver.frame.scale:.4g} {self.description.unit}"
            message = (
                f"with these lengths {dyad.point} cannot be reached at the driver's place: "
                f"it misses by {miss}"
            )
            hint = self._other_way(count, sides)
            raise UnplacedError(dyad.point, message, hint) from None
        return {
            point: complex(solver.evaluate(("point", point, "position"), motion))
            for point in dyad.points
        }

    def _solver(self, count: int, sides: Mapping[str, float]) -> Solver:
        dyads = self.dyads[:count]
        try:
            linkage = linkage_of(self.description, dyads, self.values, sides, self.parallel)
            return Solver(linkage, 1.0)
        except InputError as error:
            raise UnplacedError(dyads[-1].point, str(error), error.hint) from None

    def _other_way(self, count: int, sides: Mapping[str, float]) -> str | None:
        """Return the hint which earlier dyad should take its other place, and how to write it."""
        for number, dyad in enumerate(self.dyads[: count - 1], start=1):
            if dyad.reversible:
                flipped = {**sides, dyad.point: -sides[dyad.point]}
                try:
                    self._solver(count, flipped).positions(self.value)
                except OpenLoopError:
                    continue
                here, there = (self._places(number, each, self.value) for each in (sides, flipped))
                point = dyad.points[0]  # that in which its chains meet may be known already
                words = words_for(there[point], here[point])
                said = f": {point} = '{words[0]}' under [assembly]" if words else ""
                return f"with {point} at its other place it would close{said}"
        return None


def _choose(point: str, want: Place, both: Sequence[complex]) -> int:
    """Return which of two places is meant.

    Raises
    ------
    UnplacedError
        If neither fits better than the other.
    """
    fits = [ahead(want, place) for place in both]
    if abs(fits[0] - fits[1]) > SAME * max(map(abs, both)):
        return int(fits[1] > fits[0])
    what = f"the {want} one" if isinstance(want, str) else f"nearer to {_shown(want)}"
    where = " and ".join(map(_shown, both))
    words = " or ".join(dict.fromkeys([*words_for(*both), *words_for(both[1], both[0])]))
    hint = f"say {words}" if words else "begin with the driver elsewhere, where they lie apart"
    raise UnplacedError(point, f"{point}: neither of its two places is {what}, at {where}", hint)


def _shown(place: complex) -> str:
    return f"({place.real:.4g}, {place.imag:.4g})"

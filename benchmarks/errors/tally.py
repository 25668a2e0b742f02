"""What is found: how many results were compared, and the worst and those beyond their bounds."""

from __future__ import annotations

import itertools
import json
import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import gmpy2

from benchmarks.errors.truth import LAST_DIGIT, Truth, parts_of
from tests.kinematics.worst_cases import BOUNDS
from tests.oracle import Key
from tests.precise import fold

EPSILON = 2.0**-52
#: Below this a rate's square underflows, or loses digits on its way there: no bound holds.
LEAST_RATE = 1e-140
#: A result that may change by such a part of itself for the rounding of the inputs is in doubt.
DOUBTFUL = 1e-6


class Pose(NamedTuple):
    """One pose that was drawn: whose it is, of which family, and all that makes it again."""

    mechanism: str
    family: str
    given: Mapping[str, Any]

    @property
    def text(self) -> str:
        return json.dumps(self.given)

    def part(self, key: Key) -> str:
        """Return whose result it is; the parts of chains are counted by their kind."""
        return f"{key[0]}, {self.family}" if self.mechanism == "chains" else key[1]


@dataclass
class Record:
    """What is known of one result of one mechanism."""

    results: int = 0
    beyond: int = 0
    worst: float = 0.0
    where: str = ""
    ulps: list[float] = field(default_factory=list)
    most_ulps: float = 0.0
    where_ulps: str = ""

    def keep_ulps(self, count: float, pose: Pose) -> None:
        """Keep an error in units in the last place."""
        self.ulps.append(count)
        if count > self.most_ulps:
            self.most_ulps, self.where_ulps = count, pose.text


@dataclass
class Finding:
    """A result beyond its bound."""

    pose: Pose
    key: Key
    size: float

    @property
    def text(self) -> str:
        what = " ".join(self.key)
        return (
            f"{self.pose.mechanism}, {self.pose.family}: {what} {self.size:.3g} εκ off: "
            f"{self.pose.text}"
        )


@dataclass
class Tally:
    """All records, and what went another way."""

    records: dict[tuple[str, str, str], Record] = field(default_factory=dict)
    families: Counter[tuple[str, str]] = field(default_factory=Counter)
    beyond: Counter[tuple[str, str]] = field(default_factory=Counter)
    exactly: bool = False
    """Whether to know the worst of every result, and not of those alone that are beyond a bound."""
    others: Counter[tuple[str, str]] = field(default_factory=Counter)
    findings: list[Finding] = field(default_factory=list)
    refusals: list[tuple[Pose, str]] = field(default_factory=list)
    poses: int = 0

    @property
    def results(self) -> int:
        return sum(record.results for record in self.records.values())

    def texts(self) -> list[str]:
        """Return a line for every finding."""
        refused = [
            f"{pose.mechanism}, {pose.family}: refused, {why}: {pose.text}"
            for pose, why in self.refusals
        ]
        return [finding.text for finding in self.findings] + refused

    def refused(self, pose: Pose, truth: Truth, error: Exception) -> None:
        """Keep a pose that closes and that the program refuses, if that is not for its last digits.

        So near to a dead centre the rounding of the inputs alone may part the links.
        """
        for key, value in truth.values.items():
            for part in parts_of(key, value):
                if EPSILON * truth.kappa(key, part) > DOUBTFUL * abs(part(value)) > 0:
                    self.others["at a dead centre but for rounding", pose.mechanism] += 1
                    return
        self.others[f"{type(error).__name__}, but closes", pose.mechanism] += 1
        self.refusals.append((pose, str(error)))

    def compare(
        self,
        pose: Pose,
        measured: Mapping[Key, Any],
        truth: Truth,
        again: Callable[[], Truth],
        plain: bool,
    ) -> None:
        """Compare what the program says of a pose with the truth.

        Parameters
        ----------
        pose, measured
            The pose, and the program's results; angles in degrees.
        truth, again
            The truth, and what finds it with many more bits.
        plain
            Whether its errors in ulps count, too: it is a pose without trouble.
        """
        self.poses += 1
        self.families[pose.mechanism, pose.family] += len(measured)
        large = []
        for key, found in measured.items():
            record = self._record(pose, key)
            record.results += 1
            limit = min(BOUNDS[key[2]], record.worst) if self.exactly else BOUNDS[key[2]]
            if error(truth, key, found, least=True) > limit:
                large.append((key, limit))
            if plain:
                record.keep_ulps(ulps(truth, key, found), pose)
        while large and truth.look_on():
            large = [x for x in large if error(truth, x[0], measured[x[0]], least=True) > x[1]]
        second: Truth | None = None
        for key, _ in large:
            size = error(truth, key, measured[key])
            if size > BOUNDS[key[2]]:
                second = second or again()
                size = error(second, key, measured[key])
            self._keep(pose, key, size)

    def _record(self, pose: Pose, key: Key) -> Record:
        return self.records.setdefault((pose.mechanism, pose.part(key), key[2]), Record())

    def _keep(self, pose: Pose, key: Key, size: float) -> None:
        record = self._record(pose, key)
        if size > record.worst:
            record.worst, record.where = size, pose.text
        if not size <= BOUNDS[key[2]]:
            record.beyond += 1
            self.beyond[pose.mechanism, pose.family] += 1
            self.findings.append(Finding(pose, key, size))


def read_all(motion: Any, keys: Iterable[Key]) -> dict[Key, Any]:
    """Return results of the program by the keys of the truth."""
    found = {}
    for part, each in itertools.groupby(keys, key=lambda key: key[:2]):
        kind, name = part
        here = getattr(motion, kind)(name)
        found |= {key: getattr(here, key[2]) for key in each}
    return found


def miss(truth: Truth, key: Key, found: Any) -> Any:
    """Return by how much a result misses the truth; angles in radians."""
    if key[2] == "angle":
        return fold(gmpy2.mpfr(found) * gmpy2.const_pi() / 180 - truth.values[key])
    return found - truth.values[key]


def error(truth: Truth, key: Key, found: Any, least: bool = False) -> float:
    """Return the error of a result in units of ε·κ, or of what κ is at ``least``.

    A result that is zero whatever the numbers are has κ = 0, and no digits of its own: it is a
    difference of equals.  Its error is measured in ε of the largest result of its kind.
    """
    off = miss(truth, key, found)
    largest = truth.largest[key[2]]
    noise = LAST_DIGIT * largest
    kappa = truth.least_kappa if least else truth.kappa
    sizes = [0.0]
    for part in parts_of(key, truth.values[key]):
        size = abs(part(off))
        if abs(part(truth.values[key])) <= noise and size <= EPSILON**2 * largest:
            continue  # zero in exact numbers, and as good as that
        if not size <= noise:  # NaN is beyond any bound
            condition = kappa(key, part)
            scale = EPSILON * (condition if least or condition > noise else largest)
            sizes.append(float(size / scale) if scale and not gmpy2.is_nan(size) else math.inf)
    return max(sizes)


def ulps(truth: Truth, key: Key, found: Any) -> float:
    """Return the error of a result in units of the last place of what is true."""
    off = miss(truth, key, found)
    noise = LAST_DIGIT * truth.largest[key[2]]
    unit = 180 / gmpy2.const_pi() if key[2] == "angle" else 1
    sizes = [0.0]
    for part in parts_of(key, truth.values[key]):
        size = abs(part(off))
        if size > noise:
            sizes.append(float(size * unit / math.ulp(float(abs(part(truth.values[key])) * unit))))
    return max(sizes)

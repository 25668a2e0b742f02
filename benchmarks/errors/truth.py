"""The truth about one pose, and how large its condition numbers are.

A condition number needs one more solution for every parameter, which costs far more than the truth
itself.  A bound from below costs nothing: it knows the value, and its change with the inputs,
which the rates tell.  Only an error that is large in units of that bound is looked at again.
"""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from functools import cached_property
from operator import attrgetter, itemgetter
from typing import Any, NamedTuple

import gmpy2
import numpy as np

from tests.oracle import Key

#: Bits of the first look, and of the second at what seems to be beyond its bound.
BITS, MORE_BITS = 333, 2560
#: Where a number of the first look ends, against the largest of its kind in that pose.
LAST_DIGIT = 1e-60

INPUTS = ("angle", "omega", "alpha", "position", "velocity", "acceleration")
ORDERS = {
    "angle": 0,
    "position": 0,
    "omega": 1,
    "velocity": 1,
    "coriolis": 1,
    "alpha": 2,
    "acceleration": 2,
}
_SIBLINGS = {
    "link": ("angle", "omega", "alpha"),
    "joint": ("angle", "omega", "alpha"),
    "point": ("position", "velocity", "acceleration"),
    "slide": ("position", "velocity", "acceleration"),
}

Part = Callable[[Any], Any]


class Drive(NamedTuple):
    """How far the driver counts as moved for κ (1 rad, or its position), its rate and second."""

    reach: Any
    rate: Any
    second: Any


class Truth(ABC):
    """True values of one pose, and condition numbers when they are asked for.

    Attributes
    ----------
    values
        Every result; points are complex in the plane and three numbers in space, angles radians.
    drive
        The motion of the driver.
    """

    values: dict[Key, Any]
    drive: Drive

    @abstractmethod
    def changes(self) -> Iterator[tuple[str, dict[Key, Any]]]:
        """Yield the name of every number p, parameters and inputs, and p·∂q/∂p of every result."""

    @cached_property
    def _rest(self) -> Iterator[tuple[str, dict[Key, Any]]]:
        return self.changes()

    @cached_property
    def _seen(self) -> list[tuple[str, dict[Key, Any]]]:
        return []

    def look_on(self) -> bool:
        """Find how the results change with one more number, if there is one."""
        before = len(self._seen)
        self._seen.extend(itertools.islice(self._rest, 1))
        return len(self._seen) > before

    @cached_property
    def largest(self) -> dict[str, float]:
        """The largest number of each quantity."""
        found: dict[str, Any] = {}
        for (_, _, quantity), value in self.values.items():
            found[quantity] = max(found.get(quantity, 0), *np.ravel(abs(value)))
        return found

    def kappa(self, key: Key, part: Part) -> Any:
        """Return the condition number of a part of a result."""
        while self.look_on():
            pass
        return abs(part(self.values[key])) + sum(abs(part(x[key])) for _, x in self._seen)

    def least_kappa(self, key: Key, part: Part) -> Any:
        """Return what the condition number is at least, by the numbers that were looked at."""
        parameters = [x[key] for name, x in self._seen if name not in INPUTS]
        return sum(abs(part(x)) for x in [*self._least_terms(key), *parameters])

    def _least_terms(self, key: Key) -> list[Any]:
        """Return the value and its changes with the inputs alone.

        A velocity is proportional to the driver's rate; an acceleration is a sum of two, to the
        rate's square and to the second derivative.  How it changes with the driver's place is what
        the next order tells.
        """
        kind, name, quantity = key
        value, order = self.values[key], ORDERS[quantity]
        if quantity == "coriolis":
            return [3 * value]
        siblings = [(kind, name, each) for each in _SIBLINGS[kind]]
        # Q lies where the pin is: its velocity is that of the lever, not of the place.
        if not self.drive.rate or name == "Q" or not all(x in self.values for x in siblings):
            return [value, value] if order else [value]
        reach, rate, second = self.drive
        slope = self.values[siblings[1]] / rate
        forced = slope * second
        free = self.values[siblings[2]] - forced
        if order == 0:
            return [value, slope * reach]
        if order == 1:
            return [value, value, free / rate * reach]
        return [value, free * 2, forced]


def parts_of(key: Key, value: Any) -> list[Part]:
    """Return what is measured by itself: x and y of a point, but its acceleration as a whole.

    The errors of ω² and of α are not tied to each other: one coordinate of their sum can cancel
    without bound.
    """
    if isinstance(value, np.ndarray):
        whole = key[2] == "acceleration" or key[0] != "point"
        return [_norm] if whole else [itemgetter(k) for k in range(len(value))]
    if key[0] == "point":
        return [_same] if key[2] == "acceleration" else [attrgetter("real"), attrgetter("imag")]
    return [_same]


def _same(value: Any) -> Any:
    return value


def _norm(value: Any) -> Any:
    return gmpy2.sqrt(sum(x * x for x in value))

"""The outputs of the program of a page that is turned."""

from __future__ import annotations

from collections.abc import Iterable

from vad.kinematics.traced import Traced


class Outputs:
    """The outputs of a program, each once, in the order in which they were first asked for."""

    def __init__(self) -> None:
        self.numbers: list[float] = []
        self._places: dict[str, int] = {}

    def of(self, value: float) -> int:
        """Return the number of an output."""
        key = value.made.name if isinstance(value, Traced) else repr(float(value))
        if key not in self._places:
            self._places[key] = len(self.numbers)
            self.numbers.append(value)
        return self._places[key]

    def place(self, z: complex) -> list[int]:
        """Return the numbers of x and y."""
        return [self.of(z.real), self.of(z.imag)]

    def listed(self, places: Iterable[complex]) -> list[int]:
        """Return the numbers of x and y of several places."""
        return [each for z in places for each in self.place(z)]

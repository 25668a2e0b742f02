"""The solutions of a design as plain text: a column for each."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from vad import gate
from vad.kinematics.results import block
from vad.words import Language
from vad.written import DIGITS, MOST_DIGITS, typed

if TYPE_CHECKING:
    from vad.designs.design import Design, Solution


def table(design: Design, digits: int = DIGITS, language: str = "en") -> str:
    """Return all solutions as text in a language, with units."""
    writer = _Writer(Language(language), gate.whole("digits", digits, 1, MOST_DIGITS), design)
    columns = [writer.column(solution) for solution in design]
    names = _merged(columns)
    rows = {
        name: {str(n): column.get(name, "") for n, column in enumerate(columns)} for name in names
    }
    head = [writer.words["solution"], *(str(n) for n in range(1, len(columns) + 1))]
    return f"{writer.words[design.task.name]}\n\n{block(head, rows)}"


def _merged(columns: Iterable[Iterable[str]]) -> list[str]:
    """Return the names of all rows, each after those that stand above it in its column."""
    found: list[str] = []
    for column in columns:
        at = 0
        for name in column:
            if name not in found:
                found.insert(at, name)
            at = found.index(name) + 1
    return found


class _Writer:
    """Writes solutions in one language.

    Parameters
    ----------
    language
        The language.
    digits
        The significant digits of numbers.
    design
        The design, with its unit of lengths.
    """

    def __init__(self, language: Language, digits: int, design: Design) -> None:
        self.language, self.words = language, language.page("DESIGN")
        self.digits, self.unit = digits, design.length_unit

    def column(self, solution: Solution) -> dict[str, str]:
        """Return what is said of a solution, by the names of the rows."""
        mechanism, words, found = solution.mechanism, self.words, solution.merit
        rows = {words["mechanism"]: self.language.name(mechanism.title)}
        for name, value in mechanism.parameters().items():
            rows[self.language.name(name)] = self._size(value, name.endswith("angle"))
        rows[words["assembly"]] = self.language.page("WINDOW")[mechanism.assembly]
        if len(solution.places) > 2 and solution.origin:
            place = ", ".join(self._size(each) for each in _pair(solution.origin))
            rows[words["origin"]] = place
        for name, (link, distance, *angle) in mechanism.points.items():
            turned = "".join(f", {self._size(each, True)}" for each in angle)
            rows[f"{name}: {self.language.name(link)}"] = self._size(distance) + turned
        rows |= self._positions(solution)
        rows[words["sense"]] = words["backwards" if solution.speed < 0.0 else "forwards"]
        for note in solution.notes:
            row, _, _ = note.partition(" ")
            rows[words[row]] = words[note]
        faults = ", ".join(words[f"fault {fault}"] for fault in solution.faults)
        rows[words["faults"]] = faults or words["none"]
        if found["grashof"]:
            rows[words["grashof"]] = words[f"kind {found['grashof']}"]
        if found["stroke"] is not None:
            rows[words["stroke"]] = self._size(found["stroke"], self._turns(solution))
        if found["time_ratio"] is not None:
            rows[words["time ratio"]] = self._number(found["time_ratio"])
        transmission = found["transmission"]
        for which in ("least", "largest"):
            angle_of, at = transmission[which], transmission[f"{which}_at"]
            said = f"{self._size(angle_of, True)} ({self._size(at, True)})"
            rows[words[f"{which} transmission"]] = said
        return rows

    def _positions(self, solution: Solution) -> dict[str, str]:
        """Return a row for each position: driver, output, and angle of transmission."""
        kind = self.words["dead centre" if len(solution.places) == 2 else "position"]
        rows = {}
        for number, each in enumerate(solution.positions, start=1):
            output = self._size(each["output"], self._turns(solution))
            said = f"{self._size(each['angle'], True)}: {output}"
            rows[f"{kind} {number}"] = f"{said}, μ {self._size(each['transmission'], True)}"
        return rows

    def _turns(self, solution: Solution) -> bool:
        return bool(solution.merit.output and solution.merit.output[0] == "link")

    def _size(self, value: float, is_angle: bool = False) -> str:
        """Write an angle or a length with its unit."""
        return f"{self._number(value)}{'°' if is_angle else f' {self.unit}'}"

    def _number(self, value: float) -> str:
        return typed(value, "", self.digits)


def _pair(vector: complex) -> tuple[float, float]:
    return vector.real + 0.0, vector.imag + 0.0

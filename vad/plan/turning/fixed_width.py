"""Numbers that change without wobbling: all of a kind have as many decimals and as much room.

In come all values of a quantity, out goes the type of any of them, always as wide as the widest.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from vad.plan.lettering.runs import Run, Runs, roman
from vad.written import MEASURED, MINUS, THIN_SPACE, WRITTEN_OUT, in_turn, power_of_ten, typeset


@dataclass(frozen=True, slots=True)
class FixedWidth:
    """How the numbers of one quantity are written.

    They are multiples of ten to the ``power``, with so many ``digits`` before and ``decimals``
    after the point; ``signed`` where some are negative, ``turns`` where they are degrees;
    ``point`` is the decimal sign.
    """

    digits: int
    decimals: int
    signed: bool
    power: int = 0
    turns: bool = False
    point: str = "."

    def runs(self, value: float) -> Runs:
        """Return a number, its missing digits and sign kept as room.

        Examples
        --------
        >>> "".join(run.text for run in FixedWidth(3, 1, True).runs(-7.25) if run.shown)
        '−7.2'
        """
        value = in_turn(value) if self.turns else value
        size = round(abs(value) / 10.0**self.power, self.decimals)
        text = f"{size:.{self.decimals}f}"
        negative = value < 0 and float(text) != 0
        missing = self.digits - len(text.partition(".")[0])
        # Thousands are parted as in the widest: what is missing stands before what is shown.
        whole = typeset("0" * missing + text, self.point)
        shown = whole.lstrip("0" + THIN_SPACE) if missing else whole
        shown = shown if shown[:1].isdecimal() else "0" + shown
        room = whole.removesuffix(shown) + (MINUS if self.signed and not negative else "")
        blank = (Run(room, shown=False),) if room else ()
        tail = power_of_ten(self.power) if self.power else ""
        return blank + roman((MINUS if negative else "") + shown + tail)

    def bare(self, value: float) -> Runs:
        """Return a number of an axis, as wide as it is; a full turn ends at 360, not at 0."""
        return tuple(run for run in replace(self, turns=False).runs(value) if run.shown)


def fixed_width(unit: str, values: Iterable[float], point: str = ".") -> FixedWidth:
    """Return how to write ``values``: the largest has as many digits as anywhere else."""
    known = list(values)
    peak = max(map(abs, known), default=0.0)
    signed = any(value < 0 for value in known)
    if unit == "°":
        return FixedWidth(3, 1, signed, turns=True, point=point)
    # Rounded to the digits first: 9999.7 reads 10000.
    power = int(f"{peak:.{MEASURED - 1}e}".partition("e")[2])
    if not WRITTEN_OUT[0] <= power < WRITTEN_OUT[1]:
        return FixedWidth(1, MEASURED - 1, signed, power, point=point)
    return FixedWidth(max(power, 0) + 1, max(MEASURED - 1 - power, 0), signed, point=point)

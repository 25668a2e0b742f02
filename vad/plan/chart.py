"""The curve under a panel: the output over the driver, with a cursor.

The value at the dot is written above, always with the width of the widest one (`FixedWidth`).  A
line above the mechanism tells the times of a quick return, or the limits of a driver that swings,
and by which law it does so (`Clock`).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from vad.lecture.cycle import FLUCTUATION, JOULE, Course, Cycle, Series
from vad.plan.geometry import Rect
from vad.plan.hodographs import thinned
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Run, Runs, roman, symbols
from vad.plan.marks import Lettering, Mark, area, disc, line, lines
from vad.plan.pictures.polygon import DOT
from vad.plan.roles import DOT_RIM
from vad.strokes.notation import Notation
from vad.strokes.sheet import Sheet
from vad.words import Language
from vad.written import (
    MEASURED,
    MINUS,
    THIN_SPACE,
    WRITTEN_OUT,
    in_turn,
    power_of_ten,
    typeset,
    with_unit,
)

VALUE = 0.0335
LEAST_VALUE = 0.020
NAMED = 0.68  # of the size of its type, to which a line shrinks to keep a name
VALUE_BASELINE = 0.030  # below the upper edge
TICK = 0.028
TICK_BASELINE = 0.036  # below the curve
ABOVE, BELOW = 0.058, 0.050  # the curve, for the words
ROW = 0.030  # from one row of words below the curve to the next
GAP = 0.012  # from a tick's words to the curve
BESIDE = 0.026  # right of the curve, for half of the last tick
SMALL_DOT = 0.0048
MARGIN = 0.008  # of the shading, above and below the curve
CLOSEST = 0.034  # ticks nearer than this to one another lose the zero
LEVEL = 1e-9  # of the largest value: a curve that changes less is level, but for rounding
SIZE, LEAST = 0.030, 0.020
SPACE = 0.9  # between its parts, in type sizes
BASELINE = 0.032  # below the panel's upper edge
HEIGHT = 0.042  # of the line


@dataclass(frozen=True, slots=True)
class Dial:
    """One quantity of a chart.

    It has the name of its link or slide, its colour and the notation of its numbers.  ``since`` is
    said after an angle that is counted from elsewhere: "after touch-down".
    """

    name: str
    row: int | None
    curve: Series
    notation: Notation
    since: str = ""

    @property
    def unit(self) -> str:
        """The unit in which it is written."""
        return self.notation.unit(self.curve.unit)

    def number(self, value: float, bare: bool = False) -> Runs:
        """Return a value without its unit: as wide as all others, or ``bare``."""
        notation, unit = self.notation, self.curve.unit
        known = [notation.scaled(each, unit) for each in self.known]
        form = fixed_width(self.unit, known, notation.point)
        return (form.bare if bare else form.runs)(notation.scaled(value, unit))

    def reading(self, value: float, named: bool = True) -> Runs:
        """Return a value with its symbol and unit, and the name of the row if ``named``."""
        unit = roman(with_unit("", self.unit))
        if self.since:
            return (*self.number(value), *unit, *roman(f" {self.since}" if named else ""))
        name = roman(f"{self.name} ") if named and self.name else ()
        return (*name, *symbols(self.curve.symbol), *roman(" = "), *self.number(value), *unit)

    @property
    def known(self) -> list[float]:
        """The values that are known, the extreme ones too."""
        values = self.curve.values
        return [*map(float, values[np.isfinite(values)]), *self.curve.extremes] or [0.0]


def dial(sheet: Sheet, curve: Series) -> Dial:
    """Return the dial of a curve, with the name of its row."""
    number = next(index for index, row in enumerate(sheet.rows) if row.key == curve.row)
    return Dial(sheet.rows[number].title if curve.titled else "", number, curve, sheet.notation)


def time_of(sheet: Sheet, cycle: Cycle) -> Dial:
    """Return the dial of the driver; with a foot, how far it has turned since that touched down."""
    driver = dial(sheet, cycle.place)
    if cycle.stance is None:
        return driver
    turned = replace(cycle.place, unit="°", values=360.0 * cycle.shares)
    say = Language(sheet.language).say
    return replace(driver, curve=turned, since=say("after touch-down"))


class Chart:
    """The curve of one panel in its place; ``driver`` is given where it is read above, too."""

    def __init__(
        self,
        cycle: Cycle,
        output: Dial,
        driver: Dial,
        place: Rect,
        first: bool,
        rows: int = 1,
    ) -> None:
        self._cycle, self._place = cycle, place
        self._output, self._driver, self._first = output, driver, first
        known = output.known
        #: Of a drive, what it gives over the turn.
        self._work = cycle.work if output.curve is cycle.curves.get("drive") else None
        means = [self._work.mean] if self._work else []
        self._low, self._high = min(known + means), max(known + means)
        if self._high - self._low <= LEVEL * max(abs(self._low), abs(self._high)):
            self._low = self._high = (self._low + self._high) / 2
        self._ticks = {value: output.number(value, True) for value in (self._low, self._high)}
        if self._low < 0.0 < self._high:
            self._ticks[0.0] = roman("0")
        widest = max(width(runs, TICK) for runs in self._ticks.values())
        self.box = Rect(
            place.left + widest + GAP,
            place.bottom + BELOW + (rows - 1) * ROW,
            place.right - BESIDE,
            place.top - ABOVE,
        )
        each = zip(cycle.shares.tolist(), output.curve.values.tolist(), strict=True)
        self._points = [self.at(*place) for place in each]
        self._kept: list[int] = thinned(np.array(self._points)).tolist()
        both = self._readings(0.0)
        room = place.width - VALUE * first
        #: Of the values' type.
        self.size = fitted((*both[0], *both[1]), VALUE, LEAST_VALUE, room)

    def at(self, share: float, value: float) -> complex:
        """Return where a value stands at a share of the cycle."""
        box, span = self.box, self._high - self._low
        up = (value - self._low) / span if span else 0.5
        return complex(box.left + share * box.width, box.bottom + up * box.height)

    def value(self, share: float) -> float:
        """Return the output's value at a share of the cycle."""
        return _value(self._cycle, self._output.curve, share)

    def still(self) -> list[Mark]:
        """Return shading, ticks and the whole curve, pale."""
        marks = [area(_corners(part), "return") for part in self._returns()]
        box = self.box
        for value, runs in self._ticks.items():
            y = self.at(0.0, value).imag
            near = min(abs(y - self.at(0.0, end).imag) for end in (self._low, self._high))
            ends = complex(box.left, y), complex(box.right, y)
            marks.append(line(ends, "axis line" if value == 0.0 else "hairline"))
            if value in (self._low, self._high) or near > CLOSEST:
                at = complex(box.left - GAP - width(runs, TICK), y - 0.33 * TICK)
                marks.append(Mark(Lettering(runs, at, TICK), "notes"))
        return [*marks, *self._given(), lines(self._pieces(1.0), "curve ahead")]

    def _given(self) -> list[Mark]:
        """Return the mean of a drive, and the area of its greatest excess energy."""
        work = self._work
        if work is None:
            return []
        shares = self._cycle.shares
        end = work.greatest + (work.greatest < work.least)
        marks = []
        for low, high in ((work.least, min(end, 1.0)), (0.0, end - 1.0)):
            if high <= low:
                continue
            within = shares[(shares > low) & (shares < high)].tolist()
            over = [self.at(share, self.value(share)) for share in (low, *within, high)]
            under = [self.at(share, work.mean) for share in (high, low)]
            marks.append(area([*over, *under], "excess", self._output.row))
        level = [self.at(share, work.mean) for share in (0.0, 1.0)]
        return [*marks, line(level, "mean")]

    def scale(self, ticks: Sequence[tuple[float, str]], row: int = 0) -> list[Mark]:
        """Return one row of the words below the curve, as many as have room."""
        texts = [(share, roman(text)) for share, text in ticks]
        room = self.box.width / max(len(texts) - 1, 1)
        if max(width(runs, TICK) for _, runs in texts) + GAP / 2 > room:
            texts = texts[::2]
        y = self.box.bottom - TICK_BASELINE - row * ROW
        return [
            Mark(Lettering(runs, complex(self._x(share) - width(runs, TICK) / 2, y), TICK), "notes")
            for share, runs in texts
        ]

    def moving(self, share: float) -> list[Mark]:
        """Return the curve up to the cursor, the cursor and its dot."""
        box, x = self.box, self._x(share)
        cursor = complex(x, box.bottom - MARGIN), complex(x, box.top + MARGIN)
        marks = [lines(pieces, "curve")] if (pieces := self._pieces(share)) else []
        marks.append(line(cursor, "cursor", self._driver.row))
        value = self.value(share)
        return (
            [*marks, disc(self.at(share, value), DOT + DOT_RIM / 2, "dot")]
            if math.isfinite(value)
            else marks
        )

    def numbered(self, shares: Sequence[float]) -> list[Mark]:
        """Return the whole curve with a dot and a line at each of some shares."""
        box = self.box
        uprights = [(complex(self._x(x), box.bottom), complex(self._x(x), box.top)) for x in shares]
        dots = [self.at(share, self.value(share)) for share in shares]
        return [
            lines(uprights, "hairline"),
            lines(self._pieces(1.0), "curve"),
            *(disc(at, SMALL_DOT, "position") for at in dots if math.isfinite(at.imag)),
        ]

    def heading(self) -> list[Mark]:
        """Return what the curve shows, and in which unit."""
        output, y = self._output, self._place.top - VALUE_BASELINE
        comma = f", {output.unit}" if output.unit else ""
        runs = (
            *roman(f"{output.name} " if output.name else ""),
            *symbols(output.curve.symbol),
            *roman(comma),
        )
        return [Mark(Lettering(runs, complex(self._place.left, y), VALUE), "words")]

    def words(self, share: float) -> list[Mark]:
        """Return the value at the cursor, and in the first chart the driver's."""
        y, (output, driver) = self._place.top - VALUE_BASELINE, self._readings(share)
        marks = [Mark(Lettering(output, complex(self._place.left, y), self.size), "words")]
        if driver:
            right = complex(self._place.right - width(driver, self.size), y)
            marks.append(Mark(Lettering(driver, right, self.size), "term", self._driver.row))
        return marks

    def _readings(self, share: float) -> tuple[Runs, Runs]:
        """Return the value at the cursor, and the driver's in the first chart."""
        output = self._output.reading(self.value(share))
        if not self._first:
            return output, ()
        place = _value(self._cycle, self._driver.curve, share)
        driver = self._driver.reading(place)
        if (width(output, VALUE) + width(driver, VALUE)) * NAMED > self._place.width - VALUE:
            driver = self._driver.reading(place, named=False)
        return output, driver

    def _x(self, share: float) -> float:
        return self.box.left + share * self.box.width

    def _pieces(self, share: float) -> list[list[complex]]:
        """Return the curve up to a share, in pieces where there is no value."""
        last = share * (len(self._cycle.shares) - 1)
        points = [self._points[number] for number in self._kept if number < last]
        points.append(self.at(share, self.value(share)))
        pieces: list[list[complex]] = [[]]
        for point in points:
            if math.isfinite(point.imag):
                pieces[-1].append(point)
            elif pieces[-1]:
                pieces.append([])
        return [piece for piece in pieces if len(piece) > 1]

    def _returns(self) -> list[Rect]:
        """Return the parts of the chart in which the output returns, or a foot stands."""
        if self._cycle.shaded is None:
            return []
        first, last = self._cycle.shaded
        spans = [(first, min(last, 1.0)), (0.0, last - 1.0)] if last > 1.0 else [(first, last)]
        box = self.box
        return [
            Rect(self._x(start), box.bottom - MARGIN, self._x(end), box.top + MARGIN)
            for start, end in spans
        ]


def ticks_of(course: Course, cycle: Cycle, notation: Notation) -> list[tuple[float, str]]:
    """Return what stands below the curves: right angles of a crank, the ends of a swing."""
    if cycle.stance:
        return [(k / 4, f"{90 * k}°") for k in range(5)]
    (low, high), unit = course.ends, cycle.place.unit
    if course.swing:
        bare = unit if unit == "°" else ""
        ends = [written_end(value, bare, notation) for value in (low, high)]
        return [(0.0, ends[0]), (0.5, ends[1]), (1.0, ends[0])]
    step = 90.0 if high > low else -90.0
    return [(k / 4, f"{low + k * step:g}°") for k in range(5)]


def _value(cycle: Cycle, curve: Series, share: float) -> float:
    return float(np.interp(share, cycle.shares, curve.values))


def _corners(box: Rect) -> list[complex]:
    return [
        complex(box.left, box.bottom),
        complex(box.right, box.bottom),
        complex(box.right, box.top),
        complex(box.left, box.top),
    ]


def work_lines(cycle: Cycle, sheet: Sheet, room: Rect) -> list[Mark]:
    """Return what stands above the driven link: mean and excess energy, below them the flywheel."""
    work = cycle.work
    if work is None:
        return []
    say, notation = Language(sheet.language).say, sheet.notation
    unit = cycle.curves["drive"].unit
    energy = notation.quantity(work.energy, "J" if unit == JOULE else unit)
    words = [[say("mean", value=notation.quantity(work.mean, unit)), f"ΔE = {energy}"]]
    if work.flywheel is not None:
        share = notation.quantity(100.0 * FLUCTUATION, "%", given=True)
        inertia = notation.quantity(work.flywheel, "kg m²")
        words.append([say("flywheel", share=share, value=inertia)])
    lower = Rect(room.left, room.bottom, room.right, room.top - HEIGHT)
    rows = zip(words, (room, lower), strict=False)
    return [Mark(text, "notes") for each, place in rows for text in _set(each, place)]


class Clock:
    """The line above the mechanism.

    It has the strokes of a quick return, the stance and the swing of a foot, or the ends of a
    driver that swings.  On a narrow page it leaves out the lift of a foot, and names a driver by
    its letters alone.  Below it stands by which law a driver swings: its rates, and all that follow
    from them, are those of the given pose at one instant only.

    Attributes
    ----------
    height
        The height that its lines take of the panel, 0 if there are none.
    """

    def __init__(self, cycle: Cycle, course: Course, sheet: Sheet, room: Rect) -> None:
        self._shaded, self._stands = cycle.shaded, cycle.stance is not None
        say, shorter = Language(sheet.language).say, list[str]()
        if cycle.stance:
            lift = sheet.notation.quantity(cycle.stance.lift, cycle.curves["position"].unit)
            words = [
                f"{say('stance')} {_degrees(cycle.stance.part)}",
                f"{say('swing')} {_degrees(1.0 - cycle.stance.part)}",
                f"{say('lift')} {lift}",
            ]
            shorter = words[:2]
        elif cycle.back:
            part = cycle.back[1] - cycle.back[0]
            words = [
                f"{say('forward')} {_degrees(1.0 - part)}",
                f"{say('return')} {_degrees(part)}",
                f"{say('ratio')} {typeset(f'{cycle.ratio:.2f}', sheet.notation.point)}",
            ]
        elif course.swing:
            phrase = "swings" if sheet.driver.turns else "slides"
            row = next(row for row in sheet.rows if row.key == cycle.driver)
            unit, notation = cycle.place.unit, sheet.notation
            low, high = (written_end(end, unit, notation) for end in course.ends)
            words = [say(phrase, part=f"{row.title} {row.letters}", low=low, high=high)]
            shorter = [say(phrase, part=row.letters, low=low, high=high)]
        else:
            words = []
        self._texts = _set(words, room)
        if shorter and _end(self._texts[-1]) > room.right:
            self._texts = _set(shorter, room)
        self.height, self._law = HEIGHT if words else 0.0, list[Lettering]()
        if course.swing:
            lower = Rect(room.left, room.bottom, room.right, room.top - self.height)
            self._law = _set([say("law of swing")], lower)
            self.height += HEIGHT

    def marks(self, share: float | None = None) -> list[Mark]:
        """Return the line; the stroke in which the share of the cycle lies is dark."""
        law = [Mark(text, "notes") for text in self._law]
        if self._shaded is None or share is None:
            return [*(Mark(text, "notes") for text in self._texts), *law]
        first, last = self._shaded
        second = ((share - first) % 1.0 < last - first) != self._stands
        roles = ("notes", "words", "notes") if second else ("words", "notes", "notes")
        return [*map(Mark, self._texts, roles), *law]


def _set(words: list[str], room: Rect) -> list[Lettering]:
    """Return the words on one line, in a type that fits."""
    parts: list[Runs] = [roman(text) for text in words]
    gaps = SPACE * SIZE * max(len(parts) - 1, 0)
    size = fitted(tuple(run for part in parts for run in part), SIZE, LEAST, room.width - gaps)
    found, left = [], room.left
    for part in parts:
        found.append(Lettering(part, complex(left, room.top - BASELINE), size))
        left += width(part, size) + SPACE * size
    return found


def _end(text: Lettering) -> float:
    return text.at.real + width(text.runs, text.size)


def _degrees(share: float) -> str:
    return with_unit(typeset(f"{360.0 * share:.0f}"), "°")


def written_end(value: float, unit: str, notation: Notation) -> str:
    """Write where a driver turns back."""
    if unit == "°":
        return notation.quantity(value, unit)
    return notation.quantity(float(f"{value:.4g}"), unit, given=True)


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

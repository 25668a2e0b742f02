"""Chosen columns of a sweep as a plot: one panel for each quantity, one below the other.

Where the mechanism cannot be assembled a curve has a gap, and the gap is grey.  Each curve has its
name at its end where a panel has more than one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from vad.errors import UsageError
from vad.export import plotting
from vad.export.plotting import NAME, NAME_GAP, SYMBOLS, Look, points
from vad.export.sweep import Column, Table, check_closes, largest, unwrapped
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import roman
from vad.style import mix
from vad.words import Language
from vad.written import base_name

#: The most panels of a plot, how many stand one below the other, and the most curves of a panel.
MOST_PANELS, _BELOW, MOST_CURVES = 9, 3, 12
#: The words of quantities that have no symbol of their own.
_WORDS = {
    "stroke": "stroke",
    "time_ratio": "time ratio",
    "forward_angle": "forward angle",
    "return_angle": "return angle",
    "advantage": "mechanical advantage",
    "drive": "drive",
    "rubbing": "merit rubbing",
}
_ENDS = {"least": "min", "largest": "max", "least_at": "min", "largest_at": "max"}
_SLOWEST = ".slowest"
#: The least share of a plot's width in which "does not close" is written.
_ROOM = 0.3
#: From the edge of the picture to a plot, and from one plot to the next, in widths of the picture.
_LEFT, _BETWEEN = 0.09, 0.105
#: By how much a picture with three columns of plots is wider.
_WIDER = 1.6


def write(
    table: Table, target: BinaryIO, style: str | None = None, language: str | None = None
) -> None:
    """Write the plot of chosen columns.

    Raises
    ------
    vad.errors.AssemblyError
        If no column has a number.
    vad.errors.UsageError
        For more quantities than a plot has room for.
    """
    write_as("png", table, target, Look.of(style, language, table.motion.mechanism))


def write_as(kind: str, table: Table, target: BinaryIO, look: Look) -> None:
    """Write the plot as a file of a kind: png, svg or pdf."""
    check_closes(any(np.isfinite(column.values).any() for column in table.columns))
    panels = _panels(table, look)
    title = f"{table.motion.mechanism.title}: {', '.join(each.quantity for each in table.columns)}"
    wider = _WIDER if _across(panels) > 2 else 1.0
    with plotting.new_figure(target, kind, look, title, wider) as figure:
        inputs = {
            name: value
            for name, value in table.motion.inputs.items()
            if name != table.over.quantity
        }
        plotting.head(figure, table.motion.mechanism, inputs, look)
        _draw(figure, table, panels, look, wider)


class Name(NamedTuple):
    """The parts of a column's name: of what, which quantity, along which axis, and which end."""

    owner: str
    quantity: str
    axis: str
    end: str

    @classmethod
    def of(cls, column: str) -> Name:
        """Return the parts of a column's name.

        Examples
        --------
        >>> Name.of("rocker.omega.largest"), Name.of("C.velocity x").axis
        (Name(owner='rocker', quantity='omega', axis='', end='largest'), 'x')
        """
        whole, _, end = column.rpartition(".")
        if end not in _ENDS:
            whole, end = column, ""
        result, _, axis = whole.partition(" ")
        owner, _, quantity = result.rpartition(".")
        return cls(owner, quantity, axis, end)


@dataclass(frozen=True)
class _Panel:
    """A quantity with its curves: each a name as it is drawn, one without italics, its values."""

    title: str
    curves: list[tuple[str, str, Column]]

    @property
    def named(self) -> bool:
        """Whether its curves have names: the only curve of a mechanism's figure needs none."""
        return len(self.curves) > 1 or bool(Name.of(self.curves[0][2].quantity).owner)


def _panels(table: Table, look: Look) -> list[_Panel]:
    """Return the panels: a quantity in one unit each, in the order of the columns.

    Raises
    ------
    vad.errors.UsageError
        For more panels than a plot has, or more curves than a panel has.
    """
    found: dict[tuple[str, str], list[Column]] = {}
    for column in table.columns:
        name = Name.of(column.quantity)
        key = "place" if name.end.endswith("_at") else name.quantity
        found.setdefault((key, column.unit), []).append(column)
    most = max(map(len, found.values()))
    if len(found) > MOST_PANELS or most > MOST_CURVES:
        raise UsageError(
            f"a plot has room for {MOST_PANELS} quantities with {MOST_CURVES} curves each, got "
            f"{len(found)} with up to {most}",
            "--columns chooses some; a table takes all",
        )
    texts = _Texts(table, look.say)
    return [
        _Panel(
            " / ".join(dict.fromkeys(texts.symbol(column) for column in columns)),
            [(*texts.curve(column), unwrapped(column)) for column in columns],
        )
        for columns in found.values()
    ]


class _Texts:
    """The words of a plot in one language."""

    def __init__(self, table: Table, say: Language) -> None:
        self._say, self._motion = say, table.motion
        mechanism: Any = table.motion.mechanism
        self._slides = mechanism.slides
        self._letters: Mapping[str, str] = {**mechanism.slides, **mechanism.links}

    def symbol(self, column: Column) -> str:
        """Return the symbol of a quantity, or its words."""
        name = Name.of(column.quantity)
        if name.end.endswith("_at"):
            return SYMBOLS[next(iter(self._motion.inputs))]
        if name.quantity == "drive":
            return "$F$" if column.unit == "N" else "$T$"
        if name.quantity in _WORDS:
            return self._words(_WORDS[name.quantity])
        if name.quantity == "position" and name.owner not in self._letters:
            return f"${name.axis}$"
        return SYMBOLS[name.quantity]

    def curve(self, column: Column) -> tuple[str, str]:
        """Return the name at the end of a curve, and the same without italics."""
        name = Name.of(column.quantity)
        drawn, plain = self._owner(name)
        if name.axis:
            drawn, plain = f"{drawn}, ${name.axis}$", f"{plain}, {name.axis}"
        if name.end:
            end = _ENDS[name.end]
            drawn, plain = (", ".join(filter(None, (each, end))) for each in (drawn, plain))
            if name.end.endswith("_at"):
                of_what = replace(column, quantity=column.quantity.rpartition(".")[0])
                drawn, plain = f"{drawn} {self.symbol(of_what)}", f"{plain} ω"
        return drawn, plain

    def _owner(self, name: Name) -> tuple[str, str]:
        say = self._say
        if name.quantity == "force":
            one, _, other = name.owner.partition(".")
            text = say.say("force of one on another", one=say.name(one), other=say.name(other))
            return text, text
        if name.quantity == "rubbing" and "." in name.owner:
            pin, one, other = name.owner.split(".")
            text = say.say("merit pair", pin=pin, one=say.name(one), other=say.name(other))
            return text, text
        if name.owner.endswith(_SLOWEST):
            link = say.name(name.owner.removesuffix(_SLOWEST))
            text = f"{link}: {self._words('merit slowest')}"
            return text, text
        if name.owner in self._letters:
            slides = name.owner in self._slides
            word = say.name(base_name(name.owner) if slides else name.owner)
            letters = self._letters[name.owner]
            return plotting.italic(word, letters), plotting.plain(word, letters) + letters
        if name.owner:
            return f"$\\mathit{{{name.owner}}}$", name.owner
        if name.quantity == "transmission":
            text = "" if name.end else self._words("transmission angle")
        else:
            text = self._words(_WORDS[name.quantity])
        return text, text

    def _words(self, phrase: str) -> str:
        if phrase == "drive":
            return self._say.name(phrase)
        return self._say.say(phrase)


def _draw(figure: Figure, table: Table, panels: Sequence[_Panel], look: Look, wider: float) -> None:
    """Draw the panels in columns of at most three; lengths are divided by how much it is wider."""
    across = _across(panels)
    down = math.ceil(len(panels) / across)
    plots = figure.subplots(down, across, sharex=True, squeeze=False)
    *inner, last = (_longest(panels[i * down : (i + 1) * down]) for i in range(across))
    left, right = _LEFT / wider, min(0.95, 0.98 - (NAME_GAP + last) / wider)
    between = (_BETWEEN + max(inner, default=0.0)) / wider
    space = between * across / (right - left - (across - 1) * between)
    figure.subplots_adjust(left, 0.085, right, 0.775, wspace=space, hspace=0.40)
    text = _place_text(table, look)
    inks = {
        name: row
        for row, name in enumerate(dict.fromkeys(p for panel in panels for _, p, _ in panel.curves))
    }
    open_places = _gaps(table)
    for number, plot in enumerate(plots.T.ravel()):
        if number >= len(panels):
            plot.set_visible(False)
            continue
        panel = panels[number]
        columns = [column for _, _, column in panel.curves]
        plotting.dress(plot, columns, panel.title, largest(columns), look)
        rows = [(drawn, inks[plain], column) for drawn, plain, column in panel.curves]
        plotting.curves_of(plot, table.over.values, rows, look, panel.named)
        _shade(plot, table.over.values, open_places, look, say=number == 0)
        if number % down == down - 1 or number == len(panels) - 1:
            plotting.place_axis(plot, table.over, text, look)
            plot.tick_params(labelbottom=True)


def _across(panels: Sequence[_Panel]) -> int:
    return math.ceil(len(panels) / _BELOW)


def _longest(panels: Sequence[_Panel]) -> float:
    """Return how long the longest name beside these panels is, in widths of the picture."""
    names = [plain for panel in panels if panel.named for _, plain, _ in panel.curves]
    lengths = [plotting.share_of_width(width(roman(each), NAME)) for each in names]
    return max(lengths, default=0.0)


def _place_text(table: Table, look: Look) -> str:
    """Return what runs along the axis, without its unit."""
    motion, over = table.motion, table.over.quantity
    if over not in motion.inputs:
        return look.say.name(over)
    name = motion.solver.driver.name
    letters = {**motion.mechanism.slides, **motion.mechanism.links}[name]
    return plotting.driver_text(look, name, letters, over)


def _gaps(table: Table) -> list[tuple[int, int]]:
    """Return the first and the last place of each stretch in which no column has a number."""
    open_ = ~np.any([np.isfinite(column.values) for column in table.columns], axis=0)
    steps = np.flatnonzero(np.diff(np.concatenate([[False], open_, [False]])))
    return [(int(first), int(last) - 1) for first, last in steps.reshape(-1, 2)]


def _shade(
    plot: Axes,
    places: NDArray[np.float64],
    gaps: Sequence[tuple[int, int]],
    look: Look,
    say: bool,
) -> None:
    """Make what cannot be assembled grey, and say so in the widest of these stretches."""
    ends = [
        (float(places[max(first - 1, 0)]), float(places[min(last + 1, len(places) - 1)]))
        for first, last in gaps
    ]
    for low, high in ends:
        grey = mix(look.style.hairline, look.style.background, 0.6)
        plot.axvspan(low, high, color=grey, zorder=0.5, linewidth=0.0)
    whole = abs(float(places[-1] - places[0]))
    low, high = max(ends, key=lambda each: abs(each[1] - each[0]), default=(0.0, 0.0))
    if say and abs(high - low) > _ROOM * whole:
        plot.text(
            (low + high) / 2.0,
            0.94,
            look.say.say("does not close"),
            transform=plot.get_xaxis_transform(),
            color=look.style.grey,
            fontsize=points(NAME),
            horizontalalignment="center",
            verticalalignment="top",
        )

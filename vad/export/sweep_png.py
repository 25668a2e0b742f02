"""A sweep as a plot: a PNG picture of the columns of a motion.

Positions, velocities and accelerations stand one above the other, links to the left, slides to
the right, over the input; the driver itself is left out, for its motion is given.  Each curve has
its name at its end, and the names never touch.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, BinaryIO

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, MultipleLocator, ScalarFormatter

from vad.export.sweep import (
    Column,
    Curves,
    Results,
    check_closes,
    largest,
    limits,
    results_of,
    unwrapped,
)
from vad.kinematics.motion import Motions
from vad.kinematics.solver import Solver
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import roman
from vad.statics.burden import Burden
from vad.strokes.scene import members_of
from vad.style import Style, load_style
from vad.units import DIMENSIONS, scene_unit
from vad.words import Language
from vad.written import THIN_SPACE, WRITTEN_OUT, quantity, sign, typeset

_SIZE, _DPI = (1600, 1200), 100
#: By how much a picture with forces is wider: they are a further column.
_WIDER = 1.5
_SYMBOLS = {
    "angle": "$\\theta$",
    "omega": "$\\omega$",
    "alpha": "$\\alpha$",
    "velocity": "$v$",
    "acceleration": "$a$",
}
_LINE = 110  # characters of the smallest type on one line
_NOTHING = 1e-9
#: The type of names at the ends of curves, and the gap before them.
_NAME, _NAME_GAP = 0.026, 0.01
_ORDERS = 3
_RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
#: Ticks of an angle stand at 15°, 30°, 45°, 60°, 90° …, all others at round numbers.
_ANGLES, _NUMBERS = (1, 1.5, 3, 4.5, 6, 9, 10), (1, 2, 2.5, 5, 10)
_HARD_SPACE = "\N{NO-BREAK SPACE}"
_ENGLISH = Language("en")
#: From the plot to a name, and from one name's middle to the next one's, in type sizes.
_GAP, _PITCH = 0.5, 1.15


def write(motion: Motions, target: BinaryIO, burden: Burden | None = None) -> None:
    """Write the plot of a motion's results, and of its forces.

    Raises
    ------
    vad.errors.AssemblyError
        If none of the poses can be assembled.
    """
    check_closes(bool(np.any(motion.assembled)))
    results, style = results_of(motion, burden), load_style("paper")
    with mpl.rc_context():
        mpl.rcdefaults()  # the user's own settings are for the user's own plots
        mpl.rcParams.update(_settings(style))
        width = _SIZE[0] * (_WIDER if results.forces else 1.0)
        figure = Figure((width / _DPI, _SIZE[1] / _DPI), dpi=_DPI, facecolor=style.background)
        _head(figure, motion, style)
        _curves(figure, results, _symbols(motion, results), style)
        title = f"{motion.mechanism.title}: a sweep of its {results.place.quantity}"
        figure.savefig(target, format="png", metadata={"Title": title})


def _symbols(motion: Motions, results: Results) -> dict[str, str]:
    """Return the symbols of the slides' positions."""
    if not isinstance(motion.solver, Solver):
        return {row.name: "s" for row in results.slides}
    members = members_of(motion.mechanism)
    return {row.name: members.slide_symbol(row.name) for row in results.slides}


def _settings(style: Style) -> dict[Any, Any]:
    return {
        "font.family": "STIXGeneral",
        "mathtext.fontset": "stix",
        "font.size": _points(0.028),
        "axes.formatter.limits": (WRITTEN_OUT[0] - 1, WRITTEN_OUT[1]),
        "axes.formatter.use_mathtext": True,
        "text.color": style.text,
        "axes.labelcolor": style.text,
        "xtick.color": style.grey,
        "ytick.color": style.grey,
    }


def _head(figure: Figure, motion: Motions, style: Style) -> None:
    """Write the mechanism's name, its dimensions and the rates of its input."""
    mechanism, (_, *rates) = motion.mechanism, motion.inputs.items()
    quantities = {field.name: field.metadata["quantity"] for field in fields(mechanism)}
    given = [
        (_ENGLISH.name(name), value, quantities[name])
        for name, value in mechanism.parameters().items()
        if quantities[name] in DIMENSIONS
    ]
    given += [(f"{_SYMBOLS[name]} =", value, name) for name, value in rates]
    items = [
        f"{name} {quantity(value, sign(scene_unit(kind, mechanism.length_unit)), given=True)}"
        for name, value, kind in given
        if np.ndim(value) == 0
    ]
    joined = "   ".join(item.replace(" ", _HARD_SPACE) for item in items)
    figure.text(0.03, 0.94, mechanism.title, fontsize=_points(0.050), weight="bold")
    figure.text(
        0.03,
        0.915,
        _powers(textwrap.fill(joined, _LINE)),
        color=style.grey,
        verticalalignment="top",
    )


def _curves(figure: Figure, results: Results, symbols: Mapping[str, str], style: Style) -> None:
    """Draw the links' and the slides' motion, each row of the results in its own ink.

    ``symbols`` are those of the slides' positions.
    """
    rows = (*results.turning, *results.slides)
    inks = {id(row): style.colour("row", place) for place, row in enumerate(rows)}
    groups = [
        [row for row in group if not row.driven] for group in (results.turning, results.slides)
    ]
    drawn = [group for group in groups if group]
    loaded = _sizes(results)
    plots = figure.subplots(_ORDERS, len(drawn) + bool(loaded), sharex=True, squeeze=False)
    names = [name for name, _ in loaded[1:]] or [_plain(row) for row in drawn[-1]]
    wider = _WIDER if loaded else 1.0
    longest = max(_share(width(roman(name), _NAME)) for name in names)
    right = min(0.885, 0.98 - (_NAME_GAP + longest) / wider)
    figure.subplots_adjust(0.09 / wider, 0.085, right, 0.775, wspace=0.60, hspace=0.40)
    spin = largest([row.columns[1] for row in results.turning])
    for group, column in zip(drawn, plots.T, strict=False):
        size = largest([row.columns[0] for row in group])
        for order, plot in enumerate(column):
            curves = [unwrapped(row.columns[order]) for row in group]
            signs = [
                f"${symbols[row.name]}$"
                if curve.quantity == "position"
                else _SYMBOLS[curve.quantity]
                for row, curve in zip(group, curves, strict=True)
            ]
            _dress(plot, curves, " / ".join(dict.fromkeys(signs)), size * spin**order, style)
            ends = []
            for row, curve in zip(group, curves, strict=True):
                x, y, ink = results.place.values, curve.values, inks[id(row)]
                plot.plot(x, y, color=ink, linewidth=_points(0.0040))
                known = np.flatnonzero(np.isfinite(y))
                if known.size:
                    ends.append(Ending(_name(row), ink, y[known[-1]]))
            name_ends(plot, ends, _points(_NAME))
        _input_axis(column[-1], results)
    if loaded:
        _forces(plots.T[-1], results, loaded, style)


def _sizes(results: Results) -> list[tuple[str, Column]]:
    """Return the drive, and the size of the force in each joint, with their names."""
    found = []
    for row in results.forces:
        one, _, other = row.name.removesuffix(".force").partition(".")
        name = f"{_ENGLISH.name(one)} on {_ENGLISH.name(other)}" if other else row.name
        value = row.columns[0].values
        if len(row.columns) > 1:
            value = np.hypot(value, row.columns[1].values)
        found.append((name, replace(row.columns[0], values=value)))
    return found


def _forces(
    plots: Sequence[Axes], results: Results, loaded: Sequence[tuple[str, Column]], style: Style
) -> None:
    """Draw the drive, and below it the sizes of the forces in the joints."""
    symbols = "$T$" if results.place.quantity == "angle" else "$F$", "$F$"
    for plot, symbol, rows in zip(plots, symbols, (loaded[:1], loaded[1:]), strict=False):
        curves = [column for _, column in rows]
        _dress(plot, curves, symbol, largest(curves), style)
        ends = []
        for place, (name, curve) in enumerate(rows):
            ink, y = style.colour("row", place), curve.values
            plot.plot(results.place.values, y, color=ink, linewidth=_points(0.0040))
            known = np.flatnonzero(np.isfinite(y))
            if known.size:
                ends.append(Ending(name, ink, y[known[-1]]))
        name_ends(plot, ends, _points(_NAME))
    plots[-1].set_visible(False)
    _input_axis(plots[1], results)
    plots[1].tick_params(labelbottom=True)


def _dress(plot: Axes, curves: Sequence[Column], symbol: str, scale: float, style: Style) -> None:
    """Name the quantity, set the range of its axis and draw a grid instead of a frame.

    Values that are tiny beside ``scale`` are rounding noise, and drawn as a straight line.
    """
    quantity, unit = curves[0].quantity, _unit(curves[0].unit)
    plot.set_title(f"{symbol}, {unit}", loc="left", fontsize=_points(0.0335))
    plot.grid(color=style.hairline, linewidth=_points(0.0012))
    plot.axhline(0.0, color=style.grey, linewidth=_points(0.0020), zorder=1.0)
    plot.set_axisbelow(True)
    plot.spines[["top", "right", "left", "bottom"]].set_visible(False)
    plot.tick_params(length=0, pad=8)
    steps = _ANGLES if quantity == "angle" else _NUMBERS
    plot.yaxis.set_major_locator(MaxNLocator(5, steps=steps))
    plot.yaxis.set_major_formatter(_Parted())
    low, high = limits(np.concatenate([curve.values for curve in curves]))
    room = 0.06 * (high - low)
    if high - low <= _NOTHING * scale:
        room = abs(0.1 * high) if abs(high) > _NOTHING * scale else 1.0
    plot.set_ylim(low - room, high + room)
    power = plot.yaxis.get_offset_text()  # a ×10⁶ would stand in the title's way
    power.set_horizontalalignment("right")
    power.set_x(1.0)


def _input_axis(plot: Axes, results: Results) -> None:
    given = results.place
    driver = _name(results.driver)
    plot.xaxis.set_major_formatter(_Parted())
    plot.set_xlabel(f"{given.quantity} of the {driver}, {_unit(given.unit)}")
    plot.xaxis.set_major_locator(MaxNLocator(6, steps=_NUMBERS))
    low, high = float(given.values.min()), float(given.values.max())
    if given.quantity == "angle" and 180.0 <= high - low <= 720.0:
        plot.xaxis.set_major_locator(MultipleLocator(60.0 if high - low <= 360.0 else 120.0))
    plot.set_xlim(low, high)


def _points(share: float) -> float:
    """Return a fraction of the picture's height in points."""
    return share * _SIZE[1] * 72.0 / _DPI


def _share(size: float) -> float:
    """Return a fraction of the picture's height as one of its width."""
    return size * _SIZE[1] / _SIZE[0]


def _name(row: Curves) -> str:
    """Return a row's name with its letters in italics: rod BC, slider B."""
    return f"{_plain(row).removesuffix(row.letters)}$\\mathit{{{row.letters}}}$"


def _plain(row: Curves) -> str:
    name, letters = _ENGLISH.name(row.name), f" {row.letters}"
    return name.removesuffix(letters).removesuffix(letters.lower()) + letters


def _unit(name: str) -> str:
    """Return the sign of a unit; the font's own ² is too bold."""
    return _powers(sign(name))


def _powers(text: str) -> str:
    """Return a text with its powers as mathematics, whose font has all of their digits."""
    plain = str.maketrans(_RAISED, "-0123456789")
    return re.sub(f"[{_RAISED}]+", lambda power: f"$^{{{power[0].translate(plain)}}}$", text)


class _Parted(ScalarFormatter):
    """The numbers of an axis, in thousands like all others."""

    def __call__(self, value: float, position: int | None = None) -> str:
        text = super().__call__(value, position)
        return re.sub(
            r"(?<![.\d])\d{5,}", lambda whole: typeset(whole[0]).replace(THIN_SPACE, r"\,"), text
        )


@dataclass(frozen=True, slots=True)
class Ending:
    """A curve's name and colour, and its last value."""

    name: str
    colour: str
    value: float


def name_ends(plot: Axes, ends: Sequence[Ending], size: float) -> None:
    """Write each name to the right of the plot, as high as its curve ends.

    The range of the plot must be set; ``size`` is that of the type in points.  Names keep the order
    of the ends.
    """
    bottom, top = plot.get_ylim()
    pitch = _PITCH * size / (plot.get_window_extent().height * 72.0 / plot.figure.dpi)
    ordered = sorted(ends, key=lambda end: end.value)
    shares = [
        min(max((end.value - bottom) / (top - bottom), pitch / 2), 1.0 - pitch / 2)
        for end in ordered
    ]
    for end, share in zip(ordered, apart(shares, pitch), strict=True):
        plot.annotate(
            end.name,
            (1.0, share),
            (_GAP * size, 0.0),
            xycoords="axes fraction",
            textcoords="offset points",
            color=end.colour,
            fontsize=size,
            verticalalignment="center_baseline",
            annotation_clip=False,
        )


def apart(shares: Sequence[float], pitch: float) -> list[float]:
    """Return ascending places between 0 and 1, moved as little as need be to be ``pitch`` apart.

    Examples
    --------
    >>> apart([0.0, 0.125, 0.75, 0.75], 0.25)
    [0.0, 0.25, 0.625, 0.875]
    """
    groups: list[list[float]] = []
    for share in shares:
        groups.append([share])
        # Each round joins two groups.
        while len(groups) > 1 and _first(groups[-1], pitch) - _last(groups[-2], pitch) < pitch:
            last = groups.pop()
            groups[-1] += last
    return [_first(group, pitch) + pitch * count for group in groups for count in range(len(group))]


def _first(group: Sequence[float], pitch: float) -> float:
    """Return the first of some places that stand together about their middle, inside 0 and 1."""
    reach = pitch * (len(group) - 1)
    return min(max(sum(group) / len(group) - reach / 2, 0.0), 1.0 - reach)


def _last(group: Sequence[float], pitch: float) -> float:
    return _first(group, pitch) + pitch * (len(group) - 1)

"""A sweep as a plot: in come a motion and its columns, out goes a PNG picture.

Positions, velocities and accelerations stand one above the other, links to the left, slides to
the right, over the input; the driver itself is left out, for its motion is given.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from dataclasses import fields
from typing import IO, Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, MultipleLocator
from numpy.typing import NDArray

from vad.export.sweep.results import Column, Curves, Results
from vad.kinematics.motion import Motions
from vad.style import Style, load_style
from vad.units import scene_unit
from vad.written import WRITTEN_OUT, quantity, sign

_SIZE, _DPI = (1600, 1200), 100
_SYMBOLS = {
    "angle": "$\\theta$",
    "omega": "$\\omega$",
    "alpha": "$\\alpha$",
    "position": "$s$",
    "velocity": "$v$",
    "acceleration": "$a$",
}
_LINE = 110  # characters of the smallest type on one line
# Where this share of the poses at either end makes the range so much wider, it is cut off.
_TAIL, _PEAK = 4.0, 6.0
_NOTHING = 1e-9
_ORDERS = 3
_RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_HARD_SPACE = "\N{NO-BREAK SPACE}"


def plot(motion: Motions, results: Results, file: IO[bytes]) -> None:
    """Write the plot of a sweep."""
    style = load_style("paper")
    settings: dict[Any, Any] = {
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
    with mpl.rc_context():
        mpl.rcdefaults()  # the user's own settings are for the user's own plots
        mpl.rcParams.update(settings)
        figure = Figure((_SIZE[0] / _DPI, _SIZE[1] / _DPI), dpi=_DPI, facecolor=style.background)
        _head(figure, motion, style)
        _curves(figure, results, style)
        title = f"{motion.mechanism.title}: a sweep of its {results.place.quantity}"
        figure.savefig(file, format="png", metadata={"Title": title})


def _head(figure: Figure, motion: Motions, style: Style) -> None:
    """Write the mechanism's name, its dimensions and the rates of its input."""
    mechanism, (_, *rates) = motion.mechanism, motion.inputs.items()
    quantities = {field.name: field.metadata["quantity"] for field in fields(mechanism)}
    given = [
        (_words(name), value, quantities[name]) for name, value in mechanism.parameters().items()
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


def _curves(figure: Figure, results: Results, style: Style) -> None:
    """Draw the links' and the slides' motion, each row of the results in its own ink."""
    rows = (*results.links, *results.slides)
    inks = {id(row): style.colour("row", place) for place, row in enumerate(rows)}
    groups = [[row for row in group if not row.driven] for group in (results.links, results.slides)]
    drawn = [group for group in groups if group]
    plots = figure.subplots(_ORDERS, len(drawn), sharex=True, squeeze=False)
    figure.subplots_adjust(0.10, 0.085, 0.965, 0.735, wspace=0.26, hspace=0.40)
    spin = _largest([row.columns[1] for row in results.links])
    for group, column in zip(drawn, plots.T, strict=True):
        size = _largest([row.columns[0] for row in group])
        for order, plot in enumerate(column):
            for row in group:
                values = row.columns[order].values
                plot.plot(
                    results.place.values,
                    _broken(values) if row.columns[order].quantity == "angle" else values,
                    color=inks[id(row)],
                    linewidth=_points(0.0040),
                    label=_name(row),
                )
            _dress(plot, [row.columns[order] for row in group], size * spin**order, style)
        _legend(column[0], len(group))
        _input_axis(column[-1], results)


def _dress(plot: Axes, curves: Sequence[Column], scale: float, style: Style) -> None:
    """Name the quantity, fit its range and leave a grid in place of a box.

    What is nothing to ``scale`` is rounding, and shown as the straight line that it stands for.
    """
    quantity, unit = curves[0].quantity, sign(curves[0].unit)
    plot.set_title(f"{_SYMBOLS[quantity]}, {unit}", loc="left", fontsize=_points(0.0335))
    plot.grid(color=style.hairline, linewidth=_points(0.0012))
    plot.set_axisbelow(True)
    plot.spines[["top", "right", "left", "bottom"]].set_visible(False)
    plot.tick_params(length=0, pad=8)
    plot.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))
    low, high = _limits(np.concatenate([curve.values for curve in curves]))
    if quantity == "angle" and high - low > 300.0:
        low, high = 0.0, 360.0
        plot.yaxis.set_major_locator(MultipleLocator(90.0))
    room = 0.06 * (high - low)
    if high - low <= _NOTHING * scale:
        room = abs(0.1 * high) if abs(high) > _NOTHING * scale else 1.0
    plot.set_ylim(low - room, high + room)
    power = plot.yaxis.get_offset_text()  # a ×10⁶ would stand in the title's way
    power.set_horizontalalignment("right")
    power.set_x(1.0)


def _legend(plot: Axes, count: int) -> None:
    plot.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.30),
        ncols=count,
        frameon=False,
        borderaxespad=0.0,
        borderpad=0.0,
        handlelength=1.2,
        handletextpad=0.4,
        columnspacing=1.2,
        fontsize=_points(0.030),
    )


def _input_axis(plot: Axes, results: Results) -> None:
    given = results.place
    driver = _name(results.driver)
    plot.set_xlabel(f"{given.quantity} of the {driver}, {sign(given.unit)}")
    plot.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
    low, high = float(given.values.min()), float(given.values.max())
    if given.quantity == "angle" and 180.0 <= high - low <= 720.0:
        plot.xaxis.set_major_locator(MultipleLocator(60.0 if high - low <= 360.0 else 120.0))
    plot.set_xlim(low, high)


def _broken(degrees: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return angles with a gap where they pass from 360 to 0, lest a line be drawn across."""
    broken = degrees.copy()
    with np.errstate(invalid="ignore"):
        broken[1:][np.abs(np.diff(degrees)) > 180.0] = np.nan
    return broken


def _limits(values: NDArray[np.float64]) -> tuple[float, float]:
    """Return the range to show: all of it, unless a few poses near a dead centre dwarf the rest."""
    values = values[np.isfinite(values)]
    if not values.size:
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    inner = np.percentile(values, [_TAIL, 100.0 - _TAIL])
    most = float(inner[1] - inner[0])
    if most and high - low > _PEAK * most:
        low, high = max(low, float(inner[0]) - most), min(high, float(inner[1]) + most)
    return low, high


def _largest(columns: Sequence[Column]) -> float:
    """Return the largest magnitude that is shown of ``columns``."""
    return max(map(abs, _limits(np.concatenate([column.values for column in columns]))))


def _points(share: float) -> float:
    """Return a fraction of the picture's height in points."""
    return share * _SIZE[1] * 72.0 / _DPI


def _name(row: Curves) -> str:
    """Return a row's name with its letters: rod BC, slider B."""
    return f"{_words(row.name).removesuffix(' ' + row.letters.lower())} {row.letters}"


def _powers(text: str) -> str:
    """Return a text with its powers as mathematics, whose font has all of their digits."""
    plain = str.maketrans(_RAISED, "-0123456789")
    return re.sub(f"[{_RAISED}]+", lambda power: f"$^{{{power[0].translate(plain)}}}$", text)


def _words(name: str) -> str:
    return name.replace("_", " ")

"""A sweep as a plot: a picture of all columns of a motion.

Positions, velocities and accelerations stand one above the other, links to the left, slides to
the right, over the input; the driver itself is left out, for its motion is given.  Each curve has
its name at its end, and the names never touch.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import BinaryIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from vad.export import plotting
from vad.export.plotting import NAME, NAME_GAP, SYMBOLS, Look, curves_of, dress, place_axis
from vad.export.sweep import (
    Column,
    Curves,
    Results,
    check_closes,
    largest,
    results_of,
    unwrapped,
)
from vad.kinematics.motion import Motions
from vad.kinematics.solver import Solver
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import roman
from vad.statics.burden import Burden
from vad.strokes.members import members_of
from vad.written import base_name

#: By how much a picture with forces is wider: they are a further column.
_WIDER = 1.5
_ORDERS = 3


def write(
    motion: Motions,
    target: BinaryIO,
    burden: Burden | None = None,
    style: str | None = None,
    language: str | None = None,
) -> None:
    """Write the plot of a motion's results, and of its forces.

    Raises
    ------
    vad.errors.AssemblyError
        If none of the poses can be assembled.
    """
    write_as("png", motion, target, burden, Look.of(style, language, motion.mechanism))


def write_as(
    kind: str, motion: Motions, target: BinaryIO, burden: Burden | None, look: Look
) -> None:
    """Write the plot as a file of a kind: png, svg or pdf."""
    check_closes(bool(np.any(motion.assembled)))
    results, (_, *rates) = results_of(motion, burden), motion.inputs.items()
    title = f"{motion.mechanism.title}: a sweep of its {results.place.quantity}"
    wider = _WIDER if results.forces else 1.0
    with plotting.new_figure(target, kind, look, title, wider) as figure:
        plotting.head(figure, motion.mechanism, dict(rates), look)
        _curves(figure, results, _symbols(motion, results), look)


def _symbols(motion: Motions, results: Results) -> dict[str, str]:
    """Return the symbols of the slides' positions."""
    if not isinstance(motion.solver, Solver):
        return {row.name: "s" for row in results.slides}
    members = members_of(motion.mechanism)
    return {row.name: members.slide_letter(row.name) for row in results.slides}


def _curves(figure: Figure, results: Results, symbols: Mapping[str, str], look: Look) -> None:
    """Draw the links' and the slides' motion, each row of the results in its own ink.

    ``symbols`` are those of the slides' positions.
    """
    rows = (*results.turning, *results.slides)
    inks = {id(row): place for place, row in enumerate(rows)}
    groups = [
        [row for row in group if not row.driven] for group in (results.turning, results.slides)
    ]
    drawn = [group for group in groups if group]
    loaded = _sizes(results, look)
    plots = figure.subplots(_ORDERS, len(drawn) + bool(loaded), sharex=True, squeeze=False)
    names = [name for name, _ in loaded[1:]] or [_plain(row, look) for row in drawn[-1]]
    wider = _WIDER if loaded else 1.0
    longest = max(plotting.share_of_width(width(roman(name), NAME)) for name in names)
    right = min(0.885, 0.98 - (NAME_GAP + longest) / wider)
    figure.subplots_adjust(0.09 / wider, 0.085, right, 0.775, wspace=0.60, hspace=0.40)
    spin = largest([row.columns[1] for row in results.turning])
    for group, column in zip(drawn, plots.T, strict=False):
        size = largest([row.columns[0] for row in group])
        for order, plot in enumerate(column):
            curves = [unwrapped(row.columns[order]) for row in group]
            signs = [
                f"${symbols[row.name]}$"
                if curve.quantity == "position"
                else SYMBOLS[curve.quantity]
                for row, curve in zip(group, curves, strict=True)
            ]
            dress(plot, curves, " / ".join(dict.fromkeys(signs)), size * spin**order, look)
            ends = [
                (_name(row, look), inks[id(row)], curve)
                for row, curve in zip(group, curves, strict=True)
            ]
            curves_of(plot, results.place.values, ends, look)
        _input_axis(column[-1], results, look)
    if loaded:
        _forces(plots.T[-1], results, loaded, look)


def _sizes(results: Results, look: Look) -> list[tuple[str, Column]]:
    """Return the drive, and the size of the force in each joint, with their names."""
    found, say = [], look.say
    for row in results.forces:
        one, _, other = row.name.removesuffix(".force").partition(".")
        name = say.name(row.name)
        if other:
            name = say.say("force of one on another", one=say.name(one), other=say.name(other))
        value = row.columns[0].values
        if len(row.columns) > 1:
            value = np.hypot(value, row.columns[1].values)
        found.append((name, replace(row.columns[0], values=value)))
    return found


def _forces(
    plots: Sequence[Axes], results: Results, loaded: Sequence[tuple[str, Column]], look: Look
) -> None:
    """Draw the drive, and below it the sizes of the forces in the joints."""
    symbols = "$T$" if results.place.quantity == "angle" else "$F$", "$F$"
    for plot, symbol, rows in zip(plots, symbols, (loaded[:1], loaded[1:]), strict=False):
        curves = [column for _, column in rows]
        dress(plot, curves, symbol, largest(curves), look)
        ends = [(name, i, each) for i, (name, each) in enumerate(rows)]
        curves_of(plot, results.place.values, ends, look)
    plots[-1].set_visible(False)
    _input_axis(plots[1], results, look)
    plots[1].tick_params(labelbottom=True)


def _input_axis(plot: Axes, results: Results, look: Look) -> None:
    row, place = results.driver, results.place
    place_axis(plot, place, plotting.driver_text(look, row.name, row.letters, place.quantity), look)


def _name(row: Curves, look: Look) -> str:
    """Return a row's name with its letters in italics: rod BC, slider B."""
    return plotting.italic(_word(row, look), row.letters)


def _plain(row: Curves, look: Look) -> str:
    return plotting.plain(_word(row, look), row.letters) + row.letters


def _word(row: Curves, look: Look) -> str:
    """Return the name of a link, a slide or a joint without its letters."""
    if row.name.endswith(f"_{row.letters.lower()}"):  # one of several slides that are called alike
        return look.say.name(base_name(row.name))
    return look.say.name(row.name.removesuffix(f" {row.letters}"))

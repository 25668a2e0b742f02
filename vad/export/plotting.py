"""What all plots of sweeps have in common: type, axes, the head and names at the ends of curves."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, BinaryIO

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, MultipleLocator, ScalarFormatter
from numpy.typing import NDArray

from vad.export.sweep import Column, limits
from vad.style import Style, load_style
from vad.units import DIMENSIONS, scene_unit
from vad.words import Gap, Language
from vad.written import THIN_SPACE, WRITTEN_OUT, quantity, sign, typeset

if TYPE_CHECKING:
    from vad.mechanisms import Mechanism

_SIZE, _DPI = (1600, 1200), 100
#: The symbols of quantities.
SYMBOLS = {
    "angle": "$\\theta$",
    "omega": "$\\omega$",
    "alpha": "$\\alpha$",
    "position": "$s$",
    "distance": "$s$",
    "velocity": "$v$",
    "acceleration": "$a$",
    "coriolis": "$a_\\mathrm{C}$",
    "transmission": "$\\mu$",
    "force": "$F$",
}
_LINE = 110  # characters of the usual type on one line
#: The type of what is given, in heights of the picture, and its least share where it is much.
_GIVEN, _SMALL = 0.028, 0.75
_NOTHING = 1e-9
#: The type of names at the ends of curves, and the gap before them, in heights of the picture.
NAME, NAME_GAP = 0.026, 0.01
_RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
#: Ticks of an angle stand at 15°, 30°, 45°, 60°, 90° …, all others at round numbers.
_ANGLES, _NUMBERS = (1, 1.5, 3, 4.5, 6, 9, 10), (1, 2, 2.5, 5, 10)
_HARD_SPACE = "\N{NO-BREAK SPACE}"
#: From the plot to a name, and from one name's middle to the next one's, in type sizes.
_GAP, _PITCH = 0.5, 1.15
#: What a file of each kind says of its making, so that the same sweep is the same file.
_DATED = {"png": {}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}


@dataclass(frozen=True, slots=True)
class Look:
    """How a plot looks, and in which language its words are."""

    style: Style
    say: Language

    @classmethod
    def of(cls, style: str | None, language: str | None, mechanism: Mechanism) -> Look:
        """Return a look by the names of a style and of a language; None is the usual one.

        The mechanism may bring names of its own in that language.
        """
        return cls(load_style(style or "paper"), Language(language or "en", mechanism.own_names))


@contextmanager
def new_figure(
    target: BinaryIO, kind: str, look: Look, title: str, wider: float = 1.0
) -> Iterator[Figure]:
    """Yield a figure that is saved as a file of a kind, png, svg or pdf, when the block ends."""
    with mpl.rc_context():
        mpl.rcdefaults()  # the user's own settings are for the user's own plots
        mpl.rcParams.update(settings(look.style))
        size = _SIZE[0] * wider / _DPI, _SIZE[1] / _DPI
        figure = Figure(size, dpi=_DPI, facecolor=look.style.background)
        yield figure
        metadata: dict[str, Any] = {"Title": title, **_DATED[kind]}
        figure.savefig(target, format=kind, metadata=metadata)


def settings(style: Style) -> dict[Any, Any]:
    """Return what matplotlib is told: one type for all, and the colours of a style."""
    return {
        "font.family": "STIXGeneral",
        "mathtext.fontset": "stix",
        "font.size": points(0.028),
        "axes.formatter.limits": (WRITTEN_OUT[0] - 1, WRITTEN_OUT[1]),
        "axes.formatter.use_mathtext": True,
        "svg.hashsalt": "vad",
        "pdf.fonttype": 42,
        "text.color": style.text,
        "axes.labelcolor": style.text,
        "xtick.color": style.grey,
        "ytick.color": style.grey,
    }


def head(figure: Figure, mechanism: Mechanism, inputs: Mapping[str, Any], look: Look) -> None:
    """Write the mechanism's name, and those of its dimensions and inputs that are one number."""
    say, point = look.say, look.say.point
    quantities = {field.name: field.metadata["quantity"] for field in fields(mechanism)}
    given = [
        (say.name(name), value, quantities[name])
        for name, value in mechanism.parameters().items()
        if quantities[name] in DIMENSIONS
    ]
    given += [(f"{SYMBOLS[name]} =", value, name) for name, value in inputs.items()]
    items = []
    for name, value, kind in given:
        if value is not None and np.ndim(value) == 0:
            unit = sign(scene_unit(kind, mechanism.length_unit))
            items.append(f"{name} {quantity(value, unit, given=True).replace('.', point)}")
    joined = "   ".join(item.replace(" ", _HARD_SPACE) for item in items)
    lines = textwrap.wrap(joined, _LINE)
    size, most = _GIVEN, _LINE
    if len(lines) > 2:  # a third line would lie on the first plot
        size, most = _SMALL * _GIVEN, int(_LINE / _SMALL)
    figure.text(0.03, 0.94, say.name(mechanism.title), fontsize=points(0.050), weight="bold")
    figure.text(
        0.03,
        0.915,
        powers(textwrap.fill(joined, most)),
        color=look.style.grey,
        fontsize=points(size),
        verticalalignment="top",
    )


def curves_of(
    plot: Axes,
    places: NDArray[np.float64],
    rows: Sequence[tuple[str, int, Column]],
    look: Look,
    named: bool = True,
) -> None:
    """Draw curves over the places: each has its name, the row whose ink it takes, and values."""
    ends = []
    for name, row, column in rows:
        ink, dash = look.style.colour("row", row), look.style.line(row).dash
        style = (0, dash) if dash else "-"
        plot.plot(places, column.values, color=ink, linestyle=style, linewidth=points(0.0040))
        known = np.flatnonzero(np.isfinite(column.values))
        if known.size:
            ends.append(Ending(name, ink, column.values[known[-1]]))
    if named:
        name_ends(plot, ends, points(NAME))


def place_axis(plot: Axes, places: Column, text: str, look: Look) -> None:
    """Name what runs along the axis below a plot, and set its range."""
    plot.xaxis.set_major_formatter(_Parted(look.say.point))
    plot.set_xlabel(f"{text}, {unit_sign(places.unit)}")
    plot.xaxis.set_major_locator(MaxNLocator(6, steps=_NUMBERS))
    low, high = float(places.values.min()), float(places.values.max())
    if places.quantity == "angle" and 180.0 <= high - low <= 720.0:
        plot.xaxis.set_major_locator(MultipleLocator(60.0 if high - low <= 360.0 else 120.0))
    plot.set_xlim(low, high)


def driver_text(look: Look, name: str, letters: str, place: str) -> str:
    """Return what runs along the axis: the angle of the crank AB, the position of the slider A."""
    template = look.say.template(f"{place} of the driver")
    return "".join(
        italic(look.say.noun(name, each.article), letters) if isinstance(each, Gap) else each.text
        for each in template
    )


def italic(name: str, letters: str) -> str:
    """Return a name with its letters in italics: rod BC, slider B."""
    return f"{plain(name, letters)}$\\mathit{{{letters}}}$"


def plain(name: str, letters: str) -> str:
    """Return a name without its letters, and with the space before them."""
    end = f" {letters}"
    return name.removesuffix(end).removesuffix(end.lower()) + " "


def dress(plot: Axes, curves: Sequence[Column], symbol: str, scale: float, look: Look) -> None:
    """Name the quantity, set the range of its axis and draw a grid instead of a frame.

    Values that are tiny beside ``scale`` are rounding noise, and drawn as a straight line.
    """
    quantity, unit = curves[0].quantity, unit_sign(curves[0].unit)
    title = ", ".join(filter(None, (symbol, unit)))
    plot.set_title(title, loc="left", fontsize=points(0.0335))
    style = look.style
    plot.set_facecolor(style.background)
    plot.grid(color=style.hairline, linewidth=points(0.0012))
    plot.axhline(0.0, color=style.grey, linewidth=points(0.0020), zorder=1.0)
    plot.set_axisbelow(True)
    plot.spines[["top", "right", "left", "bottom"]].set_visible(False)
    plot.tick_params(length=0, pad=8)
    steps = _ANGLES if quantity == "angle" else _NUMBERS
    plot.yaxis.set_major_locator(MaxNLocator(5, steps=steps))
    plot.yaxis.set_major_formatter(_Parted(look.say.point))
    low, high = limits(np.concatenate([curve.values for curve in curves]))
    room = 0.06 * (high - low)
    if high - low <= _NOTHING * scale:
        room = abs(0.1 * high) if abs(high) > _NOTHING * scale else 1.0
    plot.set_ylim(low - room, high + room)
    power = plot.yaxis.get_offset_text()  # a ×10⁶ would stand in the title's way
    power.set_horizontalalignment("right")
    power.set_x(1.0)


def points(share: float) -> float:
    """Return a fraction of the picture's height in points."""
    return share * _SIZE[1] * 72.0 / _DPI


def share_of_width(size: float) -> float:
    """Return a fraction of the picture's height as one of its width."""
    return size * _SIZE[1] / _SIZE[0]


def unit_sign(name: str) -> str:
    """Return the sign of a unit; the font's own ² is too bold."""
    return powers(sign(name))


def powers(text: str) -> str:
    """Return a text with its powers as mathematics, whose font has all of their digits."""
    plain = str.maketrans(_RAISED, "-0123456789")
    return re.sub(f"[{_RAISED}]+", lambda power: f"$^{{{power[0].translate(plain)}}}$", text)


class _Parted(ScalarFormatter):
    """The numbers of an axis: in thousands, and with the decimal sign, like all others."""

    def __init__(self, point: str) -> None:
        super().__init__()
        self._point = "." if point == "." else f"{{{point}}}"

    def __call__(self, value: float, position: int | None = None) -> str:
        text = super().__call__(value, position)
        parted = re.sub(
            r"(?<![.\d])\d{5,}", lambda whole: typeset(whole[0]).replace(THIN_SPACE, r"\,"), text
        )
        return parted.replace(".", self._point)


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
    edge = pitch / 2.0
    inside = 1.0 - pitch  # the middle of a name keeps so far from both ends of the axis
    shares = [
        min(max(((end.value - bottom) / (top - bottom) - edge) / inside, 0.0), 1.0)
        for end in ordered
    ]
    for end, place in zip(ordered, apart(shares, pitch / inside), strict=True):
        share = edge + inside * place
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

"""The names of curves at their ends: in come places in a plot, out go texts that never touch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from matplotlib.axes import Axes

#: From the plot to a name, and from one name's middle to the next one's, in type sizes.
_GAP, _PITCH = 0.5, 1.15


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

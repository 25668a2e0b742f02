"""Names beside markers, each where it covers no marker and no other name."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from matplotlib.patheffects import withStroke
from matplotlib.text import Text

#: Where a name may stand: its offset from the marker in points, and how it is aligned.
PLACES = [
    ((9, 0), "left", "center"),
    ((-9, 0), "right", "center"),
    ((0, 8), "center", "bottom"),
    ((0, -8), "center", "top"),
    ((7, 9), "left", "bottom"),
    ((7, -9), "left", "top"),
    ((-7, 9), "right", "bottom"),
    ((-7, -9), "right", "top"),
    *(
        ((side * 16, way * far), "left" if side > 0 else "right", "center")
        for far in (26, 40, 54, 68, 82, 96)
        for way in (1, -1)
        for side in (1, -1)
    ),
]


def place_labels(
    panel: Any,
    labels: Iterable[tuple[str, float, float, str]],
    points: Iterable[tuple[float, float]],
) -> None:
    """Write every name beside its marker; far ones get a thin line to it."""
    spots = [panel.transData.transform(point) for point in points]
    taken: list[Any] = []
    for name, x, y, ink in labels:
        for offset, across, upright in PLACES:
            far = abs(offset[1]) > 10
            text = panel.annotate(
                name,
                (x, y),
                xytext=offset,
                textcoords="offset points",
                ha=across,
                va=upright,
                color=ink,
                fontsize=9,
                path_effects=[withStroke(linewidth=3, foreground="white")],
                arrowprops={"arrowstyle": "-", "lw": 0.5, "color": ink} if far else None,
            )
            text.get_window_extent()  # puts the text into its place
            box = Text.get_window_extent(text)  # without the line to the marker
            inside = panel.bbox.contains(box.x0, box.y0) and panel.bbox.contains(box.x1, box.y1)
            hits = any(box.padded(2).contains(*spot) for spot in spots)
            if inside and not hits and not any(box.overlaps(other) for other in taken):
                break
            text.remove()
        else:
            raise RuntimeError(f"no room for {name}")
        taken.append(box)

"""A sheet as JSON: the strokes in drawing order, the same data that is painted and animated.

In comes a `Sheet`, out goes an object with a panel per diagram.  Coordinates are ``[x, y]`` in the
panel's unit, printed in full; what a stroke has not is absent.
"""

from __future__ import annotations

import json
from typing import Any, BinaryIO

from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Shape, Sheet, Stroke


def write(
    sheet: Sheet,
    stream: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
) -> None:
    """Write ``sheet`` to ``stream``, a stroke a line; how pictures look makes no difference."""
    stream.write(to_text(sheet).encode())


def to_dict(sheet: Sheet) -> dict[str, Any]:
    """Return ``sheet`` as dictionaries, lists, strings and numbers."""
    return {
        "mechanism": sheet.mechanism,
        "panels": {
            panel.name: {
                "unit": _unit(panel),
                "strokes": [_stroke(stroke) for stroke in panel.strokes],
            }
            for panel in sheet.panels
        },
    }


def to_text(sheet: Sheet) -> str:
    """Return ``sheet`` as JSON with one stroke a line."""
    panels = ",\n".join(_panel_text(panel) for panel in sheet.panels)
    return f'{{"mechanism": {_text(sheet.mechanism)},\n "panels": {{\n{panels}}}}}\n'


def _panel_text(panel: Panel) -> str:
    strokes = ",\n".join("    " + _text(_stroke(stroke)) for stroke in panel.strokes)
    return f'  {_text(panel.name)}: {{"unit": {_text(_unit(panel))}, "strokes": [\n{strokes}]}}'


def _unit(panel: Panel) -> str:
    """Return the unit as the JSON of ``vad solve`` spells it: mm/s^2."""
    return panel.unit.replace("²", "^2")


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _stroke(stroke: Stroke) -> dict[str, Any]:
    entries = {
        "kind": stroke.kind,
        "label": stroke.label,
        "component": stroke.component,
        "link": stroke.link,
        **_shape(stroke.shape),
        "caption": stroke.caption,
    }
    return {key: value for key, value in entries.items() if value is not None}


def _shape(shape: Shape) -> dict[str, Any]:
    match shape:
        case Dot(at):
            return {"at": _xy(at)}
        case Arrow(start, end):
            return {"from": _xy(start), "to": _xy(end)}
        case Line(through, direction):
            return {"through": _xy(through), "direction": _xy(direction)}
        case Arc(centre, radius, start, sweep, through):
            return {
                "centre": _xy(centre),
                "radius": float(radius),
                "start": float(start),
                "sweep": float(sweep),
                "through": _xy(through),
            }
        case Guide(through, direction, side):
            return {"through": _xy(through), "direction": _xy(direction), "side": _xy(side)}
        case Block(at, direction, on):
            return {"at": _xy(at), "direction": _xy(direction), "on": on}


def _xy(point: complex | None) -> list[float] | None:
    # Adding 0 turns -0.0 into 0.0, and complex() numpy's numbers into Python's.
    return None if point is None else [complex(point).real + 0.0, complex(point).imag + 0.0]

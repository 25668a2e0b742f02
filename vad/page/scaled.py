"""The scales of a page that is turned: each polygon follows its size, and a bar states its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from vad.page.ink import Inker
from vad.page.outputs import Outputs
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.hand_board import HandBoard, scale_inputs
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import bold, roman
from vad.plan.page.heads import APART, TITLE
from vad.plan.pictures.polygon import BAR_OFF, WIDEST_BAR
from vad.plan.reach import corners
from vad.plan.scale import (
    LONGEST_BAR,
    SCALE_SIZE,
    VIEWS_SLACK,
    Scale,
    bar_box,
    bar_marks,
    padded,
)
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Panel


@dataclass(frozen=True)
class Scaled:
    """A polygon, or a mechanism with other dimensions, whose scale follows its size."""

    board: HandBoard
    plan: Plan
    half: Panel

    def data(self, outputs: Outputs) -> dict[str, Any]:
        """Return it as ``scales.js`` reads it: its inputs, corners and room, and its bar."""
        board, half, notation = self.board, self.half, self.plan.sheet.notation
        first = next(iter(scale_inputs(half.name, Scale(0j, 1.0))))
        scale, unit = board.scales[half.name], notation.unit(half.unit)
        corner = {z: None for z in corners(half)}
        bar = not scale.bare and {
            "unit": unit,
            "unitWide": round(width(roman(f"\u00a0{unit}"), SCALE_SIZE), 5),
            "factor": notation.scaled(1.0, half.unit),
        }
        return {
            "input": list(board.traced.inputs).index(first),
            "corners": outputs.listed(map(scale, corner)),
            "mechanism": half.picture != "vectors",
            **self._in(self._room),
            "bar": bar and {**bar, **self._bar_in(self._room)},
        }

    def placed(self, sketch: Sketch) -> dict[str, Any]:
        """Return what is different where the panel is large: its room, bar and first scale."""
        room, start = sketch.setting.room, scale_inputs(self.half.name, sketch.scale)
        return {**self._in(room), "bar": self._bar_in(room), "start": [*start.values()]}

    def _in(self, room: Rect) -> dict[str, Any]:
        """Return the room that it is to fill, within its own."""
        views = self.half.picture == "views"
        inner = room.inside(-VIEWS_SLACK) if views else room
        return {"inner": edges(padded(inner, self.half.picture == "skeleton"))}

    def _bar_in(self, room: Rect) -> dict[str, Any]:
        """Return where its bar stands, and the room for that."""
        start = self._start(room)
        return {
            "room": round(self._bar_room(room), 5),
            "at": [round(start.real, 5), round(start.imag, 5)],
        }

    def lower_bar(self, number: int, inker: Inker, since: str) -> str:
        """Return the elements of the bar of a polygon below another, seen as an attribute says."""
        text, bar, _ = bar_marks(0.1, roman("0"), self._start(self._room))
        return f'<g data-bar="{number}"{since}>{inker.mark(text)}{inker.mark(bar)}</g>'

    @property
    def bar_box(self) -> Rect:
        """What the bar of a polygon below another takes at most, with its value."""
        return bar_box(LONGEST_BAR, roman(f"500 {self.half.unit}"), self._start(self._room))

    @property
    def _room(self) -> Rect:
        return self.board.live.room(self.half, self.plan.sheet)

    def _start(self, room: Rect) -> complex:
        return complex(room.left, room.bottom + BAR_OFF)

    def _bar_room(self, room: Rect) -> float:
        if self.half.name != self.half.column:
            return WIDEST_BAR * room.width
        return room.width - width(bold(roman(self.half.title)), TITLE) - APART


def edges(room: Rect) -> list[float]:
    """Return the edges of a room: left, lower, right, upper."""
    return [round(each, 5) for each in (room.left, room.bottom, room.right, room.top)]

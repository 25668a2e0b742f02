"""The heads of a page's panels: title and scale share a line, and neither touches the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from vad.painting.svg_elements import number
from vad.plan.board import Plan
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, bold, roman
from vad.plan.page.heads import APART, TITLE, head_share
from vad.plan.scale import bar
from vad.strokes.sheet import Panel

if TYPE_CHECKING:
    from vad.page.parts import RunWriter


def scale_bar(board: Plan, panel: Panel, words: RunWriter) -> str:
    """Return the scale of a panel; nothing where it has none."""
    if board.sketches[panel.name].scale.bare:
        return ""
    length, runs = _bar(board, panel)
    return (
        f'<p class="scale"><span class="bar" style="--n:{number(length * board.form.unit)}">'
        f"</span>{words.of(runs)}</p>"
    )


def head_size(board: Plan, panel: Panel) -> str:
    """Return the declaration by how much a head is smaller; nothing where it has room."""
    if board.sketches[panel.name].scale.bare:
        return ""
    room = board.page.panels[panel.name].drawing.width
    share = head_share(bold(roman(panel.title)), *_bar(board, panel), room)
    return f";--head:{number(share, 3)}" if share < 1.0 else ""


def _bar(board: Plan, panel: Panel) -> tuple[float, Runs]:
    """Return the length of the scale bar of a panel, and what it says."""
    title, place = bold(roman(panel.title)), board.page.panels[panel.name]
    room = place.drawing.width - width(title, TITLE) - APART
    return bar(panel, board.sketches[panel.name].scale, room, board.sheet.notation)

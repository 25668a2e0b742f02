"""The panels of a page: heads and equations in words, the drawings between them.

In comes a board, out goes HTML.
"""

from __future__ import annotations

from html import escape

from vad.lecture.moment import drawing
from vad.page.ink import Inker, when
from vad.page.themed import lettered
from vad.page.wording import Words
from vad.painting.svg.grid import number
from vad.plan.board import Plan
from vad.plan.items import FOREVER
from vad.plan.lettering.runs import roman
from vad.plan.opening import reach
from vad.plan.page.foot import Piece, compose
from vad.plan.page.heads import bar
from vad.strokes.sheet import Panel


def panel_section(board: Plan, panel: Panel, inker: Inker, words: Words) -> str:
    """Return a panel: its head, its drawing, and its equations."""
    unit = board.form.unit
    sketch, place = board.sketches[panel.name], board.page.panels[panel.name]
    begun = when([(drawing(sketch.setting.first), FOREVER)])
    area, ink = place.drawing, reach(i for i in board.items if i.region == panel.name)
    name = words.of(roman(panel.title), light=False, heavy=True)
    scale = ""
    if not sketch.scale.bare:
        length, runs = bar(panel, place, sketch.scale, board.sheet.notation)
        scale = (
            f'<p class="scale"><span class="bar" style="--n:{number(length * unit)}"></span>'
            f"{words.of(runs)}</p>"
        )
    top, low = min(area.top, ink.top + 0.01), max(area.bottom, ink.bottom - 0.01)
    cut = [(area.top - top) / area.width, (top - low) / area.width]
    return (
        f'<section class="panel" style="--w:{number(area.width * unit)}">'
        f'<div class="top"{begun}><h2>{name}</h2>{scale}</div>'
        f'<div class="drawing" style="--cut:{number(cut[0], 4)};--ink:{number(cut[1], 4)}">'
        f'<svg viewBox="{inker.view(area)}" role="img" aria-label="{escape(panel.title)}">'
        f"{inker.drawing(board, panel.name)}</svg></div>"
        f'<div class="foot"{begun}>{_foot(board, panel, inker, words)}</div></section>'
    )


def _foot(board: Plan, panel: Panel, inker: Inker, words: Words) -> str:
    foot = compose(panel, board.page.panels[panel.name].drawing.width)
    lines = (
        "".join(_piece(board, panel, piece, inker, words) for piece in line) for line in foot.lines
    )
    size = number(foot.size * board.form.unit)
    return "".join(f'<p style="--n:{size}">{line}</p>' for line in lines)


def _piece(board: Plan, panel: Panel, piece: Piece, inker: Inker, words: Words) -> str:
    """Return a sign, or a term in its ink, grey until its stroke is inked."""
    space = f"margin-left:{number(piece.space)}em" if piece.space else ""
    setting, colour, beats = board.sketches[panel.name].setting, "", ""
    if piece.term:
        colour = f";color:{lettered(inker.style.colour('row', setting.row(piece.term.link)))}"
        if piece.term.stroke:
            inked = setting.after(panel.number(piece.term.stroke))
            beats = when([(inked, FOREVER)])
    says = f' style="{(space + colour).strip(";")}"' if space or colour else ""
    return f"<span{beats}{says}>{words.of(piece.runs)}</span>"

"""The panels of a page: heads and equations in words, the drawings between them.

In comes a board, out goes HTML.
"""

from __future__ import annotations

from html import escape

from vad.lecture.moment import drawing
from vad.page.ink import Inker, when
from vad.page.themed import lettered
from vad.page.wording import Words
from vad.painting.svg_elements import number
from vad.plan.board import Plan
from vad.plan.items import FOREVER
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import bold, roman
from vad.plan.opening import reach
from vad.plan.page.foot import REMARK_SIZE, Piece, compose
from vad.plan.page.heads import APART, TITLE
from vad.plan.stated_scale import bar
from vad.strokes.sheet import Panel


def panel_section(board: Plan, panel: Panel, inker: Inker, words: Words) -> str:
    """Return a panel: its head, its drawing, and its equations."""
    begun = when([(drawing(board.sketches[panel.name].setting.first), FOREVER)])
    wide = board.page.panels[panel.name].drawing.width * board.form.unit
    name = words.of(roman(panel.title), light=False, heavy=True)
    return (
        f'<section class="panel" style="--w:{number(wide)}">'
        f'<div class="top"{begun}><h2>{name}</h2>{scale_bar(board, panel, words)}</div>'
        f"{picture(board, panel, inker)}"
        f'<div class="foot"{begun}>{_foot(board, panel, inker, words)}</div></section>'
    )


def scale_bar(board: Plan, panel: Panel, words: Words) -> str:
    """Return the scale of a panel; nothing where it has none."""
    sketch, place = board.sketches[panel.name], board.page.panels[panel.name]
    if sketch.scale.bare:
        return ""
    room = place.drawing.width - width(bold(roman(panel.title)), TITLE) - APART
    length, runs = bar(panel, sketch.scale, room, board.sheet.notation)
    return (
        f'<p class="scale"><span class="bar" style="--n:{number(length * board.form.unit)}">'
        f"</span>{words.of(runs)}</p>"
    )


def picture(board: Plan, panel: Panel, inker: Inker) -> str:
    """Return the drawing of a panel, which knows where its ink ends."""
    area = board.page.panels[panel.name].drawing
    ink = reach(item for item in board.items if item.region == panel.name)
    top, low = min(area.top, ink.top + 0.01), max(area.bottom, ink.bottom - 0.01)
    cut = [(area.top - top) / area.width, (top - low) / area.width]
    return (
        f'<div class="drawing" style="--cut:{number(cut[0], 4)};--ink:{number(cut[1], 4)}">'
        f'<svg viewBox="{inker.view(area)}" role="img" aria-label="{escape(panel.title)}">'
        f"{inker.drawing(board, panel.name)}</svg></div>"
    )


def _foot(board: Plan, panel: Panel, inker: Inker, words: Words) -> str:
    foot = compose(panel, board.page.panels[panel.name].drawing.width)
    lines = ("".join(_piece(board, piece, inker, words) for piece in line) for line in foot.lines)
    size = number(foot.size * board.form.unit)
    remark = " ".join(words.of(runs) for runs in foot.remark)
    small = number(REMARK_SIZE * board.form.unit)
    said = f'<p class="remark" style="--n:{small}">{remark}</p>' if remark else ""
    return said + "".join(f'<p style="--n:{size}">{line}</p>' for line in lines)


def _piece(board: Plan, piece: Piece, inker: Inker, words: Words) -> str:
    """Return a sign, or a term in its ink, grey until its stroke is inked."""
    space = f"margin-left:{number(piece.space)}em" if piece.space else ""
    colour, beats = "", ""
    if piece.term:
        setting = board.sketches[piece.half].setting
        colour = f";color:{lettered(inker.inks.style.colour('row', setting.row(piece.term.link)))}"
        if piece.term.stroke:
            inked = setting.after(setting.panel.number(piece.term.stroke))
            beats = when([(inked, FOREVER)])
    says = f' style="{(space + colour).strip(";")}"' if space or colour else ""
    return f"<span{beats}{says}>{words.of(piece.runs)}</span>"

"""The parts of a lesson's page: its panels, its table of results, its list of strokes, its data.

A lesson becomes HTML for each place of the page, and the data with which the player moves it.  The
file, the live page and the notebook are made of the same parts, and played by the same script.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from itertools import accumulate, islice, pairwise, repeat
from typing import Any

from vad.lecture.chapters import Chapter, chapters
from vad.lecture.followed import Followed
from vad.lecture.lesson import Lesson, LessonStep
from vad.lecture.moment import drawing
from vad.lecture.telling import beats
from vad.page.hand import Hand, hand
from vad.page.heads import head_size, scale_bar
from vad.page.ink import Inker, when
from vad.page.large import large_panels
from vad.page.measures import Measures, measures
from vad.page.spoken import names_of_loads, spoken
from vad.page.themed import Inks, lettered
from vad.page.travels import page_flights, trails
from vad.painting.posed import SIZE
from vad.painting.svg_elements import number
from vad.painting.svg_text import Faces
from vad.plan.board import Plan, plan, reach
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.hand_board import HandBoard, hand_board
from vad.plan.items import FOREVER
from vad.plan.layout import MARGIN
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, bold, roman, said, symbols
from vad.plan.lettering.wrapping import cut, tied
from vad.plan.marks import line
from vad.plan.page.changing import caption_lines, figure_of, measuring
from vad.plan.page.heads import REMARK_SIZE, Piece, compose
from vad.plan.page.quarter import NAME_GAP, turn_sign
from vad.plan.page.quarter import SIZE as ENTRY
from vad.plan.page.table import CLEAR, EQUALS, VALUES, Columns, alike
from vad.plan.page.table import table as laid_out
from vad.strokes.description import parameters
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import NO_PINS
from vad.strokes.sentences import pieces_of
from vad.strokes.sheet import Cell, Panel, Row
from vad.style import load_style
from vad.words import Language, TextPiece, text_of
from vad.written import with_unit

PADDING = 0.25 * ENTRY  # after a symbol
_FIRM = "\u00a0"
_ITALIC = ("italic", "bolditalic")
_SCRIPTS = {-1: "sub", 0: "", 1: "sup"}


@dataclass(frozen=True, slots=True)
class Parts:
    """What a page is made of.

    Attributes
    ----------
    head, panels, table, chapters, steps
        HTML for the places of those names.
    data
        What the script plays: ``first`` strokes and ``panels`` by name and title, how many strokes
        are seen when it ``opens`` (see `vad.lecture.lesson.Lesson`), ``times`` of
        each stroke (seconds that it grows and rests), how long panels ``move`` to the next scene
        (seconds, and with the rest after it), ``flights`` (see `vad.page.travels`), ``spoken``
        captions, ``grow`` (see `vad.page.ink`) and ``words``.
    lines
        How many lines captions take.
    measures
        How high the board is, and how large its panels are.
    looks
        Rules of the classes in ``panels`` and ``table``.
    faces
        The letters that the page's fonts need.
    """

    head: str
    panels: str
    table: str
    chapters: str
    steps: str
    data: Mapping[str, Any]
    lines: int
    measures: Measures
    looks: str
    faces: Faces
    hand: Hand | None = None


def page_plan(lesson: Lesson) -> Plan:
    """Return the board of a lesson as its page shows it, whatever the size of its film."""
    return _plan(lesson, turned_board(lesson))


def _plan(lesson: Lesson, turned: HandBoard | None) -> Plan:
    """Return the board of a lesson; its mechanism has the scale at which it can be turned."""
    key, scales = load_style(lesson.style).key, turned.live.scales if turned else {}
    return plan(lesson.sheet, screen(SIZE), key, lesson=True, scales=scales, words=False)


def parts(
    lesson: Lesson,
    board: Plan | None = None,
    turned: HandBoard | None = None,
    known: Collection[str] = (),
    follow: Followed | None = None,
) -> Parts:
    """Return the parts of a lesson's page.

    Parameters
    ----------
    lesson
        What is played.
    board
        Its board, where that has scales of its own.
    turned
        The board on which its mechanism is turned, if ``board`` is given; None where it cannot be.
    known
        Classes whose rules are left out.
    follow
        The point whose path and hodographs alone are shown; those of all points if None.
    """
    style, faces, sheet = load_style(lesson.style), Faces(), lesson.sheet
    own, move = board is None, _move(lesson)
    turned = turned if board else turned_board(lesson)
    board = board or _plan(lesson, turned)
    inker, words = Inker(board.form, Inks(style), faces, alone=own), RunWriter(faces)
    large = large_panels(board, turned, inker) if own and move else {}
    names = names_of_loads(sheet)
    listed = [_listed(lesson, step, words, names) for step in lesson.steps]
    for phrase in Language(sheet.language).page("HAND").values() if turned else ():
        words.of(roman(phrase))
    moved = hand(turned, board, inker, words.of, large, follow) if turned else None
    found = measures(board)
    drawn = [
        panel_section(board, panel, inker, words, found.large[panel.name]) for panel in sheet.panels
    ]
    results = table(board, style.key, inker, words)
    title = f"<h1>{words.of(roman(sheet.title), light=False, heavy=True)}</h1>"
    if sheet.subtitle:
        title = f"<hgroup>{title}<p>{words.of(roman(sheet.subtitle))}</p></hgroup>"
    items = ", ".join(
        f"<span>{words.of(said(tuple(map(_firm, item))))}</span>" for item in parameters(sheet)
    )
    told = [step.chapter for step in lesson.steps]
    first = [told.index(panel.name) for panel in sheet.panels]
    return Parts(
        head=f"{title}<p>{items}</p>",
        panels="".join(drawn),
        table=results,
        chapters="".join(_chapter(*each) for each in pairwise(_chapters(lesson))),
        steps="".join(
            f"<div><h3>{words.of(roman(panel.title), light=False, heavy=True)}</h3><ol>"
            + "".join(
                item
                for step, (item, _) in zip(lesson.steps, listed, strict=True)
                if step.chapter == panel.name
            )
            + "</ol></div>"
            for panel in sheet.panels
        )
        + _stepped(lesson, turned, words),
        data={
            # First, as it is like what is packed before: one is written in terms of the other.
            "large": [each.data(name, board, inker) for name, each in large.items()],
            "first": first,
            "opens": lesson.opens,
            "panels": [[panel.name, panel.title] for panel in sheet.panels],
            "times": [
                [round(frames / lesson.fps, 3) for frames in (*_drawn(step), *step.beats)]
                for step in lesson.steps
            ],
            "answer": _answer(lesson, words),
            "move": move,
            "flights": page_flights(lesson, board, inker, large),
            "trails": trails(inker),
            "sent": _sent(lesson),
            "spoken": [words for _, words in listed],
            "grow": inker.growths,
            "words": Language(sheet.language).page("PLAYER"),
        },
        lines=len(board.page.captions),
        measures=found,
        looks=inker.classes.sheet(known),
        faces=faces,
        hand=moved,
    )


def _stepped(lesson: Lesson, turned: HandBoard | None, words: RunWriter) -> str:
    """Return the sentence of a page whose mechanism is not turned by hand; of others nothing."""
    if turned:
        return ""
    text = Language(lesson.sheet.language).say("page stepped")
    return f"<p>{words.of(roman(text))}</p>"


def _firm(piece: TextPiece) -> TextPiece:
    """Return a piece of a parameter, which no line of the page breaks."""
    return TextPiece(piece.text.replace(" ", _FIRM), piece.kind)


def _drawn(step: LessonStep) -> tuple[int, int]:
    """Return for how many frames a pencil draws a stroke, which does not fly, and till the next."""
    drawn = min(step.pencil or step.grow, step.grow)
    return drawn, step.frames - drawn


def _move(lesson: Lesson) -> list[float]:
    """Return the seconds in which panels move to the next scene, and those and a rest; or none."""
    found = [
        [frames / lesson.fps for frames in (step.glide, step.glide + step.settle)]
        for step in lesson.steps
        if step.glide
    ]
    return [round(each, 3) for each in found[0]] if found else []


def turned_board(lesson: Lesson) -> HandBoard | None:
    """Return the board on which a lesson's mechanism is turned; None where it cannot be."""
    sheet = lesson.sheet
    if not sheet.source or sheet.source.mechanism.is_rotor:
        return None
    names, form = [panel.name for panel in sheet.panels], screen(SIZE)
    if not all(DIAGRAMS[name].by_hand for name in names if name in DIAGRAMS):
        return None
    lines = caption_lines(sheet, form.width - 2 * MARGIN)
    mechanism, _, burden, pins = sheet.source
    return hand_board(mechanism, names, sheet.language, form, lines, burden, pins or NO_PINS)


def _listed(
    lesson: Lesson, step: LessonStep, words: RunWriter, names: Collection[str]
) -> tuple[str, str]:
    """Return the caption of a step as an entry of the list, and as it is read out.

    Of several strokes with one caption only the entry of the first is seen, and only it has the
    caption and its words: the player gives them to the others, and to all of them the address of
    their step.
    """
    if step.repeats:
        return "<li class=same><a></a>", ""
    item = f"<li><a>{_beats(step, words)}</a>"  # the next one ends it, or the list
    return item, spoken(pieces_of(step.stroke.said), lesson.sheet.language, names)


def _beats(step: LessonStep, words: RunWriter) -> str:
    """Return a caption; each of its beats is an element, if it has several."""
    pieces = tied(pieces_of(step.stroke.said))
    parts = beats(step.stroke.said)
    if len(parts) == 1:
        return words.of(said(pieces))
    ends = accumulate((len(text_of(part)) for part in parts), initial=0)
    *before, result = (cut(pieces, each) for each in pairwise(ends))
    told = [words.of(said(part)) for part in before] + [_result(step, result, words)]
    return "".join(f"<span>{each}</span>" for each in told)


def _result(step: LessonStep, pieces: Sequence[TextPiece], words: RunWriter) -> str:
    """Return the result of a calculation; a rate that flies to its link is an element in it."""
    if not step.sent[1]:
        return words.of(said(pieces))
    first, end = figure_of(pieces)
    texts = [words.of(said(part)) for part in (pieces[:first], pieces[first:end], pieces[end:])]
    return "{}<data>{}</data>{}".format(*texts)


def _sent(lesson: Lesson) -> dict[int, list[float]]:
    """Return when a found ω or α flies to its link, and for how long, by its stroke's number.

    That is in seconds from the end of the stroke on.
    """
    return {
        number: [
            round(frames / lesson.fps, 3) for frames in (step.sent[0] - step.grow, step.sent[1])
        ]
        for number, step in enumerate(lesson.steps)
        if step.sent[1]
    }


def _answer(lesson: Lesson, words: RunWriter) -> list[str]:
    """Return the answer of a lesson and how it is read out; nothing where it has none."""
    if lesson.answer is None:
        return []
    pieces = lesson.answer.pieces
    return [
        words.of(said(tied(pieces))),
        spoken(pieces, lesson.sheet.language, names_of_loads(lesson.sheet)),
    ]


def _chapters(lesson: Lesson) -> list[Chapter]:
    """Return the chapters of strokes, and where they end."""
    count = len(lesson.steps)
    return [*(each for each in chapters(lesson) if each.step < count), Chapter("", count, 0, 0)]


def _chapter(chapter: Chapter, after: Chapter) -> str:
    """Return the button of a chapter; that of a further loop has the number of the loop."""
    count = after.step - chapter.step
    name, more = escape(chapter.title), ""
    if chapter.loop > 1:
        name, more = str(chapter.loop), f' title="{name}"'
    return f'<button data-x="{chapter.step}" style="flex-grow:{count}"{more}>{name}</button>'


def panel_section(board: Plan, panel: Panel, inker: Inker, words: RunWriter, large: float) -> str:
    """Return a panel: its head, its drawing, its equations.

    While it is in work it is so many times as ``large``.
    """
    begun = when([(drawing(board.sketches[panel.name].setting.first), FOREVER)])
    area, unit = board.page.panels[panel.name].drawing, board.form.unit
    name = words.of(roman(panel.title), light=False, heavy=True)
    twin = " twin" if panel.below else ""
    return (
        f'<section class="panel" style="--w:{number(area.width * unit)};'
        f'--d:{number(area.height * unit)};--z:{number(large, 3)}{head_size(board, panel)}">'
        f'<div class="top{twin}"{begun}><h2>{name}</h2>{scale_bar(board, panel, words)}</div>'
        f"{picture(board, panel, inker)}"
        f'<div class="foot"{begun}>{_foot(board, panel, inker, words)}</div></section>'
    )


def picture(board: Plan, panel: Panel, inker: Inker) -> str:
    """Return the drawing of a panel, with how far its ink reaches up and down."""
    area = board.page.panels[panel.name].drawing
    drawn = [item for item in board.items if item.region == panel.name and item.marks]
    ink = reach(drawn) if drawn else area  # where all forces are zero, nothing is drawn
    top, low = min(area.top, ink.top + 0.01), max(area.bottom, ink.bottom - 0.01)
    cut = [(area.top - top) / area.width, (top - low) / area.width]
    return (
        f'<div class="drawing" style="--cut:{number(cut[0], 4)};--ink:{number(cut[1], 4)}">'
        f'<svg viewBox="{inker.view(area)}" role="img" aria-label="{escape(panel.title)}">'
        f"{inker.groups(drawn)}</svg></div>"
    )


def _foot(board: Plan, panel: Panel, inker: Inker, words: RunWriter) -> str:
    foot = compose(panel, board.page.panels[panel.name].drawing.width)
    lines = ("".join(_piece(board, piece, inker, words) for piece in line) for line in foot.lines)
    size = number(foot.size * board.form.unit)
    remark = " ".join(words.of(runs) for runs in foot.remark)
    small = number(REMARK_SIZE * board.form.unit)
    said = f'<p class="remark" style="--n:{small}">{remark}</p>' if remark else ""
    return said + "".join(f'<p style="--n:{size}">{line}</p>' for line in lines)


def _piece(board: Plan, piece: Piece, inker: Inker, words: RunWriter) -> str:
    """Return a sign, or a term in its ink; a term is grey until its stroke is drawn."""
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


def table(plan: Plan, key: float, inker: Inker, words: RunWriter) -> str:
    """Return the results of a sheet; ``key`` is the length of the line before a row's name."""
    sheet, say = plan.sheet, Language(plan.sheet.language).say
    values, names = values_of(plan, key), [_named(row) for row in sheet.rows]
    room = values - CLEAR - key - NAME_GAP
    small = _shrunk(room, max((width(name, ENTRY) for name in names), default=room))
    heads = "".join(f'<th scope="col">{words.of(roman(p.title))}</th>' for p in sheet.panels)
    rows = "".join(
        f'<tr role="row"><th scope="row" role="rowheader"{small}>'
        f"{_key(number, key, inker, row.inked)}{words.of(name)}</th>"
        + "".join(measured_cells(plan, panel, row, words, values) for panel in sheet.panels)
        + "</tr>"
        for number, (row, name) in enumerate(zip(sheet.rows, names, strict=True))
    )
    lefts = [place.drawing.left for place in plan.page.panels.values()]
    ends = [lefts[0], lefts[0] + values, *lefts[1:], plan.page.right]
    widths = [end - start for start, end in pairwise(ends)]
    columns = "".join(f'<col style="width:{100 * each / sum(widths):.2f}%">' for each in widths)
    legend = words.of(roman(say("legend"))) if _has_given(sheet.rows) else ""
    # A narrow column has room for it where it has no number.
    last = sheet.panels[-1].name
    free = next((n for n, row in enumerate(sheet.rows) if not row.cells.get(last)), 0)
    return (
        '<div class="rows"><table role="table">'
        f'<caption class="unseen">{words.of(roman(say("results")))}</caption>'
        f'<colgroup>{columns}</colgroup><thead class="unseen"><tr><td></td>{heads}</tr></thead>'
        f'<tbody role="rowgroup">{rows}</tbody></table></div>'
        f'<p class="legend" style="--row:{free}">{legend}</p>'
    )


def _named(row: Row) -> Runs:
    return roman(row.title + " ") + symbols(row.letters)


def _shrunk(room: float, need: float) -> str:
    """Return the style of what is as much smaller as it has too little room."""
    share = f"{100 * room / max(need, room):.0f}"
    return f' style="font-size:{share}%"' if share != "100" else ""


def _key(number: int, key: float, inker: Inker, inked: bool) -> str:
    """Return the line of a row in its ink, on a view of its own; empty for a row without ink."""
    mark = line([complex(0.0, 0.5), complex(key, 0.5)], "key", number)
    view, drawn = inker.view(Rect(0.0, 0.48, key, 0.52)), inker.mark(mark) if inked else ""
    return f'<svg class="key" viewBox="{view}" aria-hidden="true">{drawn}</svg>'


def values_of(plan: Plan, key: float) -> float:
    """Return the distance from the left margin to the first cells."""
    laid = laid_out(plan.sheet, plan.page, key)
    return laid.values if isinstance(laid, Columns) else VALUES


def measured_cells(plan: Plan, panel: Panel, row: Row, words: RunWriter, values: float) -> str:
    """Return what a panel measures of a row, as one cell of the table.

    If there is no room, the cell first leaves out units that the column has above, and then it gets
    smaller type.
    """
    cells = row.cells.get(panel.name, ())
    room = plan.page.panels[panel.name].drawing.width
    room -= values if panel is plan.sheet.panels[0] else 0.0
    readings = [_reading(plan, cell) for cell in cells]
    need = _need(cells, readings)
    if need > room and alike(cells, panel.name, plan.sheet.rows):
        readings = [_reading(plan, cell, bare=cell is not cells[-1]) for cell in cells]
        need = _need(cells, readings)
    small = _shrunk(room, need)
    written = map(_cell, cells, readings, repeat(words))
    halves = []
    for half, measured in panel.measures(row):
        _, since = measuring(plan.sketches, half, row, measured)
        own = "".join(islice(written, len(measured)))
        halves.append(f"<div{when([(since, FOREVER)])}{small}>{own}</div>")
    whole = "".join(halves)
    return f'<td role="cell">{whole if len(halves) == 1 else f"<div>{whole}</div>"}</td>'


def _need(cells: Sequence[Cell], readings: Sequence[Runs]) -> float:
    """Return the width of cells side by side, as the style sheet sets them."""
    signs = [width(symbols(cell.symbol), ENTRY) + PADDING for cell in cells]
    wide = sum(
        width(reading, ENTRY) + max(EQUALS, sign)
        for reading, sign in zip(readings, signs, strict=True)
    )
    return wide + CLEAR * (len(cells) - 1)


def _cell(cell: Cell, reading: Runs, words: RunWriter) -> str:
    symbol, value = words.of(symbols(cell.symbol)), words.of(reading, heavy=not cell.given)
    given = " given" if cell.given else ""
    return f'<span class="cell{given}"><span>{symbol}</span>{value}</span>'


def _reading(plan: Plan, cell: Cell, bare: bool = False) -> Runs:
    number, unit = plan.sheet.notation.cell(cell.value, cell.unit, cell.given)
    read = with_unit(number, "" if bare else unit) + turn_sign(plan.turns, cell)
    return roman("= " + read.replace(" ", "\u00a0"))


def _has_given(rows: tuple[Row, ...]) -> bool:
    return any(c.given for row in rows for cells in row.cells.values() for c in cells)


class RunWriter:
    """Writes runs as HTML, and records the letters that their fonts need."""

    def __init__(self, faces: Faces) -> None:
        self._faces = faces

    def of(self, runs: Runs, *, light: bool = True, heavy: bool = False) -> str:
        """Return runs as HTML; ``heavy`` and ``light`` say where the page sets them bold or not."""
        for each in (*(runs if light else ()), *(bold(runs) if heavy else ())):
            self._faces.add(each.face, each.text)
        text = ""
        for run in runs:
            words = escape(run.text)
            words = f"<i>{words}</i>" if run.face in _ITALIC else words
            script = _SCRIPTS[run.script]
            text += f"<{script}>{words}</{script}>" if script else words
        return text.replace("</i><i>", "").replace("</sub><sub>", "")

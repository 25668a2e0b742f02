"""The words around the panels: title, heads with scales, equations, and lengths on paper.

They are made from a sheet and its page; the loop equation stands at the foot of its panel.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from vad.errors import UsageError
from vad.plan.items import Item, Level, foot_of
from vad.plan.layout import Page, PanelPlace, rooms
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, bold, roman, said, symbols
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Lettering, Mark, line
from vad.plan.scale import SCALE_GAP, SCALE_SIZE, Scale, bar_marks, stated
from vad.plan.sketch import Sketch
from vad.strokes.description import parameters
from vad.strokes.notation import Notation
from vad.strokes.sentences import pieces_of
from vad.strokes.sheet import Arrow, Equation, Panel, Sheet, Term
from vad.words import TextPiece
from vad.written import typeset

TITLE = 0.037
LEAST_TITLE, LEAST_SCALE = 0.024, 0.020
APART = 0.0225  # the least from title to bar
#: The largest and the least type of the title of the page, of one above a subtitle, and of that.
PAGE_TITLE, PAGE_TITLE_ABOVE, SUBTITLE = (0.050, 0.036), (0.044, 0.036), (0.030, 0.026)
#: What a title takes of the page in large type; a longer one is set smaller.
TITLE_SHARE = 0.6
#: How far a subtitle is below the usual place of the title, and the title above a subtitle.
SUBTITLE_DROP, SUBTITLE_PITCH = 0.010, 0.038
PARAMETERS = 0.032
LEAST_PARAMETERS = 0.028  # in one line, and the most in two
#: The title becomes smaller for parameters that would be smaller than this, which is their size in
#: three lines; beside a very long title they may be of the other size.
READABLE, SMALLEST_PARAMETERS = 0.022, 0.014
THREE_DROP = 0.012  # of three lines below the usual place
EQUATION_SIZE = 0.036
LEAST_EQUATION = 0.034  # below this a loop takes two lines
SPACE = 0.24  # about a sign, in type sizes
LOOP_SPACE = 1.3
REMARK_SIZE = 0.030
#: From line to line of a remark, and from its last one to the first equation: they stand apart.
LINE_PITCH, REMARK_APART = 0.038, 0.055
READING = 0.030
LEAST_READING = 0.022
#: The room that one of them takes.
COLUMN = 0.58
#: From the title to the parameters; what stands for those that the title does not list.
TITLE_APART, MORE = 0.04, TextPiece("…")
#: So many parameters stand there whatever their type; of more at least so many.
FEW, FEWEST = 8, 4
#: What is given in the title, each in pieces.
Parameters = Sequence[tuple[TextPiece, ...]]


def head(
    panel: Panel,
    place: PanelPlace,
    scale: Scale,
    centimetre: float | None,
    notation: Notation,
    most: float = TITLE,
) -> list[Mark]:
    """Return the head of a panel; on paper it states what a centimetre stands for.

    Its title is no larger than ``most``.  Where there is no room for both, the title and the words
    of the scale become smaller alike.  The scale is that of the first of two polygons: above it, or
    farther to the right if there is no room.
    """
    if scale.bare:
        return _head(panel, place, most)
    first = rooms(panel, place.drawing)[0][1] if panel.below else place.drawing
    left, title = first.left, bold(roman(panel.title))
    for right in (first.right, place.drawing.right):
        room = right - left - width(title, TITLE) - APART
        length, runs = stated(panel, scale, room, centimetre, notation)
        share = head_share(title, length, runs, right - left)
        if share == 1.0:
            break
    size = max(share * SCALE_SIZE, LEAST_SCALE)
    start = right - width(runs, size) - SCALE_GAP - length
    marks = _head(panel, place, fitted(title, most, LEAST_TITLE, start - APART - left))
    return [*marks, *bar_marks(length, runs, complex(start, place.title), size)]


def head_share(title: Runs, length: float, runs: Runs, room: float) -> float:
    """Return by how much a title and the words of a scale are smaller, for they share a room."""
    beside = room - APART - length - SCALE_GAP
    return min(1.0, beside / (width(title, TITLE) + width(runs, SCALE_SIZE)))


def pale(head: list[Mark]) -> list[Mark]:
    """Return the head before its panel is begun: rule and title, faint and bare."""
    rule, title, *_ = head
    return [replace(rule, role="pale rule"), replace(title, role="pale words")]


def _head(panel: Panel, place: PanelPlace, size: float) -> list[Mark]:
    left, right = place.drawing.left, place.drawing.right
    ends = complex(left, place.rule), complex(right, place.rule)
    title = Lettering(bold(roman(panel.title)), complex(left, place.title), size)
    return [line(ends, "rule"), Mark(title, "words")]


def title_marks(sheet: Sheet, page: Page) -> list[Mark]:
    """Return the title and the parameters, which take two or three lines where one has no room.

    The title becomes smaller before they do.  A subtitle stands below it, and it moves up for that;
    so it does for parameters that have no room beside it in readable type.

    Raises
    ------
    vad.errors.UsageError
        If the title or the subtitle is too long for the page.
    """
    low = page.title
    at = complex(page.left, low)
    lines = [("title", bold(roman(sheet.title)), PAGE_TITLE, at)]
    if sheet.subtitle:
        low -= SUBTITLE_DROP
        at -= 1j * SUBTITLE_DROP
        lines = [
            ("subtitle", roman(sheet.subtitle), SUBTITLE, at),
            ("title", lines[0][1], PAGE_TITLE_ABOVE, at + 1j * SUBTITLE_PITCH),
        ]
    usual, room = TITLE_SHARE * (page.right - page.left), page.right - page.left - TITLE_APART
    natural = max(width(runs, fitted(runs, *sizes, usual)) for _, runs, sizes, _ in lines)
    least, given = _least(sheet), _ended(parameters(sheet), _listable(sheet, page))
    one, two, three = (_in_lines(given, count) for count in (1, 2, 3))
    if natural + _widest(one) * LEAST_PARAMETERS <= room:
        rows, largest = one, PARAMETERS
    elif least + _widest(two) * READABLE <= room:
        rows, largest = two, LEAST_PARAMETERS
    else:
        rows, largest = three, READABLE
        low -= THREE_DROP
    wide, whole = _widest(rows), page.right - page.left
    beneath = min(LEAST_PARAMETERS, whole / (_widest(one) or 1.0))
    beside = (room - least) / (wide or 1.0)
    if beside < min(beneath, 0.99 * READABLE) and least <= whole and not sheet.subtitle:
        return _title_above(page, lines[0][1], _listed(one[0]), beneath)
    most, usual = room - wide * SMALLEST_PARAMETERS, min(usual, room - wide * READABLE)
    named = [_named(what, runs, at, sizes, usual, most) for what, runs, sizes, at in lines]
    size = min(largest, (room - max(width(each.runs, each.size) for each in named)) / (wide or 1.0))
    *below, above = named
    marks = [Mark(above, "words"), *(Mark(each, "notes") for each in below)]
    for depth, row in enumerate(reversed(rows)):
        runs = _listed(row)
        at = complex(page.right - width(runs, size), low + depth * 1.25 * size)
        marks.append(Mark(Lettering(runs, at, size), "notes"))
    return marks


def unlisted(sheet: Sheet, page: Page) -> Parameters:
    """Return the parameters for which the title has no room in readable type: the last ones."""
    return parameters(sheet)[_listable(sheet, page) :]


def _listable(sheet: Sheet, page: Page) -> int:
    """Return how many parameters the title lists: of more than a few those that are readable.

    They are beside it, or in a line below it.
    """
    every, whole = parameters(sheet), page.right - page.left
    room, below = whole - TITLE_APART - _least(sheet), 0.0 if sheet.subtitle else whole
    if len(every) <= FEW:
        return len(every)

    def readable(count: int) -> bool:
        one, three = (_widest(_in_lines(_ended(every, count), lines)) for lines in (1, 3))
        return three * READABLE <= room or one * READABLE <= below

    return next(filter(readable, range(len(every), FEWEST, -1)), FEWEST)


def _least(sheet: Sheet) -> float:
    """Return the width of title and subtitle in their least type."""
    title = width(bold(roman(sheet.title)), PAGE_TITLE[1])
    return max(title, width(roman(sheet.subtitle), SUBTITLE[1]))


def _ended(every: Parameters, count: int) -> Parameters:
    """Return the first parameters, with a sign that there are more, if there are."""
    return [*every[:count], *([(MORE,)] if count < len(every) else [])]


def _title_above(page: Page, title: Runs, listed: Runs, size: float) -> list[Mark]:
    """Return a title with its parameters of a size in a line below it."""
    low = complex(page.left, page.title - SUBTITLE_DROP)
    large = fitted(title, *PAGE_TITLE_ABOVE, page.right - page.left)
    above = Lettering(title, low + 1j * SUBTITLE_PITCH, large)
    return [Mark(above, "words"), Mark(Lettering(listed, low, size), "notes")]


def _in_lines(items: Parameters, count: int) -> list[Parameters]:
    """Return parameters in so many lines, or in fewer if they are few: the last may be shorter."""
    share = -(-len(items) // count) or 1
    return [items[start : start + share] for start in range(0, len(items), share)]


def _named(
    what: str, runs: Runs, at: complex, sizes: tuple[float, float], usual: float, most: float
) -> Lettering:
    """Return a title or a subtitle in type between two sizes, as small as its usual width wants."""
    found = fitted(runs, *sizes, usual)
    if (wide := width(runs, found)) > most:
        letters = sum(len(run.text) for run in runs)
        fewer = max(0, int(letters * most / wide))
        message = f"{what}: has {letters} letters; this page has room for about {fewer}"
        raise UsageError(message, "try a wider page, or put a part of it into the other line")
    return Lettering(runs, at, found)


def _widest(rows: Sequence[Parameters]) -> float:
    """Return the width of the longest row of parameters in type of size 1."""
    return max((width(_listed(row), 1.0) for row in rows), default=0.0)


def _listed(items: Parameters) -> Runs:
    pieces: list[TextPiece] = []
    for item in items:
        pieces += [TextPiece(",   ")] if pieces else []
        pieces += item
    return said(tuple(pieces))


@dataclass(frozen=True, slots=True)
class Piece:
    """A term or a sign, with the space before it in type sizes, of a ``half`` of a panel."""

    runs: Runs
    term: Term | None
    space: float
    half: str


@dataclass(frozen=True, slots=True)
class Foot:
    """What stands under one panel: its remark in lines, then its equations and their type size."""

    lines: tuple[tuple[Piece, ...], ...]
    size: float
    remark: tuple[Runs, ...] = ()

    @property
    def count(self) -> int:
        """The number of all lines."""
        return len(self.remark) + len(self.lines)


def _sum(terms: Sequence[Term], half: str, sign: str = "") -> list[Piece]:
    pieces: list[Piece] = []
    for term in terms:
        if sign:
            pieces.append(Piece(roman(sign), None, SPACE, half))
        pieces.append(Piece(symbols(term.label), term, SPACE if sign else 0.0, half))
        sign = "+"
    return pieces


def pieces(equation: Equation, half: str) -> list[Piece]:
    """Return the terms and signs of an equation of a half of a panel."""
    return _sum(equation.left, half) + _sum(equation.right, half, "=")


def type_width(pieces: Sequence[Piece]) -> float:
    """Return the width of pieces in type sizes."""
    return sum(width(piece.runs, 1.0) + piece.space for piece in pieces)


def compose(panel: Panel, room: float, told: bool = True) -> Foot:
    """Return the lines of a panel's foot: loops share a line if they fit ``room``.

    If equations are not ``told``, it is the remark alone.

    A loop that is too long for one line goes on with its equals sign on the next.
    """
    remark = tuple(wrap(pieces_of(panel.remark), REMARK_SIZE, room)) if panel.remark else ()
    equations = [(each, half.name) for half in panel.halves for each in half.equations if told]
    loops = [pieces(*each) for each in equations]
    if not loops:
        return Foot((), EQUATION_SIZE, remark)
    together: list[Piece] = []
    for loop in loops:
        first = replace(loop[0], space=LOOP_SPACE if together else 0.0)
        together += [first, *loop[1:]]
    if type_width(together) * EQUATION_SIZE <= room:
        return Foot((tuple(together),), EQUATION_SIZE, remark)
    lines: list[tuple[Piece, ...]] = []
    for (equation, half), loop in zip(equations, loops, strict=True):
        if type_width(loop) * LEAST_EQUATION <= room:
            lines.append(tuple(loop))
        else:
            left = _sum(equation.left, half)
            lines += [tuple(left), tuple(loop[len(left) :])]
    widest = max(type_width(line) for line in lines)
    return Foot(tuple(lines), min(EQUATION_SIZE, room / widest), remark)


def remarks(foot: Foot, baselines: Sequence[float], left: float) -> Iterator[Lettering]:
    """Yield the lines of the remark, which stands closer together than apart from equations."""
    if not foot.remark:
        return
    count = len(foot.remark)
    low = baselines[count] + REMARK_APART if foot.lines else baselines[count - 1]
    for number, runs in enumerate(foot.remark, 1):
        y = low + (count - number) * LINE_PITCH
        yield Lettering(runs, complex(left, y), REMARK_SIZE)


def placed(foot: Foot, baselines: Sequence[float], middle: float) -> list[tuple[Lettering, Piece]]:
    """Return the terms and signs of the equation, centred, each with its piece."""
    found: list[tuple[Lettering, Piece]] = []
    for pieces, baseline in zip(foot.lines, baselines[len(foot.remark) :], strict=False):
        x = middle - type_width(pieces) * foot.size / 2
        for piece in pieces:
            x += piece.space * foot.size
            found.append((Lettering(piece.runs, complex(x, baseline), foot.size), piece))
            x += width(piece.runs, foot.size)
    return found


def lines_of(panel: Panel, room: float) -> int:
    """Return how many lines the measured vectors of a panel take in a width."""
    return -(-len(_measured(panel)) // _columns(room))


def measured(sketch: Sketch, place: PanelPlace, first: int) -> Iterator[Item]:
    """Yield the measured vectors, from the line of the foot with number ``first`` on."""
    setting, room = sketch.setting, place.drawing
    assert setting.centimetre is not None
    panel, columns = setting.panel, _columns(room.width)
    value = setting.centimetre / sketch.scale.factor
    for count, (index, arrow) in enumerate(_measured(panel)):
        stroke = panel.strokes[index]
        length = abs(arrow.end - arrow.start) / value
        runs = symbols(stroke.label) + _reading(length, value, panel.unit, setting.sheet.notation)
        size = fitted(runs, READING, LEAST_READING, room.width / columns - READING)
        left = room.left + count % columns * room.width / columns
        at = complex(left, place.equations[first + count // columns])
        mark = Mark(Lettering(runs, at, size), "term", setting.row(stroke.link))
        name, region = panel.full(stroke.name), foot_of(panel.column)
        yield Item(name, region, Level.LABEL, (mark,), setting.after(index))


def _measured(panel: Panel) -> list[tuple[int, Arrow]]:
    """Return the vectors by which a row of the results is measured, with their numbers."""
    return [
        (index, stroke.shape)
        for index, stroke in enumerate(panel.strokes)
        if panel.picture == "vectors" and stroke.reveals and isinstance(stroke.shape, Arrow)
    ]


def _columns(room: float) -> int:
    return max(1, int(room / COLUMN))


def _reading(length: float, value: float, unit: str, notation: Notation) -> Runs:
    """Return a length in centimetres, the value of a centimetre, and their product."""
    read = f"{length:.2f}"
    result = notation.quantity(float(read) * value, unit, given=True)
    scale = notation.number(value, unit, given=True)
    return roman(f" = {typeset(read, notation.point)} cm × {scale} = {result}")

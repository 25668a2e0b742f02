"""What a problem sheet has and its key has not: a task, lines for name and class, a place to work.

They stand where the page of the key is free, so that everything else stays at its place.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from vad.errors import UsageError
from vad.plan.board import Plan, reach
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, RESULTS, TASK, TITLE, Item, Level
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, roman
from vad.plan.lettering.wrapping import Pieces, wrap
from vad.plan.marks import Lettering, Mark, line
from vad.strokes.task import task
from vad.words import Language, TextPiece, text_of

#: The sizes of type of a task, the best first.
SIZES = (0.032, 0.030, 0.028, 0.026, 0.024)
#: Those of a task that has no room in any other.
SMALLEST = (0.022, 0.020, 0.018)
#: If type is as large as this, room for calculations counts more than larger type.
LARGE = 0.028
PITCH = 1.28  # from line to line, in type sizes
#: The type of the words before the lines for name and class, and the room about them.
NAME_SIZE, NAME_GAP, BETWEEN = 0.028, 0.012, 0.03
#: The least length of the line for a name, and the share of the room that it takes.
LEAST_NAME, NAME_SHARE = 0.25, 0.72
NAME_APART = 0.004  # from anything else
ABOVE = 0.018  # from the parameters to a line above them
DROP = 0.006
#: The clear space about what is written into a free place.
CLEAR = 0.024
#: How high a free place is at least that is offered for calculations.
WORKING = 0.10
#: Places whose areas differ by less are alike for calculations: the task then stands above.
ALIKE = 0.04


def upon_problem(
    key: Plan, kept: Sequence[Item], blank: Collection[str], own: str, small: bool
) -> list[Item]:
    """Return the items that only the problem has, where the items that it kept leave room.

    A task that the sheet words itself may be in very ``small`` type.

    Raises
    ------
    vad.errors.UsageError
        If the task is too long for the page.
    """
    places = list(_free(key, kept, blank))
    marks = _names(key, kept, places)
    told, places = _task(key, places, blank, own, small)
    marks += told
    room = max(places, key=_worth, default=None)
    if room and _worth(room):
        say = Language(key.sheet.language).say
        y = room.top - CLEAR / 2
        marks.append(line([complex(room.left, y), complex(room.right, y)], "hairline"))
        marks.append(_words(say("working"), complex(room.left, y - 1.3 * NAME_SIZE)))
    return [Item("", TASK, Level.GROUND, tuple(marks))]


def _worth(place: Rect) -> float:
    """Return how much room a place gives for calculations: its area, or 0 where it is too low."""
    return place.width * place.height if place.height >= WORKING else 0.0


def _names(key: Plan, kept: Sequence[Item], places: list[Rect]) -> list[Mark]:
    """Return the lines for name and class, in the first place that is free and wide enough.

    They stand beside the title, above the parameters, above the title, or in one of the other free
    places, of which the rest then remains.
    """
    page = key.page
    boxes = [box for item in kept if item.region == TITLE for box in map(_box, item.marks)]
    titles = [box for box in boxes if box.left < page.left + CLEAR]
    others = [box for box in boxes if box.left >= page.left + CLEAR]
    title = max(box.right for box in titles) + 2 * BETWEEN
    end = min((box.left for box in others), default=page.right + 2 * BETWEEN) - 2 * BETWEEN
    high = max((box.top for box in others), default=page.title) + ABOVE
    top = page.height - 0.85 * NAME_SIZE
    for left, right, y in (
        (title, end, page.title),
        (title, page.right, min(high, top)),
        (page.left, end + BETWEEN, top),
    ):
        found = _lines(key, left, right, y)
        if found and not any(
            _meet(_box(mark), box.inside(-NAME_APART)) for mark in found for box in boxes
        ):
            return found
    for number, place in enumerate(places):
        y = place.top - 1.5 * NAME_SIZE
        if (found := _lines(key, place.left, place.right, y)) and y - CLEAR > place.bottom:
            places[number] = Rect(place.left, place.bottom, place.right, y - CLEAR)
            return found
    return []


def _lines(key: Plan, left: float, right: float, y: float) -> list[Mark]:
    """Return the words for name and class with their lines; none where they are too short."""
    say = Language(key.sheet.language).say
    words = [say("name"), say("class")]
    room = right - left - BETWEEN
    room -= sum(width(roman(word), NAME_SIZE) + NAME_GAP for word in words)
    if room * NAME_SHARE < LEAST_NAME:
        return []
    marks, x, low = [], left, 1j * (y - DROP)
    for word, share in zip(words, (NAME_SHARE, 1 - NAME_SHARE), strict=True):
        marks.append(_words(word, complex(x, y)))
        x += width(roman(word), NAME_SIZE) + NAME_GAP
        marks.append(line([x + low, x + share * room + low], "writing line"))
        x += share * room + BETWEEN
    return marks


def _box(mark: Mark) -> Rect:
    return reach([Item("", TASK, Level.GROUND, (mark,))])


def _words(word: str, at: complex) -> Mark:
    return Mark(Lettering(roman(word), at, NAME_SIZE), "notes")


def _task(
    key: Plan, places: Sequence[Rect], blank: Collection[str], own: str, small: bool
) -> tuple[list[Mark], list[Rect]]:
    """Return the task, and what is left of the free places.

    It stands where its type is large, and where most room is left for calculations, else above.
    A shorter form in large type comes before a longer one in small type, if it asks for the same.
    """
    forms: tuple[Pieces, ...] = ((TextPiece(own),),) if own else task(key.sheet, blank)
    large = tuple(size for size in SIZES if size >= LARGE)
    tried = [(form, large) for form in forms[:-1]] + [(form, SIZES) for form in forms]
    tried += [(forms[-1], SMALLEST)] if small and not own else []
    for pieces, sizes in tried:
        best: tuple[tuple[float, ...], list[Mark], list[Rect]] | None = None
        for number, place in enumerate(places):
            others = [*places[:number], *places[number + 1 :]]
            for size in sizes:
                lines = wrap(pieces, size, place.width)
                high = size * (1.12 + PITCH * (len(lines) - 1))
                if high > place.height or any(width(runs, size) > place.width for runs in lines):
                    continue
                rest = [*others, Rect(place.left, place.bottom, place.right, place.top - high)]
                room = round(max(map(_worth, rest)) / ALIKE)
                worth = (min(size, LARGE), room, place.top, size)
                if best is None or worth > best[0]:
                    best = worth, _lettered(lines, size, place), rest
        if best:
            return best[1], best[2]
    letters = len(text_of(forms[0]))
    message = f"task: has {letters} letters; this page has no room for so many"
    if own:
        raise UsageError(message, "try a shorter task, or a wider page")
    raise UsageError(message, "try another size, fewer panels, or leave the task out")


def _lettered(lines: Sequence[Runs], size: float, place: Rect) -> list[Mark]:
    """Return lines of a task, from the top of a place on."""
    first = complex(place.left, place.top - 0.86 * size)
    steps = [first - 1j * PITCH * size * number for number in range(len(lines))]
    return [Mark(Lettering(runs, at, size), "words") for runs, at in zip(lines, steps, strict=True)]


def _free(key: Plan, kept: Sequence[Item], blank: Collection[str]) -> Iterator[Rect]:
    """Yield the places of the page that a problem leaves free, the largest first."""
    page, kept = key.page, [item for item in kept if item.until == FOREVER]
    found: list[Rect] = []
    if page.results:
        table = [item for item in kept if item.region == RESULTS]
        low = reach(table).bottom if table else page.results.top
        found.append(Rect(page.results.left, page.results.bottom, page.results.right, low - CLEAR))
    names = [name for name in page.panels if name in blank]
    drawings = [page.panels[name].drawing for name in names]
    first = list(page.panels).index(names[0])
    if page.columns and names == list(page.panels)[first : first + len(names)]:
        low = max(page.panels[name].region.bottom for name in names)
        low = low if page.results else page.hairline + DROP
        top = min(drawing.bottom for drawing in drawings)
        found.append(Rect(drawings[0].left, low, drawings[-1].right, top))
    else:
        lows = [page.panels[name].region.bottom for name in names]
        found += [
            Rect(each.left, low, each.right, each.bottom)
            for each, low in zip(drawings, lows, strict=True)
        ]
    feet = [foot for name in names if (foot := page.panels[name].foot)]
    if feet:  # where the equations of the key stand together
        low, top = min(foot.bottom for foot in feet), max(foot.top for foot in feet)
        found.append(Rect(feet[0].left, low, feet[0].right, top - CLEAR / 2))
    for name in page.panels.keys() - blank:
        found += _beside_drawing(page.panels[name].drawing, [i for i in kept if i.region == name])
    boxes = [_box(mark) for each in kept for mark in each.marks]
    free = [each for each in found if each.height > 0 and not any(_meet(each, b) for b in boxes)]
    yield from sorted(free, key=lambda each: (-each.width * each.height, each.left))


def _beside_drawing(room: Rect, items: Sequence[Item]) -> list[Rect]:
    """Return the places above and below what is drawn already."""
    drawn = reach(items)
    return [
        Rect(room.left, drawn.top + CLEAR, room.right, room.top - CLEAR / 2),
        Rect(room.left, room.bottom, room.right, drawn.bottom - CLEAR),
    ]


def _meet(one: Rect, other: Rect) -> bool:
    return (
        one.left < other.right
        and other.left < one.right
        and one.bottom < other.top
        and other.bottom < one.top
    )

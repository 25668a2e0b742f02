"""What a problem sheet has and its key has not: a task, lines for name and class, a place to work.

They stand where the page of the key is free, so that everything else stays at its place.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from vad.errors import UsageError
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import TASK, TITLE, Item, Level
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, roman
from vad.plan.lettering.wrapping import Pieces, wrap
from vad.plan.marks import Lettering, Mark, line
from vad.plan.page.free_places import (
    CLEAR,
    DROP,
    bands,
    box_of,
    gaps,
    lasting,
    meet,
    without,
)
from vad.plan.page.heads import unlisted
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
NAME_SIZE, NAME_GAP, BETWEEN = 0.025, 0.012, 0.03
WORKING_SIZE = 0.028
#: The least length of the line for a name, and the share of the room that it takes.
LEAST_NAME, NAME_SHARE = 0.25, 0.72
NAME_APART = 0.004  # from anything else
ABOVE = 0.018  # from the parameters to a line above them
#: From the edge of the page to capital letters at its top, and how high these are.
EDGE, CAPITAL = 0.013, 0.67
FOOT = 0.021  # the baseline of the lines for name and class at the foot of the page
#: How high a free place is at least that is offered for calculations.
WORKING = 0.10
#: Places whose areas differ by less are alike for calculations: the task then stands above.
ALIKE = 0.04


def upon_problem(key: Plan, kept: Sequence[Item], blank: Collection[str], own: str) -> list[Item]:
    """Return the items that only the problem has, where the items that it kept leave room.

    Raises
    ------
    vad.errors.UsageError
        If the task is too long for the page.
    """
    kept = lasting(kept)
    marks, places = _names(key, kept, bands(key, kept, blank))
    narrow = _free_of(marks, gaps(key, kept, blank))
    told, places = _task(key, places, narrow, blank, own)
    marks += told
    room = max(places, key=_worth, default=None)
    if room and _worth(room):
        say = Language(key.sheet.language).say
        y = room.top - CLEAR / 2
        marks.append(line([complex(room.left, y), complex(room.right, y)], "hairline"))
        heading = complex(room.left, y - 1.3 * WORKING_SIZE)
        marks.append(_words(say("working"), heading, WORKING_SIZE))
    return [Item("", TASK, Level.GROUND, tuple(marks))]


def _worth(place: Rect) -> float:
    """Return how much room a place gives for calculations: its area, or 0 where it is too low."""
    return place.width * place.height if place.height >= WORKING else 0.0


def _free_of(marks: Sequence[Mark], places: Iterable[Rect]) -> list[Rect]:
    """Return what marks leave of places."""
    left = list(places)
    for mark in marks:
        left = without(left, box_of(mark))
    return left


def _names(key: Plan, kept: Sequence[Item], places: list[Rect]) -> tuple[list[Mark], list[Rect]]:
    """Return the lines for name and class, and what they leave of the free places.

    They stand beside the title, above the parameters, above the title, in the first of the free
    places that is wide enough, or at the foot of the page.
    """
    page, marks = key.page, [m for item in kept if item.region == TITLE for m in item.marks]
    boxes = list(map(box_of, marks))
    others = [box for box in boxes if box.left >= page.left + CLEAR]
    title, name = max(zip(boxes, marks, strict=True), key=lambda each: each[0].top - each[0].left)
    assert isinstance(name.shape, Lettering)
    start = title.right + 2 * BETWEEN
    end = min((box.left for box in others), default=page.right + 2 * BETWEEN) - 2 * BETWEEN
    high = max((box.top for box in others), default=page.title) + ABOVE
    top = page.height - EDGE - CAPITAL * NAME_SIZE
    for left, right, y in (
        (start, end, name.shape.at.imag),
        (start, page.right, min(high, top)),
        (page.left, end + BETWEEN, top),
    ):
        found = _lines(key, left, right, y)
        if found and not _on(found, boxes):
            return found, places
    for number, place in enumerate(places):
        y = place.top - 1.5 * NAME_SIZE
        if (found := _lines(key, place.left, place.right, y)) and y - CLEAR > place.bottom:
            rest = Rect(place.left, place.bottom, place.right, y - CLEAR)
            return found, [*places[:number], rest, *places[number + 1 :]]
    return _lines(key, page.left, page.right, FOOT), places


def _on(marks: Sequence[Mark], boxes: Sequence[Rect]) -> bool:
    """Tell whether marks come near to one of some boxes."""
    near = [box.inside(-NAME_APART) for box in boxes]
    return any(meet(box_of(mark), box) for mark in marks for box in near)


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
        marks.append(_words(word, complex(x, y), NAME_SIZE))
        x += width(roman(word), NAME_SIZE) + NAME_GAP
        marks.append(line([x + low, x + share * room + low], "writing line"))
        x += share * room + BETWEEN
    return marks


def _words(word: str, at: complex, size: float) -> Mark:
    return Mark(Lettering(roman(word), at, size), "notes")


def _task(
    key: Plan, places: list[Rect], narrow: list[Rect], blank: Collection[str], own: str
) -> tuple[list[Mark], list[Rect]]:
    """Return the task, and what is left of the free places.

    It stands where its type is large, and where most room is left for calculations, else above.
    A shorter form in large type comes before a longer one in small type, if it asks for the same.
    Where no place across the page has room for it, it stands in a ``narrow`` one.
    """
    more = unlisted(key.sheet, key.page)
    forms: tuple[Pieces, ...] = ((TextPiece(own),),) if own else task(key.sheet, blank, more)
    large = tuple(size for size in SIZES if size >= LARGE)
    tried = [(form, large) for form in forms[:-1]] + [(form, SIZES) for form in forms]
    for offered in (places, places + narrow):
        for pieces, sizes in tried:
            if best := _best(pieces, sizes, offered, len(places)):
                return best
        tried += [] if own else [(forms[-1], SMALLEST)]
    letters = len(text_of(forms[0]))
    message = f"task: has {letters} letters; this page has no room for so many"
    if own:
        raise UsageError(message, "try a shorter task, or a wider page")
    raise UsageError(message, "try another size, fewer panels, or leave the task out")


def _best(
    pieces: Pieces, sizes: Sequence[float], places: Sequence[Rect], kept: int
) -> tuple[list[Mark], list[Rect]] | None:
    """Return a task at its best place, and what it leaves of those that are ``kept``."""
    best: tuple[tuple[float, ...], list[Mark], list[Rect]] | None = None
    for place in places:
        for size in sizes:
            lines = wrap(pieces, size, place.width)
            high = size * (1.12 + PITCH * (len(lines) - 1))
            if high > place.height or any(width(runs, size) > place.width for runs in lines):
                continue
            rest = without(
                places[:kept], Rect(place.left, place.top - high, place.right, place.top)
            )
            room = round(max(map(_worth, rest), default=0.0) / ALIKE)
            worth = (min(size, LARGE), room, place.top, size)
            if best is None or worth > best[0]:
                best = worth, _lettered(lines, size, place), rest
    return best and best[1:]


def _lettered(lines: Sequence[Runs], size: float, place: Rect) -> list[Mark]:
    """Return lines of a task, from the top of a place on."""
    first = complex(place.left, place.top - 0.86 * size)
    steps = [first - 1j * PITCH * size * number for number in range(len(lines))]
    return [Mark(Lettering(runs, at, size), "words") for runs, at in zip(lines, steps, strict=True)]

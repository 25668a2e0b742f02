"""What a class sees of lenses, and of points too close to be told apart, in a still.

All is measured on the drawn page, from its marks and the strokes of its sheet: not from the search
for lenses.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise

from tests.plan.knots import EQUAL, LEAST, TINY, distance, points_of, told_apart, vectors_of
from tests.plan.seen_letters import lines_of
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.lens import Lens
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Lettering, Mark
from vad.plan.sketch import Sketch

#: A letter farther from its dot is searched for.
FAR = 100.0 * PIXEL
#: Points are in a crowd, in which letters lack a place, if one is that near to another.
CROWD = 25.0 * PIXEL
#: A leader nearer to the middle of a stroke lies on it.
TOUCHES = 1.5 * PIXEL
STEP = 0.5 * PIXEL
#: What a lens may cover, and its leader cross: a tint and faint construction lines.
FAINT = {"plate", "construction done"}

Fault = tuple[str, str, float]


def faults(board: Plan) -> Iterator[Fault]:
    """Yield the faults of all panels of a still: which, where, and how many pixels.

    ``knot``: two lettered points that are not equal, or the ends of a vector, look like one, and no
    lens tells them apart; ``tiny``, if they are so near that no lens can.  ``far``: a letter is far
    from its dot.  Of a lens, ``needless``: nothing that it shows is crowded; ``useless``: it shows
    a knot, and does not tell it apart; ``alone``: it shows one point; ``covers``: it lies on what
    is drawn; ``crosses``: its leader does.
    """
    for name, sketch in board.sketches.items():
        for fault, what, much in (*_knots(sketch), *_letters(sketch), *_lenses(sketch)):
            yield fault, f"{name} {what}", round(720 * much, 2)


def _dots(sketch: Sketch) -> dict[complex, str]:
    """Return the places of a panel that are not equal, each with its letters."""
    found: dict[complex, list[str]] = {}
    for letter, at in points_of(sketch):
        spot = next((z for z in found if abs(z - at) <= EQUAL), at)
        letters = found.setdefault(spot, [])
        letters += [letter] if letter and letter not in letters else []
    return {at: ", ".join(letters) for at, letters in found.items()}


def _knots(sketch: Sketch) -> Iterator[Fault]:
    named = _dots(sketch)
    pairs = {pair for pair in combinations(named, 2) if named[pair[0]] and named[pair[1]]}
    for ends in vectors_of(sketch):
        one, other = (next(z for z in named if abs(z - end) <= EQUAL) for end in ends)
        if one != other and (other, one) not in pairs:
            pairs.add((one, other))
    for one, other in pairs:
        if abs(one - other) < LEAST and not told_apart(sketch, one, other):
            kind = "knot" if abs(one - other) > TINY else "tiny"
            yield kind, f"{named[one]} / {named[other]}", abs(one - other)


def _letters(sketch: Sketch) -> Iterator[Fault]:
    named = [(letter, at) for letter, at in points_of(sketch) if letter]
    for tag in sketch.tags:
        if tag.span[1] != FOREVER:
            continue
        own = [at for letter, at in named if letter in tag.text.split(", ")]
        own += [lens(at) for lens in sketch.lenses for at in own if _shows(lens, at)]
        off = min((distance(tag.box, at) for at in own), default=0.0)
        if off > FAR:
            yield "far", tag.text, off


def _lenses(sketch: Sketch) -> Iterator[Fault]:
    named = _dots(sketch)
    for lens in sketch.lenses:
        shown = [at for at, letters in named.items() if letters and _shows(lens, at)]
        name = f"×{lens.factor:g} of " + " / ".join(named[at] for at in shown)
        pairs = [ends for ends in combinations(shown, 2) if abs(ends[0] - ends[1]) > TINY]
        near = [ends for ends in pairs if abs(ends[0] - ends[1]) < LEAST]
        if len(shown) < 2:
            yield "alone", name, 0.0
        elif not near:
            others = [abs(at - z) for at in shown for z in named if z != at]
            if min(others) >= CROWD:
                yield "needless", name, min(others)
        elif not any(told_apart(sketch, *ends) for ends in near):
            yield "useless", name, max(abs(a - b) for a, b in near)
        beside = [mark for mark in _beside(sketch) if mark.role not in FAINT]
        covered = sum(_within(mark, lens) for mark in beside)
        if covered:
            yield "covers", name, covered
        crossed = _crossed(lens, beside, sketch)
        if crossed:
            yield "crosses", name, crossed


def _shows(lens: Lens, at: complex) -> bool:
    return abs(lens(at) - lens.at) < lens.radius


def _beside(sketch: Sketch) -> list[Mark]:
    """Return what stays of a panel beside its lenses."""
    stays = (i for i in sketch.items if i.until == FOREVER and i.level is not Level.LENS)
    return [mark for item in stays for mark in item.marks]


def _lines(mark: Mark) -> list[Sequence[complex]]:
    """Return the lines of a mark; of text its box."""
    if not isinstance(mark.shape, Lettering):
        return lines_of(mark)
    box = _box(mark.shape)
    low, high = complex(box.left, box.bottom), complex(box.right, box.top)
    return [(low, complex(high.real, low.imag), high, complex(low.real, high.imag), low)]


def _box(text: Lettering) -> Rect:
    ink, at, size = typeset(text.runs), text.at, text.size
    return Rect(
        at.real + size * ink.left,
        at.imag + size * ink.bottom,
        at.real + size * ink.right,
        at.imag + size * ink.top,
    )


def _within(mark: Mark, lens: Lens) -> float:
    """Return how much of the lines of a mark lies in a lens."""
    spots = [spot for line in _lines(mark) for ends in pairwise(line) for spot in _along(*ends)]
    return STEP * sum(abs(spot - lens.at) < lens.radius for spot in spots)


def _along(start: complex, end: complex) -> list[complex]:
    count = max(1, round(abs(end - start) / STEP))
    return [start + (number + 0.5) / count * (end - start) for number in range(count)]


def _crossed(lens: Lens, beside: list[Mark], sketch: Sketch) -> float:
    """Return how much of the leader of a lens lies on strokes, letters, or another lens.

    It counts where it is broken, too.
    """
    strokes = [ends for mark in beside for line in _lines(mark) for ends in pairwise(line)]
    boxes = [_box(mark.shape) for mark in beside if isinstance(mark.shape, Lettering)]
    boxes += [
        _box(mark.shape)
        for item in sketch.items
        if item.level is Level.LENS and item.until == FOREVER
        for mark in item.marks
        if isinstance(mark.shape, Lettering)
    ]
    others = [other for other in sketch.lenses if other is not lens]
    lies = 0
    for spot in _along(*lens.leader):
        lies += (
            any(_off(spot, *stroke) < TOUCHES for stroke in strokes)
            or any(distance(box, spot) < TOUCHES for box in boxes)
            or any(abs(spot - other.at) < other.radius for other in others)
            or any(abs(spot - other.place) < other.ring for other in others)
        )
    return STEP * lies


def _off(spot: complex, start: complex, end: complex) -> float:
    """Return how far a place is from a stroke."""
    if start == end:
        return abs(spot - start)
    along = ((spot - start) / (end - start)).real
    return abs(spot - start - min(max(along, 0.0), 1.0) * (end - start))

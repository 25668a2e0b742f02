"""What a class sees of the letters of a still: what they lie on, and whose they are.

All is measured on the drawn page: its marks with the widths of their lines, as far as no lens
covers them.  Nothing is asked of the search for places.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np

from tests.plan.knots import points_of
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import CAPTION, FLIGHT, Item, Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.lettering.glyphs import typeset
from vad.plan.lettering.runs import plain
from vad.plan.marks import Bow, Disc, Lettering, Mark, Polygon, Polyline
from vad.plan.roles import ROLES

#: Tints, bands of the background, and faint lines: with its halo, a letter is read on them.
PALE = {"plate", "ball", "lens", "lens band", "gap", "bar casing", "slit"}
PALE |= {"construction done", "hairline"}
#: What belongs to a text.
WRITTEN = {"leader", "rule", "pale rule", "key", "scale bar"}
WRITTEN |= {"chapter", "chapter done", "chapter ahead"}
DOTS = {"dot", "joint", "point"}
#: Lines that bear names.
NAMED = {"vector", "whole", "bar", "path", "edge", "piston rod", "slot"}
#: So deep in its box, a stroke touches a letter.
TOUCHES = 0.5 * PIXEL
#: Two texts in one line that are nearer are read as one.
RUNS_ON = 3.0 * PIXEL
#: Farther from its dot than so, a letter may name another dot that is not farther by this factor.
BESIDE, CLEARLY = 16.0 * PIXEL, 1.15
#: Farther from its dot without a leader, a letter is not seen to name it.
FARTHEST = 40.0 * PIXEL
#: So near to the way of a leader, another dot may be the one at which it ends.
ON_WAY = 5.0 * PIXEL
#: A leader that is longer must be followed with a finger.
LONGEST = 120.0 * PIXEL
#: A name farther from its line is not seen to be of it; so near it always is.
LINE_FAR, LINE_NEAR = 30.0 * PIXEL, 8.0 * PIXEL


@dataclass(frozen=True)
class Word:
    """A text on the page, with the boxes of its letters."""

    text: str
    role: str
    item: Item
    letters: tuple[Rect, ...]

    @property
    def box(self) -> Rect:
        """The box of its ink."""
        low = [complex(each.left, each.bottom) for each in self.letters]
        high = [complex(each.right, each.top) for each in self.letters]
        return Rect(
            min(z.real for z in low),
            min(z.imag for z in low),
            max(z.real for z in high),
            max(z.imag for z in high),
        )


@dataclass(frozen=True)
class Fault:
    """A fault of a text: its kind, what it says, where it is, and what it has to do with."""

    kind: str
    text: str
    at: complex
    of: str = ""


def faults(board: Plan) -> Iterator[Fault]:
    """Yield the faults of the letters of a still."""
    shown = [i for i in board.shown(board.finished) if i.region not in (CAPTION, FLIGHT)]
    page = Rect(0.0, 0.0, board.form.width, 1.0)
    words = list(_words(shown))
    yield from _on_words(words)
    lenses = [z for z in _shapes(shown, {"lens band"}) if isinstance(z, Disc)]
    for word in words:
        region = board.regions[word.item.region] if word.item.region in board.sketches else page
        if not _within(word.box, region):
            yield Fault("off its panel", word.text, word.box.centre)
    for name, sketch in board.sketches.items():
        items = [item for item in shown if item.region == name]
        own = [word for word in words if word.item.region == name]
        for word in own:
            met = sorted(_met(word, items, lenses))
            if met:
                yield Fault("on a stroke", word.text, word.box.centre, ", ".join(met))
        yield from _on_leaders(own, items)
        if sketch.setting.panel.picture == "vectors":
            yield from _of_lines(own, items)
        for lensed in (False, True):
            yield from _assigned(board, name, own, items, lensed)


def _words(items: Sequence[Item]) -> Iterator[Word]:
    for item in items:
        for mark in item.marks:
            if isinstance(mark.shape, Lettering):
                boxes = tuple(_letters(mark.shape))
                if boxes:
                    yield Word(plain(mark.shape.runs), mark.role, item, boxes)


def _letters(shape: Lettering) -> Iterator[Rect]:
    for letter in typeset(shape.runs).letters:
        if len(letter.vertices):
            low, high = (
                shape.at + shape.size * (letter.at + letter.size * corner) for corner in letter.ink
            )
            yield Rect(low.real, low.imag, high.real, high.imag)


def _shapes(items: Sequence[Item], roles: set[str]) -> Iterator[object]:
    return (mark.shape for item in items for mark in item.marks if mark.role in roles)


def _within(box: Rect, room: Rect) -> bool:
    room = room.inside(-PIXEL)
    return room.holds(complex(box.left, box.bottom)) and room.holds(complex(box.right, box.top))


# --- what letters lie on --------------------------------------------------------------------------


def lines_of(mark: Mark) -> list[Sequence[complex]]:
    """Return the lines of a mark; text has none."""
    match mark.shape:
        case Polyline(pieces):
            return list(pieces)
        case Polygon(rings):
            return [(*ring, ring[0]) for ring in rings]
        case Bow():
            return [mark.shape.line(2.0)]
        case Disc(centre, radius):
            return [Bow(centre, radius, 0.0, 360.0).line(10.0)]
        case _:
            return []


def _met(word: Word, items: Sequence[Item], lenses: Sequence[Disc]) -> Iterator[str]:
    """Yield the roles of the strokes that a text lies on."""
    box = word.box
    for item in items:
        for mark in item.marks:
            if mark.role in PALE | WRITTEN or isinstance(mark.shape, Lettering):
                continue
            half = mark.width * ROLES[mark.role].width / 2 if ROLES[mark.role].line else 0.0
            about = box.inside(-half)
            for start, end in (part for line in lines_of(mark) for part in pairwise(line)):
                x, y = sorted((start.real, end.real)), sorted((start.imag, end.imag))
                if x[0] > about.right or x[1] < about.left:
                    continue
                if y[0] > about.top or y[1] < about.bottom:
                    continue
                along = _sampled(start, end)
                if item.level < Level.LENS:
                    for lens in lenses:
                        along = along[np.abs(along - lens.centre) >= lens.radius]
                for letter in word.letters if len(along) else ():
                    inner = letter.inside(min(TOUCHES, letter.width / 4, letter.height / 4))
                    if _off(inner, along) <= half:
                        yield mark.role


def _sampled(start: complex, end: complex) -> np.ndarray:
    """Return points along a line, half a pixel apart, as far as it may be on the page."""
    count = min(4000, max(2, math.ceil(abs(end - start) / (0.5 * PIXEL))))
    return start + (end - start) * np.linspace(0.0, 1.0, count)


def _off(box: Rect, along: np.ndarray) -> float:
    """Return how far a box is from the nearest of some points."""
    aside = np.maximum(np.maximum(box.left - along.real, along.real - box.right), 0.0)
    above = np.maximum(np.maximum(box.bottom - along.imag, along.imag - box.top), 0.0)
    return float(np.hypot(aside, above).min())


def _on_words(words: Sequence[Word]) -> Iterator[Fault]:
    for one, other in combinations(words, 2):
        aside, above = _apart(one.box, other.box)
        if aside > RUNS_ON or above > 0.0:
            continue
        if any(max(_apart(x, y)) < -TOUCHES for x in one.letters for y in other.letters):
            yield Fault("on another", one.text, one.box.centre, other.text)
        elif one.item.region == other.item.region and one.item.level >= Level.LABEL:
            beside = above < -0.4 * min(one.box.height, other.box.height)
            if aside > 0.0 and beside and not other.text.startswith(","):
                yield Fault("runs on", one.text, one.box.centre, other.text)


def _apart(a: Rect, b: Rect) -> tuple[float, float]:
    aside = max(a.left - b.right, b.left - a.right)
    return aside, max(a.bottom - b.top, b.bottom - a.top)


def _on_leaders(words: Sequence[Word], items: Sequence[Item]) -> Iterator[Fault]:
    for leader in _shapes(items, {"leader"}):
        assert isinstance(leader, Polyline)
        ends = [(piece[0], piece[-1]) for piece in leader.pieces]
        for word in words:
            boxes = [each.inside(TOUCHES) for each in word.letters]
            if any(box.clipped(*each) for box in boxes for each in ends):
                yield Fault("on a leader", word.text, word.box.centre)


# --- whose letters are ----------------------------------------------------------------------------


def _assigned(
    board: Plan, name: str, words: Sequence[Word], items: Sequence[Item], lensed: bool
) -> Iterator[Fault]:
    """Yield the letters of points, in lenses or beside them, that seem to name another one."""
    sketch = board.sketches[name]
    items = [item for item in items if (item.level == Level.LENS) is lensed]
    lenses = [] if lensed else [(lens.at, lens.radius) for lens in sketch.lenses]
    dots = [z.centre for z in _shapes(items, DOTS) if isinstance(z, Disc)]
    dots = [dot for dot in dots if all(abs(dot - at) > radius for at, radius in lenses)]
    places: dict[str, list[complex]] = {}
    for letter, at in points_of(sketch):
        seen = [lens(at) for lens in sketch.lenses if abs(lens(at) - lens.at) < lens.radius]
        places.setdefault(letter, []).extend(seen if lensed else [at])
    for word in _joined([each for each in words if each.role == "letter" and each.item in items]):
        own = places.get(word.text.split(",")[0].strip(), [])
        if own:
            at = min(own, key=lambda z: _distance(word.box, z))
            others = [z for z in dots if min(abs(z - each) for each in own) > 0.5 * PIXEL]
            leader = _leader(word, items)
            found = _led(at, others, leader) if leader else _bare(word, at, others)
            for kind, of in found:
                yield Fault(kind, word.text, word.box.centre, of)


def _bare(word: Word, own: complex, others: Sequence[complex]) -> Iterator[tuple[str, str]]:
    """Yield the faults of a letter beside its dot: of what kind, and how far it is from dots."""
    off = _distance(word.box, own)
    away = min((_distance(word.box, z) for z in others), default=math.inf)
    told = f"{off / PIXEL:.0f} {away / PIXEL:.0f}"
    if away <= off:
        yield "nearer to another", told
    elif off > BESIDE and away < CLEARLY * off:
        yield "between two", told
    if off > FARTHEST:
        yield "far without leader", told


def _led(
    own: complex, others: Sequence[complex], leader: tuple[complex, complex]
) -> Iterator[tuple[str, str]]:
    """Yield the faults of a leader: of what kind, and how long it is."""
    start, end = sorted(leader, key=lambda z: abs(z - own))
    way, told = (own - end) / abs(own - end), f"{abs(start - end) / PIXEL:.0f}"
    for other in others:
        along, across = ((other - end) / way).real, abs(((other - end) / way).imag)
        if abs(other - start) < abs(own - start):
            yield "leader ends at another", told
            break
        if across < ON_WAY and 0.0 < along < abs(own - end) - 0.5 * PIXEL:
            yield "leader passes another", told
            break
    if abs(start - end) > LONGEST:
        yield "long leader", told


def _joined(words: Sequence[Word]) -> list[Word]:
    """Return words of which those of one item, in several lines, are one."""
    found: list[Word] = []
    for word in words:
        last = found[-1] if found else None
        if last and last.item is word.item:
            text, letters = f"{last.text}, {word.text}", last.letters + word.letters
            found[-1] = Word(text, word.role, word.item, letters)
        else:
            found.append(word)
    return found


def _leader(word: Word, items: Sequence[Item]) -> tuple[complex, complex] | None:
    for shape in _shapes(items, {"leader"}):
        if isinstance(shape, Polyline):
            ends = shape.pieces[0]
            if min(_distance(word.box, z) for z in ends) < 0.008:
                return ends[0], ends[-1]
    return None


def _of_lines(words: Sequence[Word], items: Sequence[Item]) -> Iterator[Fault]:
    """Yield the names of lines and vectors that stand far from them, or nearer to others."""
    lines = [
        (item.stroke, mark)
        for item in items
        for mark in item.marks
        if mark.role in NAMED and item.level < Level.LENS
    ]
    for word in words:
        own = [mark for stroke, mark in lines if stroke == word.item.stroke]
        alone = all(mark.role in ("tag", "leader") for mark in word.item.marks)
        if not (alone and own) or word.item.level == Level.LENS or _leader(word, items):
            continue
        off = min(_from(word.box, mark) for mark in own)
        others = [mark for stroke, mark in lines if stroke != word.item.stroke]
        near = min((_from(word.box, mark) for mark in others), default=math.inf)
        told = f"{off / PIXEL:.0f} {near / PIXEL:.0f}"
        if off > LINE_FAR:
            yield Fault("far from its line", word.text, word.box.centre, told)
        elif off > LINE_NEAR and near < off:
            yield Fault("nearer to another line", word.text, word.box.centre, told)


def _from(box: Rect, mark: Mark) -> float:
    parts = (part for line in lines_of(mark) for part in pairwise(line))
    return min((_off(box, _sampled(*part)) for part in parts), default=math.inf)


def _distance(box: Rect, point: complex) -> float:
    return _off(box, np.array([point]))

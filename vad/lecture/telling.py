"""What is said of a stroke, and how long that takes: captions in beats, read at a steady pace.

A caption is read at `LETTERS_PER_SECOND`, and each number in it takes about a second, because
"13.23 rad/s" takes longer to say than to see.  A calculation is said in three beats: the symbols,
then the numbers, then the result.  Strokes that need few words are told together: a pivot and a
guide, an arc and the point on it.  Strokes of which the same is said are one step of the lecture.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise

from vad.strokes.arithmetic import Terms
from vad.strokes.sentences import Sentence, pieces_of
from vad.strokes.sheet import Panel, Stroke
from vad.words import TextPiece, text_of

#: Nobody reads more than 17 printed letters a second; numbers, which take longer, not included.
LETTERS_PER_SECOND = 16.2
#: Seconds that a number takes, and each of its digits.
NUMBER, DIGIT = 0.4, 0.1
#: The pace of what has hardly any words beside its numbers.
MOST_PER_SECOND = 16.5
#: Seconds to understand a beat, whatever its length.
UNDERSTOOD = 1.0
#: Two strokes are told together if their captions have no more letters than this.
TOGETHER = 120

Pieces = tuple[TextPiece, ...]

_EQUALS = " = "
_NUMBER = re.compile(r"\d+(?:[.,\N{NARROW NO-BREAK SPACE}]\d+)*")
#: Which kinds of strokes of a mechanism are told together, and in polygons.
_PAIRS = {
    ("fixed", "fixed"),
    ("fixed", "guide"),
    ("guide", "guide"),
    ("known", "angle"),
    ("construction", "intersection"),
    ("result", "result"),
}
_PAIRS_OF_VECTORS = {("construction", "intersection")}


def reading(pieces: Pieces) -> float:
    """Return how many seconds it takes to read pieces.

    Examples
    --------
    >>> round(reading((TextPiece("b", "symbol"), TextPiece(" is the head of it."))), 2)
    1.23
    """
    text = text_of(pieces)
    numbers = [piece.text for piece in pieces if piece.kind == "figure"]
    if len(pieces) == 1:  # a caption of the lecturer's own
        numbers = _NUMBER.findall(text)
    digits = sum(map(len, numbers))
    said = NUMBER * len(numbers) + DIGIT * digits
    return max((len(text) - digits) / LETTERS_PER_SECOND + said, len(text) / MOST_PER_SECOND)


def beats(said: str | Sentence) -> tuple[Pieces, ...]:
    """Return a caption in its beats: symbols, numbers and result of a calculation.

    A caption that calculates nothing has one.

    Examples
    --------
    >>> import vad
    >>> strokes = vad.draw(vad.solve(vad.FourBar())).panel("velocity").strokes
    >>> [text_of(beat) for beat in beats(strokes[1].said)][:2]
    ['ab = ω₂·AB', ' = 10 × 40']
    """
    pieces = pieces_of(said)
    count = _operands(said)
    figures = [number for number, piece in enumerate(pieces) if piece.kind == "figure"]
    if not count or len(figures) <= count:
        return (pieces,)
    numbers = _sign_before(pieces, figures[0])
    result = _sign_before(pieces, figures[count])
    if numbers is None or result is None or not numbers < result:
        return (pieces,)
    cuts = [(0, 0), numbers, result, (len(pieces), 0)]
    return tuple(_between(pieces, start, end) for start, end in pairwise(cuts))


def _operands(said: str | Sentence) -> int:
    """Return how many numbers a caption calculates with; 0 where it does not."""
    if not isinstance(said, Sentence) or len(said.calculations) != 1:
        return 0
    parts = (said.parts[name] for name in said.calculations[0].operands if isinstance(name, str))
    return sum(len(part.addends) if isinstance(part, Terms) else 1 for part in parts)


def _sign_before(pieces: Pieces, figure: int) -> tuple[int, int] | None:
    """Return the piece and the place in it of the last equals sign before a number."""
    for number in reversed(range(figure)):
        place = pieces[number].text.rfind(_EQUALS) if pieces[number].kind == "words" else -1
        if place >= 0:
            return number, place
    return None


def _between(pieces: Pieces, start: tuple[int, int], end: tuple[int, int]) -> Pieces:
    """Return the pieces from one place to another; one in which a cut lies is divided."""
    found: list[TextPiece] = []
    for number in range(start[0], min(end[0] + 1, len(pieces))):
        text = pieces[number].text
        text = text[: end[1]] if number == end[0] else text
        text = text[start[1] :] if number == start[0] else text
        if text:
            found.append(TextPiece(text, pieces[number].kind))
    return tuple(found)


def starts(said: str | Sentence) -> tuple[float, ...]:
    """Return the seconds after which the second beat of a caption begins, and the third.

    Beside its letters each beat takes a moment to be understood, so a short one gets more than its
    share.
    """
    times = [reading(beat) for beat in beats(said)]
    share = sum(times) / (sum(times) + UNDERSTOOD * len(times))
    return tuple(accumulate(share * (time + UNDERSTOOD) for time in times[:-1]))


def told_together(panel: Panel) -> Iterator[tuple[int, int]]:
    """Yield the first and last number of strokes that are told together, in drawing order.

    What is on the board when drawing may begin is not told together with what is drawn then.
    """
    pairs = _PAIRS_OF_VECTORS if panel.picture == "vectors" else _PAIRS
    strokes, number = panel.strokes, 0
    while number < len(strokes):  # Each round tells one stroke, two, or all of one caption.
        last = number
        while share_caption(strokes, last):  # Each round adds a stroke.
            last += 1
        if last == number and _are_pair(strokes[number : number + 2], pairs):
            last += 1
        begins = (each for each in range(number + 1, last + 1) if _is_begin(panel, each))
        last = next(begins, last + 1) - 1
        yield number, last
        number = last + 1


def share_caption(strokes: Sequence[Stroke], number: int) -> bool:
    """Tell whether the same is said of a stroke and of the next one."""
    one, other = strokes[number], strokes[number + 1 : number + 2]
    return bool(one.said) and bool(other) and other[0].said == one.said


def _is_begin(panel: Panel, number: int) -> bool:
    """Tell whether a loop after the first begins, or what is drawn after all that is there.

    The pole may be told together with the first vector.
    """
    return number == panel.given or number in panel.loops[1:]


def _are_pair(strokes: Sequence[Stroke], pairs: set[tuple[str, str]]) -> bool:
    if len(strokes) != 2 or (strokes[0].kind, strokes[1].kind) not in pairs:
        return False
    one, other = strokes
    if len(beats(one.said)) > 1 or len(beats(other.said)) > 1:
        return False
    return len(one.caption) + len(other.caption) < TOGETHER


def told(panel: Panel, first: int, last: int) -> Pieces:
    """Return what is said of the strokes of a panel from ``first`` to ``last``."""
    strokes = panel.strokes[first : last + 1]
    if len(strokes) > 1 and share_caption(strokes, 0):
        return pieces_of(strokes[0].said)
    captions = [pieces_of(stroke.said) for stroke in strokes]
    found = captions[0]
    for pieces in captions[1:]:
        found = (*found, TextPiece(" "), *pieces) if found and pieces else found or pieces
    return found

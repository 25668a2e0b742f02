"""Lines of text in stretches: what a medium with type of its own can set in one go.

In come runs, out go letters that share a face and a size, each standing where the pen is after the
one before.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise

from vad.plan.lettering.glyphs import Letter, typeset
from vad.plan.lettering.runs import Runs

Stretch = tuple[Letter, ...]


@lru_cache(maxsize=1024)
def stretches(runs: Runs) -> tuple[Stretch, ...]:
    """Return the letters of a line, broken wherever the face, the size or the way changes."""
    letters = typeset(runs).letters
    breaks = [number for number, pair in enumerate(pairwise(letters), 1) if not _follows(*pair)]
    ends = [0, *breaks, len(letters)]
    return tuple(letters[start:end] for start, end in pairwise(ends) if end > start)


def _follows(before: Letter, letter: Letter) -> bool:
    """Tell whether a letter is the next one of the same stretch."""
    pen = before.at + before.size * before.advance
    alike = (letter.face, letter.size) == (before.face, before.size)
    return alike and abs(letter.at - pen) < 1e-6

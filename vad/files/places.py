"""The places that a point can take: words and coordinates, as they are written."""

from __future__ import annotations

from contextlib import suppress

from vad import gate
from vad.errors import InputError

#: The direction in which the place of each word lies.
WORDS = {"upper": 1j, "lower": -1j, "left": -1.0 + 0j, "right": 1.0 + 0j}
#: The word for a parallelogram that stays one; it is a rule and no place.
PARALLEL = "parallel"
HINT = "upper, lower, left, right, parallel, or coordinates near it"

# Places that are nearer to each other than this share of the larger one are not told apart.
SAME = 1e-9

Place = str | complex


def place_of(value: object) -> Place | None:
    """Return the place that a value of a file means; None if it means none.

    Examples
    --------
    >>> place_of("upper"), place_of([3, 4]), place_of("above")
    ('upper', (3+4j), None)
    """
    if isinstance(value, str):
        return value if value in (*WORDS, PARALLEL) else None
    if isinstance(value, list | tuple) and len(value) == 2:
        with suppress(InputError):
            return complex(*(gate.dimension("", each, signed=True) for each in value))
    return None


def opposite(word: str) -> str:
    """Return the word for the other place.

    Examples
    --------
    >>> opposite("upper")
    'lower'
    """
    return next(each for each in WORDS if WORDS[each] == -WORDS[word])


def words_for(place: complex, other: complex) -> list[str]:
    """Return the words that tell a place from another, the clearest first.

    Examples
    --------
    >>> words_for(3 + 4j, 2 - 1j)
    ['upper', 'right']
    """
    ways = {word: ahead(word, place) - ahead(word, other) for word in WORDS}
    least = SAME * max(abs(place), abs(other))
    return sorted((word for word in ways if ways[word] > least), key=lambda word: -ways[word])


def ahead(want: Place, place: complex) -> float:
    """Return how well a place fits what is wanted: the greater, the better."""
    if isinstance(want, str):
        return (place * WORDS[want].conjugate()).real
    return -abs(place - want)

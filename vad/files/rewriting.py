"""A mechanism's file with other numbers: its own text, in which they stand instead.

What is written beside them stays: comments, titles, expressions.  Which number of the text a
parameter or an input is, is found by trial: the text is read again with the new number, and only
that one may have changed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields
from itertools import islice, product
from typing import Any

from vad.errors import InputError, VadError
from vad.files.loading import MOST_WAYS, WrittenMechanism, class_of
from vad.files.reading import describe
from vad.files.tables import read_text
from vad.kinematics.motion import solve
from vad.units import number_of

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
#: A number as TOML writes it, or a text, which may be one with a unit.
_LITERAL = re.compile(rf"""(["'])(?P<text>[^"'\n]*)\1|(?<![\w."']){_NUMBER}(?![\w."'])""")
#: Places are the same if they differ by no more than this share of the largest.
_SAME = 1e-9


def rewritten(mechanism: WrittenMechanism, inputs: Mapping[str, float]) -> str:
    """Return the file of a mechanism with the mechanism's own numbers and places, in a pose.

    Parameters
    ----------
    mechanism
        One that a file describes.
    inputs
        The pose, in which it closes; what is left out stays.

    Raises
    ------
    vad.errors.InputError
        If it comes from no file, or the file cannot say it.

    Examples
    --------
    >>> from vad.files.examples import example_path
    >>> from vad.files.loading import load
    >>> text = rewritten(load(example_path("toggle-press"))(crank=170), {"angle": 50})
    >>> for line in text.splitlines():
    ...     if line.startswith("crank"):
    ...         print(line)
    crank  = { OA = 170.0 }
    crank = { angle = 50, omega = "180 rpm", alpha = 50 }
    """
    source = mechanism.written.source
    text, kind = source.text, type(mechanism)
    if not text:
        raise InputError(f"{mechanism.name}: is from no file", "vad example four-bar prints one")
    wanted = {**mechanism.written.values, **kind.inputs}
    for name, value in {**mechanism.parameters(), **inputs}.items():
        if value != wanted.get(name, value):
            wanted[name] = value
            tried = _with_number(text, kind, name, value)
            text = next((each for each in tried if _numbers(source.name, each) == wanted), "")
            if not text:
                raise InputError(f"{name}: cannot be written into {source.name}")
    places, wrong = _places(mechanism, inputs), VadError("")
    for each in _with_words(text, kind):
        try:
            if _near(_places(class_of(read_text(each, source.name))(), inputs), places):
                return each
        except VadError as error:  # in the file's own pose, or with these words, it does not close
            wrong = error
    raise InputError(str(wrong) or f"assembly: cannot be written into {source.name}", wrong.hint)


def _with_number(text: str, kind: type[WrittenMechanism], name: str, value: float) -> Iterator[str]:
    """Yield the text with another number in each place that has the own one.

    After these, yield it with an input that it leaves out beside each number.
    """
    own: Any = next((field for field in fields(kind) if field.name == name), None)
    default = own.default if own else kind.inputs[name]
    quantity = own.metadata["quantity"] if own else name
    literals = list(_LITERAL.finditer(text))
    for found in literals:
        try:
            number = number_of("", found["text"] or found[0], quantity, kind().length_unit)
        except VadError:
            continue
        if number == default:
            yield f"{text[: found.start()]}{value!r}{text[found.end() :]}"
    if not own:
        for found, gap in product(literals, (", ", "\n")):
            yield f"{text[: found.end()]}{gap}{name} = {value!r}{text[found.end() :]}"


def _with_words(text: str, kind: type[WrittenMechanism]) -> Iterator[str]:
    """Yield the text with the words of places, its own first."""
    written = kind.written
    said = {
        point: words
        for point, words in written.words.items()
        if written.source.table("assembly").get(point)
    }
    for words in islice(product(*said.values()), MOST_WAYS):
        lines = text.split("\n")
        for point, word in zip(said, words, strict=True):
            line = written.source.lines["assembly", point] - 1
            lines[line] = re.sub(
                rf"""(\b{point}\s*=\s*)["'][^"']*["']""", rf'\g<1>"{word}"', lines[line], count=1
            )
        yield "\n".join(lines)


def _numbers(name: str, text: str) -> dict[str, float]:
    """Return the parameters and inputs of a file; none of one that cannot be read."""
    try:
        found = describe(read_text(text, name))
    except VadError:
        return {}
    parameters = {each: parameter.default for each, parameter in found.parameters.items()}
    return {**parameters, **found.driver.inputs}


def _places(mechanism: WrittenMechanism, inputs: Mapping[str, float]) -> list[complex]:
    motion = solve(mechanism, **inputs)
    return [motion.point(letter).position for letter in mechanism.written.description.points]


def _near(one: list[complex], other: list[complex]) -> bool:
    largest = max(map(abs, other))
    return all(abs(a - b) <= _SAME * largest for a, b in zip(one, other, strict=True))

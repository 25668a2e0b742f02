"""What the mechanism of a sheet bears: the words load, mass, inertia, gravity and friction."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from vad.batches.job import Recipe
from vad.errors import InputError, VadError, quoted
from vad.kinematics.motion import solve
from vad.mechanisms import Mechanism
from vad.statics.burden import Burden, burden_of, check_burden
from vad.statics.forces import forces_of

#: The words that are lists of texts; gravity is one text.
_LISTED = ("load", "mass", "inertia", "friction")


def _texts(word: str, value: object) -> tuple[str, ...]:
    """Return what stands behind a word, each text checked as an option of that name is."""
    texts = [value] if isinstance(value, str) else value
    if not isinstance(texts, list | tuple) or not all(isinstance(each, str) for each in texts):
        raise InputError(f"must be a text or a list of texts, got {quoted(value)}")
    _read(**{word: tuple(texts)})
    return tuple(texts)


def _gravity(value: object) -> str:
    given = value if isinstance(value, list) else [value]
    text = ", ".join(str(each) for each in given)
    _read(gravity=text)
    return text


def _read(**words: Any) -> Burden:
    """Return the burden of some words; errors begin with the word."""
    try:
        return burden_of(**words)
    except VadError as error:
        raise _of_word(error) from None


def _of_word(error: VadError) -> InputError:
    """Return the error of an option as that of a word."""
    return InputError(str(error).removeprefix("--"), error.hint and error.hint.replace("--", ""))


#: How each word is read.
BURDEN_WORDS: dict[str, Callable[[object], Any]] = {
    **{word: partial(_texts, word) for word in _LISTED},
    "gravity": _gravity,
}


def burden_in(words: Mapping[str, Any]) -> Burden:
    """Return what the words of a sheet, as they have been read, say that it bears."""
    return _read(**{word: words[word] for word in BURDEN_WORDS if word in words})


def check_borne(kind: type[Mechanism], burden: Burden, options: Mapping[str, Any]) -> None:
    """Check that a mechanism as it is usually has all bodies, points and slides of a burden.

    Raises
    ------
    vad.errors.InputError
        For what acts nowhere, and for gravity without a mass or friction without a load.
    """
    known = {name: options[name] for name in ("points", "length_unit") if name in options}
    motion = solve(kind(**known))
    try:
        check_burden(motion.mechanism.burden, burden)
        forces_of(motion, burden)
    except VadError as error:
        raise _of_word(error) from None


def check_recipe(recipe: Recipe, kind: type[Mechanism], more: Burden) -> None:
    """Check what comes to the burden of the sheets of a recipe; errors are those of `check_borne`.

    Those that bear nothing have nothing to be checked.
    """
    both = recipe.burden.beside(more)
    if both or both.gravity is not None or both.friction:
        check_borne(kind, both, dict(recipe.options))

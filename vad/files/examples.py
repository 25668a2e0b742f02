"""The files that ship with the program: examples to begin with, and exercises of textbooks.

Among the examples mechanisms stand in one folder, shafts and engines in another.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from vad.errors import one_of

EXTENSION = ".toml"
_EXAMPLES = Path(__file__).parents[1] / "examples"
_EXERCISES = _EXAMPLES.with_name("exercises")
_ROTORS = _EXAMPLES / "balancing"


@cache
def example_names() -> tuple[str, ...]:
    """Return the names of all mechanisms among the examples, in the order of the alphabet."""
    return _names(_EXAMPLES)


@cache
def rotor_names() -> tuple[str, ...]:
    """Return the names of all shafts and engines among the examples, likewise."""
    return _names(_ROTORS)


def all_names() -> tuple[str, ...]:
    """Return the names of all examples: mechanisms, then shafts and engines."""
    return *example_names(), *rotor_names()


def _names(folder: Path) -> tuple[str, ...]:
    return tuple(sorted(path.stem for path in folder.glob(f"*{EXTENSION}")))


def example_path(name: str) -> Path:
    """Return where an example is.

    Raises
    ------
    vad.errors.UsageError
        For a name that no example has.
    """
    folder = _ROTORS if one_of("example", name, all_names()) in rotor_names() else _EXAMPLES
    return folder / (name + EXTENSION)


def example_title(name: str, language: str = "en") -> str:
    """Return what an example is, in a few words of a language.

    Examples
    --------
    >>> example_title("hoeken", "de")
    'Hoekens Geradführung'
    """
    import tomllib

    found = tomllib.loads(example_path(name).read_text("utf-8"))
    own = found.get("names", {}).get(language, {})
    return str(own.get("title", found["title"]))


@cache
def exercise_names() -> tuple[str, ...]:
    """Return the names of all exercises by author and number: khurmi-7-2 before khurmi-7-10."""
    names = (path.stem for path in _EXERCISES.glob(f"*{EXTENSION}"))
    return tuple(sorted(names, key=lambda name: [part.zfill(3) for part in name.split("-")]))


def exercise_path(name: str) -> Path:
    """Return where an exercise is.

    Raises
    ------
    vad.errors.UsageError
        For a name that no exercise has.
    """
    return _EXERCISES / (one_of("exercise", name, exercise_names()) + EXTENSION)

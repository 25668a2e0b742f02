"""The files that ship with the program: examples to begin with, and exercises of textbooks."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from vad.errors import one_of

EXTENSION = ".toml"
_EXAMPLES = Path(__file__).parents[1] / "examples"
_EXERCISES = _EXAMPLES.with_name("exercises")


@cache
def example_names() -> tuple[str, ...]:
    """Return the names of all examples, in the order of the alphabet."""
    return tuple(sorted(path.stem for path in _EXAMPLES.glob(f"*{EXTENSION}")))


def example_path(name: str) -> Path:
    """Return where an example is.

    Raises
    ------
    vad.errors.UsageError
        For a name that no example has.
    """
    return _EXAMPLES / (one_of("example", name, example_names()) + EXTENSION)


def example_title(name: str) -> str:
    """Return what an example is, in a few words."""
    import tomllib

    return str(tomllib.loads(example_path(name).read_text("utf-8"))["title"])


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

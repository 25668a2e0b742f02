"""The examples that ship with the program: files to begin with."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from vad.errors import one_of

EXTENSION = ".toml"
_HOME = Path(__file__).parents[1] / "examples"


@cache
def example_names() -> tuple[str, ...]:
    """Return the names of all examples, in the order of the alphabet."""
    return tuple(sorted(path.stem for path in _HOME.glob(f"*{EXTENSION}")))


def example_path(name: str) -> Path:
    """Return where an example is.

    Raises
    ------
    vad.errors.UsageError
        For a name that no example has.
    """
    return _HOME / (one_of("example", name, example_names()) + EXTENSION)


def example_title(name: str) -> str:
    """Return what an example is, in a few words."""
    import tomllib

    return str(tomllib.loads(example_path(name).read_text("utf-8"))["title"])

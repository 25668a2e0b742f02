"""What a page says besides its lesson: in comes a language, out go words of ``words/en.toml``."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files


@cache
def phrases(code: str) -> Mapping[str, Mapping[str, str]]:
    """Return the tables ``player`` and ``spoken`` of a language; what it lacks stays English."""
    home = files(__package__) / "words"
    tables: list[dict[str, dict[str, str]]] = [
        tomllib.loads(path.read_text("utf-8"))
        for name in ("en", code)
        if (path := home / f"{name}.toml").is_file()
    ]
    return {name: tables[0][name] | tables[-1][name] for name in tables[0]}

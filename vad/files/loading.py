"""Mechanisms from files and from tables: in comes a path or its tables, out goes a class."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vad.files.tables import Source, read_file, sorted_out
from vad.files.written_mechanism import WrittenMechanism, class_of

Table = Mapping[str, Any]


def load(path: str | Path) -> type[WrittenMechanism]:
    """Return the mechanism that a file describes: a class like `vad.FourBar`.

    Parameters
    ----------
    path
        A file in TOML, such as those that ``vad example`` prints.

    Raises
    ------
    vad.errors.InputError
        With the file's name and the line, for what cannot be read or cannot move.

    Examples
    --------
    >>> from vad.files.examples import example_path
    >>> Press = load(example_path("toggle-press"))
    >>> Press(crank=170).parameters()["rod"]
    540.0
    """
    return class_of(read_file(path))


def mechanism(
    *,
    fixed: Table,
    links: Table,
    driver: Table,
    guides: Table | None = None,
    assembly: Table | None = None,
    dimensions: Table | None = None,
    pose: Table | None = None,
    title: str = "Mechanism",
    unit: str = "mm",
    about: str = "",
    source: str = "",
) -> type[WrittenMechanism]:
    """Return the mechanism that tables describe, which are those of a file.

    Parameters
    ----------
    fixed, links, guides, driver, assembly, dimensions, pose
        The tables of a file, as dictionaries.
    title, unit, about, source
        The words of a file.

    Raises
    ------
    vad.errors.InputError
        With the name of the table, for what cannot be or cannot move.

    Examples
    --------
    >>> Rocker = mechanism(
    ...     fixed={"A": (0, 0), "D": (100, 0)},
    ...     links={"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
    ...     driver={"crank": {"angle": 60, "omega": 10}},
    ...     assembly={"C": "upper"},
    ... )
    >>> Rocker().assembly
    {'C': 'upper'}
    """
    given = {
        "dimensions": dimensions,
        "fixed": fixed,
        "links": links,
        "guides": guides,
        "driver": driver,
        "assembly": assembly,
        "pose": pose,
    }
    words = {"title": title, "unit": unit, "about": about, "source": source}
    tables = {name: table for name, table in given.items() if table is not None}
    return class_of(sorted_out(Source("", {"": words | tables})))

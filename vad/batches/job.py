"""One sheet as a job: plain data that a worker on any machine needs, and what it sends back."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from vad import __version__
from vad.batches.roster import in_file_name
from vad.errors import VadError
from vad.statics.burden import NOTHING, Burden

#: What a parameter may be: a number in the scene's unit; an assembly's word, or places by point.
Value = float | str | Mapping[str, Any]


@dataclass(frozen=True)
class Recipe:
    """What the sheets of one file, or one row of it, have in common.

    Attributes
    ----------
    mechanism
        The name of a mechanism, or of the file that ``text`` is from.
    text
        That file's text; None for a mechanism of the program's own.
    vary
        Parameters and inputs by name, each with the values from which it is drawn.
    keep
        The least sine at which the construction lines of any dyad cross.
    seed
        Of the random numbers.
    files
        The names of a sheet's files, without its number.
    blank
        The panels that a problem leaves to be drawn; None for all polygons, and the drive.
    options
        Those of `vad.draw`, `vad.animate` and `vad.save`, by name.
    ask
        The results for which a question bank asks; none for those that are drawn by the student.
    columns
        Results and figures of merit that the answers have, too, by the names of `vad.sweep`.
    tolerance
        How far off a right answer may be, as a share of it.
    burden
        What the mechanism bears beside its own.
    """

    mechanism: str
    text: str | None
    vary: tuple[tuple[str, tuple[Value, ...]], ...]
    keep: float
    seed: int
    files: tuple[str, ...]
    blank: tuple[str, ...] | None
    options: tuple[tuple[str, Any], ...]
    ask: tuple[str, ...] = ()
    columns: tuple[str, ...] = ()
    tolerance: float = 0.03
    burden: Burden = NOTHING


@dataclass(frozen=True)
class Job:
    """One sheet to be made.

    Attributes
    ----------
    recipe
        What it is made from.
    number
        Its number, from 1.
    label
        The number as it stands in front of the names of its files: "017".
    place
        Where it is written: "sheets.csv, line 18".
    roster
        Whose sheet it is: the columns of a table that are no options, by name.
    """

    recipe: Recipe
    number: int
    label: str
    place: str = field(repr=False)
    roster: tuple[tuple[str, str], ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its files."""
        whose = in_file_name(dict(self.roster))
        parts = [self.label, *([whose] if whose else [])]
        return tuple("-".join([*parts, name]) for name in self.recipe.files)

    @property
    def fingerprint(self) -> str:
        """A text that is different for a sheet that is made from other settings."""
        return hashlib.sha256(f"{__version__} {self!r}".encode()).hexdigest()


@dataclass(frozen=True)
class Product:
    """What a worker has made of a job.

    Attributes
    ----------
    job
        The job.
    answers
        The results, as `vad.Motion.to_dict` gives them.
    files
        The contents of the files by name.
    error
        Why it could not be made, or None.
    """

    job: Job
    answers: Mapping[str, Any] = field(default_factory=dict)
    files: Mapping[str, bytes] = field(default_factory=dict)
    error: VadError | None = None


@dataclass(frozen=True)
class Done:
    """One sheet of a batch, as `vad.batch` returns it.

    Attributes
    ----------
    number
        Its number, from 1.
    files
        Where its files are; none where there is an error.
    answers
        All results, as `vad.Motion.to_dict` gives them, and the ``roster``, if there is one.
    error
        Why it could not be made, or None.
    new
        Whether it was made now; False for one that stood there already.
    """

    number: int
    files: tuple[Path, ...] = ()
    answers: Mapping[str, Any] = field(default_factory=dict)
    error: VadError | None = None
    new: bool = True

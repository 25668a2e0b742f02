"""Question banks for learning platforms: questions with pictures, one number each to be found."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from vad import gate
from vad.errors import UsageError, quoted
from vad.export import formats
from vad.export.files import new_file

#: The modules that write a question bank, by the extension of the file.
FORMATS = formats("quiz")


@dataclass(frozen=True)
class Question:
    """A question whose answer is a number.

    Attributes
    ----------
    name
        Its name in the bank, of letters, digits, full stops and dashes.
    category
        What it is about: the title of the mechanism.
    task
        What is given and what is to be found, in words.
    picture, key
        The problem as it is drawn, and the drawing with its answers: PNG files.
    title
        What the pictures show, for a reader who cannot see them.
    feedback
        The words above the key.
    value, unit
        The answer.
    tolerance
        How far off a right answer may be, in that unit.
    """

    name: str
    category: str
    task: str
    picture: bytes
    key: bytes
    title: str
    feedback: str
    value: float
    unit: str
    tolerance: float

    @property
    def answer(self) -> str:
        """The answer with six digits, more than a drawing gives."""
        return f"{self.value:.6g}"

    @property
    def margin(self) -> str:
        """The tolerance with three digits."""
        return f"{self.tolerance:.3g}"


def format_of(path: str | os.PathLike[str]) -> str:
    """Return the extension by which a question bank is saved.

    Raises
    ------
    vad.errors.UsageError
        For another one.
    """
    kind = Path(gate.path("path", path)).suffix.lower()
    if kind not in FORMATS:
        known = ", ".join(FORMATS)
        raise UsageError(
            f"a question bank cannot be saved as {quoted(os.fspath(path))}", f"known: {known}"
        )
    return kind


def save_quiz(questions: Sequence[Question], path: str | os.PathLike[str]) -> None:
    """Write questions to a file, whose extension chooses the format.

    Raises
    ------
    vad.errors.UsageError
        For another kind of file.
    vad.errors.ExportError
        If the file cannot be written.
    """
    module = import_module(FORMATS[format_of(path)])
    with new_file(path) as stream:
        module.write(questions, stream)

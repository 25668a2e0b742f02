"""A question bank as plain Markdown, for a reader or for a converter."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from typing import BinaryIO

from vad.export.quiz import Question


def write(questions: Sequence[Question], target: BinaryIO) -> None:
    """Write the questions one below the other, each with its answer and its key."""
    parts: list[str] = []
    category = None
    for question in questions:
        if question.category != category:
            category = question.category
            parts.append(f"# {category}")
        parts += [
            f"## {question.name}",
            question.task,
            _image(question.title, question.picture),
            f"**{question.answer} {question.unit}** (± {question.margin} {question.unit})",
            _image(question.feedback, question.key),
        ]
    target.write(("\n\n".join(parts) + "\n").encode())


def _image(title: str, picture: bytes) -> str:
    return f"![{title}](data:image/png;base64,{b64encode(picture).decode()})"

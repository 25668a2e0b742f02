"""A question bank in GIFT, a notation that many platforms read; pictures are in the text."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Sequence
from html import escape
from typing import BinaryIO

from vad.export.quiz import Question

# These signs have a meaning in GIFT.
_SIGNS = re.compile(r"([~=#{}:\\])")


def write(questions: Sequence[Question], target: BinaryIO) -> None:
    """Write a question bank in GIFT, with a category per mechanism."""
    lines: list[str] = []
    category = None
    for question in questions:
        if question.category != category:
            category = question.category
            lines += [f"$CATEGORY: vad/{category.replace('/', '//')}", ""]
        task = _html(question.task, question.picture, question.title)
        key = _html(question.feedback, question.key, question.title)
        answer = f"{{#{question.answer}:{question.margin}####{_plain(key)}}}"
        lines += [f"::{_plain(question.name)}::[html]{_plain(task)} {answer}", ""]
    target.write("\n".join(lines).encode())


def _html(words: str, picture: bytes, title: str) -> str:
    data = b64encode(picture).decode()
    return f'<p>{escape(words)}</p><img src="data:image/png;base64,{data}" alt="{escape(title)}">'


def _plain(text: str) -> str:
    """Return a text in which no sign has a meaning."""
    return _SIGNS.sub(r"\\\1", text)

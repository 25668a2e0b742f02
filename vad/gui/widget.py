"""The window in a cell of a notebook, as a widget.

It is the page of ``vad gui`` in a frame.  Its questions come by the notebook's own channel instead
of by HTTP, and are answered by the same functions.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from importlib.resources import files
from threading import Event
from typing import TYPE_CHECKING, Any

from vad.errors import VadError, one_of
from vad.gui.answers import MEDIA, lesson, pose, saved
from vad.gui.messages import (
    ExportQuestion,
    Kinds,
    LessonQuestion,
    PoseQuestion,
    Question,
    problem,
    read,
)
from vad.gui.window import window
from vad.gui.work import ANSWER, ANSWERS, FILM, Work
from vad.mechanisms import MECHANISMS

if TYPE_CHECKING:
    from anywidget import AnyWidget

#: A frame has neither an address to keep nor one to load in another language.
_HIDDEN = "<style>[data-what=link],.side{display:none}</style>\n"
_WORK = Work(Event(), ANSWERS)
_ANSWERS: dict[str, tuple[type[Question], Callable[[Any], dict[str, Any]]]] = {
    "pose": (PoseQuestion, pose),
    "lesson": (LessonQuestion, lesson),
}


def in_cell(start: ExportQuestion) -> AnyWidget:
    """Return the widget; its class is made when it is wanted, for anywidget is an extra."""
    import anywidget
    import traitlets

    class Window(anywidget.AnyWidget):
        _esm = (files(__package__) / "widget.js").read_text("utf-8")
        page = traitlets.Unicode().tag(sync=True)
        title = traitlets.Unicode().tag(sync=True)

        def __init__(self) -> None:
            script = (files(__package__) / "channel.js").read_text("utf-8")
            head = f"{_HIDDEN}<script>{script}</script>\n"
            super().__init__(page=window(start, "", head), title=f"vad: {start.mechanism}")
            self.on_msg(self._answer)

        def _answer(self, _: object, asked: dict[str, Any], __: object) -> None:
            data, media, name = answer(asked["path"], asked["body"], start.kinds)
            self.send({"id": asked["id"], "media": media, "name": name}, [data])

    return Window()


def answer(path: str, body: object, kinds: Kinds = MECHANISMS) -> tuple[bytes, str, str]:
    """Return what the server answers to the same question: bytes, their type, a file's name."""
    kind, work = _ANSWERS.get(path, (ExportQuestion, None))
    fields: tuple[str, ...] = ()
    try:
        question: Any = read(kind, body, kinds)
        fields = question.fields
        if work is None:
            extension = one_of("format", path.removeprefix("export/"), MEDIA)
            data, name = _WORK.done_here(FILM, partial(saved, question, extension))
            return data, MEDIA[extension], name
        found = _WORK.done_here(ANSWER, partial(work, question))
    except VadError as error:
        found = {"error": problem(error, fields)}
    return json.dumps(found, ensure_ascii=False).encode(), "application/json", ""

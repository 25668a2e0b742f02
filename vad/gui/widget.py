"""The window in a cell of a notebook, as a widget.

It is the page of ``vad gui`` in a frame.  Its questions come by the notebook's own channel instead
of by HTTP, and are answered by the same functions.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib.resources import files
from threading import Event
from typing import TYPE_CHECKING, Any

from vad.errors import UsageError, VadError, one_of, quoted
from vad.gui.answers import MEDIA, lesson, pose, saved
from vad.gui.messages import (
    EntryQuestion,
    ExportQuestion,
    Kinds,
    LessonQuestion,
    PoseQuestion,
    Question,
    as_json,
    problem,
    read,
)
from vad.gui.window import listed, window
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
    "entry": (EntryQuestion, listed),
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

        def _answer(self, _: object, asked: object, __: object) -> None:
            self.send(*reply(asked, start.kinds))

    return Window()


def reply(asked: object, kinds: Kinds = MECHANISMS) -> tuple[dict[str, Any], list[bytes]]:
    """Return the message that answers a message of the page, and its bytes.

    Anything may come, because whoever has the notebook's channel can write to it.
    """
    given = asked if isinstance(asked, dict) else {}
    data, media, name = answer(given.get("path"), given.get("body"), kinds)
    return {"id": given.get("id"), "media": media, "name": name}, [data]


def answer(path: object, body: object, kinds: Kinds = MECHANISMS) -> tuple[bytes, str, str]:
    """Return what the server answers to the same question: bytes, their type, a file's name."""
    fields: tuple[str, ...] = ()
    try:
        if not isinstance(path, str):
            raise UsageError(f"path: must be a text, got {quoted(path)}")
        kind, work = _ANSWERS.get(path, (ExportQuestion, None))
        question: Any = read(kind, body, kinds)
        fields = question.fields
        if work is None:
            extension = one_of("format", path.removeprefix("export/"), MEDIA)
            data, name = _WORK.done_here(FILM, partial(saved, question, extension))
            return data, MEDIA[extension], name
        found = _WORK.done_here(ANSWER, partial(work, question))
    except VadError as error:
        found = {"error": problem(error, fields)}
    return as_json(found).encode(), "application/json", ""

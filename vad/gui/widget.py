"""The window in a cell of a notebook, as a widget.

It is the page of ``vad gui`` in a frame.  Its questions come by the notebook's own channel instead
of by HTTP, and are answered by the same functions.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import fields, replace
from functools import partial
from importlib.resources import files
from threading import Event
from typing import TYPE_CHECKING, Any

from vad.errors import UsageError, VadError, one_of, quoted
from vad.gate import number
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
from vad.gui.shelf import Shelf
from vad.gui.window import listed, window
from vad.gui.work import ANSWER, ANSWERS, FILM, Work
from vad.kinematics.motion import Motion, solve
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
    """Return the widget; its class is made when it is wanted, for anywidget is an extra.

    Its trait of the driver's name, ``angle`` or ``position``, and ``motion``, one pose of
    `vad.solve`, follow the hand, and can be observed.  Setting the first moves the mechanism.
    """
    import anywidget
    import traitlets

    driver = next(iter(start.build()[0].inputs))
    shelf = Shelf(start.kinds)

    class Window(anywidget.AnyWidget):
        _esm = (files(__package__) / "widget.js").read_text("utf-8")
        page = traitlets.Unicode().tag(sync=True)
        title = traitlets.Unicode().tag(sync=True)
        pose = traitlets.Dict().tag(sync=True)
        asked = traitlets.Dict().tag(sync=True)
        motion = traitlets.Any()

        def __init__(self) -> None:
            script = (files(__package__) / "channel.js").read_text("utf-8")
            head = f"{_HIDDEN}<script>{script}</script>\n"
            super().__init__(page=window(start, "", head), title=f"vad: {start.mechanism}")
            self._question: Question = start
            self._following = False
            self._show(_motion(start))
            self.on_msg(self._answer)

        def _answer(self, _: object, asked: object, __: object) -> None:
            message, buffers = reply(asked, shelf)
            self.send(message, buffers)
            if isinstance(asked, dict) and asked.get("path") == "lesson":
                with suppress(VadError):
                    question = read(LessonQuestion, asked.get("body"), shelf)
                    motion = _motion(question)
                    self._question = question
                    self._show(motion)

        @traitlets.observe("pose")
        def _follow(self, change: dict[str, Any]) -> None:
            """Follow the hand.  What comes is checked as a question is: any page may write it."""
            with suppress(VadError, TypeError):
                self._show(_motion(_posed(self._question, change["new"])))

        def _show(self, motion: Motion) -> None:
            self._following = True
            try:
                with self.hold_trait_notifications():
                    self.motion = motion
                    if driver in motion.inputs:
                        setattr(self, driver, float(motion.inputs[driver]))
            finally:
                self._following = False

        @traitlets.validate(driver)
        def _possible(self, proposal: dict[str, Any]) -> float:
            value = float(proposal["value"])
            if not self._following:
                pose = {driver: value}
                self.motion = _motion(_posed(self._question, pose))
                self.asked = {"number": self.asked.get("number", 0) + 1, "pose": pose}
            return value

    made: AnyWidget = type("Window", (Window,), {driver: traitlets.Float()})()
    return made


def _motion(question: Question) -> Motion:
    mechanism, inputs = question.build()
    motion = solve(mechanism, **inputs)
    for letter in motion.points:  # a pose that cannot be is an error now
        _ = motion.point(letter).position
    return motion


def _posed(question: Question, pose: Mapping[str, object]) -> Question:
    """Return a question in another pose of its mechanism; that of further points is left."""
    kind = question.kinds[question.mechanism]
    known = {each.name for each in fields(kind)}
    given = {name: number(name, value) for name, value in pose.items() if name != "assembly"}
    parameters = {name: value for name, value in given.items() if name in known}
    inputs = {name: value for name, value in given.items() if name in kind.inputs}
    return replace(
        question,
        parameters={**question.parameters, **parameters},
        inputs={**question.inputs, **inputs},
        assembly=pose.get("assembly", question.assembly),
    )


def reply(asked: object, kinds: Kinds = MECHANISMS) -> tuple[dict[str, Any], list[bytes]]:
    """Return the message that answers a message of the page, and its bytes.

    Anything may come, because whoever has the notebook's channel can write to it.
    """
    given = asked if isinstance(asked, dict) else {}
    data, media, name = answer(given.get("path"), given.get("body"), kinds)
    return {"id": given.get("id"), "media": media, "name": name}, [data]


def answer(path: object, body: object, kinds: Kinds = MECHANISMS) -> tuple[bytes, str, str]:
    """Return what the server answers to the same question: bytes, their type, a file's name."""
    say: Callable[[VadError], dict[str, Any]] = problem
    try:
        if not isinstance(path, str):
            raise UsageError(f"path: must be a text, got {quoted(path)}")
        kind, work = _ANSWERS.get(path, (ExportQuestion, None))
        question: Any = read(kind, body, kinds)
        say = question.problem
        if work is None:
            extension = one_of("format", path.removeprefix("export/"), MEDIA)
            data, name = _WORK.done_here(FILM, partial(saved, question, extension))
            return data, MEDIA[extension], name
        found = _WORK.done_here(ANSWER, partial(work, question))
    except VadError as error:
        found = {"error": say(error)}
    return as_json(found).encode(), "application/json", ""

"""The verbs `show` and `widget`: a notebook or the browser shows a thing.

A drawing, a lesson or a film is shown as it is, a mechanism in the window in which it is turned by
hand.
"""

from __future__ import annotations

import sys
import webbrowser
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from importlib.util import find_spec
from threading import Event
from typing import TYPE_CHECKING, Any

from vad.errors import ExportError, InputError, UsageError, quoted
from vad.export import FORMATS, save
from vad.export.files import temporary_folder
from vad.gui.messages import ExportQuestion
from vad.gui.visit import NO_BROWSER, visited
from vad.kinematics.motion import Motion
from vad.mechanisms import Mechanism
from vad.notebook import Thing, in_notebook
from vad.statics.burden import NOTHING
from vad.statics.forces import Forces
from vad.strokes.draw import chosen, parted
from vad.style import load_style
from vad.words import Language

if TYPE_CHECKING:
    from anywidget import AnyWidget

#: The forms in which a browser shows a file, the best first.
_SHOWN = (".html", ".mp4", ".svg")


def show(thing: Thing | Mechanism) -> None:
    """Show a thing: in a notebook beneath the cell, elsewhere in the browser.

    The browser opens a file in a temporary folder, which is removed when the next one is made a day
    later: a lesson and a sheet as a page, a turn as a
    film, a step and several poses as a drawing.  A mechanism opens as in ``vad gui``, until it is
    interrupted; in a notebook it is that of `widget`.

    Parameters
    ----------
    thing
        A mechanism, or what `vad.draw`, `vad.animate`, `vad.turn`, `vad.still` or `vad.multiples`
        returns.

    Raises
    ------
    vad.errors.UsageError
        If it is anything else.
    vad.errors.ExportError
        If no browser can be started.
    """
    if not isinstance(thing, Thing | Mechanism):
        raise UsageError(f"thing: cannot be shown, got {quoted(thing)}", "draw or animate it first")
    if in_notebook():
        import_module("IPython.display").display(
            widget(thing) if isinstance(thing, Mechanism) else thing
        )
    elif isinstance(thing, Mechanism):
        _serve(_question(thing))
    else:
        extension = next(each for each in _SHOWN if each in FORMATS[type(thing)])
        with temporary_folder(stays=True) as folder:
            path = folder / ("shown" + extension)
            save(thing, path)
        if not webbrowser.open(path.as_uri()):
            raise ExportError(NO_BROWSER, hint=f"open this file in one: {path}")


def widget(
    mechanism: Mechanism | Motion | Forces[Any, Any, Any],
    panels: Sequence[str] | str | None = None,
    style: str = "paper",
    language: str = "en",
) -> AnyWidget:
    """Return the window of ``vad gui`` for a cell of a notebook: the mechanism turned by hand.

    Parameters
    ----------
    mechanism
        A mechanism, as it moves usually, one pose of `vad.solve`, or the forces in one, as
        `vad.forces` returns them.
    panels, style, language
        As for `vad.draw` and `vad.animate`.

    Raises
    ------
    vad.errors.UsageError
        If a value is unknown, or anywidget, the extra ``notebook``, is not installed.
    vad.errors.InputError
        For a motion of many poses.
    """
    given = () if panels is None else chosen(panels)
    start = _question(mechanism, panels=given, style=style, language=language)
    if find_spec("anywidget") is None:
        hint = "install it: pip install 'vad-diagrams[notebook]'"
        raise UsageError("widget: needs anywidget, which is not installed", hint)
    from vad.gui.widget import in_cell

    return in_cell(start)


def _question(thing: Mechanism | Motion | Forces[Any, Any, Any], **options: Any) -> ExportQuestion:
    from vad.gui.answers import check_start  # a drawing does not need it

    load_style(options.get("style", "paper"))
    Language(options.get("language", "en"))
    if isinstance(thing, Mechanism):
        start = ExportQuestion.of(thing, {}, **options)
    elif not isinstance(thing, Motion | Forces):
        raise UsageError(f"mechanism: must be a mechanism or one pose, got {quoted(thing)}")
    elif thing.many:
        raise InputError("mechanism: a window opens with one pose, got arrays of poses")
    else:
        motion, forces = parted(thing)
        burden = forces.burden if forces else NOTHING
        start = ExportQuestion.of(motion.mechanism, motion.inputs, burden, **options)
    check_start(start)
    return start


def _serve(start: ExportQuestion) -> None:
    """Serve the window until an interrupt."""
    from vad.gui.server import served

    none = Event()

    def missed(reason: str) -> None:
        if reason == NO_BROWSER:
            none.set()
        else:
            print(f"{reason}; open this address in one: {key.address}", file=sys.stderr)

    with served(start) as key, visited(key, missed), suppress(KeyboardInterrupt):
        none.wait()
        raise ExportError(NO_BROWSER, hint=f"as from a shell: vad gui {start.mechanism}")

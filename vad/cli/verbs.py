"""The verbs that draw: their options, and what each does with a mechanism and its input.

They are imported only when one of them is asked for, because they know all that can be drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

import click

import vad
from vad.cli import completion
from vad.cli.groups import MechanismGroup
from vad.cli.options import (
    NamedOption,
    burden_options,
    path,
    pin_option,
    places,
    results,
    several,
    size,
    take_burden,
)
from vad.cli.output import progress, say_written
from vad.cli.places import sweep_places
from vad.cli.process import (
    before_an_end_at_once,
    say,
    signals_held_back,
    wait_for_signal,
)
from vad.cli.talk import PAUSE, SCRIPT, script_in, with_pauses
from vad.errors import UsageError, VadError
from vad.export import FOLDER, FORMATS, format_of, formats, own_options
from vad.export.files import clear_unfinished
from vad.lecture.lesson import Lesson, Still, check_size
from vad.lecture.turn import Turn
from vad.mechanisms import Mechanism
from vad.plan.format import paper_names
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import with_forces
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet
from vad.style import GROUP as STYLES
from vad.style import style_names
from vad.words import GROUP as LANGUAGES
from vad.words import languages

if TYPE_CHECKING:
    from vad.statics.burden import Burden


Inputs = dict[str, Any]
#: The files that lie beside a film with ``--subtitles``, and the films that take them.
SUBTITLES = (".srt", ".vtt")
_SUBTITLED = (".mp4", ".gif", FOLDER)
before_an_end_at_once(clear_unfinished)
_TITLES = [
    click.Option(
        ["--title"], metavar="TEXT", help="title of the page, instead of the name of the mechanism"
    ),
    click.Option(["--subtitle"], metavar="TEXT", help="line below the title  [none]"),
]
_LOOK = [
    NamedOption("style", "style", style_names(), "colours and lines  [paper]", STYLES),
    NamedOption("language", "language", languages(), "language of all words  [en]", LANGUAGES),
]
_SHEET = [
    click.Option(
        ["--panels"],
        callback=several("panel", DIAGRAMS),
        shell_complete=completion.several(DIAGRAMS),
        multiple=True,
        metavar="NAME,NAME",
        help=f"some of {', '.join(DIAGRAMS)}  [all of motion; with loads position, force, drive]",
    ),
    click.Option(
        ["--superpose"],
        is_flag=True,
        default=None,
        help="draw the forces for each load alone, and then their sums  [all loads together]",
    ),
    *_LOOK,
]
_CENTRODE = click.Option(
    ["--centrode"],
    metavar="'BODY on BODY'",
    help="with --panels centres: the curves with which a body rolls on another one, or on the "
    "frame  [with --turn: the coupler]",
)
_SIZE = click.Option(
    ["--size"],
    callback=size(),
    metavar="WxH",
    help="width and height of the picture in pixels  [1280x720]",
)
_PAPER = NamedOption(
    "paper", "paper", paper_names(), "size of a PDF in true scale, on which a ruler measures"
)
_POSITIONS = click.Option(
    ["--turn"],
    is_flag=True,
    help="draw a full turn: the paths of all points, with twelve numbered positions",
)
_BLANK = click.Option(
    ["--blank"],
    callback=several("panel", DIAGRAMS),
    shell_complete=completion.several(DIAGRAMS),
    multiple=True,
    metavar="NAME,NAME",
    help="a problem sheet: students draw these panels  [none]",
)
_TASK = click.Option(
    ["--task"], metavar="TEXT", help="the task of a problem sheet  [what is left to be drawn]"
)
_FILM = [
    click.Option(["--fps"], type=float, help="frames per second  [30]"),
    click.Option(["--speed"], type=float, help="speed of the film; 2 is twice as fast  [1]"),
    click.Option(
        ["--still"],
        metavar="STEP",
        help="save one step as a picture (.png, .svg, .pdf), as in 4 or velocity:4  [the film]",
    ),
    click.Option(
        ["--turn"], is_flag=True, help="show a full turn, with the polygons of every pose"
    ),
    click.Option(
        ["--loop"],
        type=int,
        metavar="NUMBER",
        help="begin with this dyad; the dyads before it are on the board already  [1]",
    ),
    click.Option(
        ["--plain"],
        is_flag=True,
        help="a pencil draws every vector; no vector flies from the mechanism",
    ),
    click.Option(["--subtitles"], is_flag=True, help="write FILE.srt and FILE.vtt beside the film"),
]
_LOADS = burden_options()
_FOLLOW = click.Option(
    ["--follow"],
    metavar="POINT",
    help="of --turn: the point whose path, velocity and acceleration are shown, or all  "
    "[the output of the file, or the foot of a leg]",
)
_AT = click.Option(
    ["--at"],
    callback=places(),
    metavar="PLACE,PLACE",
    help="two to six poses side by side, at these places of the driver  [one pose]",
)


def note_change_points(
    mechanism: Mechanism, low: float = -math.inf, high: float = math.inf
) -> None:
    """Write on stderr which change points lie in a range of the driver.

    At a change point the mechanism can go on in two ways.
    """
    from vad.kinematics.reach import change_points
    from vad.kinematics.results import place_unit

    turns = "angle" in mechanism.inputs
    for change in change_points(mechanism):
        turned = turns and low > -math.inf  # the same angle, not below the range
        place = low + (change.place - low) % 360.0 if turned else change.place
        if low <= place <= high:
            click.echo(f"note: {change.words(place_unit(mechanism))}", err=True)


def draw(
    mechanism: Mechanism, inputs: Inputs, output: str, turn: bool = False, **options: Any
) -> None:
    """Write a pose as a picture, or its strokes as data; or a few poses, or a whole turn."""
    at = options.pop("at", None)
    if turn and at is not None:
        raise UsageError("--turn and --at: choose one of them")
    if turn and "blank" in options:
        raise UsageError("--blank is for one pose, not for a turn")
    _check_one_pose(options, turn or at is not None)
    if "centrode" in options and at is not None:
        raise UsageError("--centrode is for one pose or a turn", "leave out --at")
    _check_followed(options, turn)
    script = script_in(options, turn or at is not None)
    burden = take_burden(mechanism, options)
    made = Turn if turn else Sheet if at is None else Multiples
    kind = format_of(Sheet, output)  # before anything is calculated
    format_of(made, output)
    if "paper" in options and kind != ".pdf":
        raise UsageError(f"--paper is for PDF, not for '{output}'", hint="as in -o sheet.pdf")
    if "task" in options and "blank" not in options:
        raise UsageError("--task is for a problem sheet", hint="as in --blank velocity")
    if "blank" in options and kind == ".json":
        raise UsageError(
            f"--blank is for pictures, not for '{output}'", hint="as in -o problem.pdf"
        )
    look = _pop(
        options, "style", "size", "paper", "blank", "task", *own_options([FORMATS[made][kind]])
    )
    drawn: Sheet | Multiples | Turn
    if at is not None:
        drawn = _multiples(mechanism, inputs, at, burden, **options)
    elif turn:
        drawn = vad.turn(_pose(mechanism, inputs, burden), **options)
    else:
        drawn = script.told(vad.draw(_pose(mechanism, inputs, burden), **options))
    vad.save(drawn, output, **look)
    say_written(output)
    if turn:
        note_change_points(mechanism)


def _check_one_pose(options: dict[str, Any], several: bool) -> None:
    """Refuse superposition and the rubbing of pins where several poses are drawn."""
    if pins := options.pop("pin", None):
        if several:
            raise UsageError("--pin is for one pose", "leave out --turn and --at")
        options["pins"] = pins
    if "superpose" in options and several:
        raise UsageError("--superpose is for one pose", "leave out --turn and --at")


def _check_followed(options: dict[str, Any], turn: bool) -> None:
    """Refuse a point to be followed in one pose."""
    if "follow" in options and not turn:
        raise UsageError("--follow is for a turn", "add --turn")


def _pose(mechanism: Mechanism, inputs: Inputs, burden: Burden | None) -> Any:
    """Return one pose, or the forces in it if there is anything that makes some."""
    return with_forces(vad.solve(mechanism, **inputs), burden)


def _multiples(
    mechanism: Mechanism, inputs: Inputs, at: list[float], burden: Burden | None, **options: Any
) -> Multiples:
    """Draw a few poses; an error about their places names the option."""
    driven = next(iter(mechanism.inputs))
    if driven in inputs:
        raise UsageError(f"--at: takes the place of --{driven}", hint=f"leave out --{driven}")
    try:
        return vad.multiples(_pose(mechanism, inputs, burden), at, **options)
    except VadError as error:
        raise type(error)(f"--at: {str(error).removeprefix('at: ')}", error.hint) from None


def animate(
    mechanism: Mechanism,
    inputs: Inputs,
    output: str,
    still: str | None = None,
    subtitles: bool = False,
    turn: bool = False,
    **options: Any,
) -> None:
    """Write the film in which one pose is drawn stroke by stroke, one step of it, or a turn."""
    _check_one_pose(options, turn)
    _check_followed(options, turn)
    script = script_in(options, turn)
    burden = take_burden(mechanism, options)
    if turn:
        of_strokes = {"--still": still is not None, "--subtitles": subtitles}
        of_strokes |= {"--loop": "loop" in options, "--plain": options.pop("plain", False)}
        for name, given in of_strokes.items():
            if given:
                why = "which draws no strokes one by one"
                raise UsageError(f"{name} does not go with --turn, {why}")
        _turn(_pose(mechanism, inputs, burden), output, **options)
        return
    thing = Lesson if still is None else Still
    kind = format_of(thing, output)
    if subtitles and (still is not None or kind not in _SUBTITLED):
        hint = "as in -o lecture.mp4 --subtitles; or -o lecture.srt alone"
        raise UsageError(f"--subtitles go beside a film, not beside '{output}'", hint)
    own = _pop(options, *own_options([FORMATS[thing][kind]]))
    timing = _pop(options, "fps", "size", "speed", "style", "loop", "plain")
    pauses = options.pop("pause", ())
    sheet = vad.draw(_pose(mechanism, inputs, burden), **options)
    lesson = vad.animate(sheet, **timing, script=with_pauses(script, pauses, sheet))
    if still is not None:
        vad.save(_still(lesson, still), output, **own)
        say_written(output)
        return
    with progress(output) as moved:
        vad.save(lesson, output, beside=SUBTITLES if subtitles else (), progress=moved, **own)
    say_written(output, f"{lesson.duration:.1f} s, {lesson.frames} frames")


def _still(lesson: Lesson, step: str) -> Still:
    """Return one step; an error about its name names the option."""
    try:
        return vad.still(lesson, step)
    except UsageError as error:
        raise UsageError(f"--still: {error}", error.hint) from None


def _turn(pose: Any, output: str, **options: Any) -> None:
    """Write the film in which the mechanism runs through a full turn."""
    own = _pop(options, *own_options([FORMATS[Turn][format_of(Turn, output)]]))
    film = vad.turn(pose, **options)
    with progress(output) as moved:
        vad.save(film, output, progress=moved, **own)
    say_written(output, f"{film.duration:.1f} s, {film.frames} frames")
    note_change_points(film.mechanism)


def sweep(mechanism: Mechanism, inputs: Inputs, output: str, **ends: Any) -> None:
    """Write the results over a range of the input or of a dimension, as a table or a plot."""
    driven = next(iter(mechanism.inputs))
    if driven in inputs and "over" not in ends:
        hint = f"a sweep runs --from one {driven} --to another"
        raise UsageError(f"--{driven} goes with --over, in whose pose a dimension varies", hint)
    look = _pop(ends, "style", "language")
    if not ends.get("pin"):
        ends.pop("pin", None)
    if {"over", "columns", "pin"} & ends.keys() or output == "-":
        from vad.cli.columns import chosen_columns

        chosen_columns(mechanism, inputs, output, look=look, **ends)
        return
    from vad.export.sweep import save_sweep

    burden = take_burden(mechanism, ends)
    swept = sweep_places(mechanism, **ends)
    save_sweep(vad.solve(mechanism, **{driven: swept}, **inputs), output, burden, **look)
    say_written(output)
    note_change_points(mechanism, float(swept.min()), float(swept.max()))


def gui(
    mechanism: Mechanism,
    inputs: Inputs,
    port: int = 0,
    no_browser: bool = False,
    **options: Any,
) -> None:
    """Serve the page until the process is asked to stop; its address is the only line printed."""
    from vad.gui.answers import check_start
    from vad.gui.messages import ExportQuestion
    from vad.gui.server import served
    from vad.gui.visit import visited
    from vad.statics.burden import NOTHING

    if "size" in options:
        check_size(options["size"])
    burden = take_burden(mechanism, options)
    start = ExportQuestion.of(mechanism, inputs, burden or NOTHING, **options)
    check_start(start)
    with signals_held_back(), served(start, port) as key:
        click.echo(key.address)

        def missed(reason: str) -> None:
            say(f"hint: {reason}; open this address in one: {key.address}")

        with nullcontext() if no_browser else visited(key, missed):
            wait_for_signal()


def _pop(options: dict[str, Any], *names: str) -> dict[str, Any]:
    """Take from ``options`` those of ``names`` that are there."""
    return {name: options.pop(name) for name in names if name in options}


def _output(extensions: Iterable[str]) -> click.Option:
    """Return the option that names the file, with the kinds of file that there are."""
    *names, last = ("FOLDER/" if each == FOLDER else f"FILE{each}" for each in extensions)
    return click.Option(
        ["-o", "--output"],
        required=True,
        callback=path(),
        shell_complete=completion.a_file,
        metavar="FILE",
        help=f"{', '.join(names)} or {last}",
    )


#: These verbs by name.
VERBS: tuple[click.Command, ...] = (
    MechanismGroup(
        "draw",
        "Draw the polygons of one pose.",
        draw,
        [
            _output(FORMATS[Sheet]),
            *_SHEET,
            _CENTRODE,
            _SIZE,
            _PAPER,
            _BLANK,
            _TASK,
            pin_option(),
            _AT,
            _POSITIONS,
            _FOLLOW,
            *_TITLES,
            SCRIPT,
            *burden_options(),
        ],
        formats=FORMATS[Sheet],
    ),
    MechanismGroup(
        "animate",
        "Make a film that draws the polygons stroke by stroke.",
        animate,
        [
            _output(FORMATS[Lesson]),
            *_SHEET,
            _CENTRODE,
            _SIZE,
            pin_option(),
            *_FILM,
            _FOLLOW,
            *_TITLES,
            SCRIPT,
            PAUSE,
            *_LOADS,
        ],
        formats=FORMATS[Lesson] | FORMATS[Still],
    ),
    MechanismGroup(
        "sweep",
        "Write the numbers over a turn, as a table or a plot.",
        sweep,
        [
            _output(formats("sweep", "table")),
            click.Option(["--steps"], type=int, help="number of poses, both ends included  [361]"),
            click.Option(
                ["--over"],
                metavar="'NAME FROM TO STEPS'",
                help="a dimension that varies, as in 'crank 20 60 41', in one pose  [a turn]",
            ),
            click.Option(
                ["--columns"],
                callback=results(),
                multiple=True,
                metavar="RESULT,RESULT",
                help="rocker.angle, C.velocity, transmission, drive, stroke, C.velocity.largest …  "
                "[all]",
            ),
            pin_option(),
            *_LOOK,
            *burden_options(),
        ],
        ranged=True,
    ),
    MechanismGroup(
        "gui",
        "Open a page on which a mechanism is turned by hand.",
        gui,
        [
            *_SHEET,
            _SIZE,
            click.Option(["--port"], type=int, help="the server's port  [any that is free]"),
            click.Option(["--no-browser"], is_flag=True, help="print the address, open nothing"),
            *_LOADS,
        ],
        usual="slider-crank",
    ),
)

"""The answers of Python: poses while something moves, the lesson of the settings, and files.

What is the same in all poses of a mechanism is kept for the mechanisms that were asked for last.
Places are in pixels of a page 1280 wide, y down, as in the drawings.  A file is made in a folder of
its own, which is removed afterwards; no question names a path.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import vad
from vad.errors import AssemblyError, DeadCentreError, ExportError, UsageError, VadError
from vad.export.files import temporary_folder
from vad.files.examples import EXTENSION
from vad.files.loading import WrittenMechanism
from vad.files.rewriting import rewritten
from vad.files.sheet_file import sheet_file
from vad.gui.messages import (
    ExportQuestion,
    LessonQuestion,
    PoseQuestion,
    Question,
    Scales,
)
from vad.kinematics.motion import Motion
from vad.kinematics.reach import closing_range
from vad.mechanisms import Mechanism
from vad.page.document import section
from vad.page.heads import scale_bar
from vad.page.ink import Inker
from vad.page.parts import RunWriter, measured_cells, parts, picture, values_of
from vad.page.themed import Inks
from vad.painting.posed import SIZE
from vad.painting.svg_text import Faces
from vad.plan.board import arrange, plan
from vad.plan.format import Format, screen
from vad.plan.hand_board import HandBoard, hand_board, poses_over_reach
from vad.plan.live_board import LiveBoard
from vad.plan.pictures.views import held_arc, tip_of
from vad.plan.scale import Scale, calm_scale
from vad.statics.burden import Burden
from vad.statics.forces import Forces
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import chosen, parted, with_forces
from vad.strokes.sheet import Arrow, Block, Sheet
from vad.style import load_style

FORM = screen(SIZE)
#: One pose, or the forces in it.
Pose = Motion | Forces[Any, Any, Any]
#: Lines for a caption, in the layout of the page: there, captions have a place of their own.
LINES = 1
POSITION = "position"
#: The most bytes of a file.
LARGEST_FILE = 200_000_000
#: The extensions of pictures and films; and what any file is, by its extension.
PICTURES, FILMS = ("png", "svg", "pdf"), ("mp4", "gif")
MEDIA = {
    "png": "image/png",
    "svg": "image/svg+xml",
    "pdf": "application/pdf",
    "json": "application/json",
    "mp4": "video/mp4",
    "gif": "image/gif",
    "html": "text/html",
    "turn": "text/html",
    "problem": "application/pdf",
    "toml": "application/toml",
}
#: The ends of names that say more than their extension.
_ENDS = {"turn": "-turn.html", "problem": "-problem.pdf"}


def check_start(question: Question) -> None:
    """Refuse what no page could begin with: more than a drawing or a page has room for.

    A pose that cannot be is none of that: the page says so, and has the fields to change it.

    Raises
    ------
    vad.errors.UsageError, vad.errors.InputError
        With what there is too much of.
    """
    motion, burden = question.solved()
    pose = with_forces(motion, burden)
    panels = _panels(question, pose)
    with suppress(AssemblyError, DeadCentreError):
        arrange(vad.draw(pose, panels, question.language), FORM, LINES)


def _panels(question: Question, pose: Pose) -> tuple[str, ...]:
    """Return the panels that are asked for, or the usual ones of the pose.

    Raises
    ------
    vad.errors.UsageError
        For a panel that is not turned by hand.
    """
    motion, forces = parted(pose)
    panels = chosen(question.panels or None, motion, forces)
    for name in panels:
        if not DIAGRAMS[name].by_hand:
            hint = f"as in vad draw {motion.mechanism.name} --panels {name} -o {name}.png"
            raise UsageError(f"panel {name!r} is not turned by hand", hint)
    return panels


def pose(question: PoseQuestion) -> dict[str, Any]:
    """Return a pose.

    Returns
    -------
    dict
        HTML in its places on a page: ``panels`` with name, scale bar and drawing, ``rows`` with
        the cells of the table, and their ``looks``, less those that the page knows.  For the next
        question, ``scales`` and ``ways``; for the hand, the ``ranges`` of the driver that close and
        the ``handle`` (see `handle_of`).  The ``results`` of ``vad solve --json``, and the
        milliseconds that it took, ``ms``.  At a dead centre there is the position alone, and an
        ``error``.

    Raises
    ------
    vad.errors.VadError
        For a pose that cannot be.
    """
    begun = time.thread_time()
    motion, burden = question.solved()
    loaded, trouble = with_forces(motion, burden), dict[str, Any]()
    mechanism, panels = motion.mechanism, _panels(question, loaded)
    try:
        sheet = vad.draw(loaded, panels, question.language)
        trouble = {"results": _results(motion, burden)}
    except DeadCentreError as error:
        if POSITION not in panels:
            raise
        sheet = vad.draw(motion, POSITION, question.language)
        trouble = {"error": question.problem(error)}
    scales = {name: scale_of(values) for name, values in question.scales.items()}
    last = question.of_last_lesson(mechanism)
    board = board_of(last, panels, question.language, burden)
    if last != mechanism:
        board = board.resized(sheet, scales)
    shown = board.pose(sheet, scales, question.ways)
    faces = Faces()
    inker, words = Inker(FORM, _inks(question.style), faces), RunWriter(faces)
    drawn = [
        [
            each.name,
            _quoted(scale_bar(shown.plan, each, words)),
            _quoted(picture(shown.plan, each, inker)),
        ]
        for each in sheet.panels
    ]
    values = values_of(shown.plan, load_style(question.style).key)
    rows = [
        [_quoted(measured_cells(shown.plan, panel, row, words, values)) for panel in sheet.panels]
        for row in sheet.rows
    ]
    return {
        "panels": drawn,
        "rows": rows,
        "looks": inker.classes.sheet(question.known),
        "scales": listed(shown.scales),
        "ways": {
            name: {label: round(way, 1) for label, way in ways.items()}
            for name, ways in shown.ways.items()
        },
        **ranges_and_handle(motion, sheet, shown.scales),
        **trouble,
        "ms": round(1e3 * (time.thread_time() - begun), 2),
    }


@lru_cache(maxsize=16)
def board_of(
    mechanism: Mechanism, panels: tuple[str, ...], language: str, burden: Burden | None = None
) -> LiveBoard:
    """Return the board for all poses of a mechanism.

    Raises
    ------
    vad.errors.AssemblyError
        If it closes nowhere.
    """
    motions = (vad.solve(mechanism, **given) for given in poses_over_reach(mechanism))
    loaded = [with_forces(motion, burden) for motion in motions]
    sheet = _first(loaded, panels, language)
    return LiveBoard.over(sheet, FORM, LINES, list(_pictured(sheet, loaded)))


def _results(motion: Motion, burden: Burden | None) -> dict[str, Any]:
    """Return the results of ``vad solve --json``."""
    found = motion.to_dict()
    return found if burden is None else found | {"forces": vad.forces(motion, *burden).to_dict()}


def _quoted(html: str) -> str:
    """Return HTML with single quotes, which JSON need not escape; no text contains either quote."""
    return html.replace('"', "'")


def _pictured(sheet: Sheet, poses: Iterable[Pose]) -> Iterator[Sheet]:
    """Yield the panels of a sheet that show bodies, of all poses that have them."""
    panels = [panel.name for panel in sheet.panels if panel.picture != "vectors"]
    for pose in poses if panels else ():
        try:
            yield vad.draw(pose, panels, "en")
        except VadError:
            continue


@lru_cache(maxsize=8)
def _inks(style: str) -> Inks:
    return Inks(load_style(style))


@lru_cache(maxsize=64)
def reach(mechanism: Mechanism) -> list[tuple[float, float]]:
    """Return the ranges of the driver that close."""
    return closing_range(mechanism)


def _first(poses: Iterable[Pose], panels: tuple[str, ...], language: str) -> Sheet:
    """Return the first sheet that has all panels."""
    wrong: VadError = AssemblyError("with these lengths the links close nowhere")
    for pose in poses:
        try:
            return vad.draw(pose, panels, language)
        except VadError as error:
            wrong = error
    raise wrong


def ranges_and_handle(motion: Motion, sheet: Sheet, scales: Mapping[str, Scale]) -> dict[str, Any]:
    """Return the ranges of the driver and its handle, by which it is turned by hand."""
    found: dict[str, Any] = {"ranges": reach(motion.mechanism), "handle": None}
    if POSITION in scales:
        found["handle"] = handle_of(motion, sheet, scales[POSITION], FORM)
    return found


def scale_of(values: tuple[float, float, float]) -> Scale:
    """Return a scale from the numbers of a question."""
    return Scale(complex(values[0], values[1]), values[2])


def listed(scales: Mapping[str, Scale]) -> Scales:
    """Return scales as a question has them; a panel with a single point has none."""
    return {
        name: (
            round(scale.origin.real, 7),
            round(scale.origin.imag, 7),
            float(f"{scale.factor:.9g}"),
        )
        for name, scale in scales.items()
        if not scale.bare
    }


def lesson(question: LessonQuestion) -> dict[str, Any]:
    """Return a lesson, as a page has it.

    Returns
    -------
    dict
        ``html``, the lesson in its places on a page; ``data`` for its player and ``looks``, the
        rules of its classes, less those that the page knows; the ``scales`` of its panels; the
        ``results`` of ``vad solve --json``.  Its ``key`` stands for the mechanism as a hand moves
        it: what a page needs for that, ``layers`` and in the data ``hand`` and ``program``, is left
        out if the question has this key.

    Raises
    ------
    vad.errors.VadError
        For a pose that cannot be, or that has no rates.
    """
    motion, burden = question.solved()
    loaded = with_forces(motion, burden)
    mechanism, panels = motion.mechanism, _panels(question, loaded)
    sheet = vad.draw(loaded, panels, question.language)
    turned = turned_board_of(mechanism, panels, question.language, burden)
    scales = dict(turned.live.scales)
    for panel in sheet.halves:
        if panel.name not in scales and panel.name in question.scales:
            before = scale_of(question.scales[panel.name])
            scales[panel.name] = calm_scale(panel, turned.live.room(panel, sheet), before)
    style = load_style(question.style)
    copy = plan(sheet, FORM, style.key, lesson=True, lines=LINES, scales=scales, words=False)
    about = repr((mechanism, panels, question.language, question.style, burden))
    key = sha256(about.encode()).hexdigest()[:16]
    told = question.key == key
    film = vad.animate(sheet, style=question.style)
    made = parts(film, copy, None if told else turned, question.known)
    answer = {
        "key": key,
        "html": section(film, made),
        "data": made.data,
        "looks": made.looks,
        "scales": listed({name: sketch.scale for name, sketch in copy.sketches.items()}),
        "results": _results(motion, burden),
    }
    if made.hand:
        hand = {"hand": {**made.hand.data, "sliders": True}, "program": made.hand.program}
        answer["data"] = {**made.data, **hand}
        answer["layers"] = [made.hand.layers[name] for name in panels]
    return answer


@lru_cache(maxsize=8)
def turned_board_of(
    mechanism: Mechanism, panels: tuple[str, ...], language: str, burden: Burden | None = None
) -> HandBoard:
    """Return the board on which a hand turns a mechanism.

    Raises
    ------
    vad.errors.AssemblyError
        If it closes nowhere.
    """
    return hand_board(mechanism, panels, language, FORM, LINES, burden)


def handle_of(motion: Motion, sheet: Sheet, scale: Scale, form: Format) -> dict[str, Any] | None:
    """Return the handle on the pin, strut or block that is driven; None where none is drawn.

    In views it is at the end of the driven angle's arc, where that is seen in true size from the
    right on.

    Returns
    -------
    dict
        ``kind``, ``name`` of the input, and where it is, ``at``.  An "angle" is measured at
        ``about``; a "length" from there, ``factor`` pixels to the unit; a "slide" along ``way``
        from ``about``.
    """

    def place(z: complex) -> list[float]:
        return [round(z.real * form.unit, 2), round((form.height - z.imag) * form.unit, 2)]

    name, factor = next(iter(motion.mechanism.inputs)), scale.factor * form.unit
    panel, driver = sheet.panel("position"), sheet.driver
    arc = held_arc(panel, driver)
    if arc:
        spots = {"at": place(scale(tip_of(arc))), "about": place(scale(arc.centre))}
        return {"kind": "angle", "name": name, **spots, "factor": factor}
    index = panel.find(driver.stroke)
    if index is None:
        return None
    shape = panel.strokes[index].shape
    if isinstance(shape, Arrow):
        kind = "angle" if driver.turns else "length"
        about, at = scale(shape.start), scale(shape.end)
        return {
            "kind": kind,
            "name": name,
            "at": place(at),
            "about": place(about),
            "factor": factor,
        }
    if not isinstance(shape, Block):
        return None
    way = _way(motion, panel.strokes[index].label)
    about = scale(shape.at - float(motion.inputs[name]) * way)
    return {
        "kind": "slide",
        "name": name,
        "at": place(scale(shape.at)),
        "about": place(about),
        "way": [way.real, -way.imag],
        "factor": factor,
    }


def _way(motion: Motion, letter: str) -> complex:
    """Return the direction in which a driven point moves, as a unit vector."""
    place, speed, *_ = motion.inputs
    moved = vad.solve(motion.mechanism, **{place: motion.inputs[place], speed: 1.0})
    return complex(moved.point(letter).velocity)


def saved(question: ExportQuestion, extension: str) -> tuple[bytes, str]:
    """Return the bytes of a file, and what it is called.

    Its kind is an extension; or "turn", the page of a whole turn, or "problem", a problem sheet, in
    which the polygons are left to be drawn; or "toml", the file of the mechanism with the
    numbers that are set: its own, or else one of a sheet.

    Raises
    ------
    vad.errors.VadError
        For what cannot be drawn or saved, or takes more than `LARGEST_FILE` bytes.
    """
    motion, burden = question.solved()
    if extension == "toml":
        return _file_of(motion, burden)
    pose = with_forces(motion, burden)
    panels = _panels(question, pose)
    sheet = vad.draw(pose, panels, question.language)
    name = motion.mechanism.name + _ENDS.get(extension, f".{extension}")
    with temporary_folder() as folder:
        path = folder / name
        if extension == "json":
            vad.save(sheet, path)
        elif extension == "turn":
            film = vad.turn(pose, style=question.style, panels=panels, language=sheet.language)
            vad.save(film, path)
        elif extension == "problem":
            blank = [panel.name for panel in sheet.panels if panel.name != POSITION]
            vad.save(sheet, path, style=question.style, blank=blank)
        elif extension in PICTURES:
            vad.save(sheet, path, style=question.style, size=question.size)
        else:
            played = vad.animate(sheet, question.fps, question.size, question.speed, question.style)
            vad.save(played, path, progress=lambda *_: _check_size(folder))
        return path.read_bytes(), name


def _file_of(motion: Motion, burden: Burden | None) -> tuple[bytes, str]:
    """Return the file of a mechanism with its numbers, and what it is called."""
    mechanism = motion.mechanism
    if not isinstance(mechanism, WrittenMechanism):
        if burden is not None:
            hint = "name them on the command line, as in --load"
            raise UsageError("loads: are not kept in the file of a sheet", hint)
        return sheet_file(motion).encode(), mechanism.name + EXTENSION
    inputs = {name: float(value) for name, value in motion.inputs.items()}
    return rewritten(mechanism, inputs).encode(), mechanism.name + EXTENSION


def _check_size(folder: Path) -> None:
    if sum(each.stat().st_size for each in folder.iterdir()) > LARGEST_FILE:
        most = f"{LARGEST_FILE / 1e6:g} MB"
        raise ExportError(f"the film takes more than {most}", "try a smaller size, or vad animate")

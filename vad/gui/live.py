"""One pose while something moves: in comes a question, out goes the page's parts for that pose.

What is the same in all poses of a mechanism is kept for the few that were asked for last.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any

import numpy as np

import vad
from vad.errors import AssemblyError, DeadCentreError, VadError
from vad.gui.grip import grip
from vad.gui.messages import PoseQuestion, Scales, problem
from vad.kinematics.motion import Motion
from vad.kinematics.reach import closing_range
from vad.mechanisms import Mechanism
from vad.page.ink import Inker
from vad.page.parts import Words, measured_cells, picture, scale_bar, values_of
from vad.page.themed import Inks
from vad.painting.posed import SIZE
from vad.painting.svg_text import Faces
from vad.plan.format import screen
from vad.plan.live_board import LiveBoard
from vad.plan.scale import Scale
from vad.strokes.draw import chosen
from vad.strokes.sheet import Panel, Sheet
from vad.style import load_style

FORM = screen(SIZE)
#: Lines for a caption, in the layout of the page: there, captions have a place of their own.
LINES = 1
POSITION = "position"
#: Poses at which is looked what the mechanism needs room for.
_POSES = 12
#: How near to the ends of the reach they get.  They lie closer there, where links turn fastest.
_END = 0.05
_TURN = (0.0, 360.0)


def pose(question: PoseQuestion) -> dict[str, Any]:
    """Return a pose.

    Returns
    -------
    dict
        HTML in its places on a page: ``panels`` with name, scale bar and drawing, ``rows`` with
        the cells of the table, and their ``looks``, less those that the page knows.  For the next
        question, ``scales`` and ``ways``; for the hand, the ``ranges`` of the driver that close and
        the ``handle`` (see `vad.gui.grip`).  The ``results`` of ``vad solve --json``, and the
        milliseconds that it took, ``ms``.  At a dead centre there is the position alone, and an
        ``error``.

    Raises
    ------
    vad.errors.VadError
        For a pose that cannot be.
    """
    begun = time.thread_time()
    mechanism, inputs = question.build()
    motion = vad.solve(mechanism, **inputs)
    panels = chosen(question.panels or None, motion)
    trouble: dict[str, Any] = {}
    try:
        sheet = vad.draw(motion, panels, question.language)
        trouble = {"results": motion.to_dict()}
    except DeadCentreError as error:
        if POSITION not in panels:
            raise
        sheet = vad.draw(motion, POSITION, question.language)
        trouble = {"error": problem(error, question.fields)}
    scales = {name: scale_of(values) for name, values in question.scales.items()}
    rested = question.rested(mechanism)
    board = board_of(rested, panels, question.language)
    if rested != mechanism:
        board = board.resized(sheet, scales)
    shown = board.pose(sheet, scales, question.ways)
    faces = Faces()
    inker, words = Inker(FORM, _inks(question.style), faces), Words(faces)
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
        **grips(motion, sheet, shown.scales),
        **trouble,
        "ms": round(1e3 * (time.thread_time() - begun), 2),
    }


@lru_cache(maxsize=16)
def board_of(mechanism: Mechanism, panels: tuple[str, ...], language: str) -> LiveBoard:
    """Return the board for all poses of a mechanism.

    Raises
    ------
    vad.errors.AssemblyError
        If it closes nowhere.
    """
    motions = list(_over(mechanism))
    poses = [_pictured(motion) for motion in motions]
    return LiveBoard.over(_first(motions, panels, language), FORM, LINES, poses)


def _quoted(html: str) -> str:
    """Return HTML with single quotes, of which JSON escapes none; a text has neither of both."""
    return html.replace('"', "'")


def _over(mechanism: Mechanism) -> Iterable[Motion]:
    """Yield poses over all that the driver reaches."""
    driven, ranges = next(iter(mechanism.inputs)), reach(mechanism)
    for low, high in ranges:
        count = max(2, _POSES // len(ranges))
        shares = 0.5 - 0.5 * np.cos(np.linspace(_END, math.pi - _END, count))
        if ranges == [_TURN]:
            shares = np.linspace(0.0, 1.0, count, endpoint=False)
        for share in shares:
            yield vad.solve(mechanism, **{driven: low + float(share) * (high - low)})


def _pictured(motion: Motion) -> Panel:
    """Return the mechanism in one pose."""
    return vad.draw(motion, POSITION, "en").panel(POSITION)


@lru_cache(maxsize=8)
def _inks(style: str) -> Inks:
    return Inks(load_style(style))


@lru_cache(maxsize=64)
def reach(mechanism: Mechanism) -> list[tuple[float, float]]:
    """Return the ranges of the driver that close."""
    return closing_range(mechanism)


def _first(motions: Iterable[Motion], panels: tuple[str, ...], language: str) -> Sheet:
    """Return the first sheet that has all panels."""
    wrong: VadError = AssemblyError("with these lengths the links close nowhere")
    for motion in motions:
        try:
            return vad.draw(motion, panels, language)
        except VadError as error:
            wrong = error
    raise wrong


def grips(motion: Motion, sheet: Sheet, scales: Mapping[str, Scale]) -> dict[str, Any]:
    """Return what the hand needs: the ranges of the driver, and its handle."""
    found: dict[str, Any] = {"ranges": reach(motion.mechanism), "handle": None}
    if POSITION in scales:
        found["handle"] = grip(motion, sheet, scales[POSITION], FORM)
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

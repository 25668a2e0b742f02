"""The fair copy: in comes a question, out goes the lesson of what is set, for the player.

The mechanism stands where it stood under the hand.
"""

from __future__ import annotations

from typing import Any

import vad
from vad.gui.live import FORM, LINES, board_of, grips, listed, scale_of
from vad.gui.messages import LessonQuestion
from vad.page.parts import parts
from vad.plan.board import plan
from vad.plan.scaling import calm_scale
from vad.strokes.draw import chosen
from vad.style import load_style


def lesson(question: LessonQuestion) -> dict[str, Any]:
    """Return a lesson.

    Returns
    -------
    dict
        The ``head``, ``panels``, ``table``, ``chapters``, ``steps``,
        ``data`` and ``looks`` of a page, and the ``scales``, ``ranges``, ``handle`` and
        ``results`` of a pose.

    Raises
    ------
    vad.errors.VadError
        For a pose that cannot be, or that has no rates.
    """
    mechanism, inputs = question.build()
    motion = vad.solve(mechanism, **inputs)
    panels = chosen(question.panels or None, motion)
    sheet = vad.draw(motion, panels, question.language)
    board, scales = board_of(mechanism, panels, question.language), {}
    for panel in sheet.halves:
        if panel.name in board.pictures:
            scales[panel.name] = board.pictures[panel.name].scale
        elif panel.name in question.scales:
            before = scale_of(question.scales[panel.name])
            scales[panel.name] = calm_scale(panel, board.room(panel, sheet), before)
    key = load_style(question.style).key
    copy = plan(sheet, FORM, key, lesson=True, lines=LINES, scales=scales, words=False)
    made = parts(vad.animate(sheet, style=question.style), copy)
    shown = {name: sketch.scale for name, sketch in copy.sketches.items()}
    return {
        "head": made.head,
        "panels": made.panels,
        "table": made.table,
        "chapters": made.chapters,
        "steps": made.steps,
        "data": made.data,
        "looks": made.looks,
        "scales": listed(shown),
        **grips(motion, sheet, shown),
        "results": motion.to_dict(),
    }

"""The parts of a page: in comes a lesson, out go HTML for the places of a page and data to move it.

The file, the live page and the notebook are made of the same parts, and played by the same script.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from typing import Any

from vad.lecture.lesson import Lesson, Step
from vad.page.ink import Inker
from vad.page.panels import panel_section
from vad.page.results_table import table
from vad.page.spoken import spoken
from vad.page.themed import Inks
from vad.page.wording import Words
from vad.painting.posed import SIZE
from vad.painting.svg_text import Faces
from vad.plan.board import Plan, plan
from vad.plan.format import screen
from vad.plan.lettering.runs import roman, said
from vad.plan.lettering.wrapping import tied
from vad.strokes.sentences import pieces_of
from vad.strokes.words import parameters
from vad.style import load_style
from vad.words import Language


@dataclass(frozen=True, slots=True)
class Parts:
    """What a page is made of.

    Attributes
    ----------
    head, panels, table, chapters, steps
        HTML for the places of those names.
    data
        What the script plays: ``first`` strokes and ``panels`` by name and title, ``times`` of
        each stroke (seconds that it grows and rests), ``spoken`` captions, ``grow`` (see
        `vad.page.growths`) and ``words``.
    lines
        How many lines captions take.
    looks
        Rules of the classes in ``panels`` and ``table``.
    faces
        The letters of it all.
    """

    head: str
    panels: str
    table: str
    chapters: str
    steps: str
    data: Mapping[str, Any]
    lines: int
    looks: str
    faces: Faces


def page_plan(lesson: Lesson) -> Plan:
    """Return the board of a lesson as its page shows it, whatever the size of its film."""
    key = load_style(lesson.style).key
    return plan(lesson.sheet, screen(SIZE), key, lesson=True, words=False)


def parts(lesson: Lesson, board: Plan | None = None) -> Parts:
    """Return the parts of a lesson's page.

    Parameters
    ----------
    lesson
        What is played.
    board
        Its board, where that has scales of its own.
    """
    board = board or page_plan(lesson)
    style, faces = load_style(lesson.style), Faces()
    inker, words = Inker(board.form, Inks(style), faces), Words(faces)
    sheet = lesson.sheet
    listed = [_listed(lesson, step, words) for step in lesson.steps]
    drawn = [panel_section(board, panel, inker, words) for panel in sheet.panels]
    results = table(board, style.key, inker, words)
    title = words.of(roman(sheet.title), light=False, heavy=True)
    items = words.of(roman(", ".join(item.replace(" ", "\u00a0") for item in parameters(sheet))))
    first = [board.sketches[panel.name].setting.first for panel in sheet.panels]
    counts = [sum(len(half.strokes) for half in panel.halves) for panel in sheet.panels]
    return Parts(
        head=f"<h1>{title}</h1><p>{items}</p>",
        panels="".join(drawn),
        table=results,
        chapters="".join(
            f'<button data-x="{start}" style="flex-grow:{count}">{escape(panel.title)}</button>'
            for panel, start, count in zip(sheet.panels, first, counts, strict=True)
        ),
        steps="".join(
            f"<div><h3>{words.of(roman(panel.title), light=False, heavy=True)}</h3><ol>"
            + "".join(
                item
                for step, (item, _) in zip(lesson.steps, listed, strict=True)
                if step.panel.column == panel.name
            )
            + "</ol></div>"
            for panel in sheet.panels
        ),
        data={
            "first": first,
            "panels": [[panel.name, panel.title] for panel in sheet.panels],
            "times": [
                [round(step.grow / lesson.fps, 3), round(step.hold / lesson.fps, 3)]
                for step in lesson.steps
            ],
            "spoken": [words for _, words in listed],
            "grow": inker.growths,
            "words": Language(sheet.language).page("PLAYER"),
        },
        lines=len(board.page.captions),
        looks=inker.classes.sheet(),
        faces=faces,
    )


def _listed(lesson: Lesson, step: Step, words: Words) -> tuple[str, str]:
    """Return the caption of a step as an entry of the list, and as it is read out."""
    pieces = pieces_of(step.stroke.said)
    place = f"#step={step.panel.column}:{lesson.place(step)}"
    item = f'<li><a href="{place}">{words.of(said(tied(pieces)))}</a></li>'
    return item, spoken(pieces, lesson.sheet.language)

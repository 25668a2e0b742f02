"""The verb `quiz`: from a file that says what a class is to get to a question bank.

Each sheet of the file becomes questions: the picture of the problem, and one result to be found.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import vad
from vad.balancing.results import results
from vad.batches.choices import written_at
from vad.batches.job import Job
from vad.batches.making import OF_DRAW, blank_of, loaded, picked
from vad.batches.sheets import read_sheets
from vad.batches.sweep import sweep
from vad.errors import InputError, one_of, unknown
from vad.export.files import temporary_folder
from vad.export.quiz import Question, format_of, save_quiz
from vad.kinematics.motion import Motion
from vad.statics.forces import DRIVE, FORCE, Forces, given_burden
from vad.strokes.description import parameters
from vad.strokes.diagram import ORDERS
from vad.strokes.given import FIGURES, given
from vad.strokes.sheet import Sheet
from vad.units import scene_unit
from vad.words import Gap, Language, text_of
from vad.written import base_name, sign

#: The pictures of a question in pixels: readable beside the text of a platform.
SIZE = (1024, 576)
#: A result that is small beside the largest of its kind is drawn no better than so much of that.
_LEAST_SHARE = 0.1
#: The ends of the names of results of each order.
_ENDINGS = (
    (".angle", ".position"),
    (".omega", ".velocity"),
    (".alpha", ".acceleration", ".coriolis"),
)
_OF_POINTS = ("velocity", "acceleration")


def quiz(
    path: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    loads: Iterable[Any] = (),
    masses: Mapping[str, Any] | None = None,
    gravity: Any = None,
    friction: Mapping[str, Any] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> list[Question]:
    """Make a question bank of a file of sheets: pictures, numerical answers, keys as feedback.

    Parameters
    ----------
    path
        A file as for `batch`.  Two of its words are for question banks.  ``ask`` has the names of
        results, such as ``"rocker.omega"``, ``"C.velocity"``, ``"drive"`` or
        ``"coupler.rocker.force"``; of points and forces the size is asked for.  Left out, these are
        the rates of the links and slides, the drive and the forces in the joints, in the panels
        that are left blank.  From instantaneous centres, Klein's construction and the turned
        velocities the rates are asked for that follow from them.
        ``tolerance`` says how far off a right answer may be, as a share of it; it is 0.03.
    output
        A file: Moodle XML (.xml), GIFT (.gift), a package of QTI 2.1 (.zip) or Markdown (.md).
    loads, masses, gravity, friction
        As for `forces`: what every mechanism bears beside all that the file says.
    progress
        Called with how many sheets are done and their total.

    Returns
    -------
    list of Question
        In the order of the file.

    Raises
    ------
    vad.errors.InputError
        For what cannot be in the file, with its line, and for a sheet that cannot be made.
    vad.errors.UsageError
        For another kind of output.
    vad.errors.ExportError
        If it cannot be written.
    """
    format_of(output)
    sheets = read_sheets(path, given_burden(loads, masses, gravity, friction))
    for failed in sheets.failed:
        assert failed.error is not None
        raise failed.error
    questions: list[Question] = []
    for number, job in enumerate(sheets.jobs, start=1):
        with written_at(job.place):
            questions += _questions(job)
        if progress is not None:
            progress(number, len(sheets.jobs))
    save_quiz(questions, output)
    return questions


def _questions(job: Job) -> Iterator[Question]:
    """Yield the questions of one sheet."""
    motion, options = picked(job), dict(job.recipe.options)
    pose = loaded(job, motion)
    wanted = {name: options[name] for name in OF_DRAW if name in options}
    sheet = vad.draw(pose, **wanted)
    blank = blank_of(job, sheet)
    language, style = Language(sheet.language, sheet.names), options.get("style")
    numbered = replace(sheet, title=f"{sheet.title} · {job.label}")
    forces = pose if isinstance(pose, Forces) else None
    asked = job.recipe.ask or tuple(dict.fromkeys(_usual(motion, forces, sheet, blank)))
    if not asked:
        raise _nothing(motion, forces, blank)
    with written_at("ask"):
        found = _values(motion, forces, sheet, asked)
    problem = _png(numbered, style, blank)
    key, title = _png(numbered, style, ()), f"{sheet.title} · {job.label}"
    known = ", ".join(dict.fromkeys(_given(sheet, asked)))
    told = language.say("quiz given", title=sheet.title, given=known)
    for result, (phrase, unit, value) in found.items():
        kind = result.rpartition(".")[2]
        largest = max(abs(each) for name, (*_, each) in found.items() if name.endswith(kind))
        yield Question(
            name=f"{job.recipe.mechanism.removesuffix('.toml')} {job.label} {result}",
            category=sheet.title,
            task=f"{told} {_find(language, phrase, *_owners(motion, result), unit, motion)}",
            picture=problem,
            key=key,
            title=title,
            feedback=language.say("quiz key"),
            value=value,
            unit=unit,
            tolerance=job.recipe.tolerance * max(abs(value), _LEAST_SHARE * largest),
        )


def _png(sheet: Sheet, style: str | None, blank: tuple[str, ...]) -> bytes:
    """Return a picture; panels named in ``blank`` are left to be drawn."""
    with temporary_folder() as folder:
        path = Path(folder, "picture.png")
        # The question says the task, and a question bank knows the name.
        problem: Any = {"blank": blank, "task": False} if blank else {}
        vad.save(sheet, path, size=SIZE, style=style, **problem)
        return path.read_bytes()


def _given(sheet: Sheet, asked: tuple[str, ...]) -> Iterator[str]:
    """Yield the dimensions and what else is given, as the sheet writes them."""
    yield from map(text_of, parameters(sheet))
    further = [o.panel for o in ORDERS if any(n.endswith(_ENDINGS[o.number]) for n in asked)]
    further += [DRIVE for name in asked if name == DRIVE or name.endswith(FORCE)]
    yield from map(text_of, given(sheet, further))


def _usual(
    motion: Motion, forces: Forces[Any, Any, Any] | None, sheet: Sheet, blank: tuple[str, ...]
) -> Iterator[str]:
    """Yield the results that a student draws.

    These are rates of links and slides that are not driven, also those that follow from a figure
    upon the mechanism; the forces in the joints, and the drive.
    """
    driven = motion.solver.driver.name
    if motion.mechanism.is_rotor:
        balanced = results(motion.mechanism.balancing(motion))
        yield from (name for name, each in balanced.items() if each.panel in blank)
        return
    links = [name for name in motion.links if name not in motion.solver.bodies]
    for order in ORDERS:
        drawn = order.panel in blank
        figures = [name for name in FIGURES.get(order.number, ()) if name in blank]
        for owners, quantity in ((links, order.rate), (motion.slides, order.panel)):
            for name in owners:
                if name != driven and (drawn or _finds(sheet, figures, name)):
                    yield f"{name}.{quantity}"
    if forces and "force" in blank:
        for joint in forces.joints:
            yield f"{joint.one}.{joint.other}{FORCE}"
    if forces and "drive" in blank:
        yield DRIVE


def _finds(sheet: Sheet, figures: list[str], name: str) -> bool:
    """Tell whether one of these panels has a result in the row of a link or a slide."""
    rows = [row for row in sheet.rows if row.key == name]
    return any(not cell.given for row in rows for each in figures for cell in row.cells[each])


def _nothing(
    motion: Motion, forces: Forces[Any, Any, Any] | None, blank: tuple[str, ...]
) -> InputError:
    """Return what is wrong where nothing is left to be found."""
    drawn = ", ".join(blank) if blank else "no panel"
    known = [name for name in motion.results if not name.endswith(".position")]
    hint = f'as in ask = ["{known[-1]}"]' if known else "blank: the panels that a student draws"
    return InputError(f"ask: {drawn} left blank, from which nothing is to be found", hint)


def _values(
    motion: Motion,
    forces: Forces[Any, Any, Any] | None,
    sheet: Sheet,
    names: tuple[str, ...],
) -> Mapping[str, tuple[str, str, float]]:
    """Return for each result the phrase that asks for it, its unit and its value."""
    found: dict[str, tuple[str, str, float]] = {}
    if motion.mechanism.is_rotor:
        balanced = results(motion.mechanism.balancing(motion))
        for name in names:
            each = balanced[one_of("result of a question", name, balanced)]
            found[name] = f"quiz found {each.kind}", each.unit, each.value
        return found
    inputs: dict[str, Any] = {name: float(value) for name, value in motion.inputs.items()}
    burden = vars(forces.burden) if forces else {}
    swept = sweep(motion.mechanism, names, **burden, **inputs)
    for name in names:
        if forces and (name == DRIVE or name.endswith(FORCE)):
            kind = FORCE[1:] if name != DRIVE else "torque" if "angle" in motion.inputs else "push"
            unit = forces.drive_unit if name == DRIVE else "N"
            value = swept[name].item()
            found[name] = f"quiz {kind}", unit, value if name == DRIVE else abs(value)
            continue
        owner, _, kind = name.partition(".")
        of_point = owner in motion.points
        if not kind or (of_point and kind not in _OF_POINTS) or owner in motion.solver.bodies:
            known = [f"{point}.velocity" for point in motion.points]
            usual = _usual(motion, forces, sheet, ("velocity", "force", "drive"))
            raise unknown("result of a question", name, [*usual, *known])
        value = swept[name].item()
        unit = scene_unit(
            "acceleration" if kind == "coriolis" else kind, motion.mechanism.length_unit
        )
        phrase = f"quiz point {kind}" if of_point else f"quiz {kind}"
        found[name] = phrase, unit, abs(value) if isinstance(value, complex) else value
    return found


def _owners(motion: Motion, result: str) -> tuple[str, str]:
    """Return whose result it is; of a force, who exerts it and upon whom."""
    if result == DRIVE:
        return motion.solver.driver.name, ""
    one, _, other = result.removesuffix(FORCE).partition(".")
    return one, other


def _find(
    language: Language, phrase: str, owner: str, other: str, unit: str, motion: Motion
) -> str:
    """Return what is to be found, in words."""
    speaker, slides = language.speaker(phrase), motion.mechanism.slides
    texts = {"unit": sign(unit), "point": owner}

    def noun(gap: Gap) -> str:
        """Return a name; of several slides that are called alike, it has the point."""
        name = other if gap.name == "other" else owner
        word = base_name(name) if name in slides else name
        said = speaker.noun(word, gap.article, gap.name)
        return said if word == name else f"{said} {slides[name]}"

    return "".join(
        (texts.get(each.name) or noun(each)) if isinstance(each, Gap) else each.text
        for each in language.template(phrase)
    )

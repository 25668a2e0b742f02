"""In which ways a mechanism on a page can be assembled, and what happens where its links part.

The factors of its loops are inputs of the page's program: so the page shows all its assemblies.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import fields
from typing import Any

from vad.kinematics.assemblies import assemblies
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.loop import LoopSolver
from vad.kinematics.solver import Solver
from vad.plan.hand_board import HandBoard
from vad.strokes.members import members_of
from vad.strokes.traced_dimensions import sides_of
from vad.words import Language


def ways(board: HandBoard, language: str, output: Callable[[float], int]) -> dict[str, Any]:
    """Return the assemblies of a mechanism, and its limits.

    Parameters
    ----------
    board
        The mechanism.
    language
        The language of the page.
    output
        The number of an output.

    Returns
    -------
    dict
        ``assemblies``: of each its name in JSON, and its factors, the mechanism's own first.
        ``elsewhere``: those that only another page has.  ``sides``: the places of these factors
        among the inputs.  ``places``: of each point that is placed, or of "" for the whole
        mechanism, the words that its assemblies have for it, each with its name.  ``limits``: an
        output that is zero where links part, and how they stand there.
    """
    mechanism, words = board.mechanism, Language(language).page("WINDOW")
    traced = list(board.traced.inputs)
    sides = {name: each for name, each in sides_of(mechanism).items() if name in traced}
    known = assemblies(mechanism)[: None if sides else 1]
    factors = list(zip(*sides.values(), strict=True)) or [()]
    places: dict[str, dict[str, str]] = {}
    for way in known if sides else ():
        for point, word in (
            {"": way.name} if isinstance(way.name, str) else way.name or {}
        ).items():
            places.setdefault(point, {})[word] = words.get(word, word)
    shown = [way.name for way in known]
    choices = next(each.metadata for each in fields(mechanism) if each.name == "assembly")
    return {
        "elsewhere": [
            each for each in choices.get("choices", ()) if shown != [None] and each not in shown
        ],
        "assemblies": [[way.name, each] for way, each in zip(known, factors, strict=True)],
        "sides": [traced.index(name) for name in sides],
        "places": [[point, list(each.items())] for point, each in places.items()],
        "limits": [[output(sine), said] for sine, said in _limits(board, Language(language))],
    }


def _limits(board: HandBoard, language: Language) -> Iterator[tuple[float, str]]:
    """Yield the sine of each loop that has two places, and how it stands where that is zero."""
    solver, words = board.traced.motion.solver, language.page("HAND")
    sines = board.traced.motion.pose.sine
    if not isinstance(solver, Solver):
        said = words.get(f"parting-{board.mechanism.name}")
        yield from [(sines[0], said)] if said else []
        return
    letters = members_of(board.mechanism).letters
    for loop, sine in zip(solver.loops, sines, strict=True):
        kind = _kind(loop)
        if kind:
            both = {"one": letters(loop.step), "other": letters(loop.other)}
            yield sine, words[kind].format(**both)


def _kind(loop: LoopSolver) -> str:
    """Return the name of the sentence of a loop at its limit; none of a loop that has no limit."""
    if not loop.two_ways or loop.loop.parallel:
        return ""
    if isinstance(loop.step, Bar) and isinstance(loop.other, Bar):
        return "parting-bars"
    line = loop.other.along if isinstance(loop.other, Slide) else None
    return "parting-guide" if isinstance(line, float) else "parting-slot"

"""Linkages of Python classes that nobody should declare: loops with bars and slides changed.

A seed changes a few steps of a linkage that is right.  It is refused when it is made, or when it is
drawn; else it is solved and drawn.  Run as a program, this module tries so many seeds from a first
one::

    python -m tests.fuzz.linkages 1000 0
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from typing import Any

import vad
from tests.fuzz.promise import broken
from tests.kinematics.hand_built import BUILT, HandBuilt
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, Step, angle_of, length_of
from vad.plan.board import plan
from vad.plan.format import screen
from vad.style import load_style

#: The most seconds that a linkage may take from its loops to the plan of its page.
LONGEST = 20.0

RIGHT: list[Any] = [kind().linkage() for kind in vad.MECHANISMS.values()]
RIGHT = [each for each in RIGHT if isinstance(each, Linkage)]
RIGHT += [build() for build in BUILT.values()]
SIZES = (0.0, -0.0, 1.0, -40.0, 60.0, 1e-9, 1e9, 5e-324, 1e-201, 1e201, 1e308, float("nan"))
PLACES = (0j, 1j, -1.0 + 0j, 2j, complex(3.0, 4.0), complex("nan"), 1e308j, 5e-324 + 0j)
NAMES = ("", "x", "crank", "coupler", "rocker", "slider", "block", "two words", "É")


def case(seed: int) -> int:
    """Return the seed, from which the linkage is made."""
    return seed


def fault(seed: int, _: int = 0) -> str | None:
    """Make the linkage of a seed, solve it and draw it; return what it breaks, or None."""
    return broken(lambda: _tried(random.Random(seed)), LONGEST)


def _tried(dice: random.Random) -> None:
    linkage: Linkage = dice.choice(RIGHT)
    for _ in range(dice.choice((1, 1, 2, 3))):
        linkage = dice.choice(MUTATIONS)(linkage, dice)
    built: Any = HandBuilt(linkage)
    place = next(iter(built.inputs))
    start = dice.choice((built.inputs[place], 0.0, 90.0, dice.uniform(0.0, 360.0)))
    vad.solve(built, **{place: [start, 0.0, float("nan")]}).to_dict()
    with suppress(vad.AssemblyError, vad.DeadCentreError):
        motion = vad.solve(built, **{place: start})
        motion.to_dict()
        plan(vad.draw(motion), screen((1280, 720)), load_style("paper").key)


def _changed(linkage: Linkage, dice: random.Random, change: Callable[[Step], Step]) -> Linkage:
    """Return a linkage with one step of one chain changed."""
    loops = list(linkage.loops)
    number = dice.randrange(len(loops))
    loop = loops[number]
    name = dice.choice(("first", "second"))
    chain = list(getattr(loop, name))
    if not chain:
        return linkage
    place = dice.randrange(len(chain))
    chain[place] = change(chain[place])
    loops[number] = replace(loop, **{name: tuple(chain)})
    return replace(linkage, loops=tuple(loops))


def _points(linkage: Linkage) -> list[str]:
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    return [*(point for step in steps for point in (step.tail, step.head)), "Z", "A1"]


def _names(linkage: Linkage) -> list[str]:
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    return [*(each.link if isinstance(each, Bar) else each.name for each in steps), *NAMES]


def _ends(linkage: Linkage, dice: random.Random) -> Linkage:
    """Let a step run between other points."""
    ends = dice.choice(_points(linkage)) + dice.choice(_points(linkage))
    return _changed(linkage, dice, lambda step: replace(step, ends=ends))


def _named(linkage: Linkage, dice: random.Random) -> Linkage:
    """Give a step another name."""
    name = dice.choice(_names(linkage))

    def change(step: Step) -> Step:
        if isinstance(step, Bar):
            return replace(step, link=name)
        return replace(step, name=name)

    return _changed(linkage, dice, change)


def _sized(linkage: Linkage, dice: random.Random) -> Linkage:
    """Give a bar another length, or a slide another line."""
    value = dice.choice((*SIZES, *_names(linkage)))

    def change(step: Step) -> Step:
        return replace(step, length=value) if isinstance(step, Bar) else replace(step, along=value)

    return _changed(linkage, dice, change)


def _turned(linkage: Linkage, dice: random.Random) -> Linkage:
    """Turn a step in its link, move it aside, or run through it backwards."""
    place = dice.choice(PLACES)
    which = dice.choice(("turn", "aside", "reverse"))

    def change(step: Step) -> Step:
        if which == "turn":
            return replace(step, turn=place)
        if which == "reverse":
            return -step
        return replace(step, offset=place) if isinstance(step, Bar) else replace(step, origin=place)

    return _changed(linkage, dice, change)


def _exchanged(linkage: Linkage, dice: random.Random) -> Linkage:
    """Put a bar in place of a slide, or a slide in place of a bar."""

    def change(step: Step) -> Step:
        if isinstance(step, Bar):
            return Slide(step.ends, step.link, dice.choice((0.0, 90.0, step.link)))
        return Bar(step.ends, step.name, 50.0)

    return _changed(linkage, dice, change)


def _driven(linkage: Linkage, dice: random.Random) -> Linkage:
    """Drive something else."""
    kind = dice.choice((angle_of, length_of))
    return replace(linkage, driver=kind(dice.choice(_names(linkage))))


def _loops(linkage: Linkage, dice: random.Random) -> Linkage:
    """Leave out a loop, repeat one, turn their order round, or take another side."""
    loops = list(linkage.loops)
    one: Loop = dice.choice(loops)
    others = (
        [each for each in loops if each is not one],
        [*loops, one],
        loops[::-1],
        [replace(each, side=-each.side) for each in loops],
        [replace(each, parallel=True) for each in loops],
        [replace(each, first=each.second, second=each.first) for each in loops],
        [replace(each, first=each.first[1:]) for each in loops],
        [replace(each, first=each.first + each.second[:1]) for each in loops],
    )
    return replace(linkage, loops=tuple(dice.choice(others)))


def _grounded(linkage: Linkage, dice: random.Random) -> Linkage:
    """Move or rename what is fixed."""
    size, angle, point = (dice.choice(each) for each in (SIZES, SIZES, _points(linkage)))
    others: tuple[dict[str, Any], ...] = (
        {"ground": (point, size, angle)},
        {"ground": None},
        {"pivot": point},
        {"place": dice.choice(PLACES)},
        {"fixed": {point: dice.choice(PLACES)}},
        {"images": (Bar("BZ", dice.choice(_names(linkage)), 30.0),)},
    )
    return replace(linkage, **dice.choice(others))


MUTATIONS: tuple[Callable[[Linkage, random.Random], Linkage], ...] = (
    *(_ends, _named, _sized, _sized, _turned, _turned, _exchanged, _driven, _loops, _grounded),
)

if __name__ == "__main__":
    from tests.fuzz.promise import run

    run(case, fault, *map(int, sys.argv[1:]))

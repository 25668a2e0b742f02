"""Whether a linkage makes sense as written: what would be solved wrongly is refused by name."""

from __future__ import annotations

import cmath
from typing import TypeGuard

from vad.errors import InputError
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, Step, length_of, scalar_of


def check(linkage: Linkage) -> None:
    """Check the chains, lengths and slides of a linkage.

    Raises
    ------
    vad.errors.InputError
        For the first that does not hold, with the number of its loop.
    """
    _check_fixed(linkage)
    fixed = _fixed(linkage)
    for number, (loop, unknowns) in enumerate(
        zip(linkage.loops, linkage.unknowns, strict=True), start=1
    ):
        where = f"loop {number}"
        chains = {"first": loop.first, "second": loop.second}
        paths = [_path(f"{where}, {name} chain", chain) for name, chain in chains.items()]
        (start, end), (other_start, other_end) = paths
        if end != other_end:
            raise InputError(f"{where}: its chains end at different points, {end} and {other_end}")
        for letter in (start, other_start):
            if start != other_start and letter not in fixed:
                raise InputError(f"{where}: {letter}, where a chain begins, is no fixed point")
        for name, chain in chains.items():
            if not any(scalar_of(step) in unknowns for step in chain):
                raise InputError(
                    f"{where}: both unknowns are in one chain, the {name} has none",
                    hint="write one of them on the other side of the equation",
                )
        for way, step in loop.steps():
            if isinstance(step, Slide) and isinstance(step.along, str):
                _check_slide(where, way, step, loop)
            elif _is_strut(step, linkage) and start == other_start:
                raise InputError(f"{where}: {step.link} must lead between two fixed points")
    _check_lengths(linkage)


def _check_fixed(linkage: Linkage) -> None:
    """Check that every fixed point is somewhere, and there alone."""
    for name, place in {linkage.pivot: linkage.place, **linkage.fixed}.items():
        if not cmath.isfinite(place):
            raise InputError(f"fixed point {name}: must be at a finite place, got {place}")
    names = [linkage.pivot, *linkage.fixed, *(linkage.ground or ())[:1]]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"fixed point {name}: is given twice")


def _is_strut(step: Step, linkage: Linkage) -> TypeGuard[Bar]:
    """Tell whether the length of a bar is what drives the linkage."""
    return isinstance(step, Bar) and length_of(str(step.length)) == linkage.driver


def _fixed(linkage: Linkage) -> set[str]:
    """Return the letters of the fixed points: pivots, and the tails of guides."""
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    moved = {step.head for step in steps}
    guides = {s.tail for s in steps if isinstance(s, Slide) and isinstance(s.along, float)}
    ground = {linkage.ground[0]} if linkage.ground else set()
    return {linkage.pivot, *linkage.fixed} | ground | (guides - moved)


def _path(where: str, chain: tuple[Step, ...]) -> tuple[str, str]:
    """Return the letters at which a chain begins and ends."""
    if not chain:
        raise InputError(f"{where}: is empty")
    start = here = chain[0].start
    for step in chain:
        if step.start != here:
            run = step.start + step.end
            raise InputError(f"{where}: is broken, {run} does not begin at {here}")
        here = step.end
    return start, here


def _check_slide(where: str, way: int, slide: Slide, loop: Loop) -> None:
    """Check that a slide on a turning link moves as the bar grows that carries it."""
    carriers = [
        sense
        for sense, bar in loop.steps()
        if isinstance(bar, Bar)
        and (bar.link, bar.length, bar.turn) == (slide.along, slide.name, slide.turn)
    ]
    if not carriers:
        raise InputError(
            f"{where}: no bar of {slide.along} carries {slide.name}",
            hint=f"add a bar of {slide.along} whose length is {slide.name!r}",
        )
    if way not in carriers:
        raise InputError(
            f"{where}: {slide.name} slides against the bar of {slide.along} that carries it",
            hint=f"turn {slide.ends} round",
        )


def _check_lengths(linkage: Linkage) -> None:
    """Check that a bar that is written twice has one length."""
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    first: dict[tuple[str, str], Bar] = {}
    for bar in (*steps, *linkage.images):
        if isinstance(bar, Bar):
            known = first.setdefault((bar.link, bar.ends), bar)
            if known.length != bar.length:
                lengths = f"{known.length} and {bar.length}"
                raise InputError(f"{bar.link}: {bar.ends} has two lengths, {lengths}")
            if (known.turn, known.offset) != (bar.turn, bar.offset):
                raise InputError(f"{bar.link}: {bar.ends} has two directions")

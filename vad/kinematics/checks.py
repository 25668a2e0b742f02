"""What would be solved wrongly, or not at all, is refused when a linkage is made.

Every message has the number of the loop, or the name of the link, slide or point.
"""

from __future__ import annotations

from typing import TypeGuard

from vad import gate
from vad.errors import InputError
from vad.kinematics.linkage import (
    Bar,
    Linkage,
    Loop,
    Scalar,
    Slide,
    Step,
    check_length,
    check_place,
    crossing,
    length_of,
    parallel,
    scalar_of,
    scalars_of,
)


def check(linkage: Linkage) -> None:
    """Refuse a linkage whose chains, lengths or slides make no sense.

    Raises
    ------
    vad.errors.InputError
        For the first thing that is wrong, with the number of its loop.
    """
    _check_fixed(linkage)
    if not linkage.loops and not linkage.images:
        raise InputError("there is no loop", hint="a driver alone moves nothing else")
    fixed = _fixed(linkage)
    moving, known = {linkage.driver}, {linkage.driver}
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
        _check_guides(where, loop, unknowns, linkage.driver)
        scalars = {scalar for _, step in loop.steps() for scalar in scalars_of(step)}
        if moving.isdisjoint(scalars):
            raise InputError(f"{where}: stands still, for {linkage.driver} does not move it")
        known.update(unknowns)
        moving.update(unknowns)
        _check_known(where, scalars, known)
    _check_known("images", {each for bar in linkage.images for each in scalars_of(bar)}, known)
    _check_lengths(linkage)
    _check_slides(linkage)


def _check_known(where: str, scalars: set[Scalar], known: set[Scalar]) -> None:
    """Refuse a vector whose line turns with a link, or whose length is one, that nothing finds."""
    for scalar in sorted(scalars - known):
        raise InputError(f"{where}: no loop finds {scalar} so far")


def _check_fixed(linkage: Linkage) -> None:
    """Check that every fixed point has one finite place."""
    for name, place in {linkage.pivot: linkage.place, **linkage.fixed}.items():
        check_place(f"fixed point {name}", place)
    if linkage.ground:
        letter, length, angle = linkage.ground
        check_length(f"distance of {letter} from {linkage.pivot}", length)
        gate.number(f"direction of {letter} from {linkage.pivot}", angle)
    names = [linkage.pivot, *linkage.fixed, *(linkage.ground or ())[:1]]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"fixed point {name}: is given twice")


def _is_strut(step: Step, linkage: Linkage) -> TypeGuard[Bar]:
    """Tell whether a bar has the length that drives the linkage."""
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
    """Check that a slide on a turning link runs in the sense of the bar that carries it."""
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


def _check_guides(where: str, loop: Loop, unknowns: tuple[Scalar, ...], driver: Scalar) -> None:
    """Check that guides cross where both slides are unknown, or one of them is all that moves."""
    for (one, along), (other, across) in crossing(loop, unknowns, driver):
        if not parallel(float(along), float(across)):
            continue
        lines = f"the lines of {one} and {other} are parallel"
        if {length_of(one), length_of(other)} == set(unknowns):
            raise InputError(f"{where}: {lines} and never cross")
        raise InputError(
            f"{where}: {lines}, so that all between them slides along without a limit",
            hint="give the lines different directions",
        )


def _check_slides(linkage: Linkage) -> None:
    """Check that a slide has one line and a name of its own, and is the length of its own link."""
    steps = [*(step for loop in linkage.loops for _, step in loop.steps()), *linkage.images]
    bars = [step for step in steps if isinstance(step, Bar)]
    links = {bar.link for bar in bars}
    lines: dict[str, float | str] = {}
    for slide in steps:
        if isinstance(slide, Slide):
            if lines.setdefault(slide.name, slide.along) != slide.along:
                raise InputError(f"{slide.name}: slides along two lines")
            if slide.name in links and slide.along != slide.name:
                raise InputError(f"{slide.name}: is a link, and a slide that is not on it")
    for bar in bars:
        if isinstance(bar.length, str) and lines.get(bar.length, bar.link) != bar.link:
            message = f"{bar.ends} has the length of {bar.length}, which does not slide on it"
            raise InputError(f"{bar.link}: {message}")


def _check_lengths(linkage: Linkage) -> None:
    """Check that a bar that stands in two loops has one length and one direction."""
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    for step in steps:
        if isinstance(step, Bar) and step.length == 0.0:
            raise InputError(f"{step.link}: {step.ends} has no length")
    first: dict[tuple[str, str], Bar] = {}
    for bar in (*steps, *linkage.images):
        if isinstance(bar, Bar):
            known = first.setdefault((bar.link, bar.ends), bar)
            if known.length != bar.length:
                lengths = f"{known.length} and {bar.length}"
                raise InputError(f"{bar.link}: {bar.ends} has two lengths, {lengths}")
            if (known.turn, known.offset) != (bar.turn, bar.offset):
                raise InputError(f"{bar.link}: {bar.ends} has two directions")

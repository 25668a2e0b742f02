"""How the end of one chain of a loop is best seen to move against the end of the other.

Rates that are added along a chain may be large and cancel.  Where a point is on a guide, its motion
is that of one slide.  Where both ends are on one link, or in its slots, they do not move as seen
from there, or slide only, however fast the link turns.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import NamedTuple

from vad.kinematics.linkage import (
    Bar,
    Linkage,
    Loop,
    Scalar,
    SignedStep,
    Slide,
    Step,
    scalars_of,
)
from vad.kinematics.state import GROUND

# What a step costs, as seen from a link: a step of that link nearly nothing, a bar of another one
# as much as the ground.  A guide rounds less than a bar; it is seen from the ground alone.  A slide
# on a link other than the one that is looked from has Coriolis' component, too.
_OF_LINK, _OF_GUIDE, _OF_BAR, _OF_SLOT, _NEVER = 0.01, 0.6, 1.0, 2.1, 1e9
# Another way must be better than the loop's own chains by this.
_GAIN = 0.3


class Way(NamedTuple):
    """A way from point to point: what it costs, its steps, and the fixed points between them."""

    cost: float
    steps: tuple[SignedStep, ...] = ()
    ground: tuple[str, str] | None = None


def carrying(
    linkage: Linkage, loop: Loop, unknown: Collection[Scalar], fixed: Collection[str]
) -> tuple[Way, str] | None:
    """Return the way from the known end of the first chain to that of the second, and who sees it.

    It uses nothing that is found later than the chains themselves: a later loop may be near a dead
    centre.  Nor does it use links that are neither theirs nor the one that sees it: a short link
    may turn very fast.  An unknown slide of the frame is seen from the ground.  None if the chains
    are as good, or if one does not begin with what is known.
    """
    ends, own = [], []
    for chain in (loop.first, loop.second):
        known = [step for step in chain if not scalars_of(step) & {*unknown}]
        if known != list(chain[: len(known)]):
            return None
        ends.append(known[-1].end if known else chain[0].start)
        own += known
    starts = loop.first[0].start, loop.second[0].start
    usable = _usable(linkage, own)
    views = {GROUND}
    unknown_steps = [step for _, step in loop.steps() if scalars_of(step) & {*unknown}]
    if not any(isinstance(step, Slide) and isinstance(step.along, float) for step in unknown_steps):
        views.update(name for end in ends for name in _links_at(end, usable))
    best: tuple[Way, str] | None = None
    least = min(_cost_of_all(own, starts, view) for view in sorted(views)) - _GAIN
    links = {link for step in own for link in _links_of(step)}
    for view in sorted(views):
        steps = {s: _cost(s, view) for s in usable if links.union([view]).issuperset(_links_of(s))}
        way = _ways(ends[0], steps, fixed, view).get(ends[1])
        if way and way.cost < least:
            best, least = (way, view), way.cost
    return best


def _usable(linkage: Linkage, own: Iterable[Step]) -> list[Step]:
    """Return all steps of which no more has to be known than of a loop's own."""
    needed = {scalar for step in own for scalar in scalars_of(step)} - {linkage.driver}
    known = {linkage.driver}
    for pair in linkage.unknowns:
        if needed <= known:
            break
        known |= {*pair}
    steps = [*(step for each in linkage.loops for _, step in each.steps()), *linkage.images]
    return [step for step in dict.fromkeys(steps) if scalars_of(step) <= known]


def _links_of(step: Step) -> list[str]:
    """Return the link of a bar, or that on which a slide slides, if any."""
    link = step.link if isinstance(step, Bar) else step.along
    return [link] if isinstance(link, str) else []


def _links_at(point: str, steps: Iterable[Step]) -> Iterator[str]:
    """Yield the links on which a point is, or slides."""
    for step in steps:
        if point in (step.tail, step.head):
            yield from _links_of(step)


def _cost(step: Step, view: str) -> float:
    if isinstance(step, Bar):
        return _OF_LINK if step.link == view else _OF_BAR
    if isinstance(step.along, str):
        return _OF_BAR if step.along == view else _OF_SLOT
    return _OF_GUIDE if view == GROUND else _NEVER


def _cost_of_all(own: Iterable[Step], starts: tuple[str, str], view: str) -> float:
    ground = _OF_BAR if starts[0] != starts[1] and view != GROUND else 0.0
    return ground + sum(_cost(step, view) for step in own)


def _ways(
    start: str, steps: Mapping[Step, float], fixed: Collection[str], view: str
) -> dict[str, Way]:
    """Return the best way to each point."""
    found = {start: Way(0.0)}
    # Each round makes a way cheaper, and no way is longer than all steps.
    for _ in range(len(steps) + 2):
        better = False
        for head, way in list(_on(found, steps, fixed, view)):
            if way.cost < found.get(head, Way(_NEVER)).cost:
                found[head], better = way, True
        if not better:
            break
    return found


def _on(
    found: Mapping[str, Way], steps: Mapping[Step, float], fixed: Collection[str], view: str
) -> Iterator[tuple[str, Way]]:
    """Yield where one more step leads, and where the ground leads."""
    for step, cost in steps.items():
        for sign, tail, head in ((1, step.tail, step.head), (-1, step.head, step.tail)):
            if tail in found:
                so_far, before, ground = found[tail]
                yield head, Way(so_far + cost, (*before, (sign, step)), ground)
    for tail in fixed:
        if tail in found and not found[tail].ground:
            so_far, before, _ = found[tail]
            cost = so_far + (0.0 if view == GROUND else _OF_BAR)
            yield from ((head, Way(cost, before, (tail, head))) for head in fixed if head != tail)

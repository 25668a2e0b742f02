"""The bodies of a linkage and the joints between them, found from the chains of its loops.

Every link is a body, and so is the block of every slide.  A link whose length is a slide is two
bodies: its barrel, which bears the name of the link, and its rod.  All bodies hang in a tree on the
frame: each by one joint on another body.  Every loop brings a dyad: two bodies (or a few more) that
hang on known ones at its two ends, and meet in its inner joint, where the tree is cut.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TypeVar

from vad.errors import InputError
from vad.kinematics.linkage import (
    Bar,
    Scalar,
    SignedStep,
    Slide,
    Step,
    angle_of,
    length_of,
    scalar_of,
)
from vad.kinematics.loop import LoopSolver
from vad.kinematics.solver import Solver

#: The name of the frame among the bodies.
FRAME = "frame"
Path = tuple[SignedStep, ...]
Thing = TypeVar("Thing")


@dataclass(frozen=True)
class Joint:
    """A joint of two bodies.

    Attributes
    ----------
    one, other
        The bodies; of a sliding joint ``one`` is the carrier, ``other`` the block.
    point
        The point at which they touch: that of the pin, or that of the block.
    slide
        The slide of a sliding joint; None for a pin.
    """

    one: str
    other: str
    point: str
    slide: Slide | None = None

    def away_from(self, body: str) -> str:
        """Return the other one of its two bodies."""
        return self.other if body == self.one else self.one


def contact(joint: Joint) -> str:
    """Return the point of the carrier at which a joint touches it: that under a block on a link."""
    slide = joint.slide
    under = slide and isinstance(slide.along, str) and slide.head == joint.point
    return slide.tail if slide and under else joint.point


@dataclass
class Body:
    """A body and the joint by which it hangs.

    Attributes
    ----------
    name
        Its name.
    link
        The link with which it turns; None if it does not turn.
    slide
        Its slide, if it is a block.
    parent
        The body on which it hangs.
    joint
        The joint by which it hangs.
    scalar
        The angle or the length that moves it against the frame or its parent.
    paths
        The steps from its reference point, which is that of its joint, to each of its points.
    """

    name: str
    link: str | None
    slide: Slide | None
    parent: str
    joint: Joint
    scalar: Scalar
    paths: dict[str, Path] = field(default_factory=dict)

    def has_fixed(self, point: str) -> bool:
        """Tell whether a point stays where it is on the body; that under a block does not."""
        steps = [step for _, step in self.paths[point]]
        return all(isinstance(s, Bar) and isinstance(s.length, float) for s in steps)

    @property
    def pinned(self) -> bool:
        """Whether it hangs by a pin."""
        return self.joint.slide is None

    @property
    def contact(self) -> str:
        """The point of its parent at which it hangs."""
        return contact(self.joint)


@dataclass(frozen=True)
class Side:
    """One side of a dyad: the bodies from an outer joint to the inner one.

    Attributes
    ----------
    bodies
        Their names; the first hangs on a known body.
    step
        The bar or slide whose scalar is unknown on this side.
    way
        +1.0 if the bar leads from the joint at which its body hangs, -1.0 if it leads there.
    """

    bodies: tuple[str, ...]
    step: Step
    way: float

    @property
    def turning(self) -> str:
        """The link that turns by an unknown angle; empty if a length is unknown."""
        return self.step.link if isinstance(self.step, Bar) else ""


@dataclass(frozen=True)
class Dyad:
    """What one loop finds, cut at its inner joint.

    Attributes
    ----------
    loop
        The number of the loop.
    first, second
        Its sides; the first is that of the loop's first chain, which is nearer to the driver.
    inner
        The joint between them.
    sense
        The cross product of the directions of both steps, over the sine of the loop.
    """

    loop: int
    first: Side
    second: Side
    inner: Joint
    sense: float

    @property
    def block(self) -> str | None:
        """The block that slides in the inner joint and is pinned to a known body, if there is one.

        It hands every couple on to the body on which it slides.
        """
        return self.inner.other if self.inner.slide else None


class Bodies:
    """The bodies of a linkage, hung in a tree.

    Parameters
    ----------
    solver
        The solver of the linkage.

    Attributes
    ----------
    solver, linkage
        What is solved.
    bodies
        By name, each after the one on which it hangs.
    dyads
        One for each loop, in the order of the loops.
    joints
        All joints, in the order of drawing: the last dyad first, in each dyad the outer joint that
        is nearer to the driver, the inner one, the other outer one, and at last the driver's own.
    at
        The bodies that have each point.
    rods
        The names of the rods of cylinders, by the name of the link.

    Raises
    ------
    vad.errors.InputError
        For a linkage whose bodies cannot be told from its loops.
    """

    def __init__(self, solver: Solver) -> None:
        self.solver, self.linkage = solver, solver.linkage
        self._places = frozenset(solver.frame.fixed)
        self._steps = solver.frame.steps
        self._slides = {s.name: s for s in self._steps if isinstance(s, Slide)}
        self.rods = {link: rod.name for link, rod in self.linkage.cylinders.items()}
        self._rod_bars = {
            bar.ends
            for bar in self._steps
            if isinstance(bar, Bar)
            for slide in self._slides.values()
            if bar.length == slide.name and slide.along == bar.link and bar.tail == slide.head
        }
        self._check_names(solver)
        self._holders: dict[str, tuple[int, str]] = dict.fromkeys(self._places, (0, FRAME))
        self.bodies: dict[str, Body] = {}
        cycles = [self._cycle(number) for number in range(len(self.linkage.loops))]
        self._hang_driver(cycles)
        self.dyads = [
            self._dyad(number, cycle, solver.loops[number]) for number, cycle in enumerate(cycles)
        ]
        self.joints = self._ordered()
        self._find_points()

    @property
    def driver(self) -> Body:
        """The body that is turned or pushed."""
        return next(b for b in self.bodies.values() if b.scalar == self.linkage.driver)

    def _check_names(self, solver: Solver) -> None:
        blocks = [self._block(slide) for slide in self._slides.values()]
        names = [FRAME, *solver.links, *blocks]
        for name in names:
            if names.count(name) > 1:
                raise InputError(
                    f"bodies: two bodies are called {name}", "call the link or the slide otherwise"
                )

    def _block(self, slide: Slide) -> str:
        return self.rods.get(slide.name, slide.name)

    def _end(self, slide: Slide) -> str:
        """Return the point of a block; that of a rod is its far end."""
        rod = self.linkage.cylinders.get(slide.name)
        return rod.point if rod else slide.head

    def _carrier(self, slide: Slide) -> str:
        """Return the body on which a block slides."""
        if isinstance(slide.along, str):
            return slide.along
        if slide.tail in self._places:
            return FRAME
        for other in self._slides.values():
            if other.head == slide.tail and isinstance(other.along, float):
                return self._block(other)
        raise InputError(
            f"bodies: {slide.name} slides on a line through {slide.tail}, which no slider carries"
        )

    def _cycle(self, number: int) -> list[tuple[str, Joint]]:
        """Return the bodies round a loop, each with the joint that leads to the next one."""
        loop = self.linkage.loops[number]
        start = loop.first[0].start, loop.second[0].start
        held = self._holders.get(start[0]) if start[0] == start[1] else (0, FRAME)
        (first, end), (second, other_end) = (
            self._walk(chain, held) for chain in (loop.first, loop.second)
        )
        back = [(joint.away_from(body), joint) for body, joint in reversed(second)]
        cycle = list(first)
        if end != other_end:
            cycle.append((end, Joint(end, other_end, loop.first[-1].end)))
        cycle += back
        begin, close = cycle[0][0], back[-1] if back else None
        last = close[1].away_from(close[0]) if close else other_end
        if last != begin:  # a floating link, at which both chains begin
            cycle.append((last, Joint(last, begin, start[0])))
        return cycle

    def _walk(
        self, chain: Sequence[Step], held: tuple[int, str] | None
    ) -> tuple[list[tuple[str, Joint]], str]:
        """Return the bodies of a chain with the joints by which it leaves them, and the last."""
        passed: list[tuple[str, Joint]] = []
        depth, here = held or (0, "")
        for step in chain:
            slide = step if isinstance(step, Slide) else None
            if slide:
                ends = self._carrier(slide), self._block(slide)
                entered = ends[1] if step.reverse else ends[0]
            else:
                assert isinstance(step, Bar)
                rod = step.ends in self._rod_bars
                entered = self.rods[step.link] if rod else step.link
            if here and here != entered:
                passed.append((here, Joint(here, entered, step.start)))
            here = entered
            if slide:
                passed.append((here, Joint(*ends, self._end(slide), slide)))
                here = passed[-1][1].away_from(here)
            depth += 1
            if held and (step.end not in self._holders or depth < self._holders[step.end][0]):
                self._holders[step.end] = depth, here
        return passed, here

    def _hang_driver(self, cycles: Sequence[Sequence[tuple[str, Joint]]]) -> None:
        """Hang the driven body on the frame, if it touches it."""
        driver = self.linkage.driver
        for joint in (joint for cycle in cycles for _, joint in cycle):
            turned = joint.slide is None and FRAME in (joint.one, joint.other)
            turned = turned and angle_of(joint.away_from(FRAME)) == driver
            pushed = joint.slide is not None and length_of(joint.slide.name) == driver
            if turned or (pushed and joint.one == FRAME):
                self._hang(joint.away_from(FRAME), FRAME, joint)
                return

    def _hang(self, name: str, parent: str, joint: Joint) -> Body:
        own = (slide for slide in self._slides.values() if self._block(slide) == name)
        slide = next(own, None)
        moved = joint.slide or slide
        link = name if slide is None else slide.along if isinstance(slide.along, str) else None
        scalar = length_of(moved.name) if moved else angle_of(name)
        self.bodies[name] = body = Body(name, link, slide, parent, joint, scalar)
        return body

    def _dyad(self, number: int, cycle: list[tuple[str, Joint]], solver: LoopSolver) -> Dyad:
        """Hang the new bodies of a loop from both ends, and cut it where they meet."""
        where = f"bodies: loop {number + 1}"
        known = {FRAME, *self.bodies}
        old = [place for place, (body, _) in enumerate(cycle) if body in known]
        if not old:
            raise InputError(f"{where} touches no known body")
        starts = [k for k in old if cycle[(k + 1) % len(cycle)][0] not in known]
        if len(starts) != 1:
            raise InputError(f"{where} is no dyad: it brings new bodies in {len(starts)} places")
        turned = [*cycle[starts[0] :], *cycle[: starts[0]]]
        ends = next((k for k in range(1, len(turned)) if turned[k][0] in known), len(turned))
        new = [body for body, _ in turned[1:ends]]
        joints = [joint for _, joint in turned[:ends]]
        first = self._side(solver, turned[0][0], new, joints)
        rest, after = new[len(first) :], joints[len(first) :]
        parent = turned[ends % len(turned)][0]
        second = self._side(solver, parent, rest[::-1], after[::-1])
        if len(first) + len(second) != len(new):
            raise InputError(f"{where} is no dyad of two bodies")
        inner = after[0]
        sides = [self._unknown(solver, side, where) for side in (first, second)]
        sense = float(-solver.way * solver.other_way)
        if scalar_of(sides[0].step) != scalar_of(solver.step):
            sense = -sense
        return Dyad(number, sides[0], sides[1], inner, sense)

    def _side(
        self, solver: LoopSolver, parent: str, new: Sequence[str], joints: Sequence[Joint]
    ) -> list[Body]:
        """Hang new bodies one on the other until one of them has an unknown, and no second one."""
        unknown = {scalar_of(solver.step), scalar_of(solver.other)}
        hung: list[Body] = []
        found = 0
        for name, joint in zip(new, joints, strict=False):
            body = self._hang(name, parent, joint)
            if body.scalar in unknown and found:
                del self.bodies[name]
                break
            if joint.slide and joint.other != name:
                raise InputError(f"bodies: {name} hangs on {parent}, which slides on it")
            found += body.scalar in unknown
            hung.append(body)
            parent = name
            if body.pinned and body.slide:  # beyond it is the line on which it slides
                break
        return hung

    def _unknown(self, solver: LoopSolver, side: Sequence[Body], where: str) -> Side:
        for body in side:
            for step in (solver.step, solver.other):
                if body.scalar == scalar_of(step):
                    names = tuple(each.name for each in side)
                    against = body.pinned and body.joint.point == step.head
                    way = -1.0 if against and isinstance(step, Bar) else 1.0
                    return Side(names, step, way)
        raise InputError(f"{where} has a side without an unknown")

    def _ordered(self) -> tuple[Joint, ...]:
        own = self.driver
        found: list[Joint] = []
        for dyad in reversed(self.dyads):
            first, second = dyad.first.bodies, dyad.second.bodies
            within = [self.bodies[name].joint for name in first]
            found += [*within, dyad.inner, *(self.bodies[n].joint for n in reversed(second))]
        return tuple(dict.fromkeys([*found, own.joint]))

    def _find_points(self) -> None:
        """Find the points of every body, and the steps that lead to them."""
        for body in self.bodies.values():
            start = body.joint.point
            if body.slide and self._rod_of(body):
                edges: list[Step] = [s for s in self._bars(body.link) if s in self.linkage.images]
            elif body.slide:
                slots = (s for s in self._steps if isinstance(s, Slide) and s.tail == start)
                edges = [s for s in slots if self._carrier(s) == body.name]
            else:
                edges = [s for s in self._bars(body.link) if s.ends not in self._rod_bars]
            body.paths = _paths(start, edges)
            for bar in self._bars(body.link):  # the rod of a driven cylinder touches it at its end
                if not body.slide and bar.ends in self._rod_bars:
                    body.paths.setdefault(bar.head, ((1, bar),))
        self.at: dict[str, list[str]] = {}
        for body in self.bodies.values():
            for point in body.paths:
                if not self._slides_at(body.name, point):
                    self.at.setdefault(point, []).append(body.name)

    def _slides_at(self, carrier: str, point: str) -> bool:
        """Tell whether a point of a carrier is only where a block slides on it."""
        return any(
            joint.slide and joint.one == carrier and joint.point == point for joint in self.joints
        )

    def _rod_of(self, body: Body) -> bool:
        return body.name in self.rods.values()

    def _bars(self, link: str | None) -> Iterator[Bar]:
        return (step for step in self._steps if isinstance(step, Bar) and step.link == link)


def _paths(start: str, edges: Sequence[Step]) -> dict[str, Path]:
    """Return the steps from a point to all that can be reached by bars or slides of one body."""
    paths: dict[str, Path] = {start: ()}
    for _ in edges:  # each round goes one step further
        for step in edges:
            for way, tail, head in ((1, step.tail, step.head), (-1, step.head, step.tail)):
                if tail in paths and head not in paths:
                    paths[head] = (*paths[tail], (way, step))
    return paths


@lru_cache(maxsize=64)
def bodies_of(plane: Solver) -> Bodies:
    """Return the bodies of a linkage; they are found once."""
    return Bodies(plane)

"""Further points that a user marks on the links: D on the rod, 100 from its first end."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from string import ascii_uppercase
from typing import Any, NamedTuple

from vad import gate
from vad.errors import InputError, quoted, unknown
from vad.kinematics.linkage import Bar, Linkage, Step, points_of

_NAME = re.compile(r"[A-Z][0-9]{0,3}")
_AS_IN = 'as in points={"D": ("rod", 100, 0)}: a link, a distance from its first end, an angle'


class LinkPoint(NamedTuple):
    """Where a point is on its link.

    Attributes
    ----------
    link
        The link.
    distance
        From the link's first end; a negative one points against the link.
    angle
        From the line of the link, counter-clockwise, in degrees.
    """

    link: str
    distance: float
    angle: float = 0.0


@dataclass(frozen=True)
class LinkPoints(Mapping[str, LinkPoint]):
    """Points on links by name, in the order in which they were given."""

    items_given: tuple[tuple[str, LinkPoint], ...] = ()

    @cached_property
    def _by_name(self) -> dict[str, LinkPoint]:
        return dict(self.items_given)

    def __getitem__(self, name: str) -> LinkPoint:
        return self._by_name[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    def __len__(self) -> int:
        return len(self.items_given)


def link_points(given: Any) -> LinkPoints:
    """Return points from names with a link, a distance and perhaps an angle each.

    Raises
    ------
    vad.errors.InputError
        For what is no such mapping, no name of a point, or no number.

    Examples
    --------
    >>> dict(link_points({"D": ("rod", 100)}))
    {'D': LinkPoint(link='rod', distance=100.0, angle=0.0)}
    """
    if not isinstance(given, Mapping):
        raise InputError(f"points: must be places by name, got {quoted(given)}", _AS_IN)
    return LinkPoints(tuple((_name(name), _place(name, given[name])) for name in given))


def _name(name: object) -> str:
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        wanted = "must be a capital letter, or one with a number"
        raise InputError(f"points: a name {wanted}, got {quoted(name)}", "as in D or D2")
    return name


def _place(name: str, given: object) -> LinkPoint:
    if not isinstance(given, tuple | list) or len(given) not in (2, 3):
        raise InputError(
            f"point {name}: must be a link and a distance, got {quoted(given)}", _AS_IN
        )
    link, *given_numbers = given
    numbers = [
        gate.dimension(f"point {name}: its {what}", number, signed=True)
        for what, number in zip(("distance", "angle"), given_numbers, strict=False)
    ]
    if not isinstance(link, str):
        raise InputError(f"point {name}: must be on a link, got {quoted(link)}", _AS_IN)
    if not numbers[0]:
        raise InputError(
            f"point {name}: its distance must not be 0", "there is the first end of the link"
        )
    return LinkPoint(link, *numbers)


def marked(
    linkage: Linkage, points: Mapping[str, LinkPoint], links: Mapping[str, str], own: set[str]
) -> Linkage:
    """Return a linkage with further points on its links.

    Parameters
    ----------
    linkage
        The linkage.  If it uses a letter that it does not report, such as that of a guide, this
        letter is replaced by another one.
    points
        The further points.
    links
        The ends of every link by its name.
    own
        The names of the points that it reports.

    Raises
    ------
    vad.errors.InputError
        For a name that is taken, or an unknown link.
    """
    if not points:
        return linkage
    from vad.kinematics.elementary import unit_at  # most mechanisms do not need it

    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    turning = {step.link for step in (*steps, *linkage.images) if isinstance(step, Bar)}
    used = {name for step in steps for name in points_of(step.ends)}
    free = (letter for letter in ascii_uppercase if letter not in {*own, *used, *points})
    bars = []
    rods = {rod.name: (each, rod) for each, rod in linkage.cylinders.items()}
    for name, (link, distance, angle) in points.items():
        known = [*(each for each in links if each in turning), *rods]
        if link not in known:
            wrong = unknown("link", link, known)
            raise InputError(f"point {name}: {wrong}", wrong.hint)
        if name in own:
            hint = f"free are {', '.join(islice(free, 5))} …"
            raise InputError(f"point {name}: the mechanism has a point {name} already", hint)
        if link in rods:  # it is counted from the outer end of the rod, towards the barrel
            barrel, rod = rods[link]
            bars.append(Bar(rod.point + name, barrel, distance, turn=rod.turn * unit_at(angle)))
            continue
        tail = points_of(links[link])[0]
        bars.append(Bar(tail + name, link, distance, turn=unit_at(angle)))
    moved = renamed(linkage, {name: next(free) for name in points if name in used})
    return replace(moved, images=(*moved.images, *bars))


def renamed(linkage: Linkage, names: Mapping[str, str]) -> Linkage:
    """Return a linkage with other names for some of its points."""
    if not names:
        return linkage

    def of(step: Step) -> Step:
        return replace(step, ends="".join(names.get(end, end) for end in points_of(step.ends)))

    ground = linkage.ground
    return replace(
        linkage,
        loops=tuple(
            replace(loop, first=tuple(map(of, loop.first)), second=tuple(map(of, loop.second)))
            for loop in linkage.loops
        ),
        images=tuple(replace(bar, ends=of(bar).ends) for bar in linkage.images),
        pivot=names.get(linkage.pivot, linkage.pivot),
        ground=ground and (names.get(ground[0], ground[0]), *ground[1:]),
        fixed={names.get(name, name): place for name, place in linkage.fixed.items()},
    )

"""The structure of a mechanism: how many freedoms it has, and of which dyads it is made.

Every link is a body, and so are the frame, the block of every guide and the rod of every cylinder;
a pin that joins k bodies counts as k - 1 joints.  A dyad (an Assur group of class II) is a pair of
links or slides that two arcs or lines locate.  The dyads come in the order of drawing.  What is
not made of dyads is refused by name.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import NamedTuple

from vad.errors import InputError
from vad.files.description import (
    Description,
    DriverEntry,
    FrameLine,
    GuideEntry,
    LinkEntry,
    LinkLine,
    SliderLine,
)
from vad.files.tables import Source


class Mobility(NamedTuple):
    """Bodies with the frame, joints of one freedom each, and what remains."""

    bodies: int
    joints: int

    @property
    def freedoms(self) -> int:
        """The degrees of freedom, 3(n - 1) - 2j."""
        return 3 * (self.bodies - 1) - 2 * self.joints

    def __str__(self) -> str:
        sum_ = f"3·{self.bodies - 1} − 2·{self.joints} = {self.freedoms}"
        return f"{self.bodies} links and {self.joints} joints give {sum_} degrees of freedom"


def mobility(description: Description) -> Mobility:
    """Count the bodies and joints of a mechanism."""
    cylinders = sum(link.cylinder for link in description.links.values())
    bodies = 1 + len(description.links) + len(description.guides) + cylinders
    pins = sum(max(0, _bodies_at(description, point) - 1) for point in description.points)
    return Mobility(bodies, pins + len(description.guides) + cylinders)


def check_mobility(source: Source, description: Description) -> Mobility:
    """Return the count of a mechanism that one driver moves.

    Raises
    ------
    vad.errors.InputError
        For any other, with a hint where its cause can be seen.
    """
    _check_connected(source, description)
    _check_guided(source, description)
    found = mobility(description)
    if found.freedoms == 1:
        _check_doubled(source, description)
        return found
    key, hint = "", None
    if found.freedoms > 1:
        for link in description.links.values():
            held = [p for p in link.points if _bodies_at(description, p) > 1]
            lines = [
                g for g in description.guides.values() if getattr(g.line, "link", "") == link.name
            ]
            if len(held) + len(lines) < 2:
                key, hint = link.name, f"{link.name}: is held at no point"
                if held:
                    hint = f"{link.name}: is held at one point, {held[0]}, only"
                break
    else:
        hint = "a link that only repeats a parallelogram can be left out"
        for one, other, both in _doubled(description):
            key, hint = other, f"{one} and {other} both have {' and '.join(both)}: one link"
    raise source.error("links", key, f"Grübler: {found}, not 1", hint)


def _doubled(description: Description) -> Iterator[tuple[str, str, list[str]]]:
    """Yield two links that have two points or more in common, and these points."""
    for one, other in combinations(description.links.values(), 2):
        both = [point for point in one.points if point in other.points]
        if len(both) > 1:
            yield one.name, other.name, both


def _check_doubled(source: Source, description: Description) -> None:
    """Refuse two links that cannot move against each other, though the count comes out right.

    Then another part of the mechanism has the freedom that these two have lost.
    """
    for one, other, both in _doubled(description):
        message = f"{other}: has {' and '.join(both)} in common with {one}, so both are one link"
        raise source.error("links", other, message, f"join {other} to another link")


def _check_connected(source: Source, description: Description) -> None:
    """Refuse links that no chain of points joins to the frame."""
    groups = [set(link.points) for link in description.links.values()]
    joined = set(description.fixed)
    for guide in description.guides.values():
        line = guide.line
        if isinstance(line, FrameLine):
            joined.add(guide.point)
        elif isinstance(line, LinkLine):
            groups.append({guide.point, *line.pair})
        else:
            groups.append({guide.point, line.through})
    # Each round joins one group more.
    while new := set().union(*(group for group in groups if group & joined)) - joined:
        joined |= new
    loose = [name for name, link in description.links.items() if not joined & set(link.points)]
    if loose:
        verb = "shares" if len(loose) == 1 else "share"
        message = f"{', '.join(loose)}: {verb} no point with the rest"
        raise source.error("links", loose[0], message)


def _check_guided(source: Source, description: Description) -> None:
    """Refuse a point that slides without belonging to a link."""
    through = [getattr(guide.line, "through", "") for guide in description.guides.values()]
    for point in description.guides:
        if not (point in through or point in description.fixed or description.links_at(point)):
            raise source.error("guides", point, f"{point}: slides, but no link has this point")


def _bodies_at(description: Description, point: str) -> int:
    """Return how many bodies a pin joins."""
    links = len(description.links_at(point))
    return links + (point in description.fixed) + (point in description.guides)


@dataclass(frozen=True)
class Dyad:
    """A pair of links or slides that is located in one step.

    Attributes
    ----------
    kind
        Its joints, R for a pin and P for a slide: RRR, RRP, RPR, PRP or RPP.
    point
        The point in which its two chains meet.
    links
        The links that it locates, first the one that hangs on a moving point.
    guides
        The guides whose slides it locates.
    points
        The points that it locates, first the one in which its chains meet.
    """

    kind: str
    point: str
    links: tuple[LinkEntry, ...] = ()
    guides: tuple[GuideEntry, ...] = ()
    points: tuple[str, ...] = ()

    @property
    def two_places(self) -> bool:
        """Whether its points can be at two places."""
        slot = self.guides[0].line if self.kind == "RPR" and self.guides else None
        aside = isinstance(slot, LinkLine) and slot.offset is not None
        return self.kind in ("RRR", "RRP") or (aside and bool(self.points))

    @property
    def reversible(self) -> bool:
        """Whether its points can be at two places, or a slot can be counted from either side."""
        return self.two_places or (self.kind == "RPR" and bool(self.points))

    def __str__(self) -> str:
        return ", ".join([link.name for link in self.links] or [g.slide for g in self.guides])


@dataclass
class _Known:
    """The links and points that are known so far.

    ``points`` tells of each known point whether it moves; fixed points do not.
    """

    description: Description
    driver: DriverEntry
    links: set[str] = field(default_factory=set)
    points: dict[str, bool] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.points = dict.fromkeys(self.description.fixed, False)
        if self.driver.kind == "angle":
            link = self.description.links[self.driver.name]
            if any(point in self.points for point in link.points):
                self.learn(link)
        for guide in self.description.guides.values():
            if guide.slide == self.driver.name and isinstance(guide.line, FrameLine):
                self.points[guide.point] = True

    def learn(self, link: LinkEntry) -> None:
        """Add a link and its points, which move unless they are fixed."""
        self.links.add(link.name)
        for point in link.points:
            self.points.setdefault(point, True)

    def point_of(self, link: LinkEntry) -> str | None:
        """Return the known point of an unknown link, if there is one.

        There is one at most: two known points would locate the link without a dyad.
        """
        return next((point for point in link.points if point in self.points), None)

    def line(self, guide: GuideEntry) -> bool:
        """Tell whether the line of a guide is known."""
        line = guide.line
        if isinstance(line, FrameLine):
            return True
        return (
            line.link in self.links if isinstance(line, LinkLine) else line.through in self.points
        )


def dyads(description: Description, driver: DriverEntry | None = None) -> list[Dyad]:
    """Return the dyads in the order of drawing.

    Raises
    ------
    vad.errors.InputError
        Without a place, for a mechanism that is not made of dyads.
    """
    known = _Known(description, driver or description.driver)
    found: list[Dyad] = []
    # Each round locates the links of a dyad, which were unknown.
    while dyad := next(_dyads(known), None):
        before = set(known.points)
        if dyad.point not in before:
            known.points[dyad.point] = True
        for link in dyad.links:
            known.learn(link)
        for guide in dyad.guides:
            known.points.setdefault(guide.point, True)
        found.append(replace(dyad, points=tuple(p for p in known.points if p not in before)))
    missing = [name for name in description.links if name not in known.links]
    missing += [g.slide for g in description.guides.values() if g.point not in known.points]
    if missing:
        raise UndividedError(missing)
    return found


class UndividedError(InputError):
    """A mechanism that is not made of dyads: the links that are missing form a larger group."""

    def __init__(self, missing: list[str]) -> None:
        super().__init__(
            f"{', '.join(missing)} can only be found together: a triad (Assur group of class III) "
            "or more, not a pair that two arcs or lines locate"
        )
        self.missing = missing


def check_dyads(source: Source, description: Description) -> list[Dyad]:
    """Return the dyads of a file.

    Raises
    ------
    vad.errors.InputError
        With its line: for one that is not made of dyads, where the hint names the drivers with
        which it is; and for one that the driver does not move.
    """
    try:
        found = dyads(description)
    except UndividedError as error:
        others = [name for name in _other_drivers(description) if _divides(description, name)]
        names = " or ".join(f"the {name}" for name in others)
        hint = (
            f"driven at {names} it is dyads alone" if others else "no other driver makes it dyads"
        )
        raise source.error("links", error.missing[0], str(error), hint) from None
    _check_driven(source, description, found)
    return found


def _check_driven(source: Source, description: Description, found: list[Dyad]) -> None:
    """Refuse a driver that moves nothing, and a dyad that it does not move."""
    driver = description.driver.name
    if not found:
        hint = "add the links that it moves, as in coupler = { BC = 120 }"
        raise source.error("driver", driver, f"{driver}: drives nothing else", hint)
    moving = {driver} | {g.point for g in description.guides.values() if g.slide == driver}
    link = description.links.get(driver)
    if link and not link.cylinder:
        moving.update(point for point in link.points if point not in description.fixed)
    for dyad in found:
        names = [each.name for each in dyad.links] + [each.slide for each in dyad.guides]
        hung_on = {*names, *(point for each in dyad.links for point in each.points)}
        for guide in dyad.guides:
            hung_on.add(guide.point)
            if not isinstance(guide.line, FrameLine):
                carrier = guide.line
                hung_on.add(carrier.link if isinstance(carrier, LinkLine) else carrier.through)
        if moving.isdisjoint(hung_on):
            table, key = ("links", names[0]) if dyad.links else ("guides", dyad.point)
            hint = f"one of its points must be on the {driver}, or on what the {driver} moves"
            raise source.error(table, key, f"{names[0]}: hangs on points that stand still", hint)
        moving.update(names)
        moving.update(point for point in dyad.points if point not in description.fixed)


def _other_drivers(description: Description) -> Iterator[str]:
    for link in description.links.values():
        if any(point in description.fixed for point in link.points):
            yield link.name
    for guide in description.guides.values():
        if isinstance(guide.line, FrameLine):
            yield guide.slide


def _divides(description: Description, name: str) -> bool:
    link = description.links.get(name)
    kind = "angle" if link and not link.cylinder else "length"
    try:
        dyads(description, replace(description.driver, kind=kind, name=name))
    except InputError:
        return False
    return True


def _dyads(known: _Known) -> Iterator[Dyad]:
    """Yield the dyads that can be located next, in the order of the file."""
    description = known.description
    unknown = [link for link in description.links.values() if link.name not in known.links]
    for link in unknown:
        if link.cylinder and known.driver.name != link.name:
            if all(point in known.points for point in link.points):
                yield Dyad("RPR", link.base[1], (link,))
            continue
        turned = known.driver.kind == "angle" and known.driver.name == link.name
        yield from _between_lines(known, link) if turned else _with_link(known, link, unknown)
    for guide in description.guides.values():
        line = guide.line
        if guide.point in known.points and isinstance(line, SliderLine):
            carrier = description.guides[line.through]
            if line.through not in known.points and known.line(carrier):
                yield Dyad("RPP", line.through, (), (carrier, guide))


def _between_lines(known: _Known, link: LinkEntry) -> Iterator[Dyad]:
    """Yield the dyad of a driven link of which two points slide on known lines."""
    guides = [known.description.guides[p] for p in link.points if p in known.description.guides]
    if len(guides) > 1 and all(map(known.line, guides[:2])):
        yield Dyad("PRP", guides[1].point, (link,), tuple(guides[:2]))


def _with_link(known: _Known, link: LinkEntry, unknown: list[LinkEntry]) -> Iterator[Dyad]:
    """Yield the dyads that begin with a link."""
    guides = known.description.guides
    held = known.point_of(link)
    if held is None:
        return
    for guide in guides.values():  # a known point in the slot of the link
        slot = isinstance(guide.line, LinkLine) and guide.line.link == link.name
        if slot and guide.point in known.points:
            yield Dyad("RPR", guide.point, (link,), (guide,))
    for point in link.points:
        if point in known.points:
            continue
        if point in guides and known.line(guides[point]):
            yield Dyad("RRP", point, (link,), (guides[point],))
        for other in unknown:
            free = not other.cylinder or other.name == known.driver.name
            if other is not link and free and point in other.points:
                far = known.point_of(other)
                if far is not None:
                    moved = known.points[far] and not known.points[held]
                    moved = (moved and not link.cylinder) or other.cylinder
                    yield Dyad("RRR", point, (other, link) if moved else (link, other))

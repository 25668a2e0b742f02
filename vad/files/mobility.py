"""How many freedoms a mechanism has: Grübler's count over bodies and joints.

Every link is a body, and the frame, the block of every guide, and the rod of every cylinder; a pin
that joins k bodies counts as k - 1 joints.
"""

from __future__ import annotations

from itertools import combinations
from typing import NamedTuple

from vad.files.description import Description, FrameLine, LinkLine
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
    """Count bodies and joints."""
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
        return found
    key, hint = "", None
    if found.freedoms > 1:
        for link in description.links.values():
            held = [p for p in link.points if _bodies_at(description, p) > 1]
            lines = [
                g for g in description.guides.values() if getattr(g.line, "link", "") == link.name
            ]
            if len(held) + len(lines) < 2:
                key, hint = link.name, f"{link.name}: is held at {_at(held)} only"
                break
    else:
        hint = "a link that only repeats a parallelogram can be left out"
        for one, other in combinations(description.links.values(), 2):
            both = [point for point in one.points if point in other.points]
            if len(both) > 1:
                key = other.name
                hint = f"{one.name} and {other.name} both have {' and '.join(both)}: one link"
    raise source.error("links", key, f"Grübler: {found}, not 1", hint)


def _check_connected(source: Source, description: Description) -> None:
    """Refuse links that hang together with nothing that is fixed."""
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
    while new := set().union(*(group for group in groups if group & joined)) - joined:
        joined |= new
    loose = [name for name, link in description.links.items() if not joined & set(link.points)]
    if loose:
        verb = "shares" if len(loose) == 1 else "share"
        message = f"{', '.join(loose)}: {verb} no point with the rest"
        raise source.error("links", loose[0], message)


def _check_guided(source: Source, description: Description) -> None:
    """Refuse what slides by itself."""
    through = [getattr(guide.line, "through", "") for guide in description.guides.values()]
    for point in description.guides:
        if not (point in through or point in description.fixed or description.links_at(point)):
            raise source.error("guides", point, f"{point}: slides, but no link has this point")


def _at(points: list[str]) -> str:
    return f"one point, {points[0]}," if points else "no point"


def _bodies_at(description: Description, point: str) -> int:
    """Return how many bodies a pin joins."""
    links = len(description.links_at(point))
    return links + (point in description.fixed) + (point in description.guides)

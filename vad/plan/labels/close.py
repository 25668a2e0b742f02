"""Points that the eye cannot tell apart: where a lens is needed, and what letters it takes.

Two vertices that are not equal and stand within `LEAST` look like one, the dots at the ends of a
vector of `SHORTEST` hide it, and a letter far from its dot is not seen to name it.  A lens enlarges
such a place by the smallest factor that brings the points `APART`, and has the letters of all that
it shows.  Needs that are near share one lens.

Two lenses are enough for nearly all panels, and more make a panel restless.  But that no two points
look like one comes first: where lenses leave such points, one or two more stand if they have room.
In a wide room, the large panel of a lesson, there is room for more than in a still.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, islice
from operator import itemgetter

from vad.plan.labels.obstacles import PIXEL
from vad.plan.labels.vertices import SAME, Vertex
from vad.plan.sketch import Close, Setting
from vad.strokes.sheet import Arrow

#: Dots that are nearer touch each other, or nearly.
LEAST = 12.0 * PIXEL
#: Of a vector that is shorter, dots and head leave no line to be seen.
SHORTEST = 20.0 * PIXEL
#: In a wide room there are lenses for dots that are farther apart, too: in a mechanism, and in a
#: polygon, where the heads of vectors that end at one reach to the other.
LEAST_WIDE, LEAST_OF_HEADS = SHORTEST, 29.0 * PIXEL
APART = 0.030
FACTORS = (4.0, 8.0, 12.0, 20.0, 50.0, 100.0, 200.0)
#: Dots that are so far apart in a lens are seen as two, if nearly.
TOUCHING = 0.017
#: A lens shows what stands within that distance, too, as far as it has room.
GATHERED = 40.0 * PIXEL
#: From a vertex in a lens to its rim: room for a letter.
LETTERED = 0.036
#: The largest radius in a room of usual width and in a wide one, and the smallest one.
LARGEST, LARGEST_ALONE, SMALLEST = 0.108, 0.135, 0.068
#: A room is wide from here on: on a page of its own, and in the scene of a lesson.
WIDE = 0.65
#: The least radius of the circle about the place.
LEAST_RING = 0.0165
MOST = 2  # lenses in a panel, but for one more where points still look like one
#: Among more points than this two lenses help little, and to look for their places takes a minute.
MANY = 30
TRIED = 16  # of the places that a lens may show
#: What points told apart nearly, and a letter that finds a place, count beside points told apart.
NEARLY, LETTER = 0.5, 0.1
#: So far apart, points are seen as two, if not their vector; what it counts to show that, too.
TWO, HIDDEN = 10.0 * PIXEL, 0.4
#: Above this factor, points are so near that it says little to tell them apart; what that counts.
USUAL, FINE = 20.0, 0.3
#: A letter finds a place where it is shown so many times as large, at most.
LETTER_FACTOR = 4.0


@dataclass(frozen=True, slots=True)
class Need:
    """Two vertices that look like one, or one whose letter has no place, by their numbers.

    ``since`` is the number of the stroke with which the need arises, ``joined`` tells whether a
    vector joins the two.
    """

    members: tuple[int, ...]
    distance: float
    since: int
    joined: bool = False

    def met(self, factor: float) -> float:
        """Return how well a lens of a factor meets it if it shows its members."""
        if len(self.members) == 1:
            return LETTER if factor <= LETTER_FACTOR else 0.0
        apart = factor * self.distance
        least = SHORTEST if self.joined else TOUCHING
        well = 1.0 if apart >= APART else NEARLY if apart >= least else 0.0
        if not self.is_pressing:
            well *= HIDDEN
        return well if factor <= USUAL else FINE * well

    @property
    def is_pressing(self) -> bool:
        """Whether its vertices look like one, or a letter has no place."""
        return len(self.members) == 1 or self.distance < TWO


def has_close(setting: Setting, vertices: Sequence[Vertex]) -> bool:
    """Tell whether two vertices that are not equal look like one."""
    return any(_needs(setting, vertices, ()))


def close_places(
    setting: Setting,
    vertices: Sequence[Vertex],
    far: Collection[str],
    shown: Callable[[Close], Collection[int]],
    pressing: bool = False,
) -> list[Close]:
    """Return the places that need a lens, the one that tells most apart first.

    ``far`` are labels that have no place beside their dots.  What a lens has ``shown`` of a place
    are the numbers of the vertices in it; none where not all of them have their letters there.
    ``pressing`` leaves out vertices that are seen as two.
    """
    needs = list(_needs(setting, vertices, far)) if len(vertices) <= MANY else []
    if pressing:
        needs = [need for need in needs if need.is_pressing]
    found: list[Close] = []
    taken: set[int] = set()
    while needs and len(found) < MOST:  # each round finds one
        tried = _tried(setting, vertices, needs, taken)
        views = ((each, shown(each)) for each in islice(tried, TRIED))
        close, seen = next(filter(itemgetter(1), views), (None, ()))
        if close is None:
            break
        found.append(close)
        taken.update(seen)
        needs = list(_unmet(needs, seen, close.factor))
    return found


def untold(setting: Setting, vertices: Sequence[Vertex], close: Sequence[Close]) -> list[Need]:
    """Return the pairs of vertices that look like one where no lens of a ``close`` place helps.

    Those that no lens can tell apart are not among them; those that are seen as two are, where
    fewer than the usual lenses stand, and in a wide room.
    """
    needs = list(_needs(setting, vertices, ())) if len(vertices) <= MANY else []
    few = len(close) < MOST or _is_wide(setting)
    needs = [need for need in needs if (few or need.is_pressing) and need.met(FACTORS[-1])]
    for each in close:
        needs = list(_unmet(needs, each.members, each.factor))
    return needs


def left_places(
    setting: Setting, vertices: Sequence[Vertex], close: Sequence[Close]
) -> Iterator[Close]:
    """Yield places that tell apart what lenses of other ``close`` places do not, the best first."""
    taken = {number for each in close for number in each.members}
    yield from islice(_tried(setting, vertices, untold(setting, vertices, close), taken), TRIED)


def _unmet(needs: Sequence[Need], shown: Collection[int], factor: float) -> Iterator[Need]:
    """Yield the needs that a lens of a factor does not meet that has ``shown`` some vertices."""
    told = frozenset(shown)
    return (each for each in needs if not (told.issuperset(each.members) and each.met(factor)))


def _tried(
    setting: Setting, vertices: Sequence[Vertex], needs: Sequence[Need], taken: Collection[int]
) -> Iterator[Close]:
    """Yield the places that meet some of the needs, the one that meets them best first."""
    found: dict[tuple[frozenset[int], float], tuple[tuple[float, ...], list[Need]]] = {}
    for need in needs:
        for factor in FACTORS:
            if not need.met(factor):
                continue
            gathered = _gathered(vertices, need.members, factor, largest(setting), taken)
            for members in (gathered, frozenset(need.members)):
                met = [each for each in needs if members.issuperset(each.members)]
                pairs = sum(each.met(factor) for each in met)
                score = -pairs, -len(met), factor, need.distance
                if len(members) > 1:
                    found.setdefault((members, factor), (score, met))
    for (members, factor), (_, met) in sorted(found.items(), key=lambda each: each[1][0]):
        yield _close(setting, vertices, members, factor, met)


def largest(setting: Setting) -> float:
    """Return the radius of a lens where there is room enough."""
    return LARGEST_ALONE if _is_wide(setting) else LARGEST


def _is_wide(setting: Setting) -> bool:
    return setting.room.width >= WIDE


def _least(setting: Setting) -> float:
    """Return how far apart two vertices have to be that need no lens."""
    if not _is_wide(setting):
        return LEAST
    return LEAST_OF_HEADS if setting.panel.picture == "vectors" else LEAST_WIDE


def _needs(setting: Setting, vertices: Sequence[Vertex], far: Collection[str]) -> Iterator[Need]:
    """Yield what needs a lens."""
    joined, least = _joined(setting, vertices), _least(setting)
    for (one, first), (other, second) in combinations(enumerate(vertices), 2):
        distance = abs(first.at - second.at)
        is_joined = (one, other) in joined
        if SAME < distance < (SHORTEST if is_joined else least):
            yield Need((one, other), distance, max(first.since, second.since), is_joined)
    for number, vertex in enumerate(vertices):
        if vertex.label in far:
            yield Need((number,), LEAST, vertex.since)


def _joined(setting: Setting, vertices: Sequence[Vertex]) -> set[tuple[int, ...]]:
    """Return the pairs of vertices that a vector joins, each by its numbers in order."""
    if setting.panel.picture != "vectors":
        return set()
    numbers = {letter: number for number, each in enumerate(vertices) for letter in each.letters}
    arrows = (each.shape for each in setting.panel.strokes if isinstance(each.shape, Arrow))
    pairs = ((numbers.get(each.tail), numbers.get(each.head)) for each in arrows)
    return {
        tuple(sorted((one, other))) for one, other in pairs if one is not None and other is not None
    }


def _close(
    setting: Setting,
    vertices: Sequence[Vertex],
    members: frozenset[int],
    factor: float,
    met: Sequence[Need],
) -> Close:
    """Return a place whose members that need a lens come first, as they appear."""
    first = sorted(met, key=lambda need: (need.since, need.distance))
    needed = list(dict.fromkeys(number for need in first for number in need.members))
    all_ = (*needed, *sorted(members - set(needed)))
    middle, reach = _about(vertices, all_)
    last = first[0].since
    many = max(2, len(needed))
    return Close(all_, middle, reach, factor, last, setting.after(last), many)


def _gathered(
    vertices: Sequence[Vertex],
    seed: Sequence[int],
    factor: float,
    radius: float,
    taken: Collection[int],
) -> frozenset[int]:
    """Return some vertices with those near to them, as many as a lens can show with letters.

    What even the lens cannot tell apart is left to another.
    """
    members, (middle, _) = [*seed], _about(vertices, seed)
    near = sorted((abs(vertex.at - middle), number) for number, vertex in enumerate(vertices))
    near = [(off, number) for off, number in near if off < GATHERED]
    for _, number in near:
        if number in taken or number in members:
            continue
        at = vertices[number].at
        if any(
            factor * abs(vertices[other].at - at) < TOUCHING for _, other in near if other != number
        ):
            continue
        _, reach = _about(vertices, [*members, number])
        if factor * reach <= radius - LETTERED:
            members.append(number)
    return frozenset(members)


def _about(vertices: Sequence[Vertex], members: Sequence[int]) -> tuple[complex, float]:
    """Return the middle of some vertices, and how far they are from there."""
    places = [vertices[number].at for number in members]
    if len(places) == 1:
        return places[0], 0.0
    one, other = max(combinations(places, 2), key=lambda ends: abs(ends[0] - ends[1]))
    middle = (one + other) / 2
    return middle, max(abs(place - middle) for place in places)

"""The pace of a lesson: the seconds in which each stroke is drawn, and rests while it is read.

A script may add pauses, and place strokes at moments of a recorded voice.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from vad.errors import UsageError
from vad.lecture.scenes import is_staged, scene_numbers
from vad.lecture.script import Script
from vad.lecture.telling import reading, share_caption, starts, told, told_together
from vad.strokes.sentences import pieces_of
from vad.strokes.sheet import Arrow, Fold, Panel, Sheet, Stroke
from vad.strokes.telling import telling
from vad.strokes.travel import Travel, TravelKind
from vad.strokes.travels import found_rates

#: Seconds in which each kind of stroke grows.  A vector takes as long if it is the longest one of
#: its panel.
GROWTH = {
    "fixed": 0.4,
    "guide": 0.8,
    "pole": 0.3,
    "angle": 0.8,
    "known": 1.2,
    "construction": 1.5,
    "intersection": 0.3,
    "result": 1.2,
}
FOLD = 1.0  # a plane that is rotated into the paper
FLIGHT = 2.4  # while a figure upon the mechanism turns onto its polygon
SWIFT = 0.3  # of each of several strokes with one caption, on average and at least
#: The seconds of the phases of a flight: most lift off, turn, are stretched, and fly.
PHASES: dict[TravelKind, tuple[float, ...]] = {
    "tangential": (0.8, 1.0, 0.6, 1.0),
    "normal": (0.8, 0.6, 1.4),
    "axial": (0.8, 0.6, 1.4),
    "coriolis": (0.6, 1.2, 0.8, 1.2),
    "turned": (0.6, 1.2, 0.8, 1.2),
    "point": (0.5, 0.6, 0.5, 1.0),
    "image": (1.0, 0.6, 1.0),
}
#: Seconds in which the traces of a flight fade when it has landed, and a rest.
LANDED, AFTER_FLIGHT = 0.3, 0.3
SHORT = 0.75  # share of that time for a vector of length zero
LEAST_REST = 0.5  # after a caption, and before the next one
GLIDE = 1.0  # the panels of a stage, as they move to their places in the next scene
SETTLE = 0.2
#: The least rest before a move, and from the last beat of a caption till then.
BEFORE_MOVE, AFTER_BEAT = 0.8, 1.2
#: A found ω or α leaves its caption when its number has stood there for a moment, flies to its link
#: and bends to an arrow.  Where a scene ends soon, it flies faster.
READ, RATE, LEAST_RATE, AFTER_RATE = 0.3, 1.6, 0.8, 0.2
SHEET = 5.0  # the whole sheet with the answer, at the end, to look it over
OPENING = 1.0
CLOSING = 4.0
AFTER_ANSWER = 0.2
LOOK = 1.5  # seconds, at least, to look at what is on the board already


@dataclass(frozen=True, slots=True)
class Times:
    """The seconds of one stroke: it grows and rests; panels glide to the next scene, and settle.

    ``beats`` are the seconds after which the second beat of its caption begins, and the third.  A
    ``pencil`` would take so many seconds of a flight.  One that finds an ω or α
    ``sends`` it to its link.  ``speed`` is that of the film.
    """

    grow: float
    hold: float
    glide: float = 0.0
    settle: float = 0.0
    beats: tuple[float, ...] = ()
    there: bool = False
    pencil: float = 0.0
    sends: bool = False
    speed: float = 1.0

    @property
    def rate(self) -> tuple[float, float]:
        """When a rate that it finds begins to fly to its link, and for how long: 0 if it is none.

        It is in seconds from the stroke's beginning.
        """
        if not self.sends or not self.beats:
            return 0.0, 0.0
        begins = max(self.beats[-1] + READ / self.speed, self.grow)
        free = self.grow + self.hold - AFTER_RATE / self.speed - begins
        enough = free * self.speed >= LEAST_RATE - 1e-9
        return (begins, min(RATE / self.speed, free)) if enough else (0.0, 0.0)

    @property
    def all(self) -> float:
        """The seconds from its beginning to the next stroke's."""
        return self.grow + self.hold + self.glide + self.settle

    def resting(self, hold: float) -> Times:
        """Return the times with another rest; in a shorter one the beats come sooner."""
        whole = self.grow + self.hold
        share = min(1.0, (self.grow + hold) / whole) if whole else 1.0
        return replace(self, hold=hold, beats=tuple(share * beat for beat in self.beats))

    def faster(self, speed: float) -> Times:
        """Return the times at a speed."""
        return replace(
            self,
            grow=self.grow / speed,
            hold=self.hold / speed,
            glide=self.glide / speed,
            settle=self.settle / speed,
            pencil=self.pencil / speed,
            speed=speed,
            beats=tuple(beat / speed for beat in self.beats),
        )


def growth(stroke: Stroke, longest: float) -> float:
    """Return how many seconds a stroke takes to draw; the ``longest`` vector takes most."""
    seconds = FOLD if isinstance(stroke.shape, Fold) else GROWTH[stroke.kind]
    if not isinstance(stroke.shape, Arrow) or not longest:
        return seconds
    return seconds * (SHORT + (1.0 - SHORT) * _length(stroke) / longest)


def rest(stroke: Stroke, grown: float, least: float = LEAST_REST) -> float:
    """Return how many seconds a stroke rests that has grown for ``grown`` seconds.

    Both times together are long enough to read its caption.
    """
    return max(reading(pieces_of(stroke.said)) - grown, least)


def _length(stroke: Stroke) -> float:
    """Return the length of a vector, 0 for another stroke."""
    shape = stroke.shape
    return abs(shape.end - shape.start) if isinstance(shape, Arrow) else 0.0


def times(sheet: Sheet, loop: int, travels: Mapping[str, Travel] | None) -> Iterator[Times]:
    """Yield the times of all strokes of a sheet, as they are told.

    Those before a loop are there already.  Some of them draw what ``travels``; None where nothing
    flies.
    """
    flown = {} if travels is None else flights(sheet, travels)
    rates = frozenset() if travels is None or not is_staged(sheet) else found_rates(sheet)
    found = {half.name: list(_times_of(half, loop, flown)) for half in sheet.halves}
    scenes = scene_numbers(sheet)
    for each, scene, after in zip(telling(sheet), scenes, [*scenes[1:], -1], strict=True):
        own = found[each.half.name][each.number]
        name = each.half.full(each.half.strokes[each.number].name)
        own = replace(own, sends=name in rates)
        if is_staged(sheet) and scene != after:
            own = _standing(own)
            own = own if after < 0 else replace(own, glide=GLIDE, settle=SETTLE)
        yield own


def _standing(own: Times) -> Times:
    """Return the times of the last stroke of a scene: it is read and stands before panels move."""
    after = READ + LEAST_RATE + AFTER_RATE if own.sends else AFTER_BEAT
    last = max(own.beats, default=0.0) + after * bool(own.beats)
    return own if own.there else replace(own, hold=max(own.hold, BEFORE_MOVE, last - own.grow))


def flights(sheet: Sheet, travels: Mapping[str, Travel]) -> dict[str, float]:
    """Return how long what ``travels`` with a stroke flies, by the full name of the stroke."""
    found = {name: sum(PHASES[travel.kind]) + LANDED for name, travel in travels.items()}
    for turned in (each for half in sheet.halves for each in half.turned):
        for panel in (half for half in sheet.halves if half.name == turned.panel):
            found[panel.full(panel.strokes[-1].name)] = FLIGHT
    return found


def _times_of(panel: Panel, loop: int, flown: Mapping[str, float]) -> Iterator[Times]:
    """Yield the times of the strokes of a panel; some are ``flown`` for so many seconds."""
    longest = max(map(_length, panel.strokes), default=0.0)
    begun = panel.loops[loop - 1] if 1 < loop <= len(panel.loops) else panel.given
    pairs = list(told_together(panel))
    looks = {last: told(panel, first, last) for first, last in pairs if last + 1 == begun}
    for first, last in pairs:
        strokes = panel.strokes[first : last + 1]
        if last < begun:
            look = max(LOOK, reading(looks[last])) if last in looks else 0.0
            yield from (
                Times(0.0, look if each == last else 0.0, there=True)
                for each in range(first, last + 1)
            )
            continue
        pencils = [growth(stroke, longest) for stroke in strokes]
        names = (panel.full(stroke.name) for stroke in strokes)
        grown = [flown.get(*each) for each in zip(names, pencils, strict=True)]
        if len(strokes) > 1 and share_caption(strokes, 0):
            yield from _times_of_one_caption(strokes[0], grown)
            continue
        for stroke, grow, pencil in zip(strokes, grown, pencils, strict=True):
            least = LEAST_REST if grow == pencil else AFTER_FLIGHT
            hold = rest(stroke, grow, least if stroke is strokes[-1] else 0.0)
            yield Times(grow, hold, beats=starts(stroke.said), pencil=pencil)


def _times_of_one_caption(stroke: Stroke, grown: Sequence[float]) -> Iterator[Times]:
    """Yield the times of strokes of which the same is said: they are drawn while it is read."""
    whole = reading(pieces_of(stroke.said))
    share = min(1.0, max(whole, SWIFT * len(grown)) / sum(grown))
    hold = max(LEAST_REST, whole - share * sum(grown))
    for number, grow in enumerate(grown, 1):
        yield Times(share * grow, hold if number == len(grown) else 0.0)


def scripted(
    found: list[Times], script: Script, sheet: Sheet, opening: float
) -> tuple[list[Times], float]:
    """Return the times as a script wants them, and the seconds of the opening.

    Its pauses are added to rests.  Before its markers rests are shortened, or the last one is
    prolonged.

    Parameters
    ----------
    found
        The times of all strokes, at the speed of the film.
    script
        The lecturer's script.
    sheet
        What is drawn.
    opening
        The seconds before the first stroke.

    Raises
    ------
    vad.errors.UsageError, vad.errors.InputError
        For a stroke that is none, and for a marker before which the strokes cannot be drawn; with
        the line of a file where there is one.
    """
    for step, seconds in script.pauses.items():
        place = script.number(sheet, "pauses", step)
        found[place] = found[place].resting(found[place].hold + seconds)
    names = {script.number(sheet, "markers", step): step for step in script.markers}
    first, clock = 0, 0.0
    for number, step in sorted(names.items()):
        before, at = found[first:number], script.markers[step]
        still = opening if first == 0 else 0.0
        rests = still + sum(each.hold for each in before)
        drawn = sum(each.all - each.hold for each in before)
        wanted = at - clock - drawn
        if wanted < 0.0:
            with script.at("markers", step):
                raise UsageError(
                    f"marker: {step} at {at:g} s: the strokes before it are drawn until "
                    f"{clock + drawn:.1f} s",
                    hint=f"try {clock + drawn + 0.05:.1f} or later",
                )
        if wanted < rests:
            before = [each.resting(wanted / rests * each.hold) for each in before]
            still *= wanted / rests
        elif before:
            before[-1] = before[-1].resting(before[-1].hold + wanted - rests)
        else:
            still = wanted
        found[first:number] = before
        opening = still if first == 0 else opening
        first, clock = number, at
    return found, opening

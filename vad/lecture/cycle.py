"""A whole turn of the driver: its course, and the paths of all points, solved at once.

A driver goes once round, or to and fro if it cannot go round.  The `Course` is its motion; the
`Cycle` has arrays over the shares of one turn.  Share 0 is where the driver passes 0° or the lower
end of its swing, share 1 is a turn later.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, product
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from vad.errors import AssemblyError
from vad.kinematics.motion import Motion
from vad.kinematics.reach import change_points, closing_range
from vad.kinematics.results import place_unit
from vad.statics.turn import Turning
from vad.strokes.centrodes import pair_of
from vad.strokes.diagram import POSITION, Spot
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.sheet import BELOW

if TYPE_CHECKING:
    from vad.lecture.followed import Followed, Stance
    from vad.lecture.turn import Turn
    from vad.mechanisms.mechanism import Mechanism
    from vad.strokes.draw import AnyScene

#: How far a swing keeps away from the dead centre at either end, as a share of its range.
KEPT = 0.03
#: A sine or cosine of a swing below this is none but for rounding: the driver rests at the ends.
ROUNDED = 1e-12
#: So many decimals of its angle a driver that goes round has: a step to a quarter of the turn ends
#: at 90°, not at 90.00000000000006°, where what is zero would be drawn as rounding.
PLACES = 12
#: The speed of a swing is the given rate over the sine of the given phase.  The sine counts as no
#: less than this, or a place near the end of the swing would make the speed too large.
LEAST = 0.3


@dataclass(frozen=True, slots=True)
class Course:
    """The motion of the driver over one turn; the phase runs from 0 to 1.

    ``names`` are those of its place and rates ("angle", "omega", "alpha"), ``given`` the values at
    phase 0.  ``swing`` is None for a full turn; otherwise the driver swings harmonically, and it
    holds the middle, the amplitude, the angle of the swing at phase 0 (radians) and its speed
    (rad/s).  Such a swing slows down towards the dead centres, so that no rate becomes too large
    there.
    """

    names: tuple[str, ...]
    given: tuple[float, ...]
    swing: tuple[float, float, float, float] | None = None

    def inputs(self, phase: float) -> dict[str, float]:
        """Return the inputs of `vad.solve` at a phase.

        Examples
        --------
        >>> Course(("angle", "omega", "alpha"), (60.0, -10.0, 0.0)).inputs(0.25)
        {'angle': 330.0, 'omega': -10.0, 'alpha': 0.0}
        """
        if self.swing is None:
            place, rate, second = self.given
            turned = (place + math.copysign(360.0, rate) * phase) % 360.0
            turned = round(turned, PLACES) % 360.0
            return dict(zip(self.names, (turned, rate, second), strict=True))
        middle, half, start, speed = self.swing
        angle = start + math.tau * phase
        # Rates of an angle count in radians.
        size = math.radians(half) if self.names[0] == "angle" else half
        waves = math.cos(angle), math.sin(angle)
        cosine, sine = (0.0 if abs(each) < ROUNDED else each for each in waves)
        values = middle + half * cosine, -size * speed * sine, -size * speed**2 * cosine
        return dict(zip(self.names, (each + 0.0 for each in values), strict=True))  # no -0.0

    @property
    def opening(self) -> float:
        """The phase at which the driver passes 0°, or the lower end of its swing."""
        if self.swing is not None:
            return (math.pi - self.swing[2]) / math.tau % 1.0
        place, rate, _ = self.given
        return math.copysign(1.0, -rate) * place / 360.0 % 1.0

    @property
    def ends(self) -> tuple[float, float]:
        """The driver's place at the opening and half a cycle later: the ends of a swing."""
        if self.swing is not None:
            middle, half = self.swing[:2]
            return middle - half, middle + half
        return (0.0, 180.0) if math.copysign(1.0, self.given[1]) > 0 else (360.0, 180.0)


def course(motion: Motion) -> Course:
    """Return the course that begins with one pose and runs through all that can follow it.

    Where the links do not close at that pose, it begins at the nearest one at which they do.

    Raises
    ------
    vad.errors.AssemblyError
        If the links close nowhere, or for one place of the driver alone.
    """
    names = tuple(motion.mechanism.inputs)
    given = tuple(float(motion.inputs[name]) for name in names)
    turns = names[0] == "angle"
    ranges = closing_range(motion.mechanism)
    if not ranges:
        raise AssemblyError("with these lengths the links close nowhere")
    if turns and ranges == [(0.0, 360.0)]:
        return Course(names, given)
    place = given[0] % 360.0 if turns else given[0]
    around = [place, place - 360.0] if turns else [place]

    def distance(ends: tuple[float, float]) -> float:
        return min(max(ends[0] - x, x - ends[1]) for x in around)

    low, high = min(_cut_at_change_points(motion.mechanism, ranges), key=distance)
    middle, half = (low + high) / 2, (0.5 - KEPT) * (high - low)
    if half < math.ulp(middle):
        unit = place_unit(motion.mechanism)
        message = f"the links close for {names[0]} {middle:g}{unit} alone, where nothing moves"
        raise AssemblyError(message, "draw that pose")
    here = min(around, key=lambda x: abs(x - middle))
    start = math.acos(min(max((here - middle) / half, -1.0), 1.0))
    rate = given[1] / (math.radians(half) if turns else half)
    # The driver passes the given place at the given rate, and in the sense of that rate.
    speed = abs(rate) / max(math.sin(start), LEAST)
    return Course(names, given, (middle, half, -start if rate > 0 else start, speed))


def _cut_at_change_points(
    mechanism: Mechanism, ranges: Sequence[tuple[float, float]]
) -> list[tuple[float, float]]:
    """Return the ranges, cut at change points: a swing keeps away from these as from its ends."""
    places = [point.place for point in change_points(mechanism)]
    parted: list[tuple[float, float]] = []
    for low, high in ranges:
        inside = {x for place in places for x in (place, place - 360.0) if low < x < high}
        parted += pairwise([low, *sorted(inside), high])
    return parted


Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]

SAMPLES = 720
#: The coefficient of fluctuation for which a flywheel is stated.
FLUCTUATION = 0.02
#: A mean below this share of the largest is none but for rounding.
_NOTHING = 1e-9
#: The unit of couples with which energy is in joules.
JOULE = "N m"
_SHARES = np.linspace(0.0, 1.0, SAMPLES + 1)
#: About a least or greatest sample: where a better one is sought, in shares of the way to the next
#: samples, and how many times.  The last ones are 1e-5 degrees apart.
BETWEEN, CLOSER = np.linspace(-1.0, 1.0, 33), 4
#: If the ratio of forward to return time is below this, the mechanism has no quick return.
LEAST_RATIO = 1.005
_WHOLE = 359.0  # degrees: an angle with at least this range goes round


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """One quantity of a row over the cycle, an angle without jumps; NaN where there is none.

    One of a point has a symbol that names it, and is not ``titled`` with the name of the row.  Its
    ``extremes``, the least and the greatest value, mostly lie between two of its ``values``.
    """

    row: str
    symbol: str
    unit: str
    values: Reals
    titled: bool = True
    extremes: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Work:
    """What the drive gives over a turn.

    Attributes
    ----------
    mean
        Its mean, in the unit of its curve.
    energy
        The greatest excess energy, in J.
    least, greatest
        The shares of the cycle between which it is given.
    flywheel
        The moment of inertia with which the speed fluctuates by `FLUCTUATION`, in kg·m²; None where
        nothing turns.
    """

    mean: float
    energy: float
    least: float
    greatest: float
    flywheel: float | None


@dataclass(frozen=True, slots=True, eq=False)
class Cycle:
    """A cycle at `SAMPLES` + 1 evenly spaced shares.

    Attributes
    ----------
    shares
        From 0 to 1, shape (n,).
    driver, output
        The rows of the results of the driver and of the output.  The output is the last slide on a
        guide of the frame, or else the last link that turns.
    place
        The driver's angle or position.
    curves
        What each panel measures of the output, by the panel's name.
    tracks
        Where the lettered points of each panel are, as complex arrays of shape (n,).
    back
        The shares at which a quick return begins and ends, or None.  The second may be above 1.
    work
        What the drive gives, where a torque is drawn of a driver that goes round.
    followed
        The point whose curves they are, where one is followed.
    """

    shares: Reals
    driver: str
    output: str
    place: Series
    curves: Mapping[str, Series]
    tracks: Mapping[str, Mapping[Spot, Complexes]]
    back: tuple[float, float] | None
    work: Work | None = None
    followed: Followed | None = None

    @property
    def stance(self) -> Stance | None:
        """When the point that is followed stands, if it is a foot; it does so from share 0 on."""
        return self.followed.stance if self.followed else None

    @property
    def shaded(self) -> tuple[float, float] | None:
        """The shares that are grey in the curves: of the return, or of the stance of a foot."""
        return (0.0, self.stance.part) if self.stance else self.back

    @property
    def ratio(self) -> float:
        """The time of the forward stroke over that of the return; 1 without a quick return."""
        if self.back is None:
            return 1.0
        part = self.back[1] - self.back[0]
        return (1.0 - part) / part


def cycle_of(turn: Turn, later: float) -> Cycle:
    """Return the cycle of a turn.

    A pose without rates is replaced by the pose that is ``later`` by that phase.
    """
    course, panels = turn.course, turn.panels
    scene = whole_turn(turn)
    point = turn.followed
    tracks = _tracks(scene, panels)
    stuck = ~np.isfinite(sum(sum(each.values()) for each in tracks.values()))
    if stuck.any():
        scene = whole_turn(turn, later * stuck)
        tracks = _tracks(scene, panels)
    motion, output = scene.motion, scene.output
    rate = _rate(motion, output)
    driver = scene.driver.name
    rolls = pair_of(motion, turn.centrode)[0] if turn.centrode else driver
    if point:
        tracks = {name: point.tracks(name, each) for name, each in tracks.items()}

    def measured(scene: AnyScene, name: str) -> Series | None:
        return (
            (_curve_of_point(scene, name, point) if point else None)
            or _curve(scene, name, DIAGRAMS[name].curve_row(scene))
            or _curve(scene, name, rolls)
            or _curve(scene, name, driver)
        )

    curves = {name: measured(scene, name) for name in panels}
    place = _curve(scene, POSITION.panel, driver)
    assert place is not None
    back = _quick_return(np.broadcast_to(rate, _SHARES.shape)) if course.swing is None else None
    back = None if point else back
    known = _with_extremes(turn, {name: curve for name, curve in curves.items() if curve}, measured)
    work = _work(turn, scene, known["drive"].values) if "drive" in known else None
    return Cycle(_SHARES, driver, output, place, known, tracks, back, work, point)


def _with_extremes(
    turn: Turn,
    curves: Mapping[str, Series],
    measured: Callable[[AnyScene, str], Series | None],
) -> dict[str, Series]:
    """Return curves with their least and greatest values, which are sought between their samples.

    About each of both the cycle is solved anew, closer and closer.
    """
    best = {}
    for name, sign in product(curves, (-1.0, 1.0)):
        peak = _peak(_SHARES, sign * curves[name].values)
        if peak:
            best[name, sign] = peak
    half = 1.0 / SAMPLES
    for _ in range(CLOSER if best else 0):
        shares = np.clip(np.concatenate([at + half * BETWEEN for at, _ in best.values()]), 0.0, 1.0)
        scene = whole_turn(turn, shares=shares)
        found = {name: measured(scene, name) for name in curves}
        for place, (name, sign) in enumerate(best):
            some = slice(place * len(BETWEEN), (place + 1) * len(BETWEEN))
            series, (_, most) = found[name], best[name, sign]
            values = sign * series.values[some] if series else np.array([])
            if series and series.unit == "°":  # about as many whole turns as there
                values = values + 360.0 * np.round((most - values) / 360.0)
            peak = _peak(shares[some], values)
            if peak and peak[1] > most:
                best[name, sign] = peak
        half /= (len(BETWEEN) - 1) / 2
    extremes = {
        name: tuple(sign * best[name, sign][1] for sign in (-1.0, 1.0) if (name, sign) in best)
        for name in curves
    }
    return {name: replace(curve, extremes=extremes[name]) for name, curve in curves.items()}


def _peak(shares: Reals, values: Reals) -> tuple[float, float] | None:
    """Return where the greatest of some values is, and that; None where no value exists."""
    if not np.isfinite(values).any():
        return None
    number = int(np.nanargmax(values))
    return float(shares[number]), float(values[number])


def _curve_of_point(scene: AnyScene, panel: str, point: Followed) -> Series | None:
    """Return what a panel measures of the point that is followed; None if it measures nothing."""
    found = point.curve(cast("Any", scene), panel)
    if found is None:
        return None
    symbol, unit, values = found
    shape = np.shape(scene.motion.assembled)
    return Series(point.row, symbol, unit, np.broadcast_to(values, shape), titled=False)


def _rate(motion: Motion, output: str) -> Any:
    """Return how fast the output moves; nothing where it is the resultant of an engine."""
    if output in motion.slides:
        return motion.slide(output).velocity
    return motion.link(output).omega if output in motion.links else 0.0


def whole_turn(turn: Turn, later: Any = 0.0, shares: Reals | None = None) -> AnyScene:
    """Return the scene of all poses of a turn at once, each of them later by some phase.

    They are those at some ``shares`` of the cycle if these are given.
    """
    phases = turn.opening + (_SHARES if shares is None else shares) + later
    inputs = [turn.course.inputs(phase) for phase in phases.tolist()]
    names = turn.course.names
    return turn.scene({name: np.array([each[name] for each in inputs]) for name in names})


def _work(turn: Turn, scene: AnyScene, torque: Reals) -> Work | None:
    """Return what the drive gives; None where the driver swings, or a torque does not exist."""
    if turn.course.swing is not None or not np.isfinite(torque).all() or scene.forces is None:
        return None
    sense = math.copysign(1.0, turn.course.given[1])
    turning = Turning(sense * 360.0 * _SHARES, torque)
    mean = turning.mean if abs(turning.mean) > _NOTHING * np.abs(torque).max() else 0.0
    rate = turn.course.given[1]
    metres = scene.forces.moment_unit == JOULE
    flywheel = turning.flywheel(FLUCTUATION, rate) if rate and metres else None
    return Work(mean, *turning.excess, flywheel)


def _tracks(scene: AnyScene, panels: Sequence[str]) -> dict[str, dict[Spot, Complexes]]:
    shape = np.shape(scene.motion.assembled)
    found: dict[str, dict[Spot, Complexes]] = {}
    for name in panels:
        found[name] = {}
        for spot, values in DIAGRAMS[name].tracks(scene).items():
            half = found.setdefault(name + BELOW, {}) if spot.below else found[name]
            half[spot] = np.broadcast_to(np.asarray(values, dtype=np.complex128), shape)
    return found


def _curve(scene: AnyScene, panel: str, name: str) -> Series | None:
    """Return what a panel measures of a link or slide, or None if it measures nothing."""
    motion = scene.motion
    cells = DIAGRAMS[panel].cells(scene, name, name in motion.slides)
    if not cells:
        return None
    shape = np.shape(motion.assembled)
    values = np.broadcast_to(np.asarray(cells[0].value, dtype=np.float64), shape)
    if cells[0].unit == "°":
        values = _unwrapped(values)
    return Series(name, cells[0].symbol, cells[0].unit, values)


def _unwrapped(degrees: Reals) -> Reals:
    """Return angles without jumps, from 0° to 360° if they can be; a swing through 0° is signed."""
    smooth = np.unwrap(degrees, period=360.0)
    low, high = np.nanmin(smooth), np.nanmax(smooth)
    turns = np.floor(low / 360.0)
    swings_through = high - low < _WHOLE and high >= 360.0 * (turns + 1.0)
    unwrapped: Reals = smooth - 360.0 * (turns + swings_through)
    return unwrapped


def _quick_return(rate: Reals) -> tuple[float, float] | None:
    """Return the shares at which the shorter stroke of a motion to and fro begins and ends."""
    count = len(rate) - 1
    forward = rate[:-1] > 0.0
    turns = np.flatnonzero(forward != np.roll(forward, -1))
    if len(turns) != 2:
        return None
    one, two = (float(i + rate[i] / (rate[i] - rate[i + 1])) / count for i in turns.tolist())
    begins, ends = min(((one, two), (two, one + 1.0)), key=lambda way: way[1] - way[0])
    part = ends - begins
    return (begins, ends) if 1.0 - part >= LEAST_RATIO * part else None

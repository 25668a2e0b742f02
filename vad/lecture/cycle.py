"""A whole cycle solved at once: the ways of all points, and the curves of what comes out.

In come a mechanism and the course of its driver, out goes a `Cycle` of arrays over its shares:
share 0 is where the driver passes 0° or the lower end of its swing, share 1 a turn later.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.motion import solve
from vad.strokes.diagram import POSITION, Spot
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import AnyScene, scene_of
from vad.strokes.sheet import BELOW
from vad.words import Language

if TYPE_CHECKING:
    from vad.lecture.course import Course
    from vad.mechanisms.mechanism import Mechanism

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]

SAMPLES = 720
#: A ratio of forward to return below this is none.
LEAST_RATIO = 1.005
_WHOLE = 359.0  # degrees: what covers as much goes round


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """One quantity over the cycle, an angle without jumps; NaN where there is none."""

    symbol: str
    unit: str
    values: Reals


@dataclass(frozen=True, slots=True, eq=False)
class Cycle:
    """A cycle at `SAMPLES` + 1 evenly spaced shares.

    Attributes
    ----------
    shares
        From 0 to 1, shape (n,).
    driver, output
        The rows of the results that are driven, and that the mechanism is there for: the last
        slide on a guide of the frame, else the last link that turns.
    place
        The driver's angle or position.
    curves
        What each panel measures of the output, by the panel's name.
    tracks
        Where the lettered points of each panel are, as complex arrays of shape (n,).
    back
        The shares at which a quick return begins and ends (that may lie beyond 1), or None.
    """

    shares: Reals
    driver: str
    output: str
    place: Curve
    curves: Mapping[str, Curve]
    tracks: Mapping[str, Mapping[Spot, Complexes]]
    back: tuple[float, float] | None

    @property
    def ratio(self) -> float:
        """The time of the way forward over that of the return; 1 where there is no return."""
        if self.back is None:
            return 1.0
        part = self.back[1] - self.back[0]
        return (1.0 - part) / part


def cycle_of(
    mechanism: Mechanism, course: Course, panels: Sequence[str], language: str, later: float
) -> Cycle:
    """Return the cycle of a mechanism; a pose without rates is taken ``later`` by that phase."""
    shares = np.linspace(0.0, 1.0, SAMPLES + 1)
    phases = course.opening + shares
    scene = _scene(mechanism, course, phases, language)
    tracks = _tracks(scene, panels)
    stuck = ~np.isfinite(sum(sum(each.values()) for each in tracks.values()))
    if stuck.any():
        scene = _scene(mechanism, course, phases + later * stuck, language)
        tracks = _tracks(scene, panels)
    motion, output = scene.motion, scene.output
    part: Any = motion.slide(output) if output in motion.slides else motion.link(output)
    rate = part.velocity if output in motion.slides else part.omega
    curves = {name: curve for name in panels if (curve := _curve(scene, name, output))}
    driver = scene.driver.name
    place = _curve(scene, POSITION.panel, driver)
    assert place is not None
    back = _return(np.broadcast_to(rate, shares.shape)) if course.swing is None else None
    return Cycle(shares, driver, output, place, curves, tracks, back)


def _scene(mechanism: Mechanism, course: Course, phases: Reals, language: str) -> AnyScene:
    inputs = [course.inputs(phase) for phase in phases.tolist()]
    arrays: dict[str, Any] = {n: np.array([each[n] for each in inputs]) for n in course.names}
    motion: Any = solve(mechanism, **arrays)
    return scene_of(motion, Language(language))


def _tracks(scene: AnyScene, panels: Sequence[str]) -> dict[str, dict[Spot, Complexes]]:
    shape = np.shape(scene.motion.assembled)
    found: dict[str, dict[Spot, Complexes]] = {}
    for name in panels:
        found[name] = {}
        for spot, values in DIAGRAMS[name].tracks(scene).items():
            half = found.setdefault(name + BELOW, {}) if spot.below else found[name]
            half[spot] = np.broadcast_to(np.asarray(values, dtype=np.complex128), shape)
    return found


def _curve(scene: AnyScene, panel: str, name: str) -> Curve | None:
    """Return what a panel measures of a link or slide, None for nothing."""
    motion = scene.motion
    cells = DIAGRAMS[panel].cells(scene, name, name in motion.slides)
    if not cells:
        return None
    shape = np.shape(motion.assembled)
    values = np.broadcast_to(np.asarray(cells[0].value, dtype=np.float64), shape)
    if cells[0].unit == "°":
        values = _unwrapped(values)
    return Curve(cells[0].symbol, cells[0].unit, values)


def _unwrapped(degrees: Reals) -> Reals:
    """Return angles without jumps, from 0° to 360° if they can be; a swing through 0° is signed."""
    smooth = np.unwrap(degrees, period=360.0)
    low, high = np.nanmin(smooth), np.nanmax(smooth)
    turns = np.floor(low / 360.0)
    swings_through = high - low < _WHOLE and high >= 360.0 * (turns + 1.0)
    unwrapped: Reals = smooth - 360.0 * (turns + swings_through)
    return unwrapped


def _return(rate: Reals) -> tuple[float, float] | None:
    """Return when the shorter way of what goes to and fro begins and ends."""
    count = len(rate) - 1
    forward = rate[:-1] > 0.0
    turns = np.flatnonzero(forward != np.roll(forward, -1))
    if len(turns) != 2:
        return None
    one, two = (float(i + rate[i] / (rate[i] - rate[i + 1])) / count for i in turns.tolist())
    begins, ends = min(((one, two), (two, one + 1.0)), key=lambda way: way[1] - way[0])
    part = ends - begins
    return (begins, ends) if 1.0 - part >= LEAST_RATIO * part else None

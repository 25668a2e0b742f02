"""Run time against error: one marker for every method and tolerance, in four panels.

``python -m benchmarks.accuracy`` writes benchmarks/results/accuracy.csv and
gallery/accuracy.png in a quarter of a minute.  The peers are measured where they are installed
(``pip install ".[benchmarks]"``; pylinkage is itself only with numba, which compiles it).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np

import vad
from benchmarks.common import (
    BLACK,
    BLUE,
    GALLERY,
    GREEN,
    ORANGE,
    PURPLE,
    RESULTS,
    facts,
    floor,
    three,
    write_csv,
)
from benchmarks.rivals import (
    ALPHA,
    LINKS,
    OMEGA,
    Course,
    MechanismPackage,
    PylinkagePackage,
    fsolve,
    installed,
)
from benchmarks.speed import reader
from vad.kinematics.linkage import angle_of
from vad.methods import (
    METHODS,
    Found,
    Problem,
    finite_differences,
    high_precision,
    newton,
    problem_of,
)
from vad.methods.comparison import seconds

MICRO = math.degrees(1e-6)
COURSES = {
    "an easy mechanism": Course(100, 40, 120, 80, start=20.0, step=15.0, count=24),
    "near a toggle: 1 to 24 µrad from it": Course(4, 3, 2, 3, 90 - 24 * MICRO, MICRO, 24),
    "at a change point: 2 to 25 µrad from it": Course(5, 2, 4, 7, 2 * MICRO, MICRO, 24),
    "a long sweep: the last of a million poses": Course(100, 40, 120, 80, 0.5, 1.0, 1_000_000),
}
#: How many poses, the last ones, are compared with the truth.
COMPARED = 24
#: An error as large as the result itself; worse is not told apart.
WRONG = 1.0
MANY = 1_000_000
INKS = {
    "vad, a million poses": BLUE,
    "vad, one pose": BLUE,
    "construction": BLACK,
    "unit vectors": BLACK,
    "loop closure": BLACK,
    "Newton": ORANGE,
    "SciPy fsolve": ORANGE,
    "finite differences": PURPLE,
    "mechanism": GREEN,
    "pylinkage": GREEN,
}


class Mark(NamedTuple):
    """One method with one setting: its time for a pose, in floors, and its largest error."""

    method: str
    setting: str
    time: float
    error: float


def truth_of(course: Course) -> np.ndarray:
    """Return what is to be found at the compared poses."""
    return np.array([_orders(high_precision.solve(problem)) for problem in problems(course)])


def problems(course: Course) -> list[Problem]:
    """Return the compared poses one by one."""
    rates = {"omega": OMEGA, "alpha": ALPHA}
    angles = course.last(COMPARED).angles
    return [problem_of(course.mechanism, {"angle": float(a), **rates}) for a in angles]


def _orders(found: Found) -> list[list[float]]:
    return [[float(found[angle_of(name)][order]) for name in LINKS] for order in range(3)]


def error(found: np.ndarray, truth: np.ndarray) -> float:
    """Return the largest error of any pose: of angles in radians, of both ω or α relative."""
    miss = found - truth
    miss[:, 0] -= math.tau * np.rint(miss[:, 0] / math.tau)
    scale = np.linalg.norm(truth, axis=2)
    scale[:, 0] = 1.0
    return float((np.linalg.norm(miss, axis=2) / scale).max())


def one_by_one(solve: Callable[[Problem], Found], course: Course, truth: np.ndarray) -> Any:
    """Return time and error of a method that solves single poses."""
    poses = problems(course)
    try:
        found = np.array([_orders(solve(problem)) for problem in poses])
    except (ArithmeticError, ValueError, vad.VadError):
        return math.nan, math.inf
    return seconds(lambda: [solve(problem) for problem in poses]) / len(poses), error(found, truth)


def a_million(course: Course, truth: np.ndarray) -> tuple[float, float]:
    """Return time and error of the program's own sweep."""
    angles = np.resize(course.angles, MANY) if course.count < MANY else course.angles
    inputs = {"angle": angles, "omega": OMEGA, "alpha": ALPHA}
    motion = vad.solve(course.mechanism, **inputs)
    links = [motion.link(name) for name in LINKS]
    orders = [[np.radians(link.angle), link.omega, link.alpha] for link in links]
    found = np.array(orders).transpose(2, 1, 0)
    end = course.count if course.count < MANY else MANY
    read = reader("four-bar")
    time = seconds(lambda: read(vad.solve(course.mechanism, **inputs))) / MANY
    return time, error(found[end - COMPARED : end].copy(), truth)


def marks(course: Course) -> Iterator[tuple[str, str, float, float]]:
    """Yield method, setting, seconds for a pose and error."""
    truth, short = truth_of(course), course.last(COMPARED)
    yield "vad, a million poses", "", *a_million(course, truth)
    yield "vad, one pose", "", *one_by_one(METHODS["closed form"], course, truth)
    for name in ("construction", "unit vectors", "loop closure"):
        yield name, "", *one_by_one(METHODS[name], course, truth)
    start = dict(zip(map(angle_of, LINKS), short.near()[0], strict=True))
    for tolerance in (1e-1, 1e-3, 1e-5, 1e-8, 1e-12):
        solve = partial(newton.solve, tolerance=tolerance, start=None if short.step > 1 else start)
        yield "Newton", f"{tolerance:.0e}", *one_by_one(solve, course, truth)
    for step in (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7):
        solve = partial(finite_differences.solve, step=step)
        yield "finite differences", f"{step:.0e}", *one_by_one(solve, course, truth)
    for tolerance in (1e-2, 1e-4, 1e-8, 1e-12):
        time = seconds(lambda tolerance=tolerance: fsolve(short, tolerance)) / short.count
        yield "SciPy fsolve", f"{tolerance:.0e}", time, error(fsolve(short, tolerance), truth)
    if installed("mechanism"):
        peer = MechanismPackage(short)
        yield "mechanism", "", seconds(peer.run) / short.count, error(peer.run(), truth)
    if installed("pylinkage"):
        peer = PylinkagePackage(course)
        time = seconds(peer.run, repeats=3) / course.count
        yield "pylinkage", "", time, error(peer.results(COMPARED), truth)


def draw_panels(results: dict[str, list[Mark]]) -> None:
    """Draw the four panels."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(13, 10), dpi=110, layout="constrained")
    panels = figure.subplots(2, 2, sharex=True, sharey=True)
    for panel, title in zip(panels.flat, results, strict=True):
        panel.set(xscale="log", yscale="log", xlim=(0.4, 3e5), ylim=(1e-17, 20), title=title)
        panel.set_yticks([1e-16, 1e-12, 1e-8, 1e-4, WRONG])
        panel.set_yticklabels(["10⁻¹⁶", "10⁻¹²", "10⁻⁸", "10⁻⁴", "wrong"])
        panel.minorticks_off()
        panel.spines[["top", "right"]].set_visible(False)
        panel.grid(color="0.92")
    figure.suptitle("\n".join(facts()), fontsize=8, color="0.35")
    for panel in panels[:, 0]:
        panel.set_ylabel("largest error: of angles in rad, of ω and α relative")
    for panel in panels[1]:
        panel.set_xlabel("time for a pose, in floors (sin + cos + sqrt + arctan2)")
    figure.draw_without_rendering()
    for panel, found in zip(panels.flat, results.values(), strict=True):
        _marks(panel, found)
    GALLERY.mkdir(exist_ok=True)
    figure.savefig(GALLERY / "accuracy.png")
    print("wrote gallery/accuracy.png")


def _marks(panel: Any, found: list[Mark]) -> None:
    from benchmarks.labels import place_labels

    labels, points, silent = [], [], []
    for method, group in groupby(found, key=lambda mark: mark.method):
        seen = [mark for mark in group if math.isfinite(mark.time) and math.isfinite(mark.error)]
        if not seen:
            silent.append(method)
            continue
        times = [mark.time for mark in seen]
        misses = [min(mark.error, WRONG) for mark in seen]
        shape = "o" if len(seen) == 1 else ".-"
        panel.plot(times, misses, shape, color=INKS[method], ms=7, lw=1)
        best = misses.index(min(misses))
        labels.append((method, times[best], misses[best], INKS[method]))
        points += zip(times, misses, strict=True)
    if silent:
        panel.text(1, 1e-1, "no answer: " + ", ".join(silent), color="0.35", fontsize=9)
    place_labels(panel, labels, points)


def main() -> None:
    """Measure, write and draw."""
    unit = floor()
    results = {
        title: [Mark(name, setting, t / unit, e) for name, setting, t, e in marks(course)]
        for title, course in COURSES.items()
    }
    rows = [
        [title, mark.method, mark.setting, three(mark.time), three(mark.error)]
        for title, found in results.items()
        for mark in found
    ]
    for row in rows:
        print("{:42} {:22} {:>6} {:>9} {:>9}".format(*row))
    write_csv(RESULTS / "accuracy.csv", ["panel", "method", "setting", "floors", "error"], rows)
    draw_panels(results)


if __name__ == "__main__":
    main()

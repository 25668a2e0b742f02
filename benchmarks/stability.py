"""Error in ε·κ against the distance from trouble: the textbooks' formulas and the program.

A result whose error is near 1 ε·κ is as good as its input allows.  Where the trouble lies in the
driver alone, because whole lengths are exact, κ is that of the driver alone.  ``python -m
benchmarks.stability`` writes benchmarks/results/stability.csv and gallery/stability.png.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

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
    three,
    write_csv,
)
from benchmarks.textbook import OMEGA
from tests.oracle import DIGITS, Quantity, UnassemblableError, reference

DISTANCES = [10 ** (-step / 2) for step in range(2, 31)]
SAMPLES = 10
NO_ANSWER = math.inf
LEAST, MOST = 0.02, 1e18

Numbers = dict[str, float]
Labels = dict[str, tuple[float, float]]


@dataclass(frozen=True)
class Family:
    """Poses at a given distance from where formulas fail.

    Attributes
    ----------
    title, distance
        What stands above the panel and below it.
    mechanism, output
        Which mechanism, and the link whose ω is looked at.
    sample
        Draws the dimensions and the angle of a pose.
    labels
        Where the names of the formulas stand in the panel: distance and error.
    conditions
        The numbers over which κ is summed; all if there are none.
    """

    title: str
    distance: str
    mechanism: str
    output: str
    sample: Callable[[random.Random, float], Numbers]
    labels: Labels
    conditions: tuple[str, ...] = ()


def four_bar_toggle(draw: random.Random, distance: float) -> Numbers:
    """Coupler and rocker in line: stretched, or folded onto each other."""
    while True:
        ground, crank, coupler, rocker = (draw.uniform(10, 100) for _ in range(4))
        stretched = draw.random() < 0.5
        diagonal = mpf(coupler) + rocker if stretched else abs(mpf(coupler) - rocker)
        cosine = (mpf(ground) ** 2 + mpf(crank) ** 2 - diagonal**2) / (2 * mpf(ground) * crank)
        if abs(cosine) < 0.95:
            break
    # Stretched, the diagonal may only become shorter; folded, only longer.
    inward = -1 if stretched else 1
    angle = float(mp.degrees(mp.acos(cosine) + inward * mpf(distance)))
    return dict(ground=ground, crank=crank, coupler=coupler, rocker=rocker, angle=angle)


def four_bar_change_point(draw: random.Random, distance: float) -> Numbers:
    """All four links in one line at 0°, with whole lengths, so that nothing is rounded."""
    while True:
        ground, crank, coupler = (float(draw.randint(1, 20)) for _ in range(3))
        rocker = abs(coupler + draw.choice((-1, 1)) * (ground - crank))
        if rocker and ground != crank:
            break
    angle = math.degrees(distance)
    return dict(ground=ground, crank=crank, coupler=coupler, rocker=rocker, angle=angle)


def slider_crank_change_point(draw: random.Random, distance: float) -> Numbers:
    """Crank and rod across the guide at -90°, with whole lengths."""
    crank, offset = float(draw.randint(1, 20)), float(draw.randint(0, 20))
    angle = math.degrees(distance) - 90.0
    return dict(crank=crank, rod=crank + offset, offset=offset, angle=angle)


def four_bar_short_rocker(draw: random.Random, distance: float) -> Numbers:
    """A rocker much shorter than the other links, in any direction."""
    ground, crank, angle = draw.uniform(10, 100), draw.uniform(10, 100), draw.uniform(20, 160)
    diagonal = ground - crank * mp.expj(mp.radians(angle))
    rocker = float(abs(diagonal) * distance)
    tip = diagonal + mp.mpf(rocker) * mp.expj(draw.uniform(0, 6))
    return dict(ground=ground, crank=crank, coupler=float(abs(tip)), rocker=rocker, angle=angle)


FAMILIES = (
    Family(
        "four-bar, near a toggle",
        "distance from it, rad",
        "four-bar",
        "rocker",
        four_bar_toggle,
        {"acos": (1e-4, 10), "squares": (1e-8, 10), "half-angle": (1e-12, 30), "vad": (1e-7, 0.05)},
    ),
    Family(
        "four-bar, near a change point",
        "distance from it, rad",
        "four-bar",
        "rocker",
        four_bar_change_point,
        {
            "acos": (1e-8, 2e14),
            "squares": (3e-7, 1e10),
            "half-angle": (1e-3, 1e10),
            "vad": (1e-9, 40),
        },
        ("angle", "omega"),
    ),
    Family(
        "slider–crank, near its change point",
        "distance from it, rad",
        "slider-crank",
        "rod",
        slider_crank_change_point,
        {
            "asin": (2e-4, 1e12),
            "squares": (1e-3, 1e9),
            "quadratic": (1e-10, 1e14),
            "vad": (1e-9, 20),
        },
        ("angle", "omega"),
    ),
    Family(
        "four-bar, with a short rocker",
        "rocker to diagonal",
        "four-bar",
        "rocker",
        four_bar_short_rocker,
        {
            "acos": (1e-4, 200),
            "squares": (1e-5, 2e6),
            "half-angle": (5e-7, 2e3),
            "vad": (1e-6, 0.05),
        },
    ),
)


def errors(family: Family, distance: float) -> Iterator[dict[str, float]]:
    """Yield the error of each formula in ε·κ, pose by pose."""
    draw = random.Random(f"{family.title} {distance:.3g}")
    found = 0
    while found < SAMPLES:
        with mp.workdps(DIGITS):
            numbers = family.sample(draw, distance)
        try:
            yield _errors(family, numbers)
        except (UnassemblableError, ZeroDivisionError):  # rounding has moved it past the toggle
            continue
        found += 1


def _errors(family: Family, numbers: Numbers) -> dict[str, float]:
    lengths = {name: value for name, value in numbers.items() if name != "angle"}
    inputs = {"angle": numbers["angle"], "omega": 1.0, "alpha": 0.0}
    key = ("link", family.output, "omega")
    truth = reference(family.mechanism, lengths, inputs)[key]

    def ours(_: Numbers) -> Any:
        mechanism = vad.MECHANISMS[family.mechanism](**lengths)
        return vad.solve(mechanism, **inputs).link(family.output).omega

    def miss(omega: Callable[[Numbers], Any]) -> float:
        try:
            return _in_epsilon_kappa(float(omega(numbers)), truth, family.conditions)
        except (ValueError, ZeroDivisionError, vad.VadError):
            return NO_ANSWER

    return {name: miss(omega) for name, omega in {**OMEGA[family.mechanism], "vad": ours}.items()}


def _in_epsilon_kappa(value: float, truth: Quantity, conditions: tuple[str, ...]) -> float:
    if math.isnan(value):
        return NO_ANSWER
    with mp.workdps(DIGITS):
        terms = [t for name, t in truth.terms.items() if not conditions or name in conditions]
        kappa = abs(truth.value) + mp.fsum(map(abs, terms))
        return float(abs(value - truth.value) / kappa * 2**52)


def curves(family: Family) -> dict[str, list[float]]:
    """Return the worst error of each formula at every distance."""
    worst: dict[str, list[float]] = {}
    for distance in DISTANCES:
        found = list(errors(family, distance))
        for name in found[0]:
            worst.setdefault(name, []).append(max(one[name] for one in found))
    return worst


def draw_panels(results: dict[str, dict[str, list[float]]]) -> None:
    """Draw one panel for each family."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 8), dpi=120, layout="constrained")
    panels = figure.subplots(2, 2, sharey=True)
    for panel, family in zip(panels.flat, FAMILIES, strict=True):
        inks = (ORANGE, PURPLE, GREEN, BLUE)
        for (name, values), ink in zip(results[family.title].items(), inks, strict=True):
            _curve(panel, values, ink, 2.5 if name == "vad" else 1.2)
            place = family.labels[name]
            panel.text(*place, name, color=ink, weight="bold", ha="center", va="center")
        panel.axhline(1, color=BLACK, lw=0.6, ls=":")
        panel.set(xscale="log", yscale="log", ylim=(LEAST, MOST * 5), xlim=(0.2, 5e-16))
        panel.set_title(family.title, fontsize=11)
        panel.set_xlabel(family.distance)
        panel.spines[["top", "right"]].set_visible(False)
        panel.set_yticks([1e0, 1e4, 1e8, 1e12, 1e16, MOST])
        panel.set_yticklabels(["1", "10⁴", "10⁸", "10¹²", "10¹⁶", "no answer"])
        panel.minorticks_off()
    for panel in panels[:, 0]:
        panel.set_ylabel("largest error of the output's ω, ε·κ")
    figure.suptitle("\n".join(facts()), fontsize=8, color="0.35")
    GALLERY.mkdir(exist_ok=True)
    figure.savefig(GALLERY / "stability.png")
    print("wrote gallery/stability.png")


def _curve(panel: Any, values: list[float], ink: str, width: float) -> None:
    """Draw a curve, and crosses where there is no answer."""
    answers = [max(value, LEAST) if value < MOST else math.nan for value in values]
    panel.plot(DISTANCES, answers, ".-", color=ink, lw=width)
    missing = [d for d, value in zip(DISTANCES, values, strict=True) if value >= MOST]
    panel.plot(missing, [MOST] * len(missing), "x", color=ink, ms=5)


def main() -> None:
    """Measure, write and draw."""
    results = {family.title: curves(family) for family in FAMILIES}
    rows = [
        [title, name, three(distance), three(value)]
        for title, worst in results.items()
        for name, values in worst.items()
        for distance, value in zip(DISTANCES, values, strict=True)
    ]
    write_csv(RESULTS / "stability.csv", ["family", "formula", "distance", "error"], rows)
    draw_panels(results)


if __name__ == "__main__":
    main()

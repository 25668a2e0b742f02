"""Poses to stress the solver with: a family and a seed go in, mechanisms with inputs come out.

Every sampler builds the mechanism around a pose (the last length is measured off it), so that all
draws close but for rounding, and places the pose where the family wants it: anywhere, near a
toggle, near a change point, with the pin near the lever's pivot, with lengths of 1 : 1e8, or at
extreme scale.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from tests.oracle import Key, Quantity, UnassemblableError, reference


@dataclass(frozen=True)
class Case:
    """One pose of one mechanism, in the words of the public contract."""

    name: str
    parameters: dict[str, float]
    inputs: dict[str, float]
    assembly: str


class Draw(random.Random):
    """Random numbers in the shapes that mechanisms need."""

    def length(self, decades: float = 1.0) -> float:
        return 10 ** self.uniform(-decades, 0) * 100

    def sign(self) -> int:
        return self.choice((-1, 1))

    def angle(self) -> float:
        return self.uniform(-360, 720)

    def tiny(self, least: float, most: float = 1.0) -> float:
        """A number of either sign, its size anywhere from 10^-least to 10^-most."""
        return self.sign() * 10 ** -self.uniform(most, least)

    def rates(self) -> dict[str, float]:
        return {
            "omega": self.sign() * 10 ** self.uniform(-1, 2),
            "alpha": self.choice((0.0, self.sign() * 10 ** self.uniform(-1, 4))),
        }


class Wide(Draw):
    """Draws lengths over four decades."""

    def length(self, decades: float = 4.0) -> float:
        return super().length(decades)


def turn(degrees: float) -> complex:
    return cmath.rect(1.0, math.radians(degrees))


def toward(family: str, draw: Draw, dead: float, decades: float = 7.0) -> float:
    """Return a direction: anywhere, or near the given one or its opposite (degrees)."""
    if family != "toggle":
        return draw.angle()
    return dead + draw.choice((0, 180)) + math.degrees(draw.tiny(decades))


Body = tuple[dict[str, float], dict[str, float]]


def four_bar(family: str, draw: Draw) -> Body:
    if family == "change point":
        return four_bar_change_point(draw)
    decades = 8.0 if family == "unequal" else 1.0
    ground, crank, rocker = (draw.length(decades) for _ in range(3))
    angle, ground_angle = draw.angle(), draw.choice((0.0, draw.angle()))
    b, d = crank * turn(angle), ground * turn(ground_angle)
    c = d + rocker * turn(toward(family, draw, math.degrees(cmath.phase(b - d))))
    links = {"ground": ground, "crank": crank, "ground_angle": ground_angle}
    if family == "unequal" and draw.random() < 0.5:  # now the coupler may be the short one
        c = b + rocker * turn(draw.angle())
        return {**links, "coupler": rocker, "rocker": abs(c - d)}, {"angle": angle, **draw.rates()}
    return {**links, "coupler": abs(c - b), "rocker": rocker}, {"angle": angle, **draw.rates()}


def four_bar_change_point(draw: Draw) -> Body:
    """Whole lengths that all lie in one line at 0° or at 180°, and an angle close to that."""
    ground, crank, coupler = (float(draw.randint(1, 20)) for _ in range(3))
    near_zero = draw.random() < 0.5
    gap = ground - crank if near_zero else ground + crank
    rocker = abs(coupler + draw.sign() * gap if near_zero else gap - coupler)
    angle = (0.0 if near_zero else 180.0) + draw.tiny(13)
    lengths = {"ground": ground, "crank": crank, "coupler": coupler, "rocker": rocker or coupler}
    return {**lengths, "ground_angle": 0.0}, {"angle": angle, **draw.rates()}


def slider_crank(family: str, draw: Draw) -> Body:
    if family == "change point":
        crank, offset = float(draw.randint(1, 20)), float(draw.choice((0, draw.randint(-9, 9))))
        angle = draw.choice((90.0, -90.0)) + draw.tiny(13)
        rod = abs(crank - offset) if angle > 0 else crank + offset
        return {"crank": crank, "rod": abs(rod) or crank, "offset": offset}, {
            "angle": angle,
            **draw.rates(),
        }
    decades = 8.0 if family == "unequal" else 1.0
    crank, rod, angle = draw.length(decades), draw.length(decades), draw.angle()
    offset = crank * turn(angle).imag + rod * turn(toward(family, draw, 90.0)).imag
    if family == "random" and rod > crank and draw.random() < 0.5:
        offset = 0.0
    return {"crank": crank, "rod": rod, "offset": offset}, {"angle": angle, **draw.rates()}


def slotted(arm: str, sign: int, ram: bool) -> Callable[[str, Draw], Body]:
    """Return the sampler of a slotted lever; its ram stands anywhere or near its own toggle."""

    def sample(family: str, draw: Draw) -> Body:
        decades = 8.0 if family == "unequal" else 1.0
        ground, crank, reach = (draw.length(decades) for _ in range(3))
        angle, ground_angle = draw.angle(), draw.choice((-90.0, 0.0, draw.angle()))
        if family == "near pivot":
            crank = ground * draw.choice((1.0, 1.0 + draw.tiny(12)))
            angle = ground_angle + draw.tiny(12)
        parameters = {"ground": ground, "crank": crank, arm: reach, "ground_angle": ground_angle}
        if ram:
            pivot = ground * turn(ground_angle)
            lever = crank * turn(angle) - pivot
            tip = pivot + sign * reach * lever / abs(lever)
            rod = draw.length(decades)
            height = tip.imag + rod * turn(toward(family, draw, 90.0)).imag
            parameters |= {"rod": rod, "ram_height": height}
        return parameters, {"angle": angle, **draw.rates()}

    return sample


def elliptical_trammel(family: str, draw: Draw) -> Body:
    decades = 8.0 if family == "unequal" else 1.0
    angle = toward(family, draw, draw.choice((0.0, 90.0)), 12)
    tracer = draw.sign() * draw.length(decades) * 2
    return {"link": draw.length(decades), "tracer": tracer}, {"angle": angle, **draw.rates()}


def scotch_yoke(family: str, draw: Draw) -> Body:
    angle = toward(family, draw, draw.choice((0.0, 90.0)), 12)
    return {"crank": draw.length()}, {"angle": angle, **draw.rates()}


def slide_rates(draw: Draw) -> dict[str, float]:
    acceleration = draw.choice((0.0, draw.sign() * draw.length() * 100))
    return {"velocity": draw.sign() * draw.length() * 10, "acceleration": acceleration}


def double_slider(family: str, draw: Draw) -> Body:
    guide_a = draw.choice((0.0, draw.angle()))
    guide_b = guide_a + draw.choice((90.0, 90.0, 45.0, 120.0, draw.uniform(5, 355)))
    decades = 8.0 if family == "unequal" else 1.0
    position = draw.sign() * draw.length(decades)
    a = position * turn(guide_a - guide_b)  # as seen along the guide of B
    b = draw.sign() * draw.length(decades)
    if family == "toggle":
        b = a.real + draw.tiny(7) * abs(position)
    inputs = {"position": position, **slide_rates(draw)}
    return {"link": abs(b - a), "guide_a": guide_a, "guide_b": guide_b}, inputs


def gate_actuator(family: str, draw: Draw) -> Body:
    decades = 8.0 if family == "unequal" else 1.0
    ground, arm = draw.length(decades), draw.length(decades)
    ground_angle = draw.choice((180.0, draw.angle()))
    direction = toward(family, draw, 0.0)
    position = abs(arm * turn(direction) - ground)
    if family == "change point":  # arm and ground lie on each other when the actuator has no length
        arm, position = ground, ground * abs(draw.tiny(12))
    parameters = {"ground": ground, "arm": arm, "ground_angle": ground_angle}
    return parameters, {"position": position, **slide_rates(draw)}


SAMPLERS: dict[str, tuple[str, Callable[[str, Draw], Body]]] = {
    "four-bar": ("four-bar", four_bar),
    "slider-crank": ("slider-crank", slider_crank),
    "crank-slotted-lever": ("crank-slotted-lever", slotted("lever", +1, ram=False)),
    "crank-slotted-lever with ram": ("crank-slotted-lever", slotted("lever", +1, ram=True)),
    "whitworth": ("whitworth", slotted("arm", -1, ram=False)),
    "whitworth with ram": ("whitworth", slotted("arm", -1, ram=True)),
    "elliptical-trammel": ("elliptical-trammel", elliptical_trammel),
    "scotch-yoke": ("scotch-yoke", scotch_yoke),
    "double-slider": ("double-slider", double_slider),
    "gate-actuator": ("gate-actuator", gate_actuator),
}
SCALES = {"scale 1e-170": 1e-170, "scale 1e170": 1e170}
FAMILIES = ("random", "toggle", "change point", "near pivot", "unequal", *SCALES)
LENGTHLESS = {"ground_angle", "guide_a", "guide_b", "angle", "omega", "alpha"}


def exists(variant: str, family: str) -> bool:
    """Say whether the mechanism has such poses at all."""
    if family == "change point":
        return variant in ("four-bar", "slider-crank", "gate-actuator")
    if family == "near pivot":
        return SAMPLERS[variant][0] in ("crank-slotted-lever", "whitworth")
    return family != "toggle" or variant not in ("crank-slotted-lever", "whitworth")


def scaled(numbers: dict[str, float], factor: float) -> dict[str, float]:
    return {key: x if key in LENGTHLESS else x * factor for key, x in numbers.items()}


def samples(
    variant: str, family: str, count: int, seed: int = 1, conditions: bool = True
) -> Iterator[tuple[Case, dict[Key, Quantity]]]:
    """Yield poses of a family with the truth about them, half of them crossed."""
    draw = Draw(f"{variant} {family} {seed}")
    name, sampler = SAMPLERS[variant]
    factor = SCALES.get(family, 1.0)
    found = 0
    while found < count:
        parameters, inputs = sampler("random" if family in SCALES else family, draw)
        case = Case(
            name,
            scaled(parameters, factor),
            scaled(inputs, factor),
            draw.choice(("open", "crossed")),
        )
        try:
            truth = reference(name, case.parameters, case.inputs, case.assembly, conditions)
        except (
            UnassemblableError,
            ZeroDivisionError,
        ):  # rounding has moved it past the toggle, or onto it
            continue
        found += 1
        yield case, truth


def options(case: Case) -> dict[str, Any]:
    """Return the keywords of the mechanism's class."""
    return {**case.parameters, "assembly": case.assembly}

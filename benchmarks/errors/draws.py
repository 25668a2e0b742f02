"""Mechanisms in the plane that are drawn where trouble is: families of poses beyond those of tests.

The families of `tests.kinematics.families` measure the last length off a pose.  Here are numbers
that coincide: few digits, equal lengths, tiny offsets, angles of whole twelfths of a turn; and each
of that but for a little, which may be as small as the last digit.
"""

from __future__ import annotations

from collections.abc import Iterator

from tests.kinematics.families import FAMILIES, SAMPLERS, SCALES, Case, Draw, exists, scaled, turn


class Deep(Draw):
    """Draws what is tiny down to the last digit."""

    def tiny(self, least: float, most: float = 1.0) -> float:
        return super().tiny(16.0, most)


class Few(Deep):
    """Draws numbers of few digits, which often are equal to each other, or almost."""

    def length(self, decades: float = 1.0) -> float:
        whole = self.choice((1.0, 1.0, 2.0, 2.0, 3.0, 4.0, 5.0, 8.0, 0.5, 10.0**-decades))
        return whole * (1.0 + self.nothing_or_little())

    def angle(self) -> float:
        whole = self.choice((0.0, 30.0, 45.0, 60.0, 90.0, 120.0, 135.0, 150.0, 180.0, -90.0, 15.0))
        return whole + self.nothing_or_little() * self.choice((1.0, 90.0))

    def nothing_or_little(self) -> float:
        return self.choice((0.0, 0.0, 0.0, self.tiny(16.0)))


def _four_bar(draw: Few) -> dict[str, float]:
    sizes = {name: draw.length() for name in ("ground", "crank", "coupler", "rocker")}
    return sizes | {"ground_angle": draw.choice((0.0, draw.angle()))}


def _slider_crank(draw: Few) -> dict[str, float]:
    offset = draw.choice((0.0, draw.length(), draw.sign() * draw.tiny(16.0)))
    return {"crank": draw.length(), "rod": draw.length(), "offset": offset}


def _slotted(arm: str, ram: bool, draw: Few) -> dict[str, float]:
    sizes = {name: draw.length() for name in ("ground", "crank", arm)}
    sizes["ground_angle"] = draw.choice((-90.0, 0.0, draw.angle()))
    if ram:
        heights = [0.0, draw.tiny(16.0), draw.sign() * draw.length()]
        heights += [-sizes["ground"], sizes["ground"], sizes["crank"]]
        sizes |= {"rod": draw.length(), "ram_height": draw.choice(heights)}
        if arm == "arm" and draw.random() < 0.2:
            del sizes["ram_height"]  # then the ram is level with the lever's pivot
    return sizes


def _coincidence(variant: str, draw: Few) -> tuple[dict[str, float], dict[str, float]]:
    name = SAMPLERS[variant][0]
    if name == "four-bar":
        sizes = _four_bar(draw)
    elif name == "slider-crank":
        sizes = _slider_crank(draw)
    elif name in ("crank-slotted-lever", "whitworth"):
        arm = "lever" if name == "crank-slotted-lever" else "arm"
        sizes = _slotted(arm, variant.endswith("ram"), draw)
    elif name == "elliptical-trammel":
        sizes = {"link": draw.length(), "tracer": draw.sign() * draw.length()}
    elif name == "scotch-yoke":
        sizes = {"crank": draw.length()}
    else:
        rates = {"velocity": draw.length(), "acceleration": draw.choice((0.0, draw.length()))}
        if name == "double-slider":
            sizes = {"link": draw.length(), "guide_a": draw.angle(), "guide_b": draw.angle()}
            return sizes, {"position": draw.sign() * draw.length(), **rates}
        sizes = {"ground": draw.length(), "arm": draw.length(), "ground_angle": draw.angle()}
        return sizes, {"position": draw.length(), **rates}
    return sizes, {"angle": draw.angle(), **draw.rates()}


def _folded(variant: str, draw: Few) -> tuple[dict[str, float], dict[str, float]]:
    """Return a pose in which links lie on each other all the time, or a toggle to its last ε."""
    name, one, other = SAMPLERS[variant][0], Draw.length(draw), Draw.length(draw)
    alike, last = 1.0 + draw.nothing_or_little(), 1.0 - 2.0**-53 * draw.randint(0, 32)
    rates = {"velocity": draw.sign() * one, "acceleration": draw.choice((0.0, other))}
    inputs = {"angle": Draw.angle(draw), **draw.rates()}
    if name == "four-bar":
        turned = draw.choice((0.0, Draw.angle(draw)))
        kite = {"ground": one, "crank": other, "coupler": other * alike, "rocker": one}
        return kite | {"ground_angle": turned}, inputs
    if name == "slider-crank":
        offset = one * draw.nothing_or_little()
        return {"crank": one, "rod": one * alike, "offset": offset}, inputs
    if name == "double-slider":
        guides = {"guide_a": draw.angle(), "guide_b": draw.angle()}
        sine = abs(turn(guides["guide_a"] - guides["guide_b"]).imag)
        return {"link": one, **guides}, {"position": one / (sine or 1.0) * last, **rates}
    if name == "gate-actuator":
        gap = abs(one + draw.sign() * other)
        sizes = {"ground": one, "arm": other, "ground_angle": draw.choice((180.0, draw.angle()))}
        return sizes, {"position": gap * draw.choice((last, 1.0 / last, alike)), **rates}
    arm = "lever" if name == "crank-slotted-lever" else "arm"
    sizes = {"ground": one, "crank": other, arm: Draw.length(draw), "ground_angle": 0.0}
    height = draw.choice((0.0, sizes[arm] * draw.nothing_or_little()))
    sizes |= {"rod": sizes[arm] * alike, "ram_height": height}
    return sizes, inputs | {"angle": draw.choice((0.0, 180.0, inputs["angle"])) + draw.tiny(16.0)}


def _other_rates(inputs: dict[str, float], draw: Draw) -> dict[str, float]:
    """Return the inputs with rates that are tiny, huge or nothing."""
    names = [name for name in inputs if name not in ("angle", "position")]
    rates = {name: draw.sign() * 10.0 ** draw.uniform(-130, 59) for name in names}
    nothing = draw.choice((*names, None))
    return inputs | rates | ({nothing: 0.0} if nothing else {})


FOLDED = [name for name in SAMPLERS if name.endswith("ram")]
FOLDED += ["four-bar", "slider-crank", "double-slider", "gate-actuator"]
OTHERS = ("deep", "coincidence", "folded", "rates")


def _drawn(
    variant: str, family: str, draw: Draw, deep: Deep, few: Few
) -> tuple[dict[str, float], dict[str, float]]:
    sampler = SAMPLERS[variant][1]
    if family == "deep":
        near = [x for x in ("toggle", "change point", "near pivot") if exists(variant, x)]
        return sampler(deep.choice(near), deep)
    if family == "folded":
        return _folded(variant, few)
    if family == "coincidence":
        return _coincidence(variant, few)
    return sampler("random" if family in (*SCALES, "rates") else family, draw)


def planar(seed: int | str, plain: float = 0.1) -> Iterator[tuple[str, str, Case]]:
    """Yield variants, families and poses without end; some may not close.

    ``plain`` is the share of those of the family "random".
    """
    draw, deep, few = (cls(f"{cls.__name__} {seed}") for cls in (Draw, Deep, Few))
    variants = list(SAMPLERS)
    while True:
        variant = draw.choice(variants)
        family = "random" if draw.random() < plain else draw.choice((*FAMILIES, *OTHERS, *OTHERS))
        if not exists(variant, family) or (family == "folded" and variant not in FOLDED):
            continue
        try:
            parameters, inputs = _drawn(variant, family, draw, deep, few)
        except ZeroDivisionError:  # the pin is on the lever's pivot
            continue
        if family == "rates":
            inputs = _other_rates(inputs, draw)
        factor = SCALES.get(family, 1.0)
        side = draw.choice(("open", "crossed"))
        yield (
            variant,
            family,
            Case(SAMPLERS[variant][0], scaled(parameters, factor), scaled(inputs, factor), side),
        )

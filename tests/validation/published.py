"""Published examples: a case of cases.json goes in, a mechanism of the program comes out.

A scene also says how the book's quantities follow from the results, read through a view with
``link``, ``point`` and ``slide``: the program's own motion, or the oracle's.
"""

from __future__ import annotations

import cmath
import json
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from mpmath import mp

from tests.oracle import reference

CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_name("cases.json").read_text())
Numbers = dict[str, float]


@dataclass(frozen=True)
class Scene:
    """One example in the words of the program."""

    name: str
    parameters: Numbers
    inputs: Numbers
    results: Callable[[Any], Numbers]
    assembly: str = "open"
    given_back: Numbers = field(default_factory=dict)
    """Where the book drives another link: its input, which must come out of the inverted scene."""


def truth(scene: Scene) -> SimpleNamespace:
    """Solve a scene with the oracle and show it like a motion."""
    items: dict[tuple[str, str], dict[str, Any]] = {}
    solved = reference(scene.name, scene.parameters, scene.inputs, scene.assembly, conditions=False)
    for (kind, name, attribute), quantity in solved.items():
        value = quantity.value * 180 / mp.pi if attribute == "angle" else quantity.value
        number = complex(value) if kind == "point" else float(value)
        items.setdefault((kind, name), {})[attribute] = number

    def look_up(kind: str) -> Callable[[str], SimpleNamespace]:
        return lambda name: SimpleNamespace(**items[kind, name])

    return SimpleNamespace(link=look_up("link"), point=look_up("point"), slide=look_up("slide"))


# --- what books print -------------------------------------------------------------------------


def vector(name: str, rate: str, value: complex) -> Numbers:
    return {
        f"{name}_{rate}": abs(value),
        f"{name}_{rate}_dir_deg": math.degrees(cmath.phase(value)),
    }


def moving_point(name: str, view: Any, base: str, link: str, arm: complex) -> Numbers:
    """Return the rates of the point ``arm`` away from ``base`` on a turning link."""
    start, turning = view.point(base), view.link(link)
    velocity = start.velocity + 1j * turning.omega * arm
    acceleration = start.acceleration + (1j * turning.alpha - turning.omega**2) * arm
    return {**vector(name, "velocity", velocity), **vector(name, "acceleration", acceleration)}


def turning(number: int, link: Any, shift: float = 0.0) -> Numbers:
    return {
        f"theta{number}_deg": link.angle + shift,
        f"omega{number}": link.omega,
        f"omega{number}_abs": abs(link.omega),
        f"alpha{number}": link.alpha,
        f"alpha{number}_abs": abs(link.alpha),
    }


def sliding(name: str, slide: Any) -> Numbers:
    return {
        f"{name}_position": slide.position,
        f"{name}_velocity": slide.velocity,
        f"{name}_speed": abs(slide.velocity),
        f"{name}_acceleration": slide.acceleration,
        f"{name}_acceleration_abs": abs(slide.acceleration),
    }


def between(view: Any, start: str, end: str) -> complex:
    return view.point(end).position - view.point(start).position


def crank_input(given: dict[str, Any], shift: float = 0.0) -> Numbers:
    return {
        "angle": float(given["theta2_deg"]) + shift,
        "omega": float(given["omega2"]),
        "alpha": float(given.get("alpha2", 0.0)),
    }


# --- one scene for each family of examples ----------------------------------------------------


def four_bar(case: dict[str, Any]) -> Scene:
    given = case["inputs"]

    def results(view: Any) -> Numbers:
        b, c = view.point("B"), view.point("C")
        found = {**turning(3, view.link("coupler")), **turning(4, view.link("rocker"))}
        for name, point in (("B", b), ("C", c)):
            found |= vector(name, "velocity", point.velocity)
            found |= vector(name, "acceleration", point.acceleration)
        found["relCB_velocity"] = abs(c.velocity - b.velocity)
        if "E_from_C" in given:
            arm = between(view, "C", "B")
            arm *= given["E_from_C"] / abs(arm)
            found |= moving_point("E", view, "C", "coupler", arm)
        return found

    links = {name: given[name] for name in ("ground", "crank", "coupler", "rocker")}
    assembly = case["branch"].split()[0]
    return Scene("four-bar", links, crank_input(given), results, assembly)


def slider_crank(case: dict[str, Any]) -> Scene:
    given = case["inputs"]
    guide = given.get("guide_deg", 0.0)

    def tracers(view: Any) -> Numbers:
        rod, found = between(view, "B", "C"), {}
        for key, value in given.items():
            name, _, what = key.partition("_")
            if what == "fraction_from_crankpin":
                arm = rod * complex(value, given[f"{name}_offset_fraction_left"])
                found |= moving_point(name, view, "B", "rod", arm)
            if what == "from_crankpin":  # X on the right of B → C, Y on the left
                side = -1 if name == "X" else 1
                along = value**2 + abs(rod) ** 2 - given[f"{name}_from_slider"] ** 2
                along /= 2 * abs(rod)
                arm = rod / abs(rod) * complex(along, side * math.sqrt(value**2 - along**2))
                found |= moving_point(name, view, "B", "rod", arm)
        return found

    def results(view: Any) -> Numbers:
        relative = view.point("C").velocity - view.point("B").velocity
        return {
            **turning(3, view.link("rod"), shift=guide),
            **sliding("slider", view.slide("slider")),
            "relXB_velocity": abs(relative),
            **tracers(view),
        }

    links = {name: given[name] for name in ("crank", "rod", "offset")}
    assembly = "crossed" if "on - side" in case["branch"] else "open"
    return Scene("slider-crank", links, crank_input(given, -guide), results, assembly)


LADDERS = {
    "ds-orhan": 120.0,
    "ds-tayal-21.4": 150.0,
    "ds-hibbeler-16.6": -45.0,
    "ds-schaum-14.9": -150.0,
    "ds-meriam-5/6": -30.0,
}
"""Direction A → B of the link in each of the double sliders."""


def ladder_results(view: Any) -> Numbers:
    arm = between(view, "A", "B") / 2
    return {
        **turning(3, view.link("link")),
        **sliding("sliderB", view.slide("slider_b")),
        **moving_point("mid", view, "A", "link", arm),
    }


def double_slider(case: dict[str, Any]) -> Scene:
    given, direction = case["inputs"], LADDERS[case["id"]]
    guides = {"guide_a": given["guideA_deg"], "guide_b": given["guideB_deg"]}
    link = given.get("rod", given.get("b"))
    to_b = math.radians(direction - guides["guide_b"])
    angle_between = math.radians(guides["guide_a"] - guides["guide_b"])
    position = given.get("xA", -link * math.sin(to_b) / math.sin(angle_between))

    def results(view: Any) -> Numbers:
        found = ladder_results(view)
        if "theta_deg" in case["exact"]:  # this book's angle grows clockwise
            found["theta_deg"] = -found["theta3_deg"]
            found |= {"omega3": -found["omega3"], "alpha3": -found["alpha3"]}
        return found

    rates = {"velocity": given["vA"], "acceleration": given.get("aA", 0.0)}
    assembly = "open" if math.cos(to_b) > 0 else "crossed"
    inputs = {"position": position, **rates}
    return Scene("double-slider", {"link": link, **guides}, inputs, results, assembly)


def ladder_driven_by_its_link(case: dict[str, Any]) -> Scene | None:
    """The same ladder as an elliptical trammel, if its guides are the axes."""
    given, exact = case["inputs"], case["exact"]
    if (given.get("guideA_deg"), given.get("guideB_deg")) != (0.0, 90.0):
        return None
    link = given["rod"]

    def results(view: Any) -> Numbers:
        found = ladder_results(view)
        found |= moving_point("P", view, "A", "link", between(view, "A", "P"))
        tracer = view.point("P")
        found |= vector("mid", "velocity", tracer.velocity)
        found |= vector("mid", "acceleration", tracer.acceleration)
        return {**found, **sliding("A", view.slide("slider_a"))}

    return Scene(
        "elliptical-trammel",
        {"link": link, "tracer": link / 2},
        {"angle": exact["theta3_deg"], "omega": exact["omega3"], "alpha": exact["alpha3"]},
        results,
        given_back={"A_velocity": given["vA"], "A_acceleration": given.get("aA", 0.0)},
    )


def slotted_results(view: Any) -> Numbers:
    lever, block = view.link("lever"), view.slide("block")
    return {
        **turning(4, lever),
        **sliding("sliding", block),
        "slot_distance": block.position,
        "coriolis_acceleration": block.coriolis,
        "coincident_velocity": abs(lever.omega * block.position),
    }


def from_centre(given: dict[str, Any]) -> complex:
    """Return the lever's pivot as seen from the crank's."""
    pivot = complex(given["slot_pivot_x"], given["slot_pivot_y"])
    return pivot - complex(given["crank_centre_x"], given["crank_centre_y"])


def ground_of(pivot: complex) -> Numbers:
    return {"ground": abs(pivot), "ground_angle": math.degrees(cmath.phase(pivot))}


def slotted_lever(case: dict[str, Any]) -> Scene:
    given = case["inputs"]
    parameters = {**ground_of(from_centre(given)), "crank": float(given["crank"]), "lever": 1.0}
    return Scene("crank-slotted-lever", parameters, crank_input(given), slotted_results)


def whitworth(case: dict[str, Any]) -> Scene:
    given = case["inputs"]

    def results(view: Any) -> Numbers:
        ram = sliding("ram", view.slide("ram"))
        return {**slotted_results(view), **turning(5, view.link("rod")), **ram}

    parameters = {
        **ground_of(from_centre(given)),
        "crank": float(given["crank"]),
        "arm": -float(given["ram_arm"]),
        "rod": float(given["ram_rod"]),
        "ram_height": given["ram_line_y"] - given["crank_centre_y"],
    }
    return Scene("whitworth", parameters, crank_input(given), results)


def rotary_engine(case: dict[str, Any]) -> Scene:
    """The cylinder is the slotted lever and turns evenly; the rod is the crank."""
    given, exact = case["inputs"], case["exact"]
    centre = complex(given["A_x"], given["A_y"])
    pin = exact["slot_distance"] * cmath.exp(1j * math.radians(given["cylinder_deg"])) - centre

    def results(view: Any) -> Numbers:
        piston = view.point("B")
        return {
            **slotted_results(view),
            **{f"{k}_rod": getattr(view.link("crank"), k) for k in ("omega", "alpha")},
            **{f"{k}_rod_abs": abs(getattr(view.link("crank"), k)) for k in ("omega", "alpha")},
            **vector("B", "velocity", piston.velocity),
            **vector("B", "acceleration", piston.acceleration),
        }

    return Scene(
        "crank-slotted-lever",
        {**ground_of(-centre), "crank": given["rod"], "lever": 1.0},
        {
            "angle": math.degrees(cmath.phase(pin)),
            "omega": exact["omega_rod"],
            "alpha": exact["alpha_rod"],
        },
        results,
        given_back={
            "theta4_deg": given["cylinder_deg"],
            "omega4": given["omega_cylinder"],
            "alpha4": given["alpha_cylinder"],
        },
    )


def scotch_yoke(case: dict[str, Any]) -> Scene:
    given, exact = case["inputs"], case["exact"]
    return Scene(
        "scotch-yoke",
        {"crank": given["crank"]},
        {"angle": 180.0 - given["theta_from_minus_x_deg"], **exact},
        lambda view: {
            **sliding("yoke", view.slide("yoke")),
            "omega": view.link("crank").omega,
            "alpha": view.link("crank").alpha,
        },
        given_back={f"yoke_{rate}": given[f"yoke_{rate}"] for rate in ("velocity", "acceleration")},
    )


def driven_by_its_slider(case: dict[str, Any]) -> Scene:
    """Hibbeler's slider-crank, guide at 90°: the answers drive it, its slider gives the input."""
    given, exact = case["inputs"], case["exact"]
    quarter = -1j  # turns the upright guide onto +x
    pin = quarter * (complex(given["C_x"], given["C_y"]) + complex(0.2, -0.2))
    slider = quarter * complex(given["C_x"], given["C_y"])

    def results(view: Any) -> Numbers:
        crank, rod = view.link("crank"), view.link("rod")
        return {
            "omega_AB": crank.omega,
            "alpha_AB": crank.alpha,
            "omega_CB": rod.omega,
            "alpha_CB": rod.alpha,
            **sliding("C", view.slide("slider")),
        }

    return Scene(
        "slider-crank",
        {"crank": given["AB"], "rod": given["CB"], "offset": slider.imag},
        {
            "angle": math.degrees(cmath.phase(pin)),
            "omega": exact["omega_AB"],
            "alpha": exact["alpha_AB"],
        },
        results,
        "open" if slider.real > pin.real else "crossed",
        given_back={"C_velocity": given["vC"], "C_acceleration": given["aC"]},
    )


SCENES: dict[str, Callable[[dict[str, Any]], Scene]] = {
    "4bar": four_bar,
    "sc": slider_crank,
    "sco": slider_crank,
    "ds": double_slider,
    "qr": slotted_lever,
    "whit": whitworth,
    "geneva": slotted_lever,
    "slot": slotted_lever,
    "rot": rotary_engine,
    "yoke": scotch_yoke,
    "inv-hibbeler": driven_by_its_slider,
}


def scene(case: dict[str, Any]) -> Scene | None:
    """Return a case in the program's words, or nothing if it has no such mechanism."""
    parts = case["id"].split("-")
    build = SCENES.get("-".join(parts[:2])) or SCENES.get(parts[0])
    return build(case) if build else None


def misses(measured: Numbers, wanted: Numbers, rel: float, absolute: float) -> dict[str, Any]:
    """Return what differs, angles modulo 360; every wanted quantity must have been measured."""
    found = {}
    for name, value in wanted.items():
        gap = measured[name] - value
        if name.endswith("_deg"):
            gap = (gap + 180) % 360 - 180
        if not abs(gap) <= max(rel * abs(value), absolute):
            found[name] = (measured[name], value)
    return found

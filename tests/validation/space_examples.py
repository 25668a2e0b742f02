"""Examples in space: a case of space.json goes in, what the program finds comes out.

The cases of the ball-jointed four-bar lie anywhere in space: they are moved into the program's
frame, which has A at its origin, z along A's axis and x along the common normal.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np

import vad

CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_name("space.json").read_text())
INPUTS = ("angle", "omega", "alpha")


def numbers(case: dict[str, Any]) -> dict[str, Any]:
    """Return what the program finds, under the names of the case."""
    return {"hooke-joint": hooke, "rssr": balls}.get(case["mechanism"], axes)(case)


def motion_of(case: dict[str, Any], **inputs: float) -> Any:
    given = case["inputs"]
    sizes = {name: value for name, value in given.items() if name not in INPUTS}
    rates = {name: given[name] for name in INPUTS} | inputs
    return vad.solve(vad.MECHANISMS[case["mechanism"]](**sizes), **rates)


def hooke(case: dict[str, Any]) -> dict[str, Any]:
    motion = motion_of(case)
    driven = motion.link("driven")
    slowest = motion_of(case, angle=90.0).link("driven").omega
    # The mock-ups look at the plane of the shafts with the driving one pointing down.
    relative = driven.omega * axis(motion) - np.array([0.0, 0.0, case["inputs"]["omega"]])
    return {
        "theta4_deg": driven.angle,
        "omega4": driven.omega,
        "alpha4": driven.alpha,
        "omega32": abs(motion.joint("P").omega),  # the cases have sizes
        "omega34": abs(motion.joint("Q").omega),
        "omega3": float(np.linalg.norm(motion.link("cross").omega)),
        "omega42": list(-relative[1:]),
        "fluctuation_rpm": (driven.omega - slowest) * 60.0 / math.tau,
    }


def axis(motion: Any) -> Any:
    """Return the driven shaft's axis, square to Q and to its velocity."""
    q = motion.point("Q")
    axis = np.cross(q.position, q.velocity) / motion.link("driven").omega
    return axis / np.linalg.norm(axis)


def axes(case: dict[str, Any]) -> dict[str, Any]:
    motion = motion_of(case)
    found: dict[str, Any] = {"theta_D_deg": motion.link("rocker").angle}
    for number, part in ((32, motion.joint("B")), (34, motion.joint("C"))):
        found |= {f"omega{number}": part.omega, f"alpha{number}": part.alpha}
    rocker = motion.link("rocker")
    found |= {"omega4": rocker.omega, "alpha4": rocker.alpha}
    for letter in "BC":
        found[f"theta_{letter}_deg"] = motion.joint(letter).angle
    coupler = motion.link("coupler")
    found |= {"omega3": list(coupler.omega), "alpha3": list(coupler.alpha)}
    solver = motion.solver
    axis, turning = (
        solver.axis(motion.pose),
        solver.axis_velocity(motion.pose, motion.velocity),
    )
    if not motion.slides:
        found |= {letter.lower(): list(motion.point(letter).position) for letter in "BC"}
        return found | {"AI_deg": axis.tau, "omega42": turning.omega, "tau_rate": turning.tau}
    for letter in "BCD":
        slide = motion.slide(f"slide_{letter.lower()}")
        rates = slide.position, slide.velocity, slide.acceleration
        found |= dict(zip((f"s_{letter}", f"v_{letter}", f"a_{letter}"), rates, strict=True))
    found["points"] = {
        "B2": list(motion.point("B").position),
        "C3": list(motion.point("C").position),
    }
    found |= {"AI_deg": axis.tau, "AH": axis.height, "v42": turning.omega.dual}
    return found | {"omega42": turning.omega.real, "tau_rate": turning.tau.real}


def balls(case: dict[str, Any]) -> dict[str, Any]:
    given = case["inputs"]
    sizes, leads, frame = placed(given)
    rates = {name: given[name] for name in ("omega", "alpha")}
    sizes["assembly"] = given["assembly"]
    motion = vad.solve(vad.RSSR(**sizes), angle=given["angle"] + leads[0], **rates)
    rocker, coupler = motion.link("rocker"), motion.link("coupler")
    angle = (rocker.angle - leads[1]) % 360.0
    found = {
        "theta4_deg": angle,
        "theta4_rad": math.radians(angle),
        "omega4": rocker.omega,
        "alpha4": rocker.alpha,
        "omega3_without_spin": list(coupler.omega @ frame),
        "alpha3_without_spin": list(coupler.alpha @ frame),
    }
    for letter in "BC":
        point = motion.point(letter)
        found[letter] = list(point.position @ frame + given["A"])
        found[f"{letter}_velocity"] = list(point.velocity @ frame)
        found[f"{letter}_acceleration"] = list(point.acceleration @ frame)
    return found


def placed(given: dict[str, Any]) -> tuple[dict[str, Any], list[float], Any]:
    """Return the program's parameters, where both angles begin, and its axes as rows."""
    a, d = (unit(np.array(given[name], float)) for name in ("crank_axis", "rocker_axis"))
    way = np.array(given["D"], float) - np.array(given["A"], float)
    normal = np.cross(a, d)
    parallel = bool(np.linalg.norm(normal) < 1e-12)
    x = unit(way - a * (way @ a) if parallel else normal)
    # A + ground·x - crank_offset·a + rocker_offset·d = D
    columns = np.array([x, a if parallel else -a, d]).T
    ground, from_a, from_d = np.linalg.lstsq(columns, way, rcond=None)[0]
    sizes = {name: given[name] for name in ("crank", "coupler", "rocker")}
    sizes |= {
        "ground": float(ground),
        "crank_offset": float(from_a),
        "rocker_offset": float(from_d),
    }
    sizes["ground_twist"] = math.degrees(math.atan2(np.cross(a, d) @ x, a @ d))
    leads = []
    for axis, zero in ((a, given["crank_zero"]), (d, given["rocker_zero"])):
        start = np.array(zero, float)
        leads.append(math.degrees(math.atan2(start @ np.cross(axis, x), start @ x)))
    return sizes, leads, np.array([x, np.cross(a, x), a])


def unit(vector: Any) -> Any:
    return vector / np.linalg.norm(vector)

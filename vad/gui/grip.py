"""What the hand holds: in comes a pose, out go the places that turn a pointer into a number.

Places are in pixels of a page 1280 wide, y down, as in the drawings.
"""

from __future__ import annotations

from typing import Any

import vad
from vad.kinematics.motion import Motion
from vad.plan.format import Format
from vad.plan.pictures.views import held_arc, tip_of
from vad.plan.scale import Scale
from vad.strokes.sheet import Arrow, Block, Sheet


def grip(motion: Motion, sheet: Sheet, scale: Scale, form: Format) -> dict[str, Any] | None:
    """Return the handle on the pin, strut or block that is driven; None where none is drawn.

    In views it is at the end of the driven angle's arc, where that is seen in true size from the
    right on.

    Returns
    -------
    dict
        ``kind``, ``name`` of the input, and where it is, ``at``.  An "angle" is measured at
        ``about``; a "length" from there, ``factor`` pixels to the unit; a "slide" along ``way``
        from ``about``.
    """

    def place(z: complex) -> list[float]:
        return [round(z.real * form.unit, 2), round((form.height - z.imag) * form.unit, 2)]

    name, factor = next(iter(motion.mechanism.inputs)), scale.factor * form.unit
    panel, driver = sheet.panel("position"), sheet.driver
    arc = held_arc(panel, driver)
    if arc:
        spots = {"at": place(scale(tip_of(arc))), "about": place(scale(arc.centre))}
        return {"kind": "angle", "name": name, **spots, "factor": factor}
    index = panel.find(driver.stroke)
    if index is None:
        return None
    shape = panel.strokes[index].shape
    if isinstance(shape, Arrow):
        kind = "angle" if driver.turns else "length"
        about, at = scale(shape.start), scale(shape.end)
        return {
            "kind": kind,
            "name": name,
            "at": place(at),
            "about": place(about),
            "factor": factor,
        }
    if not isinstance(shape, Block):
        return None
    way = _way(motion, panel.strokes[index].label)
    about = scale(shape.at - float(motion.inputs[name]) * way)
    return {
        "kind": "slide",
        "name": name,
        "at": place(scale(shape.at)),
        "about": place(about),
        "way": [way.real, -way.imag],
        "factor": factor,
    }


def _way(motion: Motion, letter: str) -> complex:
    """Return where a driven point goes."""
    place, speed, *_ = motion.inputs
    moved = vad.solve(motion.mechanism, **{place: motion.inputs[place], speed: 1.0})
    return complex(moved.point(letter).velocity)

"""The check by power: what the drive gives, the loads take."""

from __future__ import annotations

from typing import TYPE_CHECKING

from vad.kinematics.numbers import dot
from vad.strokes.arithmetic import Figure, Terms, product, total
from vad.strokes.sentences import Listed, Sentence, SentencePart, Unit
from vad.strokes.vector_equations import NOTHING
from vad.units import metres_of

if TYPE_CHECKING:
    from vad.strokes.scene import Scene

#: The most loads whose powers are listed one by one.
MOST = 4


def check_by_power(scene: Scene, drive: str, rate: str) -> Sentence | None:
    """Say that the powers of the drive and of all loads add up to zero; None where nothing moves.

    Parameters
    ----------
    scene
        The pose, with its forces.
    drive, rate
        The symbols of the drive and of the rate of what is driven: T and ω₂, Fₐ and v.
    """
    names = scene.force_names
    found, driver = names.forces, scene.driver
    turns = driver.kind == "angle"
    metres = metres_of(scene.unit) or 1.0
    speed = scene.rate(driver.name, 1) if turns else scene.speed(driver.name, 1) * metres
    whole, sizes = found.power
    given = found.drive * speed
    if sizes <= 0.0 or abs(given) <= NOTHING * sizes:
        return None
    powers = _powers(scene, metres)
    powers = [(symbol, power) for symbol, power in powers if abs(power) > NOTHING * sizes]
    length = "m" if metres_of(scene.unit) else scene.unit
    unit = "W" if metres_of(scene.unit) else f"N {length}/s"
    taken = Figure(whole - given, unit)
    parts: dict[str, SentencePart] = {
        "drive": drive,
        "symbol": rate,
        "value": Figure(found.drive, found.drive_unit),
        "unit": Unit(found.drive_unit),
        "rate": Figure(speed, "rad/s" if turns else f"{length}/s", given=True),
        "fast": Unit("rad/s" if turns else f"{length}/s"),
        "power": Figure(given, unit),
        "watt": Unit(unit),
        "symbols": Listed(tuple(symbol for symbol, _ in powers), " + "),
        "terms": Terms(tuple(Figure(power, unit) for _, power in powers)),
        "taken": taken,
    }
    calculated = [product("power", "value", "rate")]
    if len(powers) == 1:
        return scene.say("power one", *calculated, **parts)
    if 1 < len(powers) <= MOST:
        return scene.say("power", *calculated, total("taken", "terms"), **parts)
    return scene.say("power all", *calculated, **parts)


def _powers(scene: Scene, metres: float) -> list[tuple[str, float]]:
    """Return the powers of all loads by the symbols of their products: P·v_E, M·ω₄."""
    names = scene.force_names
    found = []
    for load in names.loads:
        power = dot(load.force, scene.image(load.point, 1)) * metres
        found.append((f"{names.load(load)}·v_{load.point}", power))
    for couple in names.couples:
        link = str(names.bodies[couple.body].link)
        power = couple.value * scene.rate(link, 1)
        found.append((f"{names.couple(couple)}·{scene.members.symbol('ω', link)}", power))
    return found

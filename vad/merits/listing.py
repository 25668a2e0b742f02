"""Figures of merit as a table in plain text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from typing import TYPE_CHECKING, Any

from vad.kinematics.results import block, place_unit
from vad.words import Language
from vad.written import DIGITS, typed

if TYPE_CHECKING:
    from vad.merits.merit import Merit


def table(merit: Merit, digits: int = DIGITS, language: str = "en") -> str:
    """Return the figures of merit in aligned columns of text, with units."""
    say, unit = Language(language), merit.motion.mechanism.length_unit
    lines = _lines(merit, digits, say)
    width = max(len(name) for name, _ in lines) + 2
    blocks = [
        "\n".join(f"{name:{width}}{said}" for name, said in lines),
        rubbing_table(merit["rubbing"], unit, digits, language),
        _slowest(merit["slowest"] or {}, unit, digits, say),
    ]
    return "\n\n".join(filter(None, blocks))


def extremes_table(
    merit: Merit, results: Iterable[str], digits: int = DIGITS, language: str = "en"
) -> str:
    """Return the extremes of the output and of other results, with the places where they occur."""
    place, say = place_unit(merit.motion.mechanism).strip(), Language(language).say
    rows = {
        name: {key: say("merit none") if value is None else value for key, value in each.items()}
        for name, each in merit.extremes(results).items()
        if each
    }
    at = f"{say('merit place')}, {place}"
    head = [say("merit extremes"), say("merit minimum"), at, say("merit maximum"), at]
    return block(head, rows, digits)


def rubbing_table(
    found: list[dict[str, Any]], unit: str, digits: int = DIGITS, language: str = "en"
) -> str:
    """Return velocities of rubbing, as JSON has them, as a table."""
    words = Language(language)
    say, name = words.say, words.name
    rows = {
        say("merit pair", pin=each["pin"], one=name(each["of"]), other=name(each["against"])): {
            "diameter": each["diameter"],
            "velocity": each["velocity"],
        }
        for each in found
    }
    diameter, velocity = f"{say('merit diameter')}, {unit}", f"{say('merit velocity')}, {unit}/s"
    return block([say("merit rubbing"), diameter, velocity], rows, digits)


def _lines(merit: Merit, digits: int, language: Language) -> list[tuple[str, str]]:
    """Return the name of each figure, and what is said of it."""
    found, mechanism, say = dict(merit), merit.motion.mechanism, language.say
    place, transmission = place_unit(mechanism), found["transmission"]
    slides = merit.output is not None and merit.output[0] == "slide"

    def number(value: float | None, unit: str = "") -> str:
        return "" if value is None else f"{typed(value, '', digits)}{unit}"

    def ranges(ends: Sequence[Sequence[float]]) -> str:
        if merit.turns and ends == [[0.0, 360.0]]:
            return say("merit every angle")
        pairs = [f"{number(low, place)} … {number(high, place)}" for low, high in ends]
        return reduce(lambda first, last: say("merit and", first=first, last=last), pairs or [""])

    def extreme(which: str) -> str:
        if transmission is None:
            return ""
        value, where = number(transmission[which], "°"), number(transmission[f"{which}_at"], place)
        return say("merit at", value=value, place=where)

    said = {
        "merit output": language.name(found["output"]) if found["output"] else "",
        "merit grashof": say(f"grashof {found['grashof']}") if found["grashof"] else "",
        "merit ranges": ranges(found["ranges"]),
        "merit dead": ", ".join(number(each, place) for each in found["dead_centres"]),
        "stroke": number(found["stroke"], f" {mechanism.length_unit}" if slides else "°"),
        "time ratio": number(found["time_ratio"]),
        "forward angle": number(found["forward_angle"], "°"),
        "return angle": number(found["return_angle"], "°"),
        "merit least": extreme("least"),
        "merit largest": extreme("largest"),
    }
    if found["advantage"] is not None:
        said["mechanical advantage"] = number(found["advantage"])
    return [(say(name), value or say("merit none")) for name, value in said.items()]


def _slowest(found: dict[str, Any], unit: str, digits: int, language: Language) -> str:
    say = language.say
    rows = {
        language.name(name): {
            "distance": each["distance"],
            "position": each["position"],
            "speed": abs(complex(*each["velocity"])),
            "on": say("merit yes" if each["on_link"] else "merit no"),
        }
        for name, each in found.items()
        if each
    }
    distance, speed = f"{say('merit distance')}, {unit}", f"{say('merit speed')}, {unit}/s"
    head = [distance, f"x, {unit}", f"y, {unit}", speed]
    return block([say("merit slowest"), *head, say("merit on link")], rows, digits)

"""Poses of every mechanism in the plane: its defaults, then at random, always the same ones."""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest

import vad
from tests.invariants.test_motion import defaults, optional, well_away_from_a_dead_centre
from tests.kinds import PLANE
from vad.kinematics.linkage import Slide
from vad.kinematics.motion import Motion
from vad.strokes.sheet import Arrow, Panel, Sheet, Stroke
from vad.words import languages

COUNT = 10
ORDERS = {"position": 0, "velocity": 1, "acceleration": 2}

everything = pytest.mark.parametrize("name", PLANE)
in_every_language = pytest.mark.parametrize("code", languages())


@cache
def poses(name: str) -> tuple[Motion, ...]:
    """Return motions of a mechanism: any quadrant, both senses, both assemblies, all parts."""
    kind = PLANE[name]
    chance = random.Random(name)
    found = [vad.solve(kind())]
    while len(found) < COUNT:
        mechanism, inputs = _drawn(kind, chance)
        if well_away_from_a_dead_centre(mechanism, inputs):
            found.append(vad.solve(mechanism, **inputs))
    return tuple(found)


def _drawn(kind: Any, chance: random.Random) -> tuple[Any, dict[str, float]]:
    numbers = {**defaults(kind), **(optional(kind) if chance.random() < 0.5 else {})}
    # Three decimals, as somebody would give them.
    sizes = {key: round(value * chance.uniform(0.8, 1.25), 3) for key, value in numbers.items()}
    first, second, third = kind.inputs
    place = kind.inputs[first] * chance.uniform(0.8, 1.25)
    speed = abs(kind.inputs[second]) or 1.0
    inputs = {
        first: chance.uniform(-360, 360) if first == "angle" else place,
        second: speed * chance.choice([-1, 1]) * chance.uniform(0.1, 10),
        third: speed * chance.choice([-1, 0, 1]) * chance.uniform(0.1, 10),
    }
    return kind(**sizes, assembly=chance.choice(["open", "crossed"])), inputs


def strokes(name: str, code: str) -> Iterator[tuple[Motion, Panel, Stroke]]:
    """Yield every stroke of every pose in one language, with its motion and panel."""
    for motion in poses(name):
        for panel in drawn(motion, code).panels:
            for stroke in panel.strokes:
                yield motion, panel, stroke


@cache
def drawn(motion: Motion, code: str) -> Sheet:
    """Return the sheet of a pose."""
    return vad.draw(motion, language=code)


def rate(motion: Motion, letter: str, order: int) -> complex:
    """Return the position (0), velocity (1) or acceleration (2) of a point."""
    if order and letter in motion.frame.fixed:
        return 0j
    point = motion.point(letter)
    return complex((point.position, point.velocity, point.acceleration)[order])


def between(motion: Motion, letters: str, order: int = 0) -> complex:
    """Return what the second of two points has relative to the first."""
    return rate(motion, letters[1], order) - rate(motion, letters[0], order)


def slide_of(motion: Motion, stroke: Stroke) -> Slide | None:
    """Return the slide that a stroke belongs to; None for one of a link or of the frame."""
    if stroke.label.startswith("⟂") or stroke.component in ("normal", "tangential"):
        return None  # a strut is a link, too, and bears its slide's name
    slides = (step for step in motion.frame.steps if isinstance(step, Slide))
    return next((step for step in slides if step.name == stroke.link), None)


def sliding(motion: Motion, slide: Slide, order: int) -> complex:
    """Return the velocity (1) or acceleration (2) of a block along its line."""
    if not isinstance(slide.along, str):
        return between(motion, slide.ends, order)
    amount = (motion.slide(slide.name).velocity, motion.slide(slide.name).acceleration)[order - 1]
    return cmath.rect(amount, math.radians(motion.link(slide.along).angle))


def vector(stroke: Stroke) -> complex:
    """Return the vector that a stroke draws, from its tail to its head."""
    assert isinstance(stroke.shape, Arrow), stroke
    return stroke.shape.end - stroke.shape.start

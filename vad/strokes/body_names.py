"""The bodies of a mechanism as a drawing names them: numbers, inks and nouns."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from vad.kinematics.bodies import FRAME, Body
from vad.kinematics.kennedy import Pair
from vad.strokes.sentences import Noun
from vad.written import base_name, subscript

if TYPE_CHECKING:
    from vad.strokes.scene import Scene


class BodyNames:
    """The names of the bodies in a pose.

    Parameters
    ----------
    scene
        The pose.
    bodies
        Its bodies by name.
    """

    def __init__(self, scene: Scene, bodies: Mapping[str, Body]) -> None:
        self.members, self.voice = scene.members, scene.voice
        self.bodies = bodies
        self._rows = {*self.members.links, *self.members.slides}

    @cached_property
    def numbers(self) -> dict[str, int]:
        """The number of each body: 1 is the frame, 2 the driver, as in the results."""
        found = {name: self.members.number(name) for name in self.bodies}
        known = {name: number for name, number in found.items() if number}
        free = max(known.values(), default=1)
        for name in self.bodies:
            if name not in known:
                free += 1
                known[name] = free
        return {FRAME: 1, **known}

    def centre(self, pair: Pair) -> str:
        """Return the letter of the centre of two bodies: I₂₄."""
        numbers = sorted(self.numbers[name] for name in pair)
        between = "₋" if max(numbers) > 9 else ""
        return "I" + between.join(map(subscript, numbers))

    def plain_centre(self, pair: Pair) -> str:
        """Return its name for the names of its strokes: I24."""
        numbers = sorted(self.numbers[name] for name in pair)
        return "I" + ("-" if max(numbers) > 9 else "").join(map(str, numbers))

    def row(self, body: str) -> str:
        """Return the row of the results whose ink a body has."""
        if body in self._rows:
            return body
        found = self.bodies[body]
        names = (found.slide.name if found.slide else "", found.link or "")
        return next((name for name in names if name in self._rows), self.members.driver.name)

    def noun(self, body: str) -> Noun:
        """Name a body in a sentence."""
        if body in self.members.slides and body not in self.members.links:
            return Noun(base_name(body), generic="slider")
        return Noun(body)

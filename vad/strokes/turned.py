"""The velocity polygon upon the mechanism: turned by 90° and divided by ω of the crank.

Then its pole lies in the crank's pivot A, and the velocity of the crank pin is the crank itself.  A
velocity that is square to a link lies along the link, and one along a guide square to the guide.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from vad.errors import InputError
from vad.kinematics.symbol import as_complex
from vad.strokes.arithmetic import Figure, product
from vad.strokes.diagram import POSITION, VELOCITY, Drawing, Spot
from vad.strokes.figure import FigurePencil
from vad.strokes.polygon import polygon
from vad.strokes.scene import image_letter, point_of
from vad.strokes.sentences import Noun, Sentence, SentencePart, Unit
from vad.strokes.shapes import Turned
from vad.strokes.sheet import Arrow, Cell, Dot, Line, Stroke, StrokePart

if TYPE_CHECKING:
    from vad.strokes.scene import Scene


def turned_drawing(scene: Any) -> Drawing:
    """Return the turned velocity polygon upon the mechanism.

    Raises
    ------
    vad.errors.InputError
        If the crank rests.
    """
    return _Turned(scene).drawing()


def turned_cells(scene: Any, key: str, slides: bool) -> tuple[Cell, ...]:
    """Return the velocities that follow from the figure."""
    found: tuple[Cell, ...] = scene.cells(VELOCITY, key, slides)
    return found


def turned_tracks(scene: Any) -> Mapping[Spot, Any]:
    """Return where the points of the mechanism are, and the ends of their turned velocities.

    Those of fixed points and of the crank lie on the mechanism itself.
    """
    spots: dict[Spot, Any] = dict(scene.tracks(POSITION))
    members, motion, crank = scene.members, scene.motion, scene.driver.name
    centre, still = scene.at(members.pivot(crank)), {*members.fixed, *members.points_on(crank)}
    for point in motion.points:
        if point not in still:
            end = _place(centre, motion.point(point).velocity, motion.inputs["omega"])
            spots[Spot(image_letter(point, 1), row=_row(scene, point), path="bare")] = end
    return spots


def _row(scene: Any, point: str) -> str:
    """Return the row whose ink a point has: that of the last link on which it lies."""
    links = [link for link in scene.members.links if point in scene.members.points_on(link)]
    return str(links[-1] if links else scene.driver.name)


def _place(centre: Any, velocity: Any, omega: Any) -> Any:
    """Return where on the mechanism the end of a velocity from the pole lies."""
    return centre + velocity * -1j / omega


class _Turned:
    def __init__(self, scene: Scene) -> None:
        self.scene, members = scene, scene.members
        self.crank = scene.driver.name
        self.omega = scene.motion.inputs["omega"]
        if float(self.omega) == 0.0:
            raise InputError("turned: needs a crank that turns, got omega 0", "try --omega 10")
        self.pivot = members.pivot(self.crank)
        self.centre = scene.at(self.pivot)
        self.pencil = FigurePencil(scene)

    def drawing(self) -> Drawing:
        """Turn the polygon, stroke by stroke."""
        found = polygon(self.scene, 1)
        for stroke in found.strokes:
            self._draw(stroke)
        self.pencil.zeros += [self._left_out(each) for each in found.zeros]
        sense = 90.0 if self.omega > 0 else -90.0
        turned = Turned(VELOCITY.panel, sense, abs(float(self.omega)), as_complex(self.centre))
        return self.pencil.drawing(turned=(turned,))

    def _at(self, velocity: complex) -> complex:
        """Return where the end of a velocity from the pole lies, upon the mechanism."""
        return complex(_place(self.centre, velocity, self.omega))

    def _draw(self, stroke: Stroke) -> None:
        shape = self._turned(stroke)
        said = self._said(stroke)
        new = replace(stroke, shape=shape, said=said, component="figure", image=False)
        if not isinstance(shape, Dot):
            new = replace(new, label="")
        self.pencil.strokes.append(replace(new, part=self._part(stroke)))

    def _left_out(self, stroke: Stroke) -> Stroke:
        shape, part = self._turned(stroke), self._part(stroke)
        return replace(stroke, shape=shape, component="figure", image=False, label="", part=part)

    def _part(self, stroke: Stroke) -> StrokePart:
        """Return a name that no stroke of the mechanism has."""
        return StrokePart(stroke.part.of, f"{stroke.part.which}-turned")

    def _turned(self, stroke: Stroke) -> Any:
        """Return a shape of the polygon upon the mechanism."""
        match stroke.shape:
            case Dot(at):
                return Dot(self._at(at))
            case Line(through, direction, until):
                way = direction * (-1j if self.omega > 0 else 1j)
                return Line(self._at(through), way, self._at(until))
            case Arrow(start, end, tail, head):
                return Arrow(self._at(start), self._at(end), tail, head)
        raise AssertionError(stroke.shape)

    def _said(self, stroke: Stroke) -> Sentence:
        """Return the sentence of a stroke."""
        scene, shape = self.scene, stroke.shape
        parts: dict[str, SentencePart] = {
            "omega": scene.members.symbol("ω", self.crank),
            "link": Noun(stroke.link or self.crank),
            "crank": Noun(self.crank),
            "pivot": self.pivot,
        }
        if isinstance(shape, Dot):
            phrase = "turned pole" if stroke.kind == "pole" else "turned crossing"
            return scene.say(phrase, letter=stroke.label, **parts)
        if isinstance(shape, Line):
            if shape.square_to:
                return scene.say("turned along", bar=shape.square_to, **parts)
            return scene.say("turned square", line=self._line(stroke), **parts)
        assert isinstance(shape, Arrow)
        unit = scene.rate_unit(1)
        speed = abs(shape.end - shape.start)
        parts |= {
            "label": shape.tail + shape.head,
            "rate": scene.spin(self.crank, 1),
            "size": Figure(speed / abs(float(self.omega)), scene.unit, scale=unit),
            "unit": Unit(unit),
        }
        if stroke.kind == "known" and stroke.link == self.crank:
            return scene.say("turned crank", bar=self.pivot + point_of(shape.head), **parts)
        if stroke.component == "tangential" and stroke.reveals and stroke.link:
            bar = scene.members.base(stroke.link)
            letters = point_of(shape.tail) + point_of(shape.head)
            span = scene.span(*letters) if len(letters) == 2 else scene.size(bar)
            rate = scene.rate(stroke.link, 1)
            return scene.say(
                "turned omega",
                product("turning", "rate", "size", "length"),
                symbol=scene.members.symbol("ω", stroke.link),
                bar=letters,
                length=Figure(span, scene.unit, given=True, power=-1, scale=unit),
                turning=scene.spin(stroke.link, 1),
                sense=scene.say("counter-clockwise" if rate > 0 else "clockwise"),
                **parts,
            )
        return scene.say(
            "turned speed", product("value", "rate", "size"), value=Figure(speed, unit), **parts
        )

    def _line(self, stroke: Stroke) -> Noun:
        slides = (s for s in self.scene.members.sliding if s.name == stroke.link)
        slide = next(slides, None)
        return self.scene.line(slide) if slide else Noun("guide")

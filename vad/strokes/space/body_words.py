"""What is said of the polygon of four bodies that turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from vad.kinematics.numbers import fold
from vad.kinematics.space.crossed_shafts import UniversalSolver
from vad.kinematics.space.sphere import SphereSolver
from vad.strokes.arithmetic import Figure, product
from vad.strokes.captions import PolygonCaptions
from vad.strokes.diagram import ORDERS
from vad.strokes.sentences import Sentence, SentencePart, Unit
from vad.strokes.space.body_rates import BodyRates
from vad.strokes.vector_equations import Part, Vector
from vad.written import subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace

#: What ω₄₂ changes by as it turns with OI.
TURNED = "ω" + subscript(42) + "τ̇"


@dataclass(frozen=True, eq=False, kw_only=True)
class BodyVector(Vector):
    """How one body turns against another.

    ``symbol`` is ω₄₂ or α₄₂, ``axis`` the line along which it lies, ``value`` its rate about it.
    """

    symbol: str
    axis: SentencePart
    value: float


class BodyWords(PolygonCaptions[BodyVector]):
    """What is said of the polygon of bodies.

    ``topic`` begins the phrases of its mechanism; ``sines`` says whether ω₄/ω₂ is read off the
    sphere.
    """

    topic = "bodies"
    sines = True

    def __init__(self, scene: SceneInSpace, order: int, rates: BodyRates) -> None:
        super().__init__(scene, order, ORDERS[order].unit)
        self.scene, self.rates = scene, rates

    def pole(self) -> Sentence:
        """Say that the frame is at the pole."""
        return self.say(f"bodies pole {self.panel}")

    def known(self, label: str, part: Part[BodyVector]) -> Sentence:
        """Work out a known component."""
        vector = part.of
        if part.name != "normal":
            value = Figure(vector.value, self.unit, given=True)
            return self.quantity(
                "bodies given", label=label, symbol=vector.symbol, axis=vector.axis, value=value
            )
        solver, motion = self.scene.motion.solver, self.scene.motion
        assert isinstance(solver, SphereSolver | UniversalSolver)
        found = solver.axis_velocity(motion.pose, motion.velocity)
        speed = found.tau3 if vector.reverse else found.tau
        value, omega, tau = (
            Figure(abs(each), unit)
            for each, unit in ((part.vector, self.unit), (found.omega, "rad/s"), (speed, "rad/s"))
        )
        return self.quantity(
            f"{self.topic} turned {'coupler' if vector.reverse else 'frame'}",
            product("value", "omega", "tau"),
            label=label,
            symbol="ω" + subscript(42),
            omega=omega,
            tau=tau,
            value=value,
        )

    def line(self, part: Part[BodyVector], point: str, meeting: str) -> Sentence:
        """Say why the next vertex lies on a line."""
        vector = part.of
        place = self.place(point, vector.name == "14")
        arcs = {"23": self.rates.at_b, "43": self.rates.at_c}
        arc = Figure(abs(arcs.get(vector.name, 0.0)), "°")
        panel = f" {self.panel}" if vector.name == "24" else ""
        return self.say(
            f"{self.topic} line {vector.name}{panel}",
            point=place,
            axis=vector.axis,
            meeting=meeting,
            arc=arc,
        )

    def measures(self, part: Part[BodyVector]) -> str:
        """Return the symbol of a rate."""
        return part.symbol

    def measured(self, label: str, part: Part[BodyVector]) -> Sentence:
        """Measure a result."""
        vector, motion = part.of, self.scene.motion
        value = Figure(abs(part.vector) if vector.name == "24" else vector.value, self.unit)
        parts: dict[str, SentencePart] = {"label": label, "symbol": part.symbol, "value": value}
        parts["unit"] = Unit(self.unit)
        if vector.name != "14" or self.order > 1 or not self.sines:
            return self.say("turning measured", **parts)
        assert isinstance(motion.solver, SphereSolver)
        from_a = motion.solver.axis(motion.pose).tau
        from_d = fold(from_a - motion.mechanism.parameters()["ground"])
        sign = -1.0 if from_a <= 0.0 and from_d <= 0.0 else 1.0
        arcs = {"ai": Figure(sign * from_a, "°"), "di": Figure(sign * from_d, "°")}
        return self.say("bodies sines", **parts, **arcs)

    def whole(self, label: str, size: float, vector: BodyVector) -> Sentence:
        """Measure a whole vector."""
        value = Figure(size, self.unit)
        return self.quantity("turning measured", label=label, symbol=vector.symbol, value=value)

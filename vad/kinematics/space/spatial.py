"""The spatial four-bar: it turns as its spherical image does, and slides along three axes.

The common normals of neighbouring axes and the slides close: seen from A, crank and coupler end
where ground and rocker do, a₂n₂ + s_B b + a₃n₃ = a₁n₁ + s_D d + a₄n₄ + s_C c.  The product with a
vector that is square to two of the three axes leaves one slide.  Each length enters in the first
power, and so do all rates: a slide is a sum of as many terms as there are lengths, over sin φ_C.
"""

from __future__ import annotations

from collections.abc import Sequence

from vad.kinematics.numbers import Number, nonzero
from vad.kinematics.space.instant_axis import Turns
from vad.kinematics.space.linkages import FourAxes
from vad.kinematics.space.numbers import Dual, Vector3, circling, tilted
from vad.kinematics.space.solver import PoseInSpace
from vad.kinematics.space.sphere import ORIGIN, Sphere, SpherePose, SphereSolver, Turn
from vad.kinematics.state import Pose, Rates


class Slides:
    """What slides along the axes over a spherical image.

    Attributes
    ----------
    lengths
        Those of ground, crank, coupler and rocker.
    """

    def __init__(self, sphere: Sphere, axes: FourAxes) -> None:
        arcs = axes.ground, axes.crank, axes.coupler, axes.rocker
        self.lengths = ground, crank, coupler, rocker = [each.length for each in arcs]
        cosines, (at_ground, at_crank, at_coupler, at_rocker) = sphere.cosines, sphere.sines
        both = at_coupler * at_rocker
        self._along_d = [each / at_rocker for each in self.lengths]
        self._along_b = [each / at_coupler for each in self.lengths]
        self._twists = -cosines[3], cosines[2]
        # What stands in s_C: a known part, and those of cos φ_A and cos φ_C.
        to_frame = ground * at_ground * cosines[1] + crank * at_crank * cosines[0]
        to_coupler = coupler * at_coupler * cosines[3] + rocker * at_rocker * cosines[2]
        by_a = ground * cosines[0] * at_crank + crank * cosines[1] * at_ground
        by_c = coupler * cosines[2] * at_rocker + rocker * cosines[3] * at_coupler
        self._along_c = (to_frame - to_coupler) / both, -by_a / both, by_c / both

    def found(
        self,
        pose: SpherePose,
        driven: Sequence[Number],
        turns: Sequence[Turns],
        lower: Sequence[Turns],
    ) -> Turns:
        """Return the slides, or their derivatives of the order of the rates.

        Parameters
        ----------
        pose
            The spherical image.
        driven, turns
            The orders of rates of the crank and of all others; none for the slides themselves.
        lower
            The slides and their derivatives of the orders below.
        """
        d, b, c = ([getattr(each, name) for each in turns] for name in Turns._fields)
        at_a, at_b, at_c, at_d = (
            circling(*turn, rates)[0]
            for turn, rates in (
                (pose.crank, driven),
                (pose.at_b, b),
                (pose.at_c, c),
                (pose.rocker, d),
            )
        )
        over_rocker = _between(pose.at_c, pose.rocker, self._twists[0], c, d)
        over_coupler = _between(pose.at_b, pose.at_c, self._twists[1], b, c)
        ground, crank, known_d, rocker = self._along_d
        along_d = crank * at_b - ground * over_rocker - rocker * at_c
        ground, crank, coupler, known_b = self._along_b
        along_b = crank * over_coupler + coupler * at_c - ground * at_d
        known_c, by_a, by_c = self._along_c
        along_c = by_a * at_a + by_c * at_c
        if not turns:
            along_d, along_b, along_c = along_d + known_d, along_b - known_b, along_c + known_c
        parts = zip((along_d, along_b, along_c), *lower, strict=True)
        return Turns(*(_over_sine(each, slid, pose.at_c, c) for each, *slid in parts))


def _between(
    one: Turn, other: Turn, twist: Number, first: Sequence[Number], second: Sequence[Number]
) -> Number:
    """Return cos x cos y + k sin x sin y, the cosine of an angle between two normals.

    With rates of both turns x and y it is its derivative of their order.
    """
    (c, s), (cosine, sine) = one, other
    both, across = c * cosine, s * sine
    level = both + twist * across
    if not first:
        return level
    by_one, by_other = twist * (c * sine) - s * cosine, twist * (s * cosine) - c * sine
    if len(first) == 1:
        return first[0] * by_one + second[0] * by_other
    mixed = 2.0 * (first[0] * second[0]) * (across + twist * both)
    squares = (first[0] * first[0] + second[0] * second[0]) * level
    return first[1] * by_one + second[1] * by_other + (mixed - squares)


def _over_sine(product: Number, lower: list[Number], at_c: Turn, rates: Sequence[Number]) -> Number:
    """Return s, or a derivative, where s sin φ_C or its derivative of that order is known."""
    cosine, sine = at_c[0], nonzero(at_c[1])
    if not rates:
        return product / sine
    if len(rates) == 1:
        return (product - lower[0] * rates[0] * cosine) / sine
    changed = 2.0 * lower[1] * rates[0] + lower[0] * rates[1]
    return (product - cosine * changed) / sine + lower[0] * (rates[0] * rates[0])


class SpatialSolver(SphereSolver):
    """The closure of four axes that do not meet.

    Parameters
    ----------
    axes
        Their angles and distances.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.
    """

    sliding = "slide_d", "slide_b", "slide_c"
    slides = frozenset(sliding)
    points = "ABCD"

    def __init__(self, axes: FourAxes, side: float) -> None:
        super().__init__(axes, side)
        self.axes = axes
        self.along: Slides = Slides(self.closure, axes)

    def why_dead(self, pose: Pose) -> str:
        """Say why the rates do not exist at a dead centre."""
        return "dead centre: the axes at B, C and D are parallel to one plane"

    def closed(self, angle: Number) -> PoseInSpace:
        """Return the position for a folded angle of the crank."""
        pose = super().closed(angle)
        pose.length = self._slid(pose, ())
        return pose

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve for the driver's rate, of the order after those in ``lower``."""
        found = super().rates(pose, lower, value)
        found.sliding = self._slid(pose, (*lower, found))
        return found

    def _slid(self, pose: Pose, rates: tuple[Rates, ...]) -> dict[str, Number]:
        driven = [each.turning["crank"] for each in rates]
        orders = [pose.length, *(each.sliding for each in rates)][: len(rates)]
        lower = [Turns(*(each[name] for name in self.sliding)) for each in orders]
        turns = [*map(self.turning_of, rates)]
        found = self.along.found(self.on_sphere(pose), driven, turns, lower)
        return dict(zip(self.sliding, found, strict=True))

    # --- the axes as dual numbers, for the instant axis of one pose ---------------------------

    def _arc(self, number: int) -> tuple[Dual, Dual]:
        """Return cosine and sine of a dual arc: of the ground, crank, coupler or rocker."""
        cosine, sine = self.closure.cosines[number], self.closure.sines[number]
        return _dual(cosine, sine, self.along.lengths[number])

    @property
    def coupler_sine(self) -> Number:
        """The sine of the dual arc from b to c."""
        return self._arc(2)[1]

    @property
    def axis_d(self) -> Vector3:
        """The axis d as dual numbers."""
        cosine, sine = self._arc(0)
        return Dual(0.0, 0.0), -sine, cosine

    def moving_axes(self, pose: Pose) -> tuple[Vector3, Vector3]:
        """Return b and c as dual numbers."""
        turns, slid = self.on_sphere(pose), pose.length["slide_d"]
        x, y = turns.crank
        level, size = self._arc(1)
        b = size * y, -(size * x), level
        x, y = _dual(*turns.rocker, slid)
        level, size = self._arc(3)
        return b, tilted((size * y, -(size * x), level), *self._arc(0))

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return where a common normal meets its axis, of B the crank's and of C the coupler's."""
        ground, crank, _, _ = self.along.lengths
        if letter == "A" or (letter == "D" and rates):
            return ORIGIN
        if letter == "D":
            return ground, 0.0, 0.0
        x, y = self.on_sphere(pose).crank
        if letter == "B":
            turning = [each.turning["crank"] for each in rates]
            return *circling(crank * x, crank * y, turning), 0.0
        normal, across, along = self._at_crank(pose, rates)
        aside = x * normal - y * across if len(rates) > 1 else self._aside(pose, rates)
        return aside, y * normal + x * across, along

    def _aside(self, pose: Pose, rates: tuple[Rates, ...]) -> Number:
        """Return the position or velocity of C along x, square to a and d, where it may be small.

        Ground and rocker alone move the coupler along b, crank and coupler alone along d and c.
        Thus every length has one factor, and nothing cancels.
        """
        ground, crank, coupler, rocker = self.along.lengths
        sines, cosines, turns = self.closure.sines, self.closure.cosines, self.on_sphere(pose)
        (at_a, sine_a), (at_d, sine_d), at_c = turns.crank, turns.rocker, turns.at_c[0]
        by_a, by_c = crank * cosines[1] * sines[0], coupler * cosines[2] * sines[3]
        known = crank * sines[1] * cosines[0] - coupler * sines[2] * cosines[3]
        by_frame = -sines[1] * (ground * at_d + rocker)
        by_coupler = known - by_a * at_a + by_c * at_c
        sine_c = nonzero(turns.at_c[1])
        if not rates:
            return (by_frame * sine_a + by_coupler * sine_d) / (sines[2] * sine_c)
        omega, (rocking, _, turning) = rates[0].turning["crank"], self.turning_of(rates[0])
        changed = (ground * sines[1]) * sine_d * rocking * sine_a + (
            by_a * sine_a * omega - by_c * turns.at_c[1] * turning
        ) * sine_d
        over_sine = omega * self.closure.bent(turns) / (sine_c * sine_c)
        swung = at_d * rocking - sine_d / sine_c * at_c * turning
        return (changed + by_frame * over_sine + by_coupler * swung) / (sines[2] * sine_c)

    def _at_crank(self, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return the motion of C along the crank's normal n₂, along a × n₂ and along a.

        Of a velocity ω₂, ω₃₂, and the parts of the coupler's ω along a and b are known each by
        itself: where two of these nearly cancel, a third one is what is left.
        """
        _, crank, coupler, _ = self.along.lengths
        cosine, sine = (coupler * part for part in self.on_sphere(pose).at_b)
        level, twist = self.closure.cosines[1], self.closure.sines[1]
        slid = [pose.length["slide_b"], *(each.sliding["slide_b"] for each in rates)]
        across, up = twist * slid[-1], level * slid[-1]
        if not rates:
            return crank + cosine, level * sine - across, up + twist * sine
        driven = [each.turning["crank"] for each in rates]
        turning = [each.turning["B"] for each in rates]
        on_a, on_b = self.along_a(pose, rates), self.along_b(pose, rates)
        drawn = twist * slid[0]
        if len(rates) == 1:
            return (
                driven[0] * drawn - on_b[0] * sine,
                on_a[0] * cosine + driven[0] * crank - across,
                up + twist * turning[0] * cosine,
            )
        square, aside = driven[0] * driven[0], driven[0] * twist
        inward = on_b[0] * on_b[0] + aside * aside
        turned = turning[0] * on_a[0] + driven[0] * on_b[0]
        return (
            2.0 * aside * slid[1]
            + driven[1] * drawn
            - on_b[1] * sine
            - inward * cosine
            - square * crank,
            on_a[1] * cosine - turned * sine + driven[1] * crank + square * drawn - across,
            up + twist * (turning[1] * cosine - turning[0] * turning[0] * sine),
        )


def _dual(cosine: Number, sine: Number, length: Number) -> tuple[Dual, Dual]:
    """Return cosine and sine of an angle with the length along its axis."""
    return Dual(cosine, -sine * length), Dual(sine, cosine * length)

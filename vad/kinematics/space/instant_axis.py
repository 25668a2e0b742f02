"""The instant axis I of the rocker against the crank, about which both polygons of space hinge.

It lies where the plane of the frame, of a and d, meets that of the coupler, of b and c.  All of it
is floats on the sphere, and `Dual` in space: then the dual part of τ is AH, that of ω₄₂ the sliding
v₄₂ along I, that of τ̇ the speed ḣ of H.
"""

from __future__ import annotations

from typing import NamedTuple

from vad.kinematics.numbers import Number, degrees_of, fold, vector
from vad.kinematics.space.numbers import (
    Vector3,
    added,
    carried,
    cross,
    dot,
    dual,
    nonzero,
    over,
    real,
    root,
    scaled,
)

#: The driven axis a.
Z: Vector3 = (0.0, 0.0, 1.0)
#: The normal of the frame's plane, a × d / sin α₁: the common normal from A to D.
K: Vector3 = (1.0, 0.0, 0.0)


class Turns(NamedTuple):
    """ω or α about D, of the coupler against the crank about B, and against the rocker about C."""

    at_d: Number
    at_b: Number
    at_c: Number


class AxisVelocity(NamedTuple):
    """How fast the rocker turns against the crank, and I along both circles.

    Attributes
    ----------
    omega
        ω₄₂, along i.
    tau, tau3
        τ̇ along the frame's circle and τ̇₃ along the coupler's.
    """

    omega: Number
    tau: Number
    tau3: Number


class InstantAxis:
    """Where I is, and what ω and α leave along it and across it.

    Parameters
    ----------
    b, c, d
        The axes at B, C and D.
    sine
        That of the arc from b to c.
    i
        The axis itself where it is known already, as for many poses in arrays.  Otherwise it is
        found; where both planes are one it is undetermined: NaN.

    Attributes
    ----------
    n
        The unit normal b × c / sin α₃ of the coupler's plane; that of the frame's is `K`.
    i, m, j
        Unit vectors: along OI, and square to it in the plane of the frame and of the coupler.
    sine, cosine
        Those of the angle δ between both planes; the sine is never negative.
    """

    def __init__(
        self, b: Vector3, c: Vector3, d: Vector3, sine: Number, i: Vector3 | None = None
    ) -> None:
        self.b, self.c, self.d = b, c, d
        self.n = over(cross(b, c), sine)
        line = cross(K, self.n)
        self.sine = root(dot(line, line)) if i is None else dot(line, i)
        self.i = over(line, nonzero(self.sine)) if i is None else i
        self.m, self.j = cross(K, self.i), cross(self.n, self.i)
        self.cosine = self.n[0]

    @property
    def delta(self) -> float:
        """The angle δ between both planes of one pose, in degrees."""
        return degrees_of(vector(real(self.cosine), real(self.sine)))

    @property
    def tau(self) -> float:
        """The arc τ from A to I, towards D, of one pose, in degrees within ±180."""
        x, y = self._place
        return fold(degrees_of(vector(real(x), real(y))))

    @property
    def height(self) -> Number:
        """The distance AH on the common normal, from A towards D; 0 on the sphere."""
        x, y = self._place
        return real(x) * dual(y) - real(y) * dual(x)

    @property
    def _place(self) -> tuple[Number, Number]:
        """The cosine and the sine of τ: the parts of i along z, which is a, and along -y."""
        return self.i[2], -1.0 * self.i[1]

    def relative(self, crank: Number, turns: Turns) -> tuple[Number, Number]:
        """Return ω₄d - ω₂a along i, and across it in the plane of the frame; or that of α.

        Of ω it is ω₄₂ along i.  Of α it is α₄₂ₜ along i, and ω₄₂τ̇ along m.  In space the dual part
        of α is α₄₂ₜ·AH + ω₄₂ḣ + v₄₂τ̇ along m and v̇₄₂ - ω₄₂τ̇·AH along i, with v̇₄₂ the dual part of
        α₄₂ₜ: m and i pass through H.
        """
        vector = self.difference(crank, turns)
        return dot(vector, self.i), dot(vector, self.m)

    def difference(self, crank: Number, turns: Turns) -> Vector3:
        """Return ω₄d - ω₂a, or that of α; in space its dual part is the motion of A."""
        return added(scaled(turns.at_d, self.d), scaled(-1.0 * crank, Z))

    def in_coupler(self, turns: Turns) -> Number:
        """Return the part of α₃₂b - α₃₄c across i, which is ω₄₂τ̇₃."""
        return turns.at_b * dot(self.b, self.j) - turns.at_c * dot(self.c, self.j)

    def velocity(self, crank: Number, turns: Turns) -> AxisVelocity:
        """Return ω₄₂ and how fast I itself moves.

        τ̇ and τ̇₃ follow from the signed distances p₂ and p₃ of 1 and 3 from the line 2 4.
        """
        p2, p3 = turns.at_d * dot(self.d, self.m), turns.at_b * dot(self.b, self.j)
        sine = nonzero(self.sine)
        return AxisVelocity(
            self.relative(crank, turns)[0],
            (p3 + p2 * self.cosine) / sine,
            (p2 + p3 * self.cosine) / sine,
        )

    def motion(self, *spins: Vector3) -> Vector3:
        """Return I on the sphere: its place, with ω₃ its velocity, with α₃ its acceleration."""
        if not spins:
            return self.i
        # The line K × n turns as i does, and grows from sin δ.
        first = cross(K, carried(self.n, spins[0]))
        sine = nonzero(self.sine)
        tau = dot(first, self.m) / sine
        if len(spins) == 1:
            return scaled(tau, self.m)
        second = dot(cross(K, carried(self.n, *spins)), self.m)
        onward = (second - 2.0 * dot(first, self.i) * tau) / sine
        return added(scaled(onward, self.m), scaled(-1.0 * tau * tau, self.i))

"""The instant axis I of the rocker against the crank, about which both polygons of space hinge.

It lies where the plane of the frame, of a and d, meets that of the coupler, of b and c.  All of it
is floats on the sphere, and `Dual` in space: then the dual part of τ is AH, that of ω₄₂ the sliding
v₄₂ along I, that of τ̇ the speed ḣ of H.
"""

from __future__ import annotations

from typing import NamedTuple

from vad.kinematics.numbers import Number, degrees_of, fold
from vad.kinematics.space.dual import dual, nonzero, real, root
from vad.kinematics.space.sphere import SphereRates
from vad.kinematics.space.vector3 import Vector3, added, carried, cross, dot, over, scaled

#: The normal of the frame's plane, a × d / sin α₁: the common normal from A to D.
K: Vector3 = (1.0, 0.0, 0.0)


class InstantAxis(NamedTuple):
    """Where I is.

    Attributes
    ----------
    n
        The unit normal b × c / sin α₃ of the coupler's plane; that of the frame's is `K`.
    i, m, j
        Unit vectors: along OI, and square to it in the plane of the frame and of the coupler.
    sine, cosine
        Those of the angle δ between both planes; the sine is never negative.
    """

    n: Vector3
    i: Vector3
    m: Vector3
    j: Vector3
    sine: Number
    cosine: Number

    @property
    def delta(self) -> float:
        """The angle δ between both planes of one pose, in degrees."""
        return degrees_of(complex(real(self.cosine), real(self.sine)))

    @property
    def tau(self) -> float:
        """The arc τ from A to I, towards D, of one pose, in degrees within ±180."""
        x, y = self._place
        return fold(degrees_of(complex(real(x), real(y))))

    @property
    def height(self) -> Number:
        """The distance AH on the common normal, from A towards D; 0 on the sphere."""
        x, y = self._place
        return real(x) * dual(y) - real(y) * dual(x)

    @property
    def _place(self) -> tuple[Number, Number]:
        """The cosine and the sine of τ: the parts of i along z, which is a, and along -y."""
        return self.i[2], -1.0 * self.i[1]


class AxisVelocity(NamedTuple):
    """How fast the rocker turns against the crank, and I along both circles.

    Attributes
    ----------
    omega
        ω₄₂, along i.
    p2, p3
        The signed distances of 1 and 3 from the line 2 4: ω₄d·m and ω₃₂b·j.
    tau, tau3
        τ̇ along the frame's circle and τ̇₃ along the coupler's.
    """

    omega: Number
    p2: Number
    p3: Number
    tau: Number
    tau3: Number


def instant_axis(b: Vector3, c: Vector3, sine: Number) -> InstantAxis:
    """Return the instant axis of a pose from the coupler's axes; ``sine`` is that of its arc.

    Where both planes are one it is undetermined: NaN.
    """
    n = over(cross(b, c), sine)
    line = cross(K, n)
    size = root(dot(line, line))
    i = over(line, nonzero(size))
    return InstantAxis(n, i, cross(K, i), cross(n, i), size, n[0])


def axis_velocity(
    axis: InstantAxis, b: Vector3, d: Vector3, omega: Number, rates: SphereRates
) -> AxisVelocity:
    """Return what ω₂a + ω₄₂i = ω₄d leaves along I and across it."""
    along = rates.rocker * dot(d, axis.i) + -omega * axis.i[2]
    p2, p3 = rates.rocker * dot(d, axis.m), rates.at_b * dot(b, axis.j)
    sine = nonzero(axis.sine)
    return AxisVelocity(
        along, p2, p3, (p3 + p2 * axis.cosine) / sine, (p2 + p3 * axis.cosine) / sine
    )


def axis_motion(axis: InstantAxis, *spins: Vector3) -> Vector3:
    """Return I on the sphere: its place, with ω₃ its velocity, with α₃ its acceleration."""
    if not spins:
        return axis.i
    # The line K × n turns as i does, and grows from sin δ.
    first = cross(K, carried(axis.n, spins[0]))
    sine = nonzero(axis.sine)
    tau = dot(first, axis.m) / sine
    if len(spins) == 1:
        return scaled(tau, axis.m)
    second = dot(cross(K, carried(axis.n, *spins)), axis.m)
    onward = (second - 2.0 * dot(first, axis.i) * tau) / sine
    return added(scaled(onward, axis.m), scaled(-1.0 * tau * tau, axis.i))


def axis_acceleration(axis: InstantAxis, d: Vector3, alpha: Number, seconds: SphereRates) -> Number:
    """Return α₄₂ₜ, along i, of α₂a + ω₄₂τ̇ m + α₄₂ₜ i = α₄d.

    In space the dual part of the whole sum is, in the frame's plane, α₄₂ₜ·AH + ω₄₂ḣ + v₄₂τ̇ along m
    and v̇₄₂ - ω₄₂τ̇·AH along i, with v̇₄₂ the dual part of α₄₂ₜ: m and i pass through H.
    """
    return seconds.rocker * dot(d, axis.i) + -alpha * axis.i[2]

"""The rotations of four bodies about four axes, and the vertices of their polygons.

The pole is body 1, the frame; the vector from i to j is the rotation of j relative to i.  Triangle
1 2 4 lies in the plane of the frame, which is parallel to the paper.  Triangle 2 3 4 lies in that
of the coupler, which is rotated into the paper about 2 4: to one side in all poses of a mechanism,
so that nothing jumps while it moves.  If the bodies also slide, the real parts of dual numbers are
rotations, and the dual parts are translations.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from vad.kinematics.numbers import bearing, plane
from vad.kinematics.space.instant_axis import AxisVelocity, InstantAxis, Turns, Z
from vad.kinematics.space.numbers import Vector3, dot, real
from vad.kinematics.space.solver import AxesSolver
from vad.strokes.diagram import ACCELERATION, VELOCITY, Order
from vad.strokes.space.layout import over_its_range
from vad.strokes.space.scene import Script
from vad.strokes.space.view import View
from vad.strokes.vector_equations import NOTHING
from vad.written import PRIME

#: Poses in each range in which a mechanism closes, by which the side is chosen.
SAMPLES = 181


class Bodies:
    """The rotations of the bodies of a motion, in one pose or in many as arrays.

    Parameters
    ----------
    script
        What draws the mechanism.
    view
        The view square to the plane of the frame.

    Attributes
    ----------
    solver
        What has solved the motion.
    axis
        The instant axis I with the other axes, as they are without sliding.
    seen
        The projection of a vector on the plane of the frame.
    """

    def __init__(self, script: Script, view: View) -> None:
        solver = script.motion.solver
        assert isinstance(solver, AxesSolver)
        self.motion, self.solver = script.motion, solver
        self._settled = script.settled
        b, c, d, i = (script.axis(letter) for letter in "BCDI")
        self.axis = InstantAxis(b, c, d, real(solver.coupler_sine), i)
        self.seen = view.way
        self._turns: dict[Order, tuple[Any, Turns]] = {}

    def laid(self, vector: Vector3) -> Any:
        """Return a vector of the coupler's plane, rotated into the paper about OI."""
        along, across = dot(vector, self.axis.i), self.side * dot(vector, self.axis.j)
        return along * self.seen(self.axis.i) + across * self.seen(self.axis.m)

    def arc(self, axis: Vector3) -> float:
        """Return the angle from I to an axis of the coupler's plane, in degrees, of one pose."""
        return bearing(plane(dot(axis, self.axis.i), dot(axis, self.axis.j)))

    def turns(self, order: Order) -> tuple[Any, Turns]:
        """Return ω or α of the driver, and about the other axes."""
        if order not in self._turns:
            links, joints = self.motion.link, self.motion.joint
            at_d, at_b, at_c = self.solver.turning
            parts: list[Any] = [links(self.solver.driver.name), links(at_d)]
            crank, *rest = (
                getattr(each, order.rate) for each in (*parts, joints(at_b), joints(at_c))
            )
            self._turns[order] = crank, Turns(*rest)
        return self._turns[order]

    def relative(self, order: Order) -> tuple[Any, Any]:
        """Return the rotation of 4 relative to 2: along I, and across it in the frame's plane."""
        return self.axis.relative(*self.turns(order))

    def in_coupler(self) -> Any:
        """Return ω₄₂τ̇₃, the part of α₃₂b - α₃₄c across I."""
        return self.axis.in_coupler(self.turns(ACCELERATION)[1])

    @cached_property
    def side(self) -> float:
        """The side to which the plane of the coupler is rotated, the same in all poses."""
        return _side(self._settled)

    @property
    def apart(self) -> tuple[Any, Any]:
        """How far 1 and 3 are from the line 2 4 in the polygon of ω.

        With equal signs they lie on both sides of that line if the side is +1.
        """
        turns, axis = self.turns(VELOCITY)[1], self.axis
        return turns.at_d * dot(axis.d, axis.m), turns.at_b * dot(axis.b, axis.j)

    def vertices(self, order: Order, coupler: bool = True) -> Mapping[str, Any]:
        """Return where the vertices of the polygon of ω or α are."""
        crank, turns = self.turns(order)
        two, four = crank * self.seen(Z), turns.at_d * self.seen(self.axis.d)
        prime = PRIME * (order.number - 1)
        found = {f"1{prime}": 0j, f"2{prime}": two, f"4{prime}": four}
        begin = two
        if order is ACCELERATION:
            found["4ₙ"] = two + self.relative(ACCELERATION)[1] * self.seen(self.axis.m)
        if coupler:
            if order is ACCELERATION:
                begin = found["4ₙ"] - self.in_coupler() * self.side * self.seen(self.axis.m)
                found["3ₙ"] = begin
            found[f"3{prime}"] = begin + turns.at_b * self.laid(self.axis.b)
        return found

    # --- with dual numbers: what slides -------------------------------------------------------

    @cached_property
    def screw(self) -> InstantAxis:
        """The axis I of one pose, with its place and in dual numbers where something slides."""
        return self.solver.axis(self.motion.pose)

    @cached_property
    def pace(self) -> AxisVelocity:
        """ω₄₂ and how fast I moves, in one pose."""
        return self.solver.axis_velocity(self.motion.pose, self.motion.velocity)

    @cached_property
    def height(self) -> Any:
        """AH, the distance of I from A, for the motion of A relative to the crank."""
        if not self.motion.many:
            return self.screw.height
        way = self.seen(self.axis.i)
        return (self.sliding(VELOCITY)["a₄"] * way.conjugate()).imag / self.relative(VELOCITY)[0]

    @cached_property
    def growth(self) -> Any:
        """α₄₂ₜ of one pose, and as its dual part v̇₄₂."""
        return self.solver.axis_acceleration(self.motion.pose, self.motion.acceleration)

    def sliding(self, order: Order) -> Mapping[str, Any]:
        """Return where the vertices of the polygon below are: A as a point of the rocker."""
        slide: Any = self.motion.slide("slide_d")
        slid = getattr(slide, order.panel)
        d, i, prime = self.seen(self.axis.d), self.seen(self.axis.i), PRIME * (order.number - 1)
        z = self.turns(order)[1].at_d * self.ground * 1j * d
        end, turned = z + slid * d, self.turned_with_axis if prime else 0j
        y = turned + ((end - turned) * i.conjugate()).imag * (1j * i)
        places = {"a": 0j, "d": 0j, **({"x": turned} if prime else {}), "y": y, "z": z}
        return {**{letter + prime: at for letter, at in places.items()}, f"a{prime}₄": end}

    @property
    def turned_with_axis(self) -> Any:
        """The part of the acceleration of A that is due to the turning of its velocity with OI."""
        pace = self.axis.velocity(*self.turns(VELOCITY)).tau
        return pace * 1j * self.sliding(VELOCITY)["a₄"]

    @cached_property
    def ground(self) -> float:
        """AD, the distance of d from A."""
        ground: float = self.motion.mechanism.parameters()["ground"]
        return ground


@lru_cache(maxsize=64)
def _side(mechanism: Any) -> float:
    """Return the side on which the triangles of ω lie apart in most poses; -1 of equal ones."""
    turning: Any = over_its_range(mechanism, SAMPLES)
    return 1.0 if np.nanmedian(np.prod(turning.bodies.apart, axis=0)) > NOTHING else -1.0

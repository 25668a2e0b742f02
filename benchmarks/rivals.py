"""Other programs on the same four-bar: SciPy's fsolve, and the peers where they are installed.

Each takes a `Course` and returns what it finds at every pose: an array of poses × (angle, ω, α) ×
(coupler, rocker), in radians.
"""

from __future__ import annotations

import importlib.util
import math
import warnings
from dataclasses import dataclass

import numpy as np

import vad

OMEGA, ALPHA = 10.0, 5.0
LINKS = ("coupler", "rocker")


@dataclass(frozen=True)
class Course:
    """A four-bar whose crank advances in equal steps; angles in degrees."""

    ground: float
    crank: float
    coupler: float
    rocker: float
    start: float
    step: float
    count: int

    @property
    def mechanism(self) -> vad.FourBar:
        """The linkage in the program's own form."""
        return vad.FourBar(self.ground, self.crank, self.coupler, self.rocker)

    def angle(self, number: int) -> float:
        """Return the crank's angle at one pose."""
        return self.start + number * self.step

    @property
    def angles(self) -> np.ndarray:
        """The crank's angle at every pose."""
        return self.start + self.step * np.arange(self.count)

    def last(self, count: int) -> Course:
        """Return the course of the last poses alone."""
        first = max(self.count - count, 0)
        start = self.angle(first)
        lengths = (self.ground, self.crank, self.coupler, self.rocker)
        return Course(*lengths, start, self.step, self.count - first)

    def near(self, digits: int = 2) -> np.ndarray:
        """Return roughly what is to be found at the first pose, as iterations need to be told."""
        motion = vad.solve(self.mechanism, angle=self.angle(0), omega=OMEGA, alpha=ALPHA)
        links = [motion.link(name) for name in LINKS]
        found = [
            [math.radians(math.remainder(link.angle, 360)) for link in links],
            [link.omega for link in links],
            [link.alpha for link in links],
        ]
        return np.array([[float(f"{value:.{digits}g}") for value in order] for order in found])


def installed(name: str) -> bool:
    """Tell whether a peer can be measured."""
    return importlib.util.find_spec(name) is not None


def fsolve(course: Course, tolerance: float) -> np.ndarray:
    """Solve the loop equations by SciPy's fsolve, each pose from the one before."""
    from scipy.optimize import fsolve

    r2, r3, r4 = course.crank, course.coupler, course.rocker
    place, results = course.near()[0], []
    for angle in np.deg2rad(course.angles):
        crank = np.array([math.cos(angle), math.sin(angle)])

        def gap(unknowns: np.ndarray, crank: np.ndarray = crank) -> np.ndarray:
            (t3, t4), (x, y) = unknowns, r2 * crank
            return np.array(
                [
                    x + r3 * math.cos(t3) - course.ground - r4 * math.cos(t4),
                    y + r3 * math.sin(t3) - r4 * math.sin(t4),
                ]
            )

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of slow progress, at a change point
            place = fsolve(gap, place, xtol=tolerance)
        b, c = (np.array([math.cos(t), math.sin(t)]) for t in place)
        matrix = np.array([[-r3 * b[1], r4 * c[1]], [r3 * b[0], -r4 * c[0]]])
        across = np.array([-crank[1], crank[0]])
        omega = np.linalg.solve(matrix, -r2 * OMEGA * across)
        normals = r2 * OMEGA**2 * crank + r3 * omega[0] ** 2 * b - r4 * omega[1] ** 2 * c
        alpha = np.linalg.solve(matrix, normals - r2 * ALPHA * across)
        results.append([place, omega, alpha])
    return np.array(results)


class MechanismPackage:
    """The package `mechanism`: vector loops, each order solved by fsolve."""

    def __init__(self, course: Course) -> None:
        from mechanism import Mechanism, Vector, get_joints

        a, b, c, d = get_joints("A B C D")
        crank = Vector((a, b), r=course.crank)
        coupler = Vector((b, c), r=course.coupler)
        ground = Vector((a, d), r=course.ground, theta=0)
        rocker = Vector((d, c), r=course.rocker)
        self._links = coupler, rocker
        self._mechanism = Mechanism(
            vectors=(crank, coupler, ground, rocker),
            origin=a,
            loops=lambda x, i: crank(i) + coupler(x[0]) - ground() - rocker(x[1]),
            pos=np.deg2rad(course.angles),
            vel=np.full(course.count, OMEGA),
            acc=np.full(course.count, ALPHA),
            guess=tuple(course.near()),
        )

    def run(self) -> np.ndarray:
        """Solve all poses."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self._mechanism.iterate()
        return np.array(
            [
                [link.pos.thetas for link in self._links],
                [link.vel.omegas for link in self._links],
                [link.acc.alphas for link in self._links],
            ]
        ).transpose(2, 0, 1)


class PylinkagePackage:
    """The package `pylinkage`: circles intersected in closed form, step by step."""

    def __init__(self, course: Course) -> None:
        from pylinkage import Crank, Ground, RRRDyad
        from pylinkage.simulation import Linkage

        self._course = course
        before = course.angle(-1)  # it steps before it looks
        point = vad.solve(course.mechanism, angle=before).point("C").position
        a, d = Ground(0.0, 0.0), Ground(course.ground, 0.0)
        crank = Crank(a, course.crank, math.radians(course.step), math.radians(before))
        c = RRRDyad(crank.output, d, course.coupler, course.rocker, point.real, point.imag)
        self._linkage = Linkage([a, d, crank, c])
        self._linkage.set_input_velocity(crank, OMEGA, ALPHA)
        self._before = self._linkage.get_coords()
        self._linkage.step_fast_with_kinematics(1)  # compiles, where numba is installed

    def run(self) -> None:
        """Solve all poses; what it finds are points and their velocities and accelerations."""
        self._linkage.set_coords(self._before)
        self._found = self._linkage.step_fast_with_kinematics(self._course.count)

    def results(self, count: int) -> np.ndarray:
        """Return the last poses of the last run as angles and their rates."""
        d = complex(self._course.ground)
        position, velocity, acceleration = (
            [found[-count:, k, 0] + 1j * found[-count:, k, 1] for k in (2, 3)]
            for found in self._found
        )
        bars = position[1] - position[0], position[1] - d
        first = (velocity[1] - velocity[0]) / bars[0], velocity[1] / bars[1]
        second = (acceleration[1] - acceleration[0]) / bars[0], acceleration[1] / bars[1]
        # The second derivative of r·exp(iθ) is (iα - ω²) times it.
        return np.array([np.angle(bars), np.imag(first), np.imag(second)]).transpose(2, 0, 1)

"""A solver written down once, as programs for what is asked of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from vad.kinematics.evaluation import Evaluation
from vad.kinematics.numbers import Number
from vad.kinematics.program import Program
from vad.kinematics.recording import Recorded, RecordedVector, Tape
from vad.kinematics.results.formulas import Result, order_of

if TYPE_CHECKING:
    from vad.kinematics.any_solver import AnySolver


class RecordedSolver:
    """The programs of a solver, each made when it is first asked for.

    There are three orders: the pose, the velocities and the accelerations.  The numbers of each
    order are kept; what is found of them begins there, and not with the driver again.
    """

    def __init__(self, solver: AnySolver) -> None:
        tape = Tape()
        self._solver = solver
        self._inputs = tuple(map(tape.input, ("place", "rate", "second_rate")))
        self._evaluation = Evaluation(solver, self._inputs)
        self._orders: list[Program] = []
        self._results: dict[Result, Program] = {}

    def order(self, order: int) -> Program:
        """Return what leads from all that is known of the orders below, and one input, to an order.

        The first number of the pose tells whether the links close.
        """
        while len(self._orders) <= order:
            below = len(self._orders)
            given = (*self._known(below - 1), self._inputs[below])
            names = {number.name for number in given}
            new = {
                x.name: x
                for x in _parts(self._numbers(below))
                if isinstance(x, Recorded) and x.name not in names
            }
            self._orders.append(Program(given, tuple(new.values())))
        return self._orders[order]

    def result(self, result: Result) -> Program:
        """Return what leads from all that is known in its order to a number, or to x, y and z."""
        if result not in self._results:
            value = self._solver.evaluate(result, self._evaluation)
            outputs = [_without_sign(x) for x in _parts([value])]
            self._results[result] = Program(self._known(order_of(result)), outputs)
        return self._results[result]

    @cached_property
    def sines(self) -> Program:
        """What leads from the driver's place to the sine of each loop."""
        return Program(self._inputs[:1], self._evaluation.pose.sine)

    def _known(self, order: int) -> tuple[Recorded, ...]:
        """Return the inputs and the numbers of an order and of those below."""
        if order < 0:
            return ()
        program = self.order(order)
        return (*program.inputs, *program.outputs)

    def _numbers(self, order: int) -> list[Number]:
        if order:
            return self._evaluation.rates(order)[-1].all()
        pose = self._evaluation.pose
        sum_of_all = self._inputs[0] + sum(pose.sine)  # NaN where the links do not close
        return [sum_of_all == sum_of_all, *pose.all()]


def _parts(values: Iterable[Number]) -> Iterator[Number]:
    for value in values:
        if isinstance(value, tuple):
            yield from value
        elif isinstance(value, complex | RecordedVector):
            yield from (value.real, value.imag)
        else:
            yield value


def _without_sign(number: Number) -> Number:
    """Return a number of which no zero is negative."""
    return number.tape.note("add", number, 0.0) if isinstance(number, Recorded) else number + 0.0

"""A solver written down once, as programs for what is asked of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from vad.kinematics.evaluation import Evaluation
from vad.kinematics.numbers import Number
from vad.kinematics.program import Program
from vad.kinematics.recording import Recorded, RecordedVector, Tape
from vad.kinematics.results.formulas import Result, evaluate, order_of

if TYPE_CHECKING:
    from vad.kinematics.solver import Solver


class RecordedSolver:
    """The programs of a solver, each made when it is first asked for.

    There are three orders: the pose, the velocities and the accelerations.  The numbers of each
    order are kept; what is found of them begins there, and not with the driver again.
    """

    def __init__(self, solver: Solver) -> None:
        tape = Tape()
        self._inputs = tuple(map(tape.input, ("place", "rate", "second_rate")))
        self._evaluation = Evaluation(solver, self._inputs)
        self._kept: list[dict[str, Recorded]] = []
        self._orders: list[Program] = []
        self._results: dict[Result, Program] = {}

    def order(self, order: int) -> Program:
        """Return what leads from the orders below and the inputs to the numbers of an order.

        The first number of the pose tells whether the links close.
        """
        while len(self._orders) <= order:
            numbers = self._numbers(len(self._orders))
            self._orders.append(Program(self._given(len(self._orders)), list(numbers.values())))
            self._kept.append(numbers)
        return self._orders[order]

    def result(self, result: Result) -> Program:
        """Return what leads from its order, those below and the inputs to a number, or x and y."""
        if result not in self._results:
            self.order(order_of(result))
            value = evaluate(result, self._evaluation)
            outputs = [_without_sign(x) for x in _parts([value])]
            self._results[result] = Program(self._given(order_of(result)), outputs)
        return self._results[result]

    def _given(self, order: int) -> list[Recorded]:
        kept = [x for numbers in self._kept[: order + 1] for x in numbers.values()]
        return kept + list(self._inputs[: order + 1])

    def _numbers(self, order: int) -> dict[str, Recorded]:
        """Return what is new in an order, by its name on the tape."""
        if order:
            values = self._evaluation.rates(order)[-1].all()
        else:
            pose = self._evaluation.pose
            sum_of_all = self._inputs[0] + sum(pose.sine)  # NaN where the links do not close
            values = [sum_of_all == sum_of_all, *pose.all()]
        given = {number.name for number in self._given(order)}
        new = (x for x in _parts(values) if isinstance(x, Recorded) and x.name not in given)
        return {number.name: number for number in new}


def _parts(values: Iterable[Number]) -> Iterator[Number]:
    for value in values:
        if isinstance(value, complex | RecordedVector):
            yield from (value.real, value.imag)
        else:
            yield value


def _without_sign(number: Number) -> Number:
    """Return a number of which no zero is negative."""
    return number.tape.note("add", number, 0.0) if isinstance(number, Recorded) else number + 0.0

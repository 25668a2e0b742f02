"""Six ways to solve a mechanism, for comparison: the three of the textbooks and three others.

Every method is a function.  It takes a `Problem`, which is the loop equations of a mechanism with
the motion of its driver, and returns the positions, rates and second derivatives of all unknowns.
Three of the methods solve mechanisms in space, too.  As far as possible the methods are independent
of the solver and of each other.  Only ``vad compare`` and tests use them.
"""

from collections.abc import Callable
from typing import Any

from vad.methods import (
    closed_form,
    construction,
    finite_differences,
    loop_closure,
    newton,
    unit_vectors,
)
from vad.methods.problem import Found, Jet, Problem, problem_of

Method = Callable[[Any], Found]

#: The methods by the name that a table shows.
METHODS: dict[str, Method] = {
    "construction": construction.solve,
    "unit vectors": unit_vectors.solve,
    "loop closure": loop_closure.solve,
    "closed form": closed_form.solve,
    "Newton": newton.solve,
    "finite differences": finite_differences.solve,
}
#: The methods that solve mechanisms in space, too.
METHODS_IN_SPACE: dict[str, Method] = {
    "closed form": closed_form.solve,
    "Newton": newton.solve_in_space,
    "finite differences": finite_differences.solve,
}

__all__ = ["METHODS", "METHODS_IN_SPACE", "Found", "Jet", "Method", "Problem", "problem_of"]

"""The methods stand apart: only the command line uses them, and they do not use the solver."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parents[2] / "vad"
METHODS = PACKAGE / "methods"


@cache
def imports(path: Path) -> set[str]:
    """Return the full names of what a file imports, wherever in it."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return names


def test_only_the_command_line_uses_the_methods():
    users = {
        path.relative_to(PACKAGE).as_posix()
        for path in PACKAGE.rglob("*.py")
        if METHODS not in path.parents
        if any(name.startswith("vad.methods") for name in imports(path))
    }
    assert users == {"cli/compare.py"}


def test_the_methods_use_the_declared_loops_and_nothing_of_the_solver():
    for path in METHODS.glob("*.py"):
        names = {name for name in imports(path) if name.split(".")[0] == "vad"}
        if path.name == "closed_form.py":
            names = {name for name in names if name.startswith("vad.methods")}
        allowed = (
            "vad.methods",
            "vad.kinematics.linkage.",
            "vad.kinematics.space.linkages.",
            "vad.mechanisms.Mechanism",
            "vad.errors",
        )
        assert all(name.startswith(allowed) for name in names), path.name


def test_mpmath_is_loaded_by_the_reference_alone():
    users = {
        path.name for path in PACKAGE.rglob("*.py") if any("mpmath" in n for n in imports(path))
    }
    assert users == {"high_precision.py", "comparison.py"}

"""What `import vad` shows: the names that a type checker sees are those that there are."""

from __future__ import annotations

import ast
import inspect
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

import vad
from vad.export import FORMATS, Options, own_options

ROOT = Path(__file__).parents[1]


def shown_to_type_checkers() -> dict[str, str]:
    """Return the names that are imported for type checkers alone, with their modules."""
    (block,) = (
        node
        for node in ast.parse(inspect.getsource(vad)).body
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    )
    return {each.name: node.module for node in block.body for each in node.names}


def test_all_names_are_typed():
    assert sorted(shown_to_type_checkers()) == sorted(vad.__all__)


@pytest.mark.parametrize("name", vad.__all__)
def test_a_name_is_what_a_type_checker_takes_it_for(name):
    assert getattr(vad, name) is getattr(import_module(shown_to_type_checkers()[name]), name)


def test_the_names_are_listed():
    assert set(dir(vad)) == {*vad.__all__, "__version__"}
    everything: dict[str, object] = {}
    exec("from vad import *", everything)
    assert set(vad.__all__) <= set(everything)


def test_a_new_mechanism_is_found_by_itself():
    code = """
from dataclasses import dataclass
import vad

@dataclass(frozen=True)
class Ninth(vad.FourBar):
    name = "ninth"

assert vad.Ninth is Ninth and "Ninth" in dir(vad)
"""
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True)


@pytest.mark.parametrize(
    ("wrong", "meant"), [("slove", "solve"), ("Fourbar", "FourBar"), ("Motoin", "Motion")]
)
def test_a_misspelt_name_is_answered_with_the_nearest(wrong, meant):
    with pytest.raises(AttributeError, match=f"no attribute '{wrong}'; did you mean '{meant}'"):
        getattr(vad, wrong)


def test_private_names_are_not_guessed():
    with pytest.raises(AttributeError, match=r"no attribute '__wrapped__'$"):
        vad.__wrapped__  # noqa: B018


def test_options_are_those_of_the_formats():
    modules = {module for formats in FORMATS.values() for module in formats.values()}
    options = {
        name
        for module in modules
        for name, each in inspect.signature(import_module(module).write).parameters.items()
        if each.default is not each.empty
    }
    assert set(Options.__annotations__) <= options
    assert options - own_options(modules).keys() <= set(Options.__annotations__)

"""The class of a file: like those of the built-in mechanisms, and it travels as its text."""

from __future__ import annotations

import dataclasses
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

import vad
from tests.files.verified import BY_NAME, verified
from vad.files.examples import example_names, example_path
from vad.mechanisms.mechanism import NUMBERS

ROOT = Path(__file__).parents[2]


def test_fields_have_defaults_and_help():
    fields = {field.name: field for field in dataclasses.fields(verified("watt-1"))}
    numbers = [name for name in fields if fields[name].metadata["quantity"] in NUMBERS]
    assert numbers == ["Dx", "crank", "BC", "BE", "CBE", "DC", "DF", "CDF", "arm", "link"]
    assert fields["CBE"].default == 30.0
    assert all(field.metadata["help"] for field in fields.values())
    with pytest.raises(TypeError, match="nothing"):
        verified("watt-1")(nothing=3)


@pytest.mark.parametrize(("name", "wrong"), [("crank", -1), ("BC", 0), ("CBE", 30j), ("Dx", None)])
def test_a_parameter_is_checked_by_name(name, wrong):
    with pytest.raises(vad.InputError, match=f"^{name}: must be"):
        verified("watt-1")(**{name: wrong})


def test_other_numbers_of_which_no_link_can_be_made():
    with pytest.raises(vad.InputError, match="the triangle BCE with sides 110, 5 and 70 does not"):
        verified("stephenson-3")(BE=5)


def test_it_is_no_mechanism_of_the_menu():
    assert verified("watt-1").name not in vad.MECHANISMS
    assert set(dir(vad)) == {*vad.__all__, "__version__"}


def test_mechanisms_are_equal_if_their_text_and_numbers_are():
    watt, again = verified("watt-1"), vad.load(example_path("watt-1"))
    assert watt(arm=121) == watt(arm=121) != watt()
    assert hash(watt(arm=121)) == hash(watt(arm=121))
    assert watt() != again()  # another text
    assert vad.load(example_path("watt-1")) is again
    assert watt(assembly={"G": "upper"}) != watt()


def test_replacing_a_number_keeps_the_rest():
    one = verified("toggle-press")(rod=550, assembly={"B": "left"})
    other = dataclasses.replace(one, crank=150)
    assert (other.rod, other.crank, other.assembly["B"]) == (550, 150, "left")


def test_it_survives_the_way_to_another_process(tmp_path):
    mechanism = verified("shaper")(rod=190)
    assert pickle.loads(pickle.dumps(mechanism)) == mechanism
    path = tmp_path / "mechanism.pickle"
    path.write_bytes(pickle.dumps(mechanism))
    code = (
        "import pickle, sys, vad; m = pickle.load(open(sys.argv[1], 'rb'));"
        "print(repr(vad.solve(m).slide('ram').acceleration), type(m)().rod)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.split() == [repr(vad.solve(mechanism).slide("ram").acceleration), "180.0"]


def test_the_unit_labels_lengths():
    kind = verified("landing-gear")
    assert kind().length_unit == "mm"
    assert vad.solve(kind(length_unit="cm")).to_dict()["units"]["velocity"] == "cm/s"


@pytest.mark.parametrize("name", ["watt-1", "landing-gear", "oblique-yoke"])
def test_inputs_are_the_file_s_own(name):
    kind, rates = verified(name), BY_NAME[name]["rates"]
    first, *others = kind.inputs
    assert kind.inputs[first] == BY_NAME[name]["poses"][0]["input"]
    assert [kind.inputs[each] for each in others] == pytest.approx(rates, rel=1e-13)
    assert dict(vad.solve(kind()).inputs) == dict(kind.inputs)


def test_there_are_two_dozen_examples():
    assert len(example_names()) >= 24
    wanted = (
        "watt-1 watt-2 stephenson-3 toggle-press drag-link hoeken peaucellier pantograph "
        "jansen-leg atkinson-engine landing-gear oscillating-cylinder beam-engine"
    )
    assert set(wanted.split()) <= set(example_names())

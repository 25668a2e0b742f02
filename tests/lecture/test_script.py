"""A lecturer's script: own captions, pauses, markers, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

import vad
from vad.errors import InputError, UsageError, VadError
from vad.lecture.lesson import Lesson

SHEET = vad.draw(vad.solve(vad.SliderCrank()))
TALK = """\
[captions]
"velocity:pole" = "We begin at the pole."
[pauses]
"velocity:C.crossing" = 3
[markers]
"velocity:pole" = 40
"acceleration:1" = 90.5
"""


def start_of(lesson: Lesson, name: str) -> float:
    """Return the second at which a stroke begins."""
    frame = lesson.opening
    for step in lesson.steps:
        if step.panel.full(step.stroke.name) == name:
            return frame / lesson.fps
        frame += step.frames
    raise KeyError(name)


@pytest.mark.parametrize("speed", [0.8, 1.0, 2.0])
def test_a_script_is_followed(tmp_path: Path, speed: float):
    (tmp_path / "talk.toml").write_text(TALK)
    lesson = vad.animate(SHEET, script=tmp_path / "talk.toml", speed=speed)
    assert lesson.sheet.panel("velocity").strokes[0].caption == "We begin at the pole."
    assert start_of(lesson, "velocity:pole") == pytest.approx(40.0, abs=0.05)
    assert start_of(lesson, "acceleration:pole") == pytest.approx(90.5, abs=0.05)


@pytest.mark.parametrize("step", ["velocity:C.crossing", "velocity:5", "13", 13])
def test_a_pause_prolongs_the_rest_of_its_stroke(step: str | int):
    usual = vad.animate(SHEET)
    slower = vad.animate(SHEET, script={"pauses": {step: 2.5}})
    held = [b.hold - a.hold for a, b in zip(usual.steps, slower.steps, strict=True)]
    assert sum(held) == pytest.approx(75, abs=2)
    assert max(range(len(held)), key=held.__getitem__) == 12


def test_a_caption_of_several_strokes_is_replaced_as_a_whole():
    sheet = vad.draw(vad.solve(vad.HookeJoint()))
    script = {"captions": {"position:P.circle": "The pin P.", "position:P.angle": "Its angle."}}
    told = vad.animate(sheet, script=script).sheet.panel("position")
    said = {name: told.strokes[told.number(name)].caption for name in ("OP.arm", "P.angle")}
    assert said == {"OP.arm": "The pin P.", "P.angle": "Its angle."}
    assert told.strokes[told.number("Q.ellipse")] == sheet.panel("position").strokes[11]


@pytest.mark.parametrize(
    ("script", "said"),
    [
        ({"pauses": {"velocity:C.nothing": 1}}, "not a step"),
        ({"pauses": {"speed:1": 1}}, "unknown panel"),
        ({"pauses": {"1": -1}}, "pause: must be seconds"),
        ({"pauses": {"1": float("nan")}}, "pause: "),
        ({"pauses": 3}, "must be a table"),
        ({"captions": {"1": 3}}, "caption: must be a line of text"),
        ({"colours": {}}, "unknown table"),
        ({"markers": {"velocity:pole": 2}}, "marker: velocity:pole at 2 s"),
        (3, "script: must be the name of a file"),
        ("/nowhere/talk.toml", "No such file"),
    ],
)
def test_what_is_no_script_is_refused_in_one_line(script: object, said: str):
    with pytest.raises(VadError) as refusal:
        vad.animate(SHEET, script=script)
    assert said in str(refusal.value)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("table", ["captions", "pauses", "markers"])
def test_a_step_that_a_sheet_does_not_have_is_named_with_its_line(tmp_path: Path, table: str):
    file = tmp_path / "talk.toml"
    value = '"x"' if table == "captions" else "3"
    file.write_text(f"# velocity:99\n[{table}]\n'velocity:99' = {value}\n")
    with pytest.raises(InputError, match=r"^talk\.toml, line 3: there is no step 99: ") as refusal:
        vad.animate(SHEET, script=file)
    assert not isinstance(refusal.value, UsageError)  # which would be a wrong command
    file.write_text(TALK.replace("= 40", "= 2"))
    with pytest.raises(InputError, match=r"^talk\.toml, line 6: marker: velocity:pole at 2 s"):
        vad.animate(SHEET, script=file)


def test_a_fault_in_a_file_is_named_with_its_line(tmp_path: Path):
    file = tmp_path / "talk.toml"
    file.write_text('[pauses]\n"velocity:1" = "long"\n')
    with pytest.raises(InputError, match=r"^talk\.toml, line 2: pause: "):
        vad.animate(SHEET, script=file)
    file.write_text("[pauses\n")
    with pytest.raises(InputError, match=r"^talk\.toml: is no TOML"):
        vad.animate(SHEET, script=file)


def test_the_name_of_a_stroke_that_is_not_there_is_answered_with_those_that_are():
    for step, hint in (
        ("velocity:pool", "did you mean 'pole'?"),
        ("velocity:xyz", "known: pole, AB.tangential, BC.line, "),
        ("one", "as in 4 or velocity:4"),
    ):
        with pytest.raises(UsageError, match="not a step") as refusal:
            vad.animate(SHEET, script={"captions": {step: "Words."}})
        assert str(refusal.value.hint).startswith(hint)


def test_a_marker_out_of_order_is_refused():
    markers = {"velocity:pole": 60, "acceleration:pole": 50}
    with pytest.raises(UsageError, match="marker: acceleration:pole at 50 s"):
        vad.animate(SHEET, script={"markers": markers})

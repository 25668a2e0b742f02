"""What a type checker says of a user's program: mypy --strict, in a project of its own."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import vad

pytest.importorskip("mypy", reason="mypy comes with the extra 'test'")

ROOT = Path(__file__).parents[1]

GOOD = """\
from pathlib import Path
from typing import assert_type

import numpy as np
from numpy.typing import NDArray

import vad

assert_type(vad.FourBar(crank="4 cm", ground_angle="10 deg").crank, float)
crank = vad.SliderCrank(60, rod=140.0, length_unit="cm")
assert_type(crank.offset, float)
shaper = vad.CrankSlottedLever(rod=120, ram_height=140, ground_angle=-90, assembly="crossed")
assert_type(shaper.rod, float | None)

motion = vad.solve(crank, angle=116.9, omega=10, alpha=np.float64(0))
assert_type(motion, vad.Motion)
assert_type(motion.assembled, bool)
assert_type(motion.link("rod").omega, float)
assert_type(motion.point("C").velocity, complex)
assert_type(motion.slide("slider").coriolis, float | None)
print(round(motion.link("rod").omega, 4), motion.table(), motion.links)
vad.solve(vad.FourBar(), omega="120 rpm")
vad.solve(vad.DoubleSlider(1000, 0, 90), position=500, velocity=2000, acceleration=0)

turn = vad.solve(vad.FourBar(), angle=np.linspace(0, 360, 7), omega=10.0)
assert_type(turn, vad.Motions)
assert_type(turn.assembled, NDArray[np.bool_])
assert_type(turn.link("rocker").alpha, NDArray[np.float64])
assert_type(turn.point("C").position, NDArray[np.complex128])
assert_type(vad.solve(vad.FourBar(), angle=[0.0, 90.0]), vad.Motions)
assert_type(vad.solve(vad.FourBar(), omega=np.arange(3)), vad.Motions)

sheet = vad.draw(motion, panels=("velocity",), language="de")
assert_type(sheet, vad.Sheet)
lesson = vad.animate(sheet, fps=25, size=(640, 480), speed=2, style="chalk")
assert_type(lesson, vad.Lesson)
assert_type(vad.turn(crank), vad.Turn)
assert_type(vad.turn(motion), vad.Turn)
assert_type(vad.still(lesson, "velocity:4"), vad.Still)


for made in vad.batch("sheets.toml", Path("sheets"), jobs=2):
    print(made.number, made.files, made.answers["links"], made.error and made.error.hint)
print(vad.sweep(crank, ("rod.omega", "C.velocity"), angle=np.linspace(0, 360, 7))["rod.omega"])


def told(done: int, total: int) -> None:
    print(done, total)


vad.save(sheet, Path("sheet.pdf"), paper="A4")
vad.save(lesson, "lesson.mp4", progress=told, subtitles=False, beside=(".srt", ".vtt"))


def solved(kind: type[vad.Mechanism]) -> vad.Motion | vad.VadError:
    try:
        return vad.solve(kind())
    except vad.AssemblyError as error:
        print(error.hint)
        return error


Press = vad.load("press.toml")
print(vad.solve(Press(crank=175), angle=40).slide("ram").velocity, Press().links)
print([solved(kind) for kind in vad.MECHANISMS.values()], vad.__version__)
"""

# What is wrong with a line stands behind it: the code of the error, and words of its message.
BAD = """\
import vad

vad.solve("nonsense", angel=3)  # call-overload: did you mean "angle"; call-overload: "str", "int"
vad.solve("nonsense")  # call-overload: "str"
vad.solve(vad.FourBar(), angel=3)  # call-overload: did you mean "angle"; call-overload: variant
vad.solve(vad.FourBar(), angle=3j)  # call-overload: "complex"
vad.solve(vad.FourBar(), position=4)  # call-overload: "FourBar", "int"
vad.FourBar(crnk=4)  # call-arg: did you mean "crank"
vad.solve(vad.DoubleSlider(), angle=4)  # call-overload: "DoubleSlider", "int"
vad.FourBar(crank=[4])  # arg-type: "float | str"
vad.Whitworth(rod=[4])  # arg-type: "float | str | None"
vad.FourBar(100, 40, 120, 80, 0)  # call-arg: Too many; arg-type: "str"
vad.FourBar().crank = 3.0  # misc: read-only
motion = vad.solve(vad.FourBar(), angle=60)
rate: str = motion.link("rocker").omega  # assignment: "float"
speed: float = motion.point("C").velocity  # assignment: "complex"
motion.joint("C")  # attr-defined: "joint"
vad.draw(vad.solve(vad.FourBar(), angle=[0, 90]))  # arg-type: "Motion[float, complex
sheet = vad.draw(motion)
vad.animate(motion)  # arg-type: "Sheet"
vad.animate(sheet, fsp=30)  # call-arg: "fsp"
lesson: vad.Turn = vad.animate(sheet)  # assignment: "Lesson"
vad.save(motion, "a.png")  # arg-type: "Motion[float, complex
vad.save(sheet, "a.png", size="640x480")  # arg-type: "tuple[int, int] | None"
vad.save(sheet, "a.png", siez=(640, 480))  # call-arg: "siez"
vad.slove(vad.FourBar())  # attr-defined: "slove"
"""


# Of the library, mypy sees its types and is silent about it, as about an installed one.  Types of
# those that it uses do not occur in its own: to read them takes ten seconds and changes nothing.
SETTINGS = """\
[mypy]
strict = True
follow_imports = silent

[mypy-matplotlib.*,PIL.*,av.*,mpmath.*,pint.*,fontTools.*,rich.*,click.*]
follow_imports = skip
"""


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[str]]:
    """Return what mypy says of the two programs: code and message behind file and line."""
    project = tmp_path_factory.mktemp("project")
    (project / "good.py").write_text(GOOD)
    (project / "bad.py").write_text(BAD)
    (project / "mypy.ini").write_text(SETTINGS)
    words = ["--config-file=mypy.ini", f"--cache-dir={os.devnull}", "--hide-error-context"]
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *words, "good.py", "bad.py"],
        cwd=project,
        env={**os.environ, "MYPYPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""
    found: dict[str, list[str]] = {}
    for place, message, code in re.findall(r"(\w+\.py:\d+): error: (.*)  \[(.*)\]", done.stdout):
        found.setdefault(place, []).append(f"{code}: {message}")
    assert done.stdout.splitlines()[-1].startswith(f"Found {sum(map(len, found.values()))} errors")
    return found


def test_a_good_program_passes(said):
    assert [place for place in said if place.startswith("good")] == []


def test_every_mistake_is_found_for_its_reason(said):
    for number, line in enumerate(BAD.splitlines(), 1):
        reasons = [reason for reason in line.partition("  # ")[2].split("; ") if reason]
        errors = said.get(f"bad.py:{number}", [])
        assert len(errors) == len(reasons), line
        for error, reason in zip(errors, reasons, strict=True):
            code, _, words = reason.partition(": ")
            assert error.startswith(f"{code}: ")
            assert words in error


def test_the_types_are_shipped():
    assert (Path(vad.__file__).parent / "py.typed").exists()

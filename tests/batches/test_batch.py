"""Sheets by the hundred: the same for any number of workers, and never made twice."""

from __future__ import annotations

import cmath
import csv
import dataclasses
import json
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pypdf
import pytest

import vad
from tests.batches.conftest import CLASS
from tests.oracle import reference
from vad.batches import making

ROOT = Path(__file__).parents[2]
EVERYTHING = """\
[sheet]
mechanism = "scotch-yoke"
count = 2
files = ["problem.pdf", "film.mp4"]
size = [320, 240]
fps = 5
speed = 100
[vary]
crank = { from = 20, to = 90 }
angle = [30, 60]
"""


def test_any_number_of_workers_makes_the_same_bytes(written, contents, tmp_path):
    path = written(EVERYTHING)
    vad.batch(path, tmp_path / "one")
    vad.batch(path, tmp_path / "two", jobs=2)
    files = ("problem.pdf", "film.mp4")
    names = {f"{number}-{file}" for number in ("001", "002") for file in files}
    assert set(contents(tmp_path / "one")) == names | {"answers.csv", "answers.json"}
    assert contents(tmp_path / "one") == contents(tmp_path / "two")


def test_a_problem_is_its_key_without_the_answers(written, tmp_path):
    text = CLASS.replace('["key.json"]', '["problem.pdf", "key.pdf"]').replace("10", "1")
    (done,) = vad.batch(written(text), tmp_path / "out")
    problem, key = (pypdf.PdfReader(path).pages[0] for path in done.files)
    assert key.mediabox.width == pytest.approx(297 / 25.4 * 72, abs=0.01)
    rocker = f"{done.answers['links']['rocker']['omega']:.3f}".replace("-", "−")
    assert "001" in problem.extract_text()
    assert rocker in key.extract_text()
    assert rocker not in problem.extract_text()


def test_the_numbers_are_nice_and_kept_from_dead_centres(written, tmp_path):
    made = vad.batch(written(), tmp_path / "out")
    assert [each.number for each in made] == list(range(1, 11))
    for each in made:
        parameters, given = each.answers["parameters"], each.answers["input"]
        assert parameters["crank"] in (30, 35, 40, 45, 50)
        assert parameters["coupler"] in (90, 95, 100, 110, 120, 130, 140, 150)
        assert (parameters["ground"], parameters["rocker"]) == (100, 80)
        assert given["angle"] % 5 == 0 <= given["angle"] <= 355
        links = {name: each.answers["links"][name]["angle"] for name in ("coupler", "rocker")}
        turned = complex(0, 1) ** ((links["coupler"] - links["rocker"]) / 90)
        assert abs(turned.imag) >= 0.35
    assert len({json.dumps(each.answers["input"]) for each in made}) > 5


def vector(degrees: float) -> complex:
    return cmath.rect(1.0, math.radians(degrees))


def test_the_answers_are_those_of_the_oracle(written, tmp_path):
    vad.batch(written(), tmp_path / "out")
    for answer in json.loads((tmp_path / "out" / "answers.json").read_text("utf-8")):
        truth = reference("four-bar", answer["parameters"], answer["input"])
        for kind in ("link", "point"):
            for name, results in answer[f"{kind}s"].items():
                for quantity, value in results.items():
                    found = complex(*value) if isinstance(value, list) else value
                    wanted = complex(truth[kind, name, quantity].value)
                    if quantity == "angle":
                        found, wanted = vector(found), vector(math.degrees(wanted.real))
                    scale = 1e5 if quantity == "acceleration" else 1e3
                    assert abs(found - wanted) < 1e-12 * scale, (name, quantity)


def test_the_table_holds_what_the_data_hold(written, tmp_path):
    made = vad.batch(written(), tmp_path / "out")
    with open(tmp_path / "out" / "answers.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [int(row["number"]) for row in rows] == [each.number for each in made]
    for row, each in zip(rows, made, strict=True):
        assert float(row["crank"]) == each.answers["parameters"]["crank"]
        assert float(row["rocker omega [rad/s]"]) == each.answers["links"]["rocker"]["omega"]
        assert float(row["C velocity y [mm/s]"]) == each.answers["points"]["C"]["velocity"][1]


def test_answers_can_be_given_again_as_a_table_of_sheets(written, tmp_path):
    made = vad.batch(written(), tmp_path / "out")
    with open(tmp_path / "out" / "answers.csv", newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    given = [place for place, name in enumerate(head) if "[" not in name and name != "number"]
    lines = [",".join(row[place] for place in given) + ",key.json" for row in rows]
    text = "\n".join([",".join(head[place] for place in given) + ",files", *lines])
    again = vad.batch(written(text, "again.csv"), tmp_path / "again")
    assert [each.answers for each in again] == [each.answers for each in made]


def stamps(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.glob("*-*")}


def test_what_was_killed_goes_on_where_it_was(written, contents, tmp_path):
    path = written(CLASS.replace("key.json", "key.svg").replace("10", "6"))
    out = tmp_path / "out"
    words = [sys.executable, "-m", "vad", "batch", str(path), "-o", str(out)]
    with subprocess.Popen(words, env={**os.environ, "PYTHONPATH": str(ROOT)}) as running:
        deadline = time.monotonic() + 60
        while not (out / "002-key.svg").exists():
            assert time.monotonic() < deadline
            time.sleep(0.01)
        running.send_signal(signal.SIGKILL)
    before = stamps(out)
    made = vad.batch(path, out)
    new = {each.number for each in made if each.new}
    assert 1 not in new
    assert 6 in new
    assert {name: stamp for name, stamp in stamps(out).items() if int(name[:3]) not in new} == {
        name: stamp for name, stamp in before.items() if int(name[:3]) not in new
    }
    vad.batch(path, tmp_path / "whole")
    assert contents(out) == contents(tmp_path / "whole")


def test_a_sheet_stands_only_if_it_is_what_would_be_made(written, contents, tmp_path):
    out = tmp_path / "out"

    def made_anew(text: str) -> list[int]:
        return [each.number for each in vad.batch(written(text), out) if each.new]

    everything = list(range(1, 11))
    assert made_anew(CLASS) == everything
    whole = contents(out)
    assert made_anew(CLASS) == []
    assert made_anew("# a remark\n" + CLASS) == []
    (out / "004-key.json").write_text("{}")
    (out / "007-key.json").unlink()
    assert made_anew(CLASS) == [4, 7]
    assert contents(out) == whole
    assert made_anew(CLASS.replace("10", "12")) == [11, 12]
    assert made_anew(CLASS.replace("0.35", "0.5")) == everything
    assert made_anew(CLASS) == everything
    assert contents(out) == whole | {n: contents(out)[n] for n in ("011-key.json", "012-key.json")}


DAMAGE = {
    "a digit": lambda line: line.replace(b'"input": {"angle": ', b'"input": {"angle": 1'),
    "a byte that is no text": lambda line: line.replace(b"four", b"f\xffur"),
    "a line that is cut short": lambda line: line[: len(line) // 2],
    "a number of another kind": lambda line: line.replace(b'"number": 4', b'"number": [4]'),
    "no files": lambda line: line.replace(b'"files": {', b'"files": 3, "file": {'),
    "no units": lambda line: line.replace(b'"units"', b'"unit"'),
    "half a letter": lambda line: line.replace(b'"mm"', b'"\\ud800"'),
    "depth": lambda line: b"[" * 100_000,
    "digits": lambda line: b'{"number": ' + b"9" * 10_000 + b"}",
    "another value": lambda line: b"4",
}


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("damage", DAMAGE)
@pytest.mark.parametrize("name", ["answers.json", "answers.part.jsonl"])
def test_of_damaged_answers_one_sheet_is_made_anew(written, contents, tmp_path, damage, name):
    path, out = written(), tmp_path / "out"
    vad.batch(path, out)
    whole = contents(out)
    lines = (out / "answers.json").read_bytes().split(b"\n")
    assert DAMAGE[damage](lines[4]) != lines[4]
    lines[4] = DAMAGE[damage](lines[4])
    (out / "answers.json").unlink()
    (out / name).write_bytes(b"\n".join(lines))
    assert [each.number for each in vad.batch(path, out) if each.new] == [4]
    assert contents(out) == whole


def test_a_line_that_was_cut_short_costs_no_other_one(written, contents, tmp_path):
    path, out = written(), tmp_path / "out"
    whole = vad.batch(path, out)
    lines = (out / "answers.json").read_bytes().split(b"\n")[1:4]
    (out / "answers.json").unlink()
    (out / "answers.part.jsonl").write_bytes(b"\n".join(lines)[:-99])

    def stop(done: int, total: int) -> None:
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        vad.batch(path, out, progress=stop)
    made = vad.batch(path, out)
    assert [each.number for each in made if each.new] == [5, 6, 7, 8, 9, 10]
    assert [each.answers for each in made] == [each.answers for each in whole]


def test_a_later_damaged_line_hides_no_earlier_one(written, tmp_path):
    path, out = written(), tmp_path / "out"
    vad.batch(path, out)
    lines = (out / "answers.json").read_bytes().split(b"\n")
    (out / "answers.part.jsonl").write_bytes(DAMAGE["a digit"](lines[4]))
    assert not [each.number for each in vad.batch(path, out) if each.new]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes with names")
@pytest.mark.parametrize("name", ["answers.json", "001-key.json"])
def test_a_pipe_among_the_files_is_not_waited_for(written, tmp_path, name):
    (tmp_path / "out").mkdir()
    os.mkfifo(tmp_path / "out" / name)
    with pytest.raises(vad.ExportError, match="is not a file that can be replaced"):
        vad.batch(written(), tmp_path / "out")


def test_one_sheet_is_made_again(written, contents, tmp_path):
    path, out = written(), tmp_path / "out"
    (alone,) = vad.batch(path, out, only=7)
    assert alone.number == 7
    one = contents(out)
    assert set(one) == {"007-key.json", "answers.csv", "answers.json"}
    vad.batch(path, out)
    assert contents(out)["007-key.json"] == one["007-key.json"]
    whole, (again,) = contents(out), vad.batch(path, out, only=7)
    assert again.new
    assert contents(out) == whole


def test_a_row_that_fails_is_no_hindrance(written, tmp_path):
    path = written(
        "mechanism,crank,angle,files\n"
        "four-bar,40,60,key.json\n"
        "four-bar,130,0,key.json\n"
        "four-bra,40,60,key.json\n"
        "scotch-yoke,,,key.json\n",
        "sheets.csv",
    )
    made = vad.batch(path, tmp_path / "out", jobs=2)
    assert [each.error is None for each in made] == [True, False, False, True]
    assert str(made[1].error).startswith("sheets.csv, line 3: angle 0°: the links miss by")
    assert isinstance(made[1].error, vad.AssemblyError)
    assert [path.name for path in sorted((tmp_path / "out").glob("0*"))] == [
        "001-key.json",
        "004-key.json",
    ]
    answers = json.loads((tmp_path / "out" / "answers.json").read_text("utf-8"))
    assert [each["number"] for each in answers] == [1, 4]


def test_numbers_that_are_nowhere_found_name_the_dyad(written, tmp_path, monkeypatch):
    assert making.TRIES == 2000
    monkeypatch.setattr(making, "TRIES", 50)
    text = CLASS.replace("{ share = 0.25 }", "[400, 450]", 1).replace("10", "1")
    (done,) = vad.batch(written(text), tmp_path / "out")
    assert "in 50 tries" in str(done.error)
    assert "coupler and rocker" in str(done.error)


@pytest.mark.parametrize(
    ("options", "part"),
    [
        ({"jobs": 0}, "jobs: must be a whole number from 1 on"),
        ({"jobs": 2, "cluster": "tcp://127.0.0.1:1"}, "jobs: a cluster has its own workers"),
        ({"only": 11}, "only: there is no sheet 11"),
        ({"only": True}, "only: there is no sheet True"),
        ({"folder": 3}, "folder: must be the name of a folder, got 3"),
    ],
)
def test_what_cannot_be_asked_for(written, tmp_path, options, part):
    with pytest.raises(vad.UsageError) as caught:
        vad.batch(**{"path": written(), "folder": tmp_path / "out", **options})
    assert part in str(caught.value)
    assert not (tmp_path / "out").exists()


def test_progress_is_told(written, tmp_path):
    told = []
    vad.batch(written(), tmp_path / "out", progress=lambda *counts: told.append(counts))
    assert told == [(count, 10) for count in range(1, 11)]


def test_a_film_is_encoded_by_one_thread(written, tmp_path):
    """Its bytes depend on their number, and are to be the same on every machine."""
    text = CLASS.replace('"key.json"', '"film.mp4"').replace("10\n", "1\n")
    look = "size = [320, 240]\nfps = 5\nspeed = 30\n"
    (made,) = vad.batch(written(text.replace("[vary]", look + "[vary]")), tmp_path / "out")
    mechanism = vad.FourBar(**made.answers["parameters"])
    sheet = vad.draw(vad.solve(mechanism, **made.answers["input"]))
    sheet = dataclasses.replace(sheet, title=f"{sheet.title} · 001")
    lesson = vad.animate(sheet, fps=5, size=(320, 240), speed=30)
    films = []
    for threads in (1, 2):
        vad.save(lesson, tmp_path / "film.mp4", threads=threads)
        films.append((tmp_path / "film.mp4").read_bytes())
    assert films[0] != films[1]
    assert made.files[0].read_bytes() == films[0]


def test_numbers_in_the_cells_of_a_table_may_have_a_fraction(written, tmp_path):
    table = "mechanism,files,size,fps,speed\nfour-bar,film.srt,320x240,12.5,2.5\n"
    (made,) = vad.batch(written(table, "sheets.csv"), tmp_path / "out")
    assert made.error is None
    mechanism = vad.FourBar(**made.answers["parameters"])
    sheet = vad.draw(vad.solve(mechanism, **made.answers["input"]))
    vad.save(vad.animate(sheet, fps=12.5, speed=2.5), tmp_path / "film.srt")
    assert made.files[0].read_bytes() == (tmp_path / "film.srt").read_bytes()


@pytest.mark.exhaustive(3)
@pytest.mark.parametrize(
    ("panels", "found"),
    [
        (["centres"], "639.5"),
        (["turned"], "639.5"),
        (["klein"], "63.95"),
        (["centres", "velocity"], "639.5"),
        (["position", "velocity"], "639.5"),
    ],
)
def test_a_problem_shows_no_number_that_its_panels_find(tmp_path, panels, found):
    """Whatever the kind of diagram is: the velocity of the slider, or the side AM of Klein."""
    (tmp_path / "sheets.toml").write_text(
        f"""\
[sheet]
mechanism = "slider-crank"
panels = {panels}
files = ["problem.svg", "key.svg"]
count = 1
"""
    )
    (made,) = vad.batch(tmp_path / "sheets.toml", tmp_path / "out")
    problem, key = (path.read_text("utf-8") for path in made.files)
    assert found in key
    assert found not in problem

"""Whatever is called with whatever: one line of a `VadError`, or an answer."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest

import vad
from tests.fuzz import calls, files, linkages
from tests.fuzz.promise import broken

MOTION = vad.solve(vad.FourBar())
SHEET = vad.draw(MOTION)
LESSON = vad.animate(SHEET)
BOTH = np.array([60.0, 61.0])
NONE: Any = np.array([])
MASS = {"coupler": {"mass": 2, "at": NONE}}
ENGINE: Any = ([{"mass": 11.5, "line": 45}], 75, 4, 500)


@pytest.mark.parametrize("entrance", [calls, files, linkages])
def test_nothing_that_comes_in_breaks_the_promise(entrance, exhaustive):
    seeds = range(200 if exhaustive else 20)
    found = {seed: entrance.fault(entrance.case(seed), seed) for seed in seeds}
    assert {seed: told for seed, told in found.items() if told} == {}


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: vad.load(True), "path: must be the name of a file, got True"),
        (lambda: vad.load(calls.EndlessPath()), "path: must be the name of a file"),
        (lambda: vad.load("x" * 100_000), "'xxx"),
        (lambda: vad.load("x" * 252), "'xxx"),
        (lambda: vad.sheet_from_json(calls.EndlessPath()), "sheet: must be the name of a file"),
        (lambda: vad.save(SHEET, calls.EndlessPath()), "path: must be the name of a file"),
        (lambda: vad.batch(calls.EndlessPath(), "out"), "path: must be the name of a file"),
        (lambda: vad.sweep(vad.FourBar(), results=None), "results: must be names of results"),
        (lambda: vad.sweep(vad.FourBar(), itertools.count()), "results: must be names of results"),
        (lambda: vad.solve(MOTION), "mechanism: must be a mechanism with its dimensions"),
        (lambda: vad.solve(SHEET), "mechanism: must be a mechanism with its dimensions"),
        (lambda: vad.turn(LESSON), "mechanism: must be a mechanism with its dimensions"),
        (lambda: vad.draw(MOTION, itertools.repeat("velocity")), "panels: must be names of panels"),
        (lambda: vad.draw(MOTION, language=[]), "unknown language []"),
        (lambda: vad.draw(MOTION, language={}), "unknown language {}"),
        (lambda: vad.multiples(vad.FourBar(), itertools.count()), "at: must be 2 to 6 places"),
        (lambda: vad.animate(SHEET, size=itertools.repeat("x")), "size: must be a width and a"),
        (lambda: vad.save(vad.still(LESSON, 1), "o.pdf", paper=BOTH), "paper: not for a step"),
        (lambda: vad.save(SHEET, "o.pdf", paper=BOTH), "unknown paper"),
        (lambda: vad.save(SHEET, "o.pdf", paper=""), "unknown paper"),
        (lambda: vad.save(SHEET, "o.html", style=BOTH), "unknown style"),
        (lambda: vad.save(SHEET, "o.svg", beside=np.array(60.0)), "beside: must be extensions"),
        (lambda: vad.save(SHEET, "o.svg", beside=itertools.count()), "beside: must be extensions"),
        (lambda: vad.save(SHEET, "o.svg", blank=itertools.count()), "blank: must be names of"),
        (lambda: vad.save(LESSON, "o.mp4", subtitles=BOTH), "subtitles: must be True or False"),
        (lambda: vad.save(LESSON, "o.mp4", threads="x"), "threads: must be a whole number"),
        (lambda: vad.FourBar(crank=np.timedelta64(1, "s")), "crank: must be a number"),
        (lambda: vad.FourBar(crank=np.complex128(1 + 2j)), "crank: must be a number"),
        (lambda: vad.FourBar(crank=bytearray(b"60")), "crank: must be a number"),
        (lambda: vad.merit(vad.FourBar(crank=np.array([60.0]))), "crank: must be one number"),
        (lambda: vad.draw(MOTION, superpose=NONE), "superpose: must be True or False"),
        (lambda: vad.draw(MOTION, pins=NONE), "pins: must be diameters by point"),
        (lambda: vad.animate(SHEET, plain=NONE), "plain: must be True or False"),
        (lambda: vad.turn(vad.FourBar(), follow=NONE), "unknown follow"),
        (lambda: vad.load(NONE), "path: must be the name of a file"),
        (lambda: vad.still(LESSON, NONE), "array([], dtype=float64) is not a step"),
        (lambda: vad.forces(MOTION, masses=MASS), "mass of coupler: unknown point"),
        (lambda: vad.engine(*ENGINE, reference=NONE), "reference: must be one number"),
        (lambda: vad.engine(*ENGINE, shaft=BOTH), "shaft.masses: A: must be words"),
        (lambda: vad.engine(*ENGINE, locomotive=NONE), "locomotive: must be a table"),
        (lambda: vad.merit(vad.FourBar(), output=NONE), "unknown output"),
        (lambda: vad.merit(vad.FourBar(), pins=NONE), "pins: must be diameters by point"),
        (lambda: vad.forces(MOTION).force([], "rocker"), "unknown body []"),  # type: ignore[arg-type]
        (lambda: vad.FourBar(crank=np.array(["60"])), "crank: must be a number or an array"),
        (lambda: vad.FourBar(crank=10**5000), "crank: must be a finite number, got an int"),
    ],
)
def test_what_cannot_be_is_said_in_one_line(call, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found: list[Any] = []

    def tried() -> None:
        with pytest.raises(vad.VadError) as caught:
            call()
        found.append(caught.value)
        raise caught.value

    assert broken(tried, calls.LONGEST) is None
    assert str(found[0]).startswith(said)
    assert not list(tmp_path.iterdir())


def test_a_call_with_an_unknown_progress_is_refused_before_anything_is_made(tmp_path):
    sheets = tmp_path / "sheets.toml"
    sheets.write_text('[sheet]\nmechanism = "four-bar"\nfiles = ["key.json"]\n', "utf-8")
    with pytest.raises(vad.UsageError, match=r"^progress: must be a function"):
        vad.batch(sheets, tmp_path / "out", progress="often")  # type: ignore[arg-type]
    assert not (tmp_path / "out").exists()

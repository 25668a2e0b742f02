"""Single steps, subtitles beside a film, and the size of a picture."""

from __future__ import annotations

import pytest
from PIL import Image

SMALL = ("--fps", "5", "--size", "320x240", "--speed", "20")


def made(vad, *words):
    result = vad(*words)
    assert (result.code, result.out, result.err) == (0, "", "")


@pytest.mark.parametrize("name", ["step.png", "step.svg", "step.pdf"])
def test_one_step(vad, tmp_path, name):
    made(vad, "animate", "slider-crank", "--still", "velocity:4", "-o", str(tmp_path / name))
    assert [each.name for each in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize(
    ("words", "part"),
    [
        ("--still 99 -o a.png", "there is no step 99: the lesson has"),
        ("--still 1 -o a.mp4", "one step of a film cannot be saved as"),
        ("--still 1 -o a.png --subtitles", "--subtitles go beside a film"),
        ("--subtitles -o a.pdf", "--subtitles go beside a film"),
        ("-o a.png", "a film cannot be saved as 'a.png'"),
    ],
)
def test_what_does_not_go_together(vad, tmp_path, monkeypatch, words, part):
    monkeypatch.chdir(tmp_path)
    result = vad("animate", "slider-crank", *words.split())
    assert result.code == 2
    assert part in result.err
    assert not list(tmp_path.iterdir())


@pytest.mark.exhaustive(3)
@pytest.mark.parametrize("name", ["film.mp4", "film.gif", "film/"])
def test_subtitles(vad, tmp_path, name):
    made(vad, "animate", "scotch-yoke", *SMALL, "--subtitles", "-o", f"{tmp_path}/{name}")
    names = {each.name for each in tmp_path.iterdir()}
    assert names == {name.strip("/"), "film.srt", "film.vtt"}


def test_pages(vad, tmp_path):
    path = tmp_path / "lesson.pdf"
    made(vad, "animate", "scotch-yoke", "-o", str(path))
    assert path.read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize("size", [(1024, 768), (640, 360)])
def test_the_size_of_a_picture(vad, tmp_path, size):
    path = tmp_path / "sheet.png"
    made(vad, "draw", "slider-crank", "--size", f"{size[0]}x{size[1]}", "-o", str(path))
    with Image.open(path) as picture:
        assert picture.size == size


def test_a_size_that_cannot_be(vad, tmp_path):
    result = vad("draw", "slider-crank", "--size", "10x10", "-o", str(tmp_path / "sheet.png"))
    assert (result.code, result.out) == (2, "")
    assert result.err.startswith("error: size: must be between 320x240")
    assert not list(tmp_path.iterdir())


def test_a_problem_sheet(vad, tmp_path):
    path = tmp_path / "problem.svg"
    made(vad, "draw", "scotch-yoke", "--blank", "velocity,acceleration", "-o", str(path))
    svg = path.read_text("utf-8")
    assert "velocity:pole" in svg and "velocity:CB.line" not in svg


@pytest.mark.parametrize(
    "words",
    ["scotch-yoke --at 30,0.25turn,2rad", "gate-actuator --at 3.5,46in", "four-bar --at=-60,60"],
)
def test_poses_side_by_side(vad, tmp_path, words):
    path = tmp_path / "poses.svg"
    made(vad, "draw", *words.split(), "--panels", "position", "-o", str(path))
    count = words.count(",") + 1
    assert path.read_text("utf-8").count("Position: ") == count


@pytest.mark.parametrize(
    ("words", "part"),
    [
        ("--blank velocty -o a.png", "--blank: unknown panel 'velocty'"),
        ("--blank velocity -o a.json", "--blank is for pictures, not for 'a.json'"),
        ("--panels position --blank velocity -o a.png", "unknown panel 'velocity'"),
        ("--at 30 -o a.png", "--at: must be 2 to 6 places of the driver, got 1"),
        ("--at 30,x -o a.png", "--at: 'x' is not a number"),
        ("--at 30,4mm -o a.png", "--at: 'mm' is not a unit of angle"),
        ("--at 30,60 --angle 20 -o a.png", "--at: takes the place of --angle"),
        ("--at 30,60 -o a.json", "several poses cannot be saved as"),
        ("--at 30,60 --blank velocity -o a.png", "blank: not for several poses"),
    ],
)
def test_problems_and_poses_that_cannot_be(vad, tmp_path, monkeypatch, words, part):
    monkeypatch.chdir(tmp_path)
    result = vad("draw", "slider-crank", *words.split())
    assert result.code == 2
    assert part in result.err and len(result.err.splitlines()) <= 2
    assert not list(tmp_path.iterdir())


def test_a_pose_that_does_not_close_is_said_of_its_option(vad, tmp_path):
    result = vad("draw", "four-bar", "--crank", "130", "--at", "30,10", "-o", f"{tmp_path}/a.png")
    assert result.code == 1
    assert result.err.startswith("error: --at: angle 10°: the links miss")


def test_true_scale(vad, tmp_path):
    path = tmp_path / "sheet.pdf"
    made(vad, "draw", "slider-crank", "--paper", "A4", "-o", str(path))
    assert path.read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(
    ("words", "part"),
    [
        ("--paper A4 -o a.png", "--paper is for PDF, not for 'a.png'"),
        ("--paper A4 -o a.json", "--paper is for PDF"),
        ("--paper A5 -o a.pdf", "--paper: unknown paper 'A5'"),
        ("--paper A4 --size 640x480 -o a.pdf", "paper: not for a picture with a size"),
    ],
)
def test_true_scale_is_for_pdf(vad, tmp_path, monkeypatch, words, part):
    monkeypatch.chdir(tmp_path)
    result = vad("draw", "slider-crank", *words.split())
    assert result.code == 2
    assert part in result.err
    assert not list(tmp_path.iterdir())

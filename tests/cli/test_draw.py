"""``vad draw`` and ``vad animate``: files by extension, and what a terminal sees of it."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

import vad as library
from vad.mechanisms import MECHANISMS
from vad.style import style_names
from vad.words import languages

SMALL = ("--fps", "5", "--size", "320x240", "--speed", "20")
BEGINNINGS = {
    "png": b"\x89PNG",
    "svg": b"<?xml",
    "pdf": b"%PDF",
    "json": b"{",
    "mp4": b"\x00\x00\x00",
    "gif": b"GIF8",
}


def made(vad, *words):
    result = vad(*words)
    assert (result.code, result.out, result.err) == (0, "", "")


@pytest.mark.parametrize("extension", ["png", "svg", "pdf", "json", "JSON"])
def test_a_picture_by_its_extension(vad, tmp_path, extension):
    path = tmp_path / f"sheet.{extension}"
    made(vad, "draw", "slider-crank", "-o", str(path))
    assert path.read_bytes().startswith(BEGINNINGS[extension.lower()])


@pytest.mark.parametrize("name", MECHANISMS)
def test_the_strokes_of_every_mechanism(vad, tmp_path, name):
    path = tmp_path / "sheet.json"
    made(vad, "draw", name, "-o", str(path))
    sheet = json.loads(path.read_text(encoding="utf-8"))
    assert sheet["mechanism"] == name
    assert set(sheet["panels"]) == {"position", "velocity", "acceleration"}


@pytest.mark.parametrize(
    ("words", "panels"),
    [
        ([], ["position", "velocity", "acceleration"]),
        (["--panels", "velocity"], ["velocity"]),
        (["--panels", "position,velocity"], ["position", "velocity"]),
        (["--panels", "position, acceleration"], ["position", "acceleration"]),
        (["--panels", "position", "--panels", "velocity"], ["position", "velocity"]),
        (["--panels", "velocity,velocity", "--panels=velocity"], ["velocity"]),
    ],
)
def test_panels(vad, tmp_path, words, panels):
    path = tmp_path / "sheet.json"
    made(vad, "draw", "four-bar", *words, "-o", str(path))
    assert sorted(json.loads(path.read_text(encoding="utf-8"))["panels"]) == sorted(panels)


@pytest.mark.exhaustive(3)
@pytest.mark.parametrize("style", style_names())
def test_styles(vad, tmp_path, style):
    path = tmp_path / "sheet.png"
    made(vad, "draw", "scotch-yoke", "--style", style, "-o", str(path))
    made(vad, "animate", "scotch-yoke", "--style", style, *SMALL, "-o", str(tmp_path / "a.gif"))


@pytest.mark.parametrize("code", languages())
def test_languages(vad, tmp_path, code):
    path = tmp_path / "sheet.json"
    made(vad, "draw", "four-bar", "--language", code, "-o", str(path))
    sheet = library.draw(library.solve(library.FourBar()), language=code)
    stroke = json.loads(path.read_text(encoding="utf-8"))["panels"]["velocity"]["strokes"][-1]
    assert stroke["caption"] == sheet.panel("velocity").strokes[-1].caption


@pytest.mark.parametrize("extension", ["mp4", "gif"])
def test_a_film_by_its_extension(vad, tmp_path, extension):
    path = tmp_path / f"film.{extension}"
    made(vad, "animate", "slider-crank", *SMALL, "-o", str(path))
    assert path.read_bytes().startswith(BEGINNINGS[extension])
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_a_folder_of_frames(vad, tmp_path):
    made(vad, "animate", "scotch-yoke", *SMALL, "-o", f"{tmp_path}/frames/")
    frames = sorted((tmp_path / "frames").iterdir())
    assert len(frames) > 3
    assert all(frame.read_bytes().startswith(BEGINNINGS["png"]) for frame in frames)


@pytest.mark.parametrize(
    "words",
    [
        "--fps 0", "--fps -1", "--fps nan", "--fps inf", "--fps 1e9", "--speed 0", "--speed -2",
        "--speed nan", "--speed 1e-300", "--speed inf", "--size 0x0", "--size 1x1",
        "--size 999999999x999999999", "--size 99999x2",
    ],
)  # fmt: skip
def test_timing_out_of_range(vad, tmp_path, words):
    path = tmp_path / "film.mp4"
    result = vad("animate", "scotch-yoke", *words.split(), "-o", str(path))
    assert result.code in (1, 2)
    assert result.err.startswith("error: ")
    assert len(result.err.splitlines()) <= 2
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("verb", "name"), [("draw", "a.png"), ("animate", "a.mp4"), ("sweep", "a.csv")]
)
def test_a_place_that_cannot_be_written(vad, tmp_path, verb, name):
    for path in (tmp_path / "nowhere" / name, tmp_path / name):
        (tmp_path / name).mkdir(exist_ok=True)
        result = vad(verb, "scotch-yoke", "-o", str(path))
        assert (result.code, result.out) == (1, "")
        assert result.err.startswith("error: ")
    assert not list((tmp_path / name).iterdir())


def test_names_in_any_script(vad, tmp_path):
    path = tmp_path / "Schubkurbel ω′ 曲柄.json"
    made(vad, "draw", "slider-crank", "-o", str(path))
    assert path.exists()


@pytest.mark.skipif(os.name != "posix", reason="a terminal of POSIX")
def test_a_terminal_sees_progress_and_what_was_written(environment, tmp_path):
    import pty

    main, side = pty.openpty()
    command = [sys.executable, "-m", "vad", "animate", "scotch-yoke", *SMALL, "-o", "film.gif"]
    with subprocess.Popen(
        command, stdout=side, stderr=side, env={**environment, "TERM": "xterm"}, cwd=tmp_path
    ) as running:
        os.close(side)
        seen = b""
        try:
            while part := os.read(main, 4096):
                seen += part
        except OSError:  # how Linux says that the other side has been closed
            pass
        os.close(main)
    assert running.returncode == 0
    assert b"film.gif" in seen and b"%" in seen
    assert b"wrote film.gif (" in seen.splitlines()[-1]

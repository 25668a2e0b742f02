"""The gallery: its scenes assemble, its films are small, its pictures come out the same."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest
from PIL import Image

import vad
from gallery import build
from vad.cli.run import run
from vad.export.sheet_json import to_dict
from vad.files.examples import example_path
from vad.style import style_names

FILMS = sorted(build.HERE.glob("films/*.gif"))


def test_scenes_are_of_mechanisms_that_exist():
    assert set(build.SCENES) <= set(vad.MECHANISMS)


@pytest.mark.parametrize("name", [*sorted(vad.MECHANISMS), *build.EXAMPLES])
def test_every_scene_assembles(name: str):
    assert build.sheet(name).mechanism == name


@pytest.mark.parametrize("name", build.LOADED)
def test_every_load_is_borne(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The sheet has its forces, and the command beside the film makes the same."""
    monkeypatch.chdir(tmp_path)
    found = build.sheet(name)
    assert [panel.name for panel in found.panels][-2:] == ["force", "drive"]
    mechanism = found.mechanism
    if mechanism not in vad.MECHANISMS:
        Path(f"{mechanism}.toml").write_bytes(example_path(mechanism).read_bytes())
    words = shlex.split(build.command(name).rpartition("&& ")[2])
    words[1:2], words[-1] = ["draw"], "sheet.json"
    assert run(words[1:]) == 0
    assert json.loads(Path("sheet.json").read_text("utf-8")) == to_dict(found)


def test_what_is_shown_is_shown_in_every_style_as_picture_and_film():
    films = {path.stem for path in FILMS}
    assert films == {
        *(f"{name}-{style}" for name in vad.MECHANISMS for style in style_names()),
        *(f"{name}-{build.SHEET_STYLE}" for name in (*build.EXAMPLES, *build.LOADED)),
    }
    assert films == {path.stem for path in build.HERE.glob("posters/*.png")}


def test_films_are_small():
    for path in FILMS:
        name = path.stem.rpartition("-")[0]
        assert path.stat().st_size < build.most_bytes(name), path.name


def test_a_poster_is_rebuilt_identically(tmp_path: Path):
    once, again = tmp_path / "once.png", tmp_path / "again.png"
    build.poster("whitworth", "chalk", once)
    build.poster("whitworth", "chalk", again)
    assert once.read_bytes() == again.read_bytes()
    assert once.stat().st_size < 100_000
    with Image.open(once) as picture:
        assert picture.size == build.POSTER
        assert "Whitworth" in picture.text["Title"]


def test_the_command_beside_a_film_makes_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    words = build.command("crank-slotted-lever").split()
    words[1:2] = ["draw"]
    words[-1] = "sheet.png"
    assert run(words[1:]) == 0
    by_hand = tmp_path / "by-hand.png"
    vad.save(build.sheet("crank-slotted-lever"), by_hand)
    assert (tmp_path / "sheet.png").read_bytes() == by_hand.read_bytes()

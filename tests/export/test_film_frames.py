from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.export.synthetic import frames, lesson, pictures
from vad.errors import ExportError
from vad.export import save
from vad.export.film_frames import is_frame
from vad.lecture.lesson import Lesson


@pytest.fixture
def film(folder: Path, painter: None) -> Lesson:
    made = lesson()
    save(made, "film/")
    return made


def test_one_picture_for_every_frame(film: Lesson) -> None:
    names = sorted(os.listdir("film"))
    assert names == [f"frame_{number:04d}.png" for number in range(1, film.frames + 1)]
    for name, painted in zip(names, pictures(film), strict=True):
        with Image.open(Path("film", name)) as image:
            assert (image.format, image.mode, image.size) == ("PNG", "P", film.size)
            error = np.asarray(image.convert("RGB")).astype(int) - painted
        assert np.abs(error).mean() < 0.2
        # Crossings of two inks are not in the palette, all else is.
        assert np.mean(np.abs(error).max(-1) > 4) < 0.01


def test_a_pause_is_a_hard_link(film: Lesson) -> None:
    files = {os.stat(Path("film", name)).st_ino for name in os.listdir("film")}
    assert len(files) == len([f for f in frames(film) if f.changed != (0, 0, 0, 0)])


def test_copies_where_there_are_no_links(
    folder: Path, painter: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_paths: Path) -> None:
        raise PermissionError

    save(lesson(), "linked/")
    monkeypatch.setattr(os, "link", refuse)
    save(lesson(), "copied/")
    assert os.listdir("linked") and sorted(os.listdir("linked")) == sorted(os.listdir("copied"))
    for path in Path("linked").iterdir():
        assert path.read_bytes() == Path("copied", path.name).read_bytes()
        assert Path("copied", path.name).stat().st_nlink == 1


def test_long_films_have_longer_names(folder: Path, painter: None) -> None:
    save(lesson(steps=1, hold=10_000), "film/")
    assert min(os.listdir("film")) == "frame_00001.png"


def test_a_shorter_film_leaves_no_old_frames(film: Lesson) -> None:
    shorter = lesson(steps=1)
    save(shorter, "film/")
    assert len(os.listdir("film")) == shorter.frames < film.frames


def test_frames_of_other_programs_are_not_lost(folder: Path, painter: None) -> None:
    Path("film").mkdir()
    Image.new("RGB", (4, 4)).save("film/frame_0001.png")
    with pytest.raises(ExportError, match=r"holds 'frame_0001\.png'"):
        save(lesson(), "film/")
    assert os.listdir("film") == ["frame_0001.png"]


def test_what_a_frame_is(film: Lesson) -> None:
    frame = Path("film/frame_0001.png")
    assert is_frame(frame)
    frame.rename("film/cover.png")
    assert not is_frame(Path("film/cover.png"))
    Path("film/frame_9999.png").mkdir()
    assert not is_frame(Path("film/frame_9999.png"))
    Path("film/frame_9998.png").symlink_to("frame_0002.png")
    assert not is_frame(Path("film/frame_9998.png"))

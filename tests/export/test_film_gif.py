from __future__ import annotations

import io
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image, ImageSequence

import vad
from tests.export.synthetic import frames, lesson, pictures
from vad.export import film_gif, save
from vad.export.palette import coarse
from vad.lecture.lesson import Lesson
from vad.painting.film import EMPTY, Frame

Bytes = NDArray[np.uint8]


def read(source: str | io.BytesIO) -> tuple[list[Bytes], list[int]]:
    """Return the pictures of a GIF and the hundredths of a second for which each is shown."""
    with Image.open(source) as image:
        shown = [
            (np.asarray(frame.convert("RGB")), round(frame.info["duration"] / 10))
            for frame in ImageSequence.Iterator(image)
        ]
    return [picture for picture, _ in shown], [delay for _, delay in shown]


def mapped(picture: Bytes, style: str = "paper") -> Bytes:
    palette = coarse(style)
    opaque = np.full((*picture.shape[:2], 1), 255, np.uint8)
    colours: Bytes = palette.colours[palette.indices(np.concatenate([picture, opaque], -1))]
    return colours


def encoded(source: Iterator[Frame], size: tuple[int, int], fps: float = 30.0) -> io.BytesIO:
    stream = io.BytesIO()
    film_gif.encode(source, stream, size=size, rate=Fraction(fps), palette=coarse("paper"))
    return stream


def flashes(count: int, repeats: int = 1) -> Iterator[Frame]:
    """Yield pictures each of which differs from the one before in one pixel."""
    buffer = np.full((8, 8, 4), 255, np.uint8)
    for number in range(count):
        x, y = number % 8, number // 8 % 8
        buffer[y, x, :3] = 255 - buffer[y, x, :3]
        box = (x, y, x + 1, y + 1) if number else (0, 0, 8, 8)
        yield Frame(buffer, box, repeats)


@pytest.mark.parametrize("style", ["paper", "print"])
@pytest.mark.parametrize("fps", [30.0, 25.0, 12.5])
def test_every_frame_is_the_picture_that_was_painted(
    folder: Path, painter: None, style: str, fps: float
) -> None:
    made = lesson(style=style, fps=fps)
    save(made, "film.gif")
    shown, delays = read("film.gif")
    starts = np.concatenate([[0], np.cumsum(delays)])
    for number, picture in enumerate(pictures(made)):
        at = np.searchsorted(starts, round(100 * number / fps), side="right") - 1
        assert (shown[at] == mapped(picture, style)).all()


@pytest.mark.parametrize("fps", [1, 7.5, 23.976, 24, 25, 29.97, 30, 48, 50, 60, 90, 120, 240])
def test_plays_for_the_stated_time(folder: Path, painter: None, fps: float) -> None:
    made = lesson(fps=fps)
    save(made, "film.gif")
    delays = read("film.gif")[1]
    assert sum(delays) == pytest.approx(100 * made.duration, abs=0.5)
    assert min(delays) >= 2


def test_loops_for_ever(folder: Path, painter: None) -> None:
    save(lesson(), "film.gif")
    with Image.open("film.gif") as image:
        assert image.info["loop"] == 0


def test_a_pause_is_one_image(folder: Path, painter: None) -> None:
    made: Lesson = lesson(hold=200)
    save(made, "film.gif")
    shown, delays = read("film.gif")
    assert len(shown) >= len([f for f in frames(made) if f.changed != EMPTY])
    assert sum(delay > 600 for delay in delays) == len(made.steps)


def test_delays_are_rounded_from_the_start() -> None:
    assert read(encoded(flashes(9), (8, 8)))[1] == [3, 4, 3] * 3


@pytest.mark.parametrize("fps", [60, 75, 100, 120])
def test_fast_films_leave_pictures_out(fps: int) -> None:
    count = 61
    shown, delays = read(encoded(flashes(count), (8, 8), fps))
    last = list(frame.pixels[..., :3].copy() for frame in flashes(count))[-1]
    assert (shown[-1] == mapped(last)).all()
    assert len(shown) <= 100 * count / fps / 2 + 1
    assert min(delays) >= 2
    assert sum(delays) == pytest.approx(100 * count / fps, abs=1.5)


def test_pauses_longer_than_a_delay_can_say() -> None:
    shown, delays = read(encoded(flashes(2, repeats=2000), (8, 8), 1))
    assert sum(delays) == 400_000
    assert len({picture.tobytes() for picture in shown}) == 2


def corners(rest: int) -> Iterator[Frame]:
    """Yield a picture that differs from the one before at the top and at the bottom."""
    buffer = np.full((100, 80, 4), 255, np.uint8)
    yield Frame(buffer, (0, 0, 80, 100), rest)
    buffer[:5, :5, :3] = buffer[90:, 60:, :3] = 0
    yield Frame(buffer, (0, 0, 80, 100), 10)


def test_after_a_pause_distant_changes_are_two_small_images() -> None:
    stream = encoded(corners(10), (80, 100))
    shown, delays = read(stream)
    assert delays == [31, 2, 34]
    assert (shown[1][:50] == 255).all() and (shown[1][90:, 60:] == 0).all()
    assert (shown[2] == mapped(list(corners(10))[-1].pixels[..., :3])).all()


def test_in_motion_every_picture_is_one_image() -> None:
    assert read(encoded(corners(2), (80, 100)))[1] == [7, 33]


def test_changes_that_the_palette_does_not_show_cost_nothing() -> None:
    def barely() -> Iterator[Frame]:
        buffer = np.full((8, 8, 4), 255, np.uint8)
        yield Frame(buffer, (0, 0, 8, 8), 1)
        buffer[2, 2, 0] = 254
        yield Frame(buffer, (0, 0, 4, 4), 1)

    shown, delays = read(encoded(barely(), (8, 8)))
    assert (len(shown), delays) == (1, [7])


def test_only_changed_pixels_are_written() -> None:
    size = (200, 150)

    def dot() -> Iterator[Frame]:
        buffer = np.full((150, 200, 4), 255, np.uint8)
        yield Frame(buffer, (0, 0, *size), 1)
        buffer[70, 60, :3] = 0
        yield Frame(buffer, (0, 0, *size), 1)

    stream = encoded(dot(), size)
    with Image.open(stream) as image:
        image.seek(1)
        assert image.tile[0][1] == (60, 70, 61, 71) or image.dispose_extent == (60, 70, 61, 71)


def test_the_default_lecture_is_small(folder: Path) -> None:
    made = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    vad.save(made, "lecture.gif")
    assert Path("lecture.gif").stat().st_size <= 560_000
    assert sum(read("lecture.gif")[1]) == pytest.approx(100 * made.duration, abs=0.5)

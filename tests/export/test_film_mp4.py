"""Films as MP4: what other programs read back of them, and the colours of their planes."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest

from tests.export.synthetic import SHEET, frames, lesson, pictures
from vad.errors import UsageError
from vad.export import film_mp4, save
from vad.export.film_mp4 import convert, even
from vad.export.lesson_srt import Cue, cues
from vad.lecture.lesson import Lesson


def decoded(path: str) -> list[Any]:
    with av.open(path) as film:
        return list(film.decode(video=0))


@pytest.fixture
def film(folder: Path, painter: None) -> Lesson:
    made = lesson()
    save(made, "film.mp4")
    return made


def test_what_players_need(film: Lesson) -> None:
    with av.open("film.mp4") as container:
        (stream,) = container.streams.video
        codec = stream.codec_context
        assert (codec.name, codec.pix_fmt) == ("h264", "yuv420p")
        assert (codec.width, codec.height) == film.size
        assert not codec.has_b_frames
        assert (codec.color_range, codec.colorspace) == (1, 1)
        assert (codec.color_primaries, codec.color_trc) == (1, 1)
        assert stream.average_rate == film.fps
        assert stream.start_time == 0
    data = Path("film.mp4").read_bytes()
    assert data.index(b"moov") < data.index(b"mdat")


@pytest.mark.parametrize("fps", [1, 7.5, 23.976, 24, 25, 29.97, 30000 / 1001, 30, 60, 120])
def test_plays_for_the_stated_time(folder: Path, painter: None, fps: float) -> None:
    made = lesson(fps=fps)
    save(made, "film.mp4")
    with av.open("film.mp4") as container:
        stream = container.streams.video[0]
        assert container.duration / av.time_base == pytest.approx(made.duration, abs=0.001)
        assert float(stream.duration * stream.time_base) == pytest.approx(made.duration, abs=0.001)
        times = [frame.time for frame in container.decode(stream)]
    assert times == pytest.approx([number / fps for number in range(made.frames)], abs=1e-3)


def test_every_frame_is_the_picture_that_was_painted(film: Lesson) -> None:
    shown = decoded("film.mp4")
    expected = pictures(film)
    assert len(shown) == len(expected) == film.frames
    for frame, picture in zip(shown, expected, strict=True):
        plane = frame.planes[0]
        luma = np.frombuffer(plane, np.uint8).reshape(-1, plane.line_size)[:, : frame.width]
        truth = 16 + 219 / 255 * (picture @ [0.2126, 0.7152, 0.0722])
        assert np.abs(luma - truth).max() < 16
        assert np.sqrt(np.mean((luma - truth) ** 2)) < 2
    colours = shown[-1].to_ndarray(format="rgb24").reshape(-1, 3).mean(0)
    assert colours == pytest.approx(expected[-1].reshape(-1, 3).mean(0), abs=2)


@pytest.mark.parametrize("size", [(95, 64), (96, 63), (95, 63)])
def test_odd_size(folder: Path, size: tuple[int, int]) -> None:
    with pytest.raises(UsageError, match=f"size: .*{size[0]}x{size[1]}") as caught:
        save(lesson(size=size), "film.mp4")
    assert caught.value.hint == "try 96x64"
    assert not list(folder.iterdir())


def test_no_dates_no_versions_of_the_container(film: Lesson) -> None:
    assert b"Lavf" not in Path("film.mp4").read_bytes()
    with av.open("film.mp4") as container:
        assert "creation_time" not in container.metadata


def test_the_film_says_what_it_shows(film: Lesson) -> None:
    with av.open("film.mp4") as container:
        assert container.metadata["title"].startswith(SHEET.title)


class TestSubtitles:
    def test_track_reads_back(self, folder: Path, painter: None) -> None:
        made = lesson()
        save(made, "film.mp4")
        with av.open("film.mp4") as container:
            (track,) = container.streams.subtitles
            assert track.codec_context.name == "mov_text"
            assert not track.disposition  # the picture shows the captions: off until asked for
            assert container.streams.video[0].disposition == av.stream.Disposition.default
            assert track.metadata["language"] == "eng"
            packets = [p for p in container.demux(track) if p.size > 2]
            read = [
                Cue(
                    float(packet.pts * packet.time_base),
                    float((packet.pts + packet.duration) * packet.time_base),
                    bytes(packet)[2:].decode(),
                )
                for packet in packets
            ]
        assert [cue.text for cue in read] == [cue.text for cue in cues(made)]
        for one, other in zip(read, cues(made), strict=True):
            assert (one.start, one.end) == pytest.approx((other.start, other.end), abs=0.001)

    def test_text_is_shown_as_written(self, folder: Path) -> None:
        text = "{\\b1} ω₂·AB \\N < 3, c′"
        with open("film.mp4", "w+b") as stream:
            film_mp4.encode(
                frames(lesson()),
                stream,
                size=(96, 64),
                rate=Fraction(30),
                subtitles=[Cue(0.1, 0.5, text)],
                language="de",
            )
        with av.open("film.mp4") as container:
            (track,) = container.streams.subtitles
            assert track.metadata["language"] == "deu"
            texts = [bytes(p)[2:].decode() for p in container.demux(track) if p.size > 2]
        assert texts == [text]

    def test_film_is_no_longer_for_it(self, folder: Path, painter: None) -> None:
        save(lesson(), "without.mp4", subtitles=False)
        save(lesson(), "with.mp4")
        with av.open("without.mp4") as one, av.open("with.mp4") as other:
            assert one.duration == other.duration
        assert len(decoded("with.mp4")) == len(decoded("without.mp4"))

    def test_no_empty_track(self, folder: Path, painter: None) -> None:
        save(Lesson(SHEET, (), 3, 3, 30.0, (96, 64)), "film.mp4")
        with av.open("film.mp4") as container:
            assert not container.streams.subtitles


def planes(width: int, height: int) -> list[np.ndarray]:
    return [np.full((height // scale, width // scale), 7, np.uint8) for scale in (1, 2, 2)]


@pytest.mark.parametrize(
    ("rgb", "ycc"),
    [
        ((0, 0, 0), (16, 128, 128)),
        ((255, 255, 255), (235, 128, 128)),
        ((255, 0, 0), (63, 102, 240)),
        ((0, 255, 0), (173, 42, 26)),
        ((0, 0, 255), (32, 240, 118)),
    ],
)
def test_published_values(rgb: tuple[int, ...], ycc: tuple[int, ...]) -> None:
    pixels = np.full((2, 2, 4), (*rgb, 255), np.uint8)
    samples = convert(pixels, (0, 0, 2, 2))
    assert (samples.y[0, 0], samples.cb[0, 0], samples.cr[0, 0]) == ycc


def test_all_colours_survive() -> None:
    random = np.random.default_rng(2)
    pixels = random.integers(0, 256, (64, 64, 4), np.uint8).repeat(2, 0).repeat(2, 1)
    samples = convert(pixels, (0, 0, 128, 128))
    y = 255 / 219 * (samples.y - 16.0)
    cb, cr = (
        255 / 224 * (plane.repeat(2, 0).repeat(2, 1) - 128.0) for plane in (samples.cb, samples.cr)
    )
    red, blue = y + 1.5748 * cr, y + 1.8556 * cb
    green = (y - 0.2126 * red - 0.0722 * blue) / 0.7152
    assert np.abs(np.stack([red, green, blue], -1) - pixels[..., :3]).max() < 2.5


@pytest.mark.parametrize("box", [(3, 5, 4, 6), (0, 0, 1, 1), (7, 2, 12, 9), (0, 0, 16, 12)])
def test_only_the_box_is_written(box: tuple[int, int, int, int]) -> None:
    random = np.random.default_rng(3)
    pixels = random.integers(0, 256, (12, 16, 4), np.uint8)
    whole, part = planes(16, 12), planes(16, 12)
    convert(pixels, (0, 0, 16, 12)).store(whole)
    convert(pixels, box).store(part)
    left, top, right, bottom = even(box)
    for scale, full, window in zip((1, 2, 2), whole, part, strict=True):
        inside = (
            slice(top // scale, bottom // scale),
            slice(left // scale, right // scale),
        )
        assert (window[inside] == full[inside]).all()
        window[inside] = 7
        assert (window == 7).all()

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.export import synthetic
from tests.export.synthetic import SHEET, filmed, lesson
from vad.errors import ExportError, UsageError
from vad.export import FORMATS, format_of, save
from vad.lecture.lesson import Lesson
from vad.painting.film import Frame
from vad.strokes.sheet import Sheet

FILMS = ["film.mp4", "film.gif", "film/"]
ROOT = Path(__file__).resolve().parents[2]


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.mark.parametrize("path", [*FILMS, "film.srt", "film.vtt", "film", "FILM.GIF"])
def test_a_film_is_saved_by_extension(folder: Path, painter: None, path: str) -> None:
    save(lesson(), path)
    assert os.listdir() == [path.rstrip("/")]
    assert Path(path).is_dir() == ("." not in path)


def test_an_existing_folder_takes_frames(folder: Path, painter: None) -> None:
    Path("lecture.3").mkdir()
    save(lesson(), "lecture.3")
    assert "frame_0001.png" in os.listdir("lecture.3")


def test_paths_may_be_paths(folder: Path) -> None:
    save(SHEET, folder / "sheet.json")
    assert os.listdir() == ["sheet.json"]


@pytest.mark.parametrize(
    ("thing", "path"),
    [
        (SHEET, "a.mp4"),
        (SHEET, "a.xyz"),
        (SHEET, "a"),
        (SHEET, "a/"),
        (lesson(), "a.svg"),
        (lesson(), "a.png"),
        (lesson(), "a.mkv"),
    ],
)
def test_misuse_is_answered_with_what_works(folder: Path, thing: object, path: str) -> None:
    with pytest.raises(UsageError, match=f"cannot be saved as '{path}'") as caught:
        save(thing, path)  # type: ignore[arg-type]
    own = {".png", ".svg", ".json"} if thing is SHEET else {".mp4", ".gif", "(frames/)"}
    assert caught.value.hint is not None
    assert {".pdf", ".html", *own} <= set(re.split("[ ,;]+", caught.value.hint))
    assert os.listdir() == []


def test_the_hint_is_one_clause_unless_another_thing_has_the_format() -> None:
    with pytest.raises(UsageError) as caught:
        format_of(Lesson, "film.bmp")
    assert str(caught.value.hint).startswith("as .mp4, .gif")
    assert ";" not in str(caught.value.hint)
    with pytest.raises(UsageError) as caught:
        format_of(Sheet, "sheet.mp4")
    assert str(caught.value.hint).endswith("; .mp4 is for a film")


def test_other_things_cannot_be_saved(folder: Path) -> None:
    with pytest.raises(UsageError, match="a str cannot be saved"):
        save("text", "a.png")  # type: ignore[arg-type]


def test_a_folder_in_place_of_a_file(folder: Path) -> None:
    Path("film.mp4").mkdir()
    with pytest.raises(ExportError, match=r"'film\.mp4' is a folder"):
        save(lesson(), "film.mp4")


def test_formats_are_not_imported_before_they_are_used() -> None:
    heavy = "{'matplotlib', 'av', 'PIL', 'vad.export.film_mp4', 'vad.export.film_gif'}"
    code = f"import sys, vad.export; assert not {heavy} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True)


@pytest.mark.parametrize("path", [*FILMS, "film.srt", "film.vtt"])
def test_progress_counts_every_frame(folder: Path, painter: None, path: str) -> None:
    calls: list[tuple[int, int]] = []
    film = lesson()
    save(film, path, progress=lambda done, total: calls.append((done, total)))
    assert calls == sorted(calls)
    assert calls[-1] == (film.frames, film.frames)


@pytest.mark.parametrize("path", FILMS)
def test_same_film_same_bytes(folder: Path, painter: None, path: str) -> None:
    saved = []
    for _ in range(2):
        save(lesson(), path)
        saved.append(contents(folder))
    assert saved[0] == saved[1]


class TestInterruption:
    """Whenever it comes, the old film stays and nothing else does."""

    @pytest.mark.exhaustive(6)
    @pytest.mark.parametrize("path", FILMS)
    @pytest.mark.parametrize("kind", [KeyboardInterrupt, SystemExit, OSError])
    def test_at_any_frame(
        self, folder: Path, path: str, kind: type[BaseException], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        stop_at = 0

        def stopping(film: Lesson) -> Iterator[Frame]:
            for number, frame in enumerate(synthetic.frames(film)):
                if number == stop_at:
                    raise kind(28, "No space left on device")
                yield frame

        monkeypatch.setattr("vad.painting.film.filmed", filmed(stopping))
        film = lesson(steps=2)
        pictures = len(list(synthetic.frames(film)))
        stop_at = pictures
        save(film, path)
        old = contents(folder)
        for moment in range(pictures):
            stop_at = moment
            for target in (path, "new_" + path):
                with pytest.raises(ExportError if kind is OSError else kind):
                    save(film, target)
            assert contents(folder) == old
            assert os.listdir() == [path.rstrip("/")]

    @pytest.mark.exhaustive(6)
    @pytest.mark.parametrize("path", FILMS)
    def test_from_the_keyboard(self, folder: Path, path: str) -> None:
        code = """
import sys, time
from tests.export import synthetic
import vad.painting.film
import vad.painting.film
from vad.export import save

def slow(film):
    for number, frame in enumerate(synthetic.frames(film)):
        if number == 7:
            print("half way", flush=True)
            time.sleep(60)
        yield frame

vad.painting.film.filmed = synthetic.filmed(slow)
save(synthetic.lesson(), sys.argv[1])
"""
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        if not path.endswith("/"):
            Path(path).write_bytes(b"old")
        old = contents(folder)
        with subprocess.Popen(
            [sys.executable, "-c", code, path],
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,  # the traceback
        ) as process:
            assert process.stdout is not None
            assert process.stdout.readline() == b"half way\n"
            process.send_signal(signal.SIGINT)
            assert process.wait(10) == -signal.SIGINT
        assert contents(folder) == old
        assert len(os.listdir()) == len(old)


@pytest.mark.exhaustive(6)
@pytest.mark.parametrize("path", FILMS)
def test_full_disk(folder: Path, path: str) -> None:
    """A file that cannot grow stands for a disk that is full, at whatever byte that happens."""
    code = """
import resource, sys
from pathlib import Path
from tests.export import synthetic
from vad.errors import ExportError
import vad.painting.film
from vad.export import save

vad.painting.film.filmed = synthetic.filmed()
film = synthetic.lesson()
save(film, sys.argv[1])
made = Path(sys.argv[1])
size = max(each.stat().st_size for each in (made.iterdir() if made.is_dir() else [made]))
for limit in (0, size // 4, size // 2, size - 1):
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))
    try:
        save(film, "new_" + sys.argv[1])
    except ExportError as error:
        assert "cannot be written: " in str(error), error
    else:
        raise AssertionError(limit)
"""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    subprocess.run([sys.executable, "-B", "-c", code, path], env=environment, check=True)
    assert os.listdir() == [path.rstrip("/")]


@pytest.mark.exhaustive(6)
@pytest.mark.parametrize("path", FILMS)
def test_memory_does_not_grow_with_the_film(folder: Path, path: str) -> None:
    code = """
import resource, sys
from tests.export import synthetic
import vad.painting.film
import vad.painting.film
from vad.export import save

def peak(steps):
    save(synthetic.lesson(steps=steps, size=(320, 180)), sys.argv[1])
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

vad.painting.film.filmed = synthetic.filmed()
once, tenfold = peak(10), peak(100)
assert tenfold < 1.1 * once, (once, tenfold)
"""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    subprocess.run([sys.executable, "-c", code, path], env=environment, check=True)


def test_every_format_is_registered_once() -> None:
    modules = [module for formats in FORMATS.values() for module in formats.values()]
    assert all(module.startswith("vad.export.") for module in modules)
    assert all(key == key.lower() for formats in FORMATS.values() for key in formats)

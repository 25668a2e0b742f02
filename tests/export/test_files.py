from __future__ import annotations

import os
import shutil
import signal
import stat
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import vad
from tests.export.synthetic import lesson
from vad.errors import ExportError
from vad.export import files

Interruption = [KeyboardInterrupt, SystemExit, ValueError, MemoryError]


def ours(path: Path) -> bool:
    return path.name.startswith("ours")


def fill(folder: Path, text: str = "new") -> None:
    (folder / "ours").write_text(text)


@pytest.fixture
def umask() -> int:
    old = os.umask(0o022)
    os.umask(old)
    return old


class TestNewFile:
    def test_appears_when_it_is_complete(self, folder: Path) -> None:
        with files.new_file("a.bin") as stream:
            stream.write(b"whole")
            stream.flush()
            assert not Path("a.bin").exists()
        assert Path("a.bin").read_bytes() == b"whole"
        assert os.listdir() == ["a.bin"]

    def test_old_file_stays_until_then(self, folder: Path) -> None:
        Path("a.bin").write_bytes(b"old")
        with files.new_file("a.bin") as stream:
            stream.write(b"new")
            stream.flush()
            assert Path("a.bin").read_bytes() == b"old"
        assert Path("a.bin").read_bytes() == b"new"

    @pytest.mark.parametrize("kind", Interruption)
    def test_nothing_remains_of_an_unfinished_one(
        self, folder: Path, kind: type[BaseException]
    ) -> None:
        Path("a.bin").write_bytes(b"old")
        with pytest.raises(kind), files.new_file("a.bin") as stream:
            stream.write(b"half")
            raise kind
        assert os.listdir() == ["a.bin"]
        assert Path("a.bin").read_bytes() == b"old"

    @pytest.mark.parametrize("mask", [0o022, 0o027, 0o077])
    def test_permissions_are_those_of_any_new_file(self, folder: Path, mask: int) -> None:
        old = os.umask(mask)
        try:
            with files.new_file("a.bin") as stream:
                stream.write(b"x")
        finally:
            os.umask(old)
        assert stat.S_IMODE(os.stat("a.bin").st_mode) == 0o666 & ~mask

    @pytest.mark.parametrize("mode", [0o600, 0o664, 0o755])
    def test_permissions_are_those_of_the_file_that_is_replaced(
        self, folder: Path, mode: int
    ) -> None:
        Path("a.bin").write_bytes(b"old")
        os.chmod("a.bin", mode)
        with files.new_file("a.bin") as stream:
            stream.write(b"new")
        assert Path("a.bin").read_bytes() == b"new"
        assert stat.S_IMODE(os.stat("a.bin").st_mode) == mode

    def test_stream_can_be_reopened_by_its_name(self, folder: Path) -> None:
        with files.new_file("a.bin") as stream:
            Path(stream.name).write_bytes(b"by name")
        assert Path("a.bin").read_bytes() == b"by name"

    def test_link_is_followed(self, folder: Path) -> None:
        Path("far").mkdir()
        Path("far/a.bin").write_bytes(b"old")
        Path("near.bin").symlink_to("far/a.bin")
        with files.new_file("near.bin") as stream:
            stream.write(b"new")
        assert Path("near.bin").is_symlink()
        assert Path("far/a.bin").read_bytes() == b"new"

    def test_longest_name_that_a_folder_can_hold(self, folder: Path) -> None:
        name = "x" * 251 + ".bin"
        with files.new_file(name) as stream:
            stream.write(b"x")
        assert os.listdir() == [name]

    def test_missing_folder(self, folder: Path) -> None:
        with pytest.raises(ExportError, match="folder 'no such/er' does not exist") as caught:
            files.new_file("no such/er/a.bin").__enter__()
        assert caught.value.hint == "create it first: mkdir -p 'no such/er'"

    def test_file_in_place_of_the_folder(self, folder: Path) -> None:
        Path("plain").touch()
        with pytest.raises(ExportError, match="'plain' is not a folder"):
            files.new_file("plain/a.bin").__enter__()

    def test_folder_in_place_of_the_file(self, folder: Path) -> None:
        Path("a.bin").mkdir()
        with pytest.raises(ExportError, match=r"'a\.bin' is a folder"):
            files.new_file("a.bin").__enter__()

    def test_device_is_not_replaced(self, folder: Path) -> None:
        os.mkfifo("pipe")
        with pytest.raises(ExportError, match="'pipe' is not a file"):
            files.new_file("pipe").__enter__()
        assert Path("pipe").is_fifo()

    @pytest.mark.parametrize("closed", [".", "a.bin"])
    def test_no_permission(
        self, folder: Path, closed: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        Path("a.bin").touch()
        shut = Path(closed).resolve()
        # The one who runs the tests may be allowed everything: ask as somebody who is not.
        monkeypatch.setattr(os, "access", lambda path, _mode: Path(path) != shut)
        with pytest.raises(ExportError, match="no permission"):
            files.new_file("a.bin").__enter__()

    def test_what_the_system_says_is_passed_on(self, folder: Path) -> None:
        with (
            pytest.raises(ExportError, match=r"^'a\.bin' cannot be written: no space left"),
            files.new_file("a.bin"),
        ):
            raise OSError(28, "No space left on device")
        assert os.listdir() == []


class TestNewFolder:
    def test_appears_when_it_is_complete(self, folder: Path) -> None:
        with files.new_folder("film", ours) as part:
            fill(part)
            assert not Path("film").exists()
        assert Path("film/ours").read_text() == "new"
        assert os.listdir() == ["film"]

    def test_permissions_are_those_of_any_new_folder(self, folder: Path, umask: int) -> None:
        with files.new_folder("film", ours) as part:
            fill(part)
        assert stat.S_IMODE(os.stat("film").st_mode) == 0o777 & ~umask

    @pytest.mark.parametrize("held", [[], ["ours_1", "ours_2"]])
    def test_replaces_its_own_kind(self, folder: Path, held: list[str]) -> None:
        Path("film").mkdir()
        for name in held:
            Path("film", name).touch()
        with files.new_folder("film/", ours) as part:
            fill(part)
            assert sorted(os.listdir("film")) == held
        assert os.listdir("film") == ["ours"]
        assert os.listdir() == ["film"]

    def test_loses_nothing_else(self, folder: Path) -> None:
        Path("film").mkdir()
        Path("film/ours_1").touch()
        Path("film/thesis.tex").touch()
        with pytest.raises(ExportError, match=r"holds 'thesis\.tex', which would be lost"):
            files.new_folder("film", ours).__enter__()
        assert sorted(os.listdir("film")) == ["ours_1", "thesis.tex"]

    def test_loses_nothing_that_came_meanwhile(self, folder: Path) -> None:
        Path("film").mkdir()
        with pytest.raises(ExportError, match="holds"), files.new_folder("film", ours) as part:
            fill(part)
            Path("film/thesis.tex").touch()
        assert os.listdir("film") == ["thesis.tex"]
        assert os.listdir() == ["film"]

    @pytest.mark.parametrize("kind", Interruption)
    def test_nothing_remains_of_an_unfinished_one(
        self, folder: Path, kind: type[BaseException]
    ) -> None:
        Path("film").mkdir()
        fill(Path("film"), "old")
        with pytest.raises(kind), files.new_folder("film", ours) as part:
            fill(part)
            raise kind
        assert os.listdir() == ["film"]
        assert Path("film/ours").read_text() == "old"

    def test_old_one_comes_back_if_the_new_one_cannot_take_its_place(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        Path("film").mkdir()
        fill(Path("film"), "old")
        rename = os.rename

        def failing(source: Path, target: Path) -> None:
            if source.suffix == ".part":
                raise KeyboardInterrupt
            rename(source, target)

        monkeypatch.setattr(os, "rename", failing)
        with pytest.raises(KeyboardInterrupt), files.new_folder("film", ours) as part:
            fill(part)
        assert os.listdir() == ["film"]
        assert Path("film/ours").read_text() == "old"

    def test_file_in_place_of_the_folder(self, folder: Path) -> None:
        Path("film").touch()
        with pytest.raises(ExportError, match="'film' is a file, not a folder"):
            files.new_folder("film", ours).__enter__()

    @pytest.mark.parametrize("path", [".", ".."])
    def test_the_current_folder_is_not_replaced(
        self, folder: Path, path: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        Path("ours").mkdir()
        monkeypatch.chdir("ours")
        with pytest.raises(ExportError, match="the folder that you are in"):
            files.new_folder(path, ours).__enter__()


class TestInterrupts:
    """The library hears no signal itself; what a signal raises leaves nothing half-written."""

    @pytest.mark.parametrize("make", [files.new_file, lambda path: files.new_folder(path, ours)])
    def test_a_second_one_in_the_midst_of_clearing_up(
        self, folder: Path, make: Callable[[str], Any], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        calls: list[object] = []

        def interrupted(call: Callable[..., None]) -> Callable[..., None]:
            def once(*arguments: Any, **options: Any) -> None:
                calls.append(call)
                if len(calls) == 1:
                    raise KeyboardInterrupt
                call(*arguments, **options)

            return once

        monkeypatch.setattr(Path, "unlink", interrupted(Path.unlink))
        monkeypatch.setattr(shutil, "rmtree", interrupted(shutil.rmtree))
        with pytest.raises(KeyboardInterrupt), make("made"):
            raise KeyboardInterrupt
        assert len(calls) > 1
        assert os.listdir() == []

    def test_an_old_folder_is_kept_if_it_cannot_be_put_back(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        Path("film").mkdir()
        fill(Path("film"), "old")
        rename = os.rename

        def failing(source: Path, target: Path) -> None:
            if target.name == "film":
                raise OSError(5, "Input/output error")
            rename(source, target)

        monkeypatch.setattr(os, "rename", failing)
        with pytest.raises(ExportError), files.new_folder("film", ours) as part:
            fill(part)
        (kept,) = folder.glob(".vad-*.old")
        assert (kept / "ours").read_text() == "old"

    @pytest.mark.parametrize("path", ["film.gif", "film/"])
    def test_handlers_stay_as_they_are(self, folder: Path, painter: None, path: str) -> None:
        numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
        before = [signal.getsignal(number) for number in numbers]
        heard: list[list[object]] = []

        def progress(_done: int, _total: int) -> None:
            heard.append([signal.getsignal(number) for number in numbers])

        vad.save(lesson(), path, progress=progress)
        assert heard
        assert all(each == before for each in heard)
        assert [signal.getsignal(number) for number in numbers] == before

    def test_other_threads_write_too(self, folder: Path) -> None:
        def work() -> None:
            with files.new_file("a.bin") as stream:
                stream.write(b"threaded")

        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
        assert Path("a.bin").read_bytes() == b"threaded"


class TestLeftovers:
    """What a killed process left is swept an hour later, and nothing else."""

    PART = ".vad-0123abcd.part"

    @staticmethod
    def aged(path: Path, hours: float) -> None:
        then = time.time() - 3600 * hours
        os.utime(path, (then, then), follow_symlinks=False)

    @pytest.mark.parametrize("kind", ["file", "folder", "link"])
    @pytest.mark.parametrize("make", [files.new_file, lambda path: files.new_folder(path, ours)])
    def test_an_old_part_is_swept(
        self, folder: Path, kind: str, make: Callable[[str], Any]
    ) -> None:
        part, precious = folder / self.PART, folder / "thesis"
        precious.mkdir()
        fill(precious)
        if kind == "file":
            part.write_bytes(b"half")
        elif kind == "folder":
            part.mkdir()
            fill(part)
        else:
            part.symlink_to(precious)
        self.aged(part, 1.1)
        with make("made"):
            pass
        assert sorted(os.listdir()) == ["made", "thesis"]
        assert (precious / "ours").read_text() == "new"

    @pytest.mark.parametrize(
        "name",
        [".vad-0123abcd.old", ".vad-0123abcd.part~", ".vad-zzzzzzzz.part", "x.part", ".vad-1.part"],
    )
    def test_nothing_of_another_name(self, folder: Path, name: str) -> None:
        Path(name).touch()
        self.aged(Path(name), 1000)
        with files.new_file("made"):
            pass
        assert sorted(os.listdir()) == sorted([name, "made"])

    def test_what_is_still_being_written_stays(self, folder: Path) -> None:
        with files.new_file("one") as stream:
            self.aged(Path(stream.name), 0.9)
            with files.new_file("two"):
                pass
            stream.write(b"whole")
        assert Path("one").read_bytes() == b"whole"

    def test_a_part_that_cannot_be_removed_hinders_nobody(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        Path(self.PART).touch()
        self.aged(Path(self.PART), 2)

        def refuse(path: str | Path) -> None:
            if Path(path).name == self.PART:
                raise PermissionError(1, "Operation not permitted")

        monkeypatch.setattr(os, "unlink", refuse)
        with files.new_file("made"):
            pass
        assert sorted(os.listdir()) == [self.PART, "made"]


def test_a_file_is_on_the_disk_before_it_takes_its_place(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[tuple[str, int, int]] = []
    sync, replace = os.fsync, os.replace

    def synced(descriptor: int) -> None:
        found = os.fstat(descriptor)
        seen.append(("sync", found.st_ino, found.st_size))
        sync(descriptor)

    def replaced(source: Path, target: Path) -> None:
        found = os.stat(source)
        seen.append(("replace", found.st_ino, found.st_size))
        replace(source, target)

    monkeypatch.setattr(os, "fsync", synced)
    monkeypatch.setattr(os, "replace", replaced)
    with files.new_file("a.bin") as stream:
        stream.write(b"whole")
    inode = os.stat("a.bin").st_ino
    assert seen == [("sync", inode, 5), ("replace", inode, 5)]


def test_a_loop_of_links_is_not_replaced(folder: Path) -> None:
    Path("a.bin").symlink_to("b.bin")
    Path("b.bin").symlink_to("a.bin")
    with pytest.raises(ExportError, match=r"'a\.bin' is a link that leads to itself"):
        files.new_file("a.bin").__enter__()
    assert Path("a.bin").is_symlink()


def test_the_root_is_no_folder_to_be_replaced() -> None:
    with pytest.raises(ExportError, match="'/' is the root"):
        files.new_folder("/", ours).__enter__()

"""Files and folders that appear whole or not at all.

The caller gets a stream, or an empty folder, beside the path.  When the caller has filled it, it
takes the place of the path in one step; a file is on the disk by then.  Until then, the old file
stays as it was.  After any exception, also after an interrupt, nothing half-written remains.  A
signal that the program turns into an exception, as the command line does, leaves nothing behind
either; nor does an end at once before which `clear_unfinished` is called.  If a program is killed,
its unfinished files are removed when the next file is made in the same folder.
"""

from __future__ import annotations

import contextlib
import os
import re
import secrets
import shlex
import shutil
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from vad.errors import ExportError

#: The name of an unfinished file, and how many seconds it may stand untouched.
_PART, _HOUR = re.compile(r"\.vad-[0-9a-f]{8}\.part"), 3600.0
#: The name of a temporary folder, and how many seconds it may stand.
_TEMPORARY, _DAY = re.compile(r"vad-[0-9a-f]{8}\.tmp"), 86400.0
#: What removes the unfinished files and folders of this moment, in the order of their making.
_unfinished: list[Callable[[], None]] = []


@contextmanager
def new_file(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """Yield a stream whose bytes become the file ``path`` when the block ends without error.

    The stream can be read, sought and reopened by its ``name``; the file gets the permissions of
    the one that it replaces, or of any new file (the umask).

    Raises
    ------
    vad.errors.ExportError
        If the file cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp())
    >>> with new_file(folder / "note.txt") as stream:
    ...     _ = stream.write(b"whole")
    ...     list(folder.glob("*.txt"))
    []
    >>> (folder / "note.txt").read_text()
    'whole'
    """
    final = _place(path)
    if final.is_dir():
        raise ExportError(f"'{path}' is a folder, not a file", hint="name a file inside it")
    if final.exists() and not final.is_file():
        raise ExportError(f"'{path}' is not a file that can be replaced")
    if final.exists() and not os.access(final, os.W_OK):
        raise ExportError(f"no permission to replace '{path}'")
    part = final.with_name(f".vad-{secrets.token_hex(4)}.part")

    def clear() -> None:
        part.unlink(missing_ok=True)

    with _explained(path), cleared_up(clear):
        _remove_leftovers(final.parent)
        with open(part, "x+b") as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        if final.exists():
            shutil.copymode(final, part)
        os.replace(part, final)


@contextmanager
def new_folder(path: str | os.PathLike[str], replaceable: Callable[[Path], bool]) -> Iterator[Path]:
    """Yield an empty folder that becomes the folder ``path`` when the block ends without error.

    Parameters
    ----------
    path
        Where the folder is to be.
    replaceable
        Says of a file whether the program has made it.  An existing folder is replaced only if
        this is true of everything in it.

    Raises
    ------
    vad.errors.ExportError
        If the folder cannot be written, or holds anything else.
    """
    final = _place(path)
    name = final.with_name(f".vad-{secrets.token_hex(4)}")
    part, old = name.with_suffix(".part"), name.with_suffix(".old")

    def clear() -> None:
        if old.exists() and not final.exists():
            os.rename(old, final)
        shutil.rmtree(part, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)

    with _explained(path), cleared_up(clear):
        _check_folder(path, final, replaceable)
        _remove_leftovers(final.parent)
        part.mkdir()
        yield part
        _check_folder(path, final, replaceable)
        if final.exists():
            os.rename(final, old)
        os.rename(part, final)


@contextmanager
def temporary_folder(
    place: str | os.PathLike[str] | None = None, *, stays: bool = False
) -> Iterator[Path]:
    """Yield an empty folder that its owner alone can read, and that is removed at the end.

    What a killed process has left is removed when the next one is made in the same place, a day
    later.

    Parameters
    ----------
    place
        The folder in which it is made; None for that of temporary files.
    stays
        Whether it stays if the block ends without error, because another program reads what is in
        it: then it is removed as if its process had been killed.

    Raises
    ------
    vad.errors.ExportError
        If there is no place for it.

    Examples
    --------
    >>> with temporary_folder() as folder:
    ...     _ = (folder / "note.txt").write_text("for now")
    >>> folder.exists()
    False
    """
    with _explained("a temporary folder"):
        around = Path(tempfile.gettempdir() if place is None else place)
        path = around / f"vad-{secrets.token_hex(4)}.tmp"

    filled = False

    def clear() -> None:
        if not (stays and filled):
            shutil.rmtree(path, ignore_errors=True)

    with cleared_up(clear):
        _remove_leftovers(around, _TEMPORARY, _DAY)
        with _explained(path):
            path.mkdir(mode=0o700)
        yield path
        filled = True


@contextmanager
def cleared_up(clear: Callable[[], None]) -> Iterator[None]:
    """Call ``clear`` twice when the block ends: an interrupt may cut short the first call.

    It may be called at any moment of the block, too, by `clear_unfinished`.
    """
    _unfinished.append(clear)
    try:
        try:
            yield
        finally:
            clear()
    finally:
        clear()
        _unfinished.remove(clear)


def clear_unfinished() -> None:
    """Remove all unfinished files and folders: this process is about to end, at any moment.

    Nothing may be made after that.
    """
    for clear in reversed(_unfinished.copy()):
        with contextlib.suppress(Exception):  # the others are to be removed all the same
            clear()


def _remove_leftovers(folder: Path, name: re.Pattern[str] = _PART, age: float = _HOUR) -> None:
    """Remove what a killed process has left in ``folder`` under such a ``name``.

    A process that still runs has touched it within so many seconds, its ``age``.
    """
    long_ago = time.time() - age
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if not name.fullmatch(entry.name):
                continue
            with contextlib.suppress(OSError):
                if entry.stat(follow_symlinks=False).st_mtime > long_ago:
                    continue
                if entry.is_dir(follow_symlinks=False):
                    shutil.rmtree(entry.path)
                else:
                    os.unlink(entry.path)


def _place(path: str | os.PathLike[str]) -> Path:
    """Return ``path`` with links resolved, in a folder that can be written."""
    try:
        final = Path(os.path.realpath(path))
        final.exists()
    except (OSError, ValueError) as error:  # a name too long, or with a zero byte in it
        reason = str(getattr(error, "strerror", error)).lower()
        raise ExportError(f"'{path}' cannot be a file: {reason}") from None
    if final.is_symlink():
        raise ExportError(f"'{path}' is a link that leads to itself")
    if not final.name:
        raise ExportError(f"'{path}' is the root of all folders", hint="name a folder of its own")
    folder, shown = final.parent, Path(path).parent
    if not folder.exists():
        hint = f"create it first: mkdir -p {shlex.quote(str(shown))}"
        raise ExportError(f"folder '{shown}' does not exist", hint=hint)
    if not folder.is_dir():
        raise ExportError(f"'{shown}' is not a folder")
    if not os.access(folder, os.W_OK | os.X_OK):
        raise ExportError(f"no permission to write in the folder '{shown}'")
    return final


def _check_folder(
    path: str | os.PathLike[str], final: Path, replaceable: Callable[[Path], bool]
) -> None:
    if not final.exists():
        return
    if not final.is_dir():
        raise ExportError(f"'{path}' is a file, not a folder", hint="name another folder")
    with contextlib.suppress(OSError):
        if final.samefile(Path.cwd()) or final in Path.cwd().parents:
            hint = "name a folder of its own, such as frames/"
            raise ExportError(f"'{path}' is the folder that you are in", hint=hint)
    foreign = next((each.name for each in sorted(final.iterdir()) if not replaceable(each)), None)
    if foreign is not None:
        hint = "name a new folder, or an empty one"
        raise ExportError(f"folder '{path}' holds '{foreign}', which would be lost", hint=hint)


@contextmanager
def _explained(path: str | os.PathLike[str]) -> Iterator[None]:
    """Turn what the operating system says into an error of this program."""
    try:
        yield
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise ExportError(f"'{path}' cannot be written: {reason}") from error

"""The folder of a batch: what stands in it, what comes to it, and the answers.

While a batch runs, each sheet that is done is noted in a journal, a line each; when it ends, the
journal becomes ``answers.json``.  A sheet stands if its note says that it was made from the same
settings, and its files are still those that were written.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from vad.batches.answer_cells import cells
from vad.batches.job import Done, Job, Product
from vad.errors import ExportError, UsageError, shown
from vad.export.files import new_file

_ANSWERS, _TABLE, _JOURNAL = "answers.json", "answers.csv", "answers.part.jsonl"

Note = Mapping[str, Any]


class Folder:
    """A folder that is filled with sheets.

    Parameters
    ----------
    path
        Where it is; it is made if its parent is there.

    Raises
    ------
    vad.errors.ExportError
        If it cannot be.
    vad.errors.UsageError
        For what is no name.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        if not isinstance(path, str | os.PathLike):
            raise UsageError(f"folder: must be the name of a folder, got {shown(path)}")
        self.path = Path(path)
        try:
            self.path.mkdir(exist_ok=True)
        except FileExistsError:
            message = f"{shown(str(path))} is a file, not a folder"
            raise ExportError(message, "name another folder") from None
        except (OSError, ValueError) as error:
            raise _cannot(path, error) from None
        self._notes = {note["number"]: note for note in self._noted()}

    def standing(self, job: Job) -> Done | None:
        """Return a sheet that stands already; None where it is still to be made."""
        note = self._notes.get(job.number)
        if note is None or note["made_from"] != job.fingerprint:
            return None
        files: Mapping[str, str] = note["files"]
        if set(files) != set(job.names):
            return None
        if any(_digest_of(self.path / name) != digest for name, digest in files.items()):
            return None
        return self._done(note, new=False)

    def take(self, product: Product) -> Done:
        """Write the files of a sheet, and note that it is done."""
        job = product.job
        if product.error is not None:
            return Done(job.number, error=product.error)
        for name, content in product.files.items():
            with new_file(self.path / name) as stream:
                stream.write(content)
        note = {
            "number": job.number,
            **product.answers,
            "files": {name: _digest(content) for name, content in product.files.items()},
            "made_from": job.fingerprint,
        }
        self._notes[job.number] = note
        try:
            with open(self.path / _JOURNAL, "a", encoding="utf-8") as journal:
                journal.write(_line(note) + "\n")
        except OSError as error:
            raise _cannot(self.path / _JOURNAL, error) from None
        return self._done(note, new=True)

    def finish(self, sheets: Iterable[Done]) -> None:
        """Write the answers of these sheets."""
        notes = [self._notes[done.number] for done in sheets if done.error is None]
        with new_file(self.path / _TABLE) as stream:
            stream.write(_table(notes).encode())
        with new_file(self.path / _ANSWERS) as stream:
            body = ",\n".join(map(_line, notes))
            stream.write(f"[\n{body}\n]\n".encode())
        (self.path / _JOURNAL).unlink(missing_ok=True)

    def _noted(self) -> Iterator[Note]:
        """Yield what earlier runs noted, the latest last; what is no note is left out."""
        for name in (_ANSWERS, _JOURNAL):
            try:
                text = (self.path / name).read_text("utf-8")
            except (OSError, UnicodeDecodeError):
                continue
            for line in text.splitlines():
                try:
                    note = json.loads(line.rstrip(","))
                except ValueError:  # a bracket, or a line that was cut short
                    continue
                if isinstance(note, dict) and {"number", "files", "made_from"} <= note.keys():
                    yield note

    def _done(self, note: Note, new: bool) -> Done:
        extra = ("number", "files", "made_from")
        answers = {name: value for name, value in note.items() if name not in extra}
        return Done(
            note["number"], tuple(self.path / name for name in note["files"]), answers, new=new
        )


def _line(note: Note) -> str:
    return json.dumps(note, ensure_ascii=False)


def _table(notes: list[Note]) -> str:
    """Return the answers as a table with every digit, empty where a mechanism has no such thing."""
    rows = [{"number": note["number"], **cells(note)} for note in notes]
    columns = dict.fromkeys(name for row in rows for name in row)
    text = io.StringIO()
    table = csv.DictWriter(text, columns or ["number"], lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    return text.getvalue()


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def _digest_of(path: Path) -> str | None:
    try:
        return _digest(path.read_bytes())
    except OSError:
        return None


def _cannot(path: str | os.PathLike[str], error: Exception) -> ExportError:
    said = (getattr(error, "strerror", None) or str(error)).lower()
    return ExportError(f"folder {shown(os.fspath(path))} cannot be written: {said}")

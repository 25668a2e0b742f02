"""The verb `batch`: from a file that says what a class is to get to a folder of sheets.

While a batch runs, each sheet that is done is noted in a journal, a line each; when it ends, the
journal becomes ``answers.json``.  A sheet need not be made again if its note is undamaged and says
that it was made from the same settings, and its files are unchanged.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from vad import gate
from vad.batches.job import Done, Job, Product
from vad.batches.merging import check_merged, merged
from vad.batches.sheets import read_sheets
from vad.batches.workers import products
from vad.discovery import from_extra
from vad.errors import ExportError, UsageError, quoted
from vad.export.files import new_file
from vad.export.workbook import workbook
from vad.statics.forces import given_burden

_ANSWERS, _TABLE, _JOURNAL = "answers.json", "answers.csv", "answers.part.jsonl"
_BOOK = "answers.xlsx"
JournalNote = Mapping[str, Any]
_AXES = "xyz"


def batch(
    path: str | os.PathLike[str],
    folder: str | os.PathLike[str],
    jobs: int = 1,
    *,
    cluster: str | None = None,
    only: int | None = None,
    merge: str | os.PathLike[str] | None = None,
    excel: bool = False,
    loads: Iterable[Any] = (),
    masses: Mapping[str, Any] | None = None,
    gravity: Any = None,
    friction: Mapping[str, Any] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> list[Done]:
    """Make the sheets of a file: problems, keys, and all answers as ``answers.csv`` and ``.json``.

    Every sheet is the same for any number of workers.  One that stands in the folder already, made
    from the same settings, is not made again, so that a batch that was cut short goes on where it
    was.

    Parameters
    ----------
    path
        A ``.toml`` file with ``[sheet]``, ``[vary]`` and ``[keep]``, or a ``.csv`` file with one
        row a sheet.
    folder
        Where the files go; it is made if its parent is there.
    jobs
        How many processes work, this one among them; more than one need the extra ``batch``.
    cluster
        The address of the scheduler of a Dask cluster, which works instead; it needs the extra
        ``cluster``.
    only
        The number of one sheet, which is made again.
    merge
        A PDF that gets the pages of all files of that kind, with bookmarks: first those of one
        name, such as the problems, then those of the next one.  It needs the extra ``merge``.
    excel
        Whether the answers are a sheet of Excel, too, ``answers.xlsx``; it needs the extra
        ``excel``.
    loads, masses, gravity, friction
        As for `forces`: what every mechanism bears beside all that the file says.
    progress
        Called with how many sheets are done and their total: after each one, and twice a second
        while workers make the next one.

    Returns
    -------
    list of Done
        The sheets by number.  One that could not be made has an ``error``; the others are there.

    Raises
    ------
    vad.errors.InputError
        For what cannot be in the file, with its line.
    vad.errors.ExportError
        If the folder cannot be written, or a worker dies.
    """
    if (gate.index(jobs) or 0) < 1:
        raise UsageError(f"jobs: must be a whole number from 1 on, got {quoted(jobs)}")
    gate.function("progress", progress)
    if gate.flag("excel", excel):
        from_extra("xlsxwriter", "excel")  # before anything is made
    if merge is not None:
        check_merged(merge)
    if cluster is not None and jobs != 1:
        raise UsageError("jobs: a cluster has its own workers", "leave out one of them")
    sheets = read_sheets(path, given_burden(loads, masses, gravity, friction))
    total = len(sheets.jobs) + len(sheets.failed)
    if only is not None:
        if not 1 <= (gate.index(only) or 0) <= total:
            raise UsageError(f"only: there is no sheet {quoted(only)}", f"from 1 to {total}")
        only = int(only)
    target = Folder(folder)
    stand = (target.standing(job) for job in sheets.jobs if job.number != only)
    done = {each.number: each for each in (*sheets.failed, *stand) if each is not None}
    wanted = [job for job in sheets.jobs if job.number not in done and only in (None, job.number)]
    count = 0
    for product in products(wanted, jobs, cluster):
        if product is not None:
            done[product.job.number] = target.take(product)
            count += 1
        if progress is not None:
            progress(count, len(wanted))
    ordered = [done[number] for number in sorted(done)]
    target.finish(ordered, excel)
    if merge is not None:
        merged(ordered, merge)
    return [each for each in ordered if only in (None, each.number)]


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
        path = gate.path("folder", path, "folder")
        self.path = Path(path)
        try:
            self.path.mkdir(exist_ok=True)
        except FileExistsError:
            message = f"{quoted(str(path))} is a file, not a folder"
            raise ExportError(message, "name another folder") from None
        except (OSError, ValueError) as error:
            raise _cannot(path, error) from None
        self._earlier: dict[int, list[JournalNote]] = {}
        for note in self._noted():
            self._earlier.setdefault(note["number"], []).append(note)
        self._notes: dict[int, JournalNote] = {}

    def standing(self, job: Job) -> Done | None:
        """Return a sheet that is in the folder already; None if it must be made."""
        for note in reversed(self._earlier.get(job.number, [])):
            if note["made_from"] != _seal(note, job):
                continue
            files: Mapping[str, str] = note["files"]
            if all(_digest_of(self.path / name) == digest for name, digest in files.items()):
                self._notes[job.number] = note
                return self._done(note, new=False)
        return None

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
        }
        note["made_from"] = _seal(note, job)
        self._notes[job.number] = note
        try:
            with open(self.path / _JOURNAL, "a", encoding="utf-8", newline="\n") as journal:
                journal.write("\n" + _line(note))  # the line before may have been cut short
        except OSError as error:
            raise _cannot(self.path / _JOURNAL, error) from None
        return self._done(note, new=True)

    def finish(self, sheets: Iterable[Done], excel: bool = False) -> None:
        """Write the answers of these sheets, as a sheet of Excel, too, where that is wanted."""
        notes = [self._notes[done.number] for done in sheets if done.error is None]
        if excel:
            columns, rows = _rows(notes)
            with new_file(self.path / _BOOK) as stream, workbook(stream, "answers") as book:
                book.sheet("answers", columns, ([row.get(c) for c in columns] for row in rows))
        with new_file(self.path / _TABLE) as stream:
            stream.write(_table(notes).encode())
        with new_file(self.path / _ANSWERS) as stream:
            body = ",\n".join(map(_line, notes))
            stream.write(f"[\n{body}\n]\n".encode())
        (self.path / _JOURNAL).unlink(missing_ok=True)

    def _noted(self) -> Iterator[JournalNote]:
        """Yield the notes of earlier runs, the latest last; what is no note is left out."""
        for name in (_ANSWERS, _JOURNAL):
            for line in (_content(self.path / name) or b"").split(b"\n"):
                try:
                    note = json.loads(line.strip().removesuffix(b","))
                except (ValueError, RecursionError):  # a bracket, or a line that is damaged
                    continue
                keys = {"number", "files", "made_from"}
                if isinstance(note, dict) and keys <= note.keys() and type(note["number"]) is int:
                    yield note

    def _done(self, note: JournalNote, new: bool) -> Done:
        extra = ("number", "files", "made_from")
        answers = {name: value for name, value in note.items() if name not in extra}
        return Done(
            note["number"], tuple(self.path / name for name in note["files"]), answers, new=new
        )


def _seal(note: JournalNote, job: Job) -> str:
    """Return a text that is different for other settings, and for a note that says anything else.

    It stands in the note as ``made_from``.
    """
    said = {name: value for name, value in note.items() if name != "made_from"}
    return _digest(f"{job.fingerprint} {_line(said)}".encode("utf-8", "surrogatepass"))


def _line(note: JournalNote) -> str:
    return json.dumps(note, ensure_ascii=False)


def _table(notes: list[JournalNote]) -> str:
    """Return the answers as a table with every digit, empty where a mechanism has no such thing."""
    columns, rows = _rows(notes)
    text = io.StringIO()
    table = csv.DictWriter(text, columns, lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    return text.getvalue()


def _rows(notes: list[JournalNote]) -> tuple[list[str], list[dict[str, Any]]]:
    """Return the columns of a table of answers, and its rows."""
    rows = [{"number": note["number"], **cells(note)} for note in notes]
    return list(dict.fromkeys(name for row in rows for name in row)) or ["number"], rows


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def _digest_of(path: Path) -> str | None:
    content = _content(path)
    return None if content is None else _digest(content)


def _content(path: Path) -> bytes | None:
    """Return what is in a file; None where there is none that can be read."""
    try:
        return path.read_bytes() if path.is_file() else None
    except OSError:
        return None


def _cannot(path: str | os.PathLike[str], error: Exception) -> ExportError:
    said = (getattr(error, "strerror", None) or str(error)).lower()
    return ExportError(f"folder {quoted(os.fspath(path))} cannot be written: {said}")


def cells(answers: Mapping[str, Any]) -> dict[str, Any]:
    """Return what was given and all results, the latter with units in the columns' names.

    ``answers`` is what `vad.Motion.to_dict` gives; ``found`` in it are further answers,
    such as what balances a shaft.

    Examples
    --------
    >>> import vad
    >>> row = cells(vad.solve(vad.ScotchYoke(), angle=90).to_dict())
    >>> row["crank"], row["yoke velocity [mm/s]"], row["B position y [mm]"]
    (50.0, -500.0, 50.0)
    """
    units: Mapping[str, str] = answers["units"]

    def head(name: str, quantity: str) -> str:
        kin = {"position": "length", "coriolis": "acceleration"}
        return f"{name} [{units[kin.get(quantity, quantity)]}]"

    row: dict[str, Any] = {**answers.get("roster", {}), "mechanism": answers["mechanism"]}
    row |= answers["parameters"]
    row |= {"assembly": _assembly(answers["assembly"]), "length_unit": units["length"]}
    row |= answers["input"]
    joints = {f"joint {letter}": each for letter, each in answers.get("joints", {}).items()}
    parts = answers["links"] | joints, answers["slides"], answers["points"]
    for owner, results in (pair for part in parts for pair in part.items()):
        for quantity, value in results.items():
            if isinstance(value, list):  # a vector
                for axis, number in zip(_AXES, value, strict=False):
                    row[head(f"{owner} {quantity} {axis}", quantity)] = number
            else:
                row[head(f"{owner} {quantity}", quantity)] = value
    for each in answers.get("found", ()):
        row[f"{each['name']} [{each['unit']}]" if each["unit"] else each["name"]] = each["value"]
    return row | _forces(answers["forces"]) if "forces" in answers else row


def _forces(found: Mapping[str, Any]) -> dict[str, Any]:
    """Return the drive, and the force in each joint, as `vad sweep` calls them."""
    newton = found["units"]["force"]
    row = {f"drive [{found['units']['drive']}]": found["drive"]}
    for joint in found["joints"]:
        for axis, number in zip(_AXES, joint["force"], strict=False):
            row[f"{joint['of']}.{joint['on']}.force {axis} [{newton}]"] = number
    return row


def _assembly(assembly: str | Mapping[str, Any] | None) -> str:
    """Return an assembly as it stands in a cell.

    Examples
    --------
    >>> _assembly("open"), _assembly({"B": "left", "G": "upper"})
    ('open', 'B=left G=upper')
    """
    if isinstance(assembly, Mapping):
        return " ".join(f"{point}={place}" for point, place in assembly.items())
    return assembly or ""

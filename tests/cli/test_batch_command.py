"""``vad batch``: exit codes, lines and what stands in the folder."""

from __future__ import annotations

import pytest

from tests.batches.conftest import CLASS


@pytest.fixture
def written(tmp_path):
    """Write a file of sheets and return its path."""

    def write(text=CLASS, name="sheets.toml"):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_a_class_gets_its_sheets(vad, written, tmp_path):
    result = vad("batch", str(written()), "-o", str(tmp_path / "out"))
    assert (result.code, result.out, result.err) == (0, "", "")
    assert len(list((tmp_path / "out").iterdir())) == 12


def test_a_sheet_that_fails_is_one_line(vad, written, tmp_path):
    rows = ["mechanism,crank,files", "four-bar,40,key.json", "four-bar,-3,key.json"]
    path = written("\n".join(rows), "sheets.csv")
    result = vad("batch", str(path), "-o", str(tmp_path / "out"))
    assert (result.code, result.out) == (1, "")
    said = "error: sheet 2: sheets.csv, line 3: crank: must be positive, got -3\n"
    assert result.err == said
    assert (tmp_path / "out" / "001-key.json").exists()


def test_wrong_usage(vad, written, tmp_path):
    path, out = str(written()), str(tmp_path / "out")
    for words, code, part in (
        (["-o", out], 2, "error: batch needs a file of sheets"),
        ([path], 2, "error: -o is missing"),
        ([path, "-o", out, "--only", "11"], 2, "error: only: there is no sheet 11"),
        ([path, "-o", out, "--jbos", "2"], 2, "hint: did you mean '--jobs'?"),
        ([path + "x", "-o", out], 2, "error: sheets cannot be read from"),
        ([str(tmp_path / "no.toml"), "-o", out], 1, "No such file or directory"),
        (["no.toml", "-o", out], 1, "hint: vad batch --help shows a file to begin with"),
        ([path.replace("sheets", "sheetz"), "-o", out], 1, "hint: sheets.toml is a file"),
        ([path, "-o", path], 1, "is a file, not a folder"),
        ([path, "-o", f"{out}/deeper"], 1, "cannot be written: no such file"),
        ([path, "-o", out, "--cluster", "nonsense"], 1, "cluster: nobody answers at 'nonsense'"),
    ):
        result = vad("batch", *words)
        assert result.code == code
        assert part in result.err
        assert "Traceback" not in result.err


def test_one_sheet_alone(vad, written, tmp_path):
    result = vad("batch", str(written(CLASS)), "-o", str(tmp_path / "out"), "--only", "3")
    assert (result.code, result.err) == (0, "")
    assert (tmp_path / "out" / "003-key.json").exists()


def test_the_command_lists_the_roster(vad, tmp_path):
    (tmp_path / "a.csv").write_text("mechanism,name,files\nfour-bar,Ada,key.json\n", "utf-8")
    result = vad("batch", str(tmp_path / "a.csv"), "-o", str(tmp_path / "out"))
    assert (result.code, result.err) == (0, "note: carried into names, titles and answers: name\n")

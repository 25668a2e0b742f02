"""Wrong words: one line ``error:``, perhaps one ``hint:``, and the exit code of the contract."""

from __future__ import annotations

import pytest


def complaint(result, code):
    """Return the error and the hint, having checked that there is nothing else."""
    assert (result.code, result.out) == (code, "")
    lines = result.err.splitlines()
    assert lines[0].startswith("error: ")
    assert [line.partition(" ")[0] for line in lines[1:]] in ([], ["hint:"])
    return lines[0][7:], lines[1][6:] if len(lines) > 1 else None


@pytest.mark.parametrize(
    ("words", "nearest"),
    [
        ("sovle slider-crank", "solve"),
        ("anmiate slider-crank -o a.mp4", "animate"),
        ("solve sldier-crank", "slider-crank"),
        ("solve fourbar", "four-bar"),
        ("solve Slider-Crank", "slider-crank"),
        ("solve slider_crank", "slider-crank"),
        ("solve slider-crank --crnak 60", "--crank"),
        ("solve slider-crank --crnak=60", "--crank"),
        ("solve slider-crank -crank 60", "--crank"),
        ("solve four-bar --ground_angle 60", "--ground-angle"),
        ("solve four-bar --assembly corssed", "crossed"),
        ("draw four-bar --panels velcity -o a.png", "velocity"),
        ("draw four-bar --panels position,velcity -o a.png", "velocity"),
        ("draw four-bar --style chlak -o a.png", "chalk"),
        ("draw four-bar --omega 3 --ou x.png", "--output"),
        ("list --jsn", "--json"),
        ("--versoin", "--version"),
    ],
)
def test_a_misspelt_word_is_answered_with_the_nearest(vad, words, nearest):
    _, hint = complaint(vad(*words.split()), 2)
    assert hint == f"did you mean '{nearest}'?"


def test_a_short_word_is_answered_with_all_that_there_are(vad):
    _, hint = complaint(vad(*["draw", "four-bar", "--language", "es", "-o", "a.png"]), 2)
    assert hint == "known: de, en, fr"


@pytest.mark.parametrize(
    ("words", "part"),
    [
        ("solve four-bar --crank abc", "--crank: 'abc' is not a number"),
        ("solve four-bar --crank 6_", "--crank: '6_' is not a number"),
        ("solve four-bar --crank 1,5", "--crank: '1,5' is not a number"),
        ("solve four-bar --crank --rocker", "--crank: '--rocker' is not a number"),
        ("solve four-bar --crank", "--crank needs a value"),
        ("solve four-bar --crank 6kg", "--crank: 'kg' is not a unit of length"),
        ("solve four-bar --omega 6mm", "--omega: 'mm' is not a unit of turning speed"),
        ("solve four-bar --omega 6Hz", "--omega: 'Hz' is not a unit of turning speed"),
        ("solve four-bar --length-unit bananas", "--length-unit: 'bananas' is not a unit of"),
        ("solve four-bar --length-unit s", "--length-unit: 's' is not a unit of length"),
        ("solve four-bar --digits 0", "digits: must be a whole number from 1 to 17, got 0"),
        ("solve four-bar more", "unexpected extra argument"),
        ("solve four-bar --json=3", "--json"),
        ("solve", "needs the name of a mechanism"),
        ("solve --json", "needs the name of a mechanism"),
        ("solve four-bar --position 3", "unknown option '--position'"),
        ("solve double-slider --omega 3", "unknown option '--omega'"),
        ("solve scotch-yoke --rod 3", "unknown option '--rod'"),
        ("draw four-bar", "-o is missing"),
        ("animate four-bar", "-o is missing"),
        ("sweep four-bar", "-o is missing"),
        ("draw four-bar -o", "-o needs a value"),
        ("animate four-bar -o=", "-o: the name is empty"),
        ("draw four-bar -o x.png --panels ,", "unknown panel ''"),
        ("animate four-bar -o x.mp4 --fps many", "--fps"),
        ("animate four-bar -o x.mp4 --size 12", "--size: '12' is not a size"),
        ("animate four-bar -o x.mp4 --size 1280x-720", "--size: '1280x-720' is not a size"),
        ("sweep four-bar -o x.csv --steps 1.5", "--steps"),
        ("animate four-bar --subtitles -o /", "'/' has no name, and so no file beside it"),
        ("sweep four-bar -o x.csv --steps 1", "--steps: must be from 2 to 10000000"),
        ("sweep four-bar -o x.csv --steps 10000001", "--steps: must be from 2 to 10000000"),
        ("sweep four-bar -o x.csv --from 7 --to 7", "--from, --to: 7 to 7 is no range"),
        ("sweep four-bar -o x.csv --to inf", "--from, --to: 0 to inf is no range"),
        ("animate four-bar -o x.png --still 99", "--still: there is no step 99: the lesson has"),
        ("animate four-bar -o x.png --still one", "--still: 'one' is not a step"),
        ("animate four-bar -o x.png --still velocty:1", "--still: unknown panel 'velocty'"),
        ("animate four-bar -o x.png --still " + "9" * 5000, "--still: there is no step 999"),
        ("animate four-bar -o x.srt --pause 4", "--pause: '4' is no pause"),
        ("animate four-bar -o x.srt --pause 4=1e5", "--pause: must be seconds from 0 to 3600, got"),
        ("animate four-bar -o x.srt --pause 4=-1", "--pause: must be seconds from 0 to 3600, got"),
        ("animate four-bar -o x.srt --pause 999=1", "--pause: there is no step 999: the lesson"),
        ("animate four-bar -o x.srt --pause foo=1", "--pause: 'foo' is not a step"),
        ("animate four-bar -o x.srt --pause 4=1,4=2", "--pause: step 4 is given twice"),
        ("animate four-bar -o x.srt --pause 1=1,foo=2", "--pause: 'foo' is not a step"),
        (
            "animate four-bar -o x.srt --pause 1=1 --pause position:1=2",
            "step position:1 is given twice",
        ),
        ("animate four-bar -o x.srt --speed 1000 --fps 1", "no caption stands as long as a frame"),
        ("list four-bar", "unexpected extra argument"),
        ("four-bar", "unknown command 'four-bar'"),
    ],
)
def test_wrong_usage_is_said_in_one_line(vad, words, part, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    error, _ = complaint(vad(*words.split()), 2)
    assert part in error
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("verb", ["draw", "animate", "sweep"])
def test_a_missing_output_is_answered_with_the_extensions(vad, verb):
    _, hint = complaint(vad(verb, "four-bar"), 2)
    extensions = {"draw": "png svg pdf json", "animate": "mp4 gif /", "sweep": "csv png"}
    assert all(each in hint for each in extensions[verb].split())


@pytest.mark.parametrize("word", ["0", "-4", "nan", "inf", "-inf", "1e400", "1e-400", "-1 cm"])
def test_a_length_that_cannot_be(vad, word):
    error, _ = complaint(vad("solve", "four-bar", "--crank", word), 1)
    assert error.startswith("crank: must be")


@pytest.mark.parametrize("name", ["angle", "omega", "alpha"])
@pytest.mark.parametrize("word", ["nan", "-inf", "1e999"])
def test_an_input_that_is_not_finite(vad, name, word):
    error, _ = complaint(vad("solve", "four-bar", f"--{name}", word), 1)
    assert error.startswith(f"{name}: must be a finite number")


def test_an_option_like_no_other_is_answered_with_all(vad):
    _, hint = complaint(vad("draw", "four-bar", "--xxxxx", "3", "-o", "x.png"), 2)
    assert hint.startswith("known: --")
    assert "--panels" in hint


def test_an_option_of_another_verb_is_answered_with_that_verb(vad):
    _, hint = complaint(vad("draw", "four-bar", "--fps", "3", "-o", "x.png"), 2)
    assert hint == "--fps is an option of vad animate"


@pytest.mark.parametrize(
    ("words", "said", "works"),
    [
        ("draw four-bar -o x.svg --no-sliders", "--no-sliders is for .html", ".html"),
        ("draw --no-sliders four-bar -o x.svg", "--no-sliders is for .html", ".html"),
        ("animate four-bar --no-sliders -o=x.svg", "--no-sliders is for .html", ".html"),
        ("animate four-bar -o x.svg --per-panel", "--per-panel is for .pptx", ".pptx"),
    ],
)
def test_an_option_of_another_format_is_answered_with_that_format(vad, words, said, works):
    error, hint = complaint(vad(*words.split()), 2)
    assert (error, hint) == (f"{said}, not for 'x.svg'", f"as in -o FILE{works}")


def test_the_known_options_are_those_of_all_formats(vad):
    _, hint = complaint(vad(*["animate", "four-bar", "-o", "x.mp4", "--zzzzzz"]), 2)
    assert "--no-sliders, --per-panel" in hint


@pytest.mark.parametrize("given", ["--rod 100", "--ram-height 180"])
def test_a_ram_takes_two_options(vad, given):
    _, hint = complaint(vad("solve", "crank-slotted-lever", *given.split()), 1)
    assert hint == "as in --rod 100 --ram-height 180"


@pytest.mark.parametrize(
    "words",
    [
        ["solve", "four-bar", "--crank", "9" * 130_000 + "x"],
        ["solve", "x" * 130_000],
        ["x" * 130_000],
        ["solve", "four-bar", "--" + "x" * 130_000],
        ["animate", "four-bar", "-o", "a.mp4", "--fps", "x" * 130_000],
        ["animate", "four-bar", "-o", "a.png", "--still", "x" * 130_000],
        ["draw", "four-bar", "-o", "x" * 130_000],
    ],
    ids=["number", "mechanism", "command", "option", "rate", "step", "file"],
)
def test_a_word_as_long_as_a_book_is_not_said_in_full(vad, words):
    result = vad(*words)
    assert result.code in (1, 2)
    assert all(len(line) < 520 for line in result.err.splitlines())


def test_the_root_of_all_folders_is_no_film(vad):
    error, _ = complaint(vad("animate", "scotch-yoke", "-o", "/"), 1)
    assert "'/'" in error


def test_a_matplotlibrc_that_cannot_be_read_is_named(process, tmp_path):
    (tmp_path / "matplotlibrc").write_bytes(b"font.family: \xff\n")
    result = process("sweep", "scotch-yoke", "-o", "a.png", cwd=tmp_path)
    error, _ = complaint(result, 1)
    assert "matplotlibrc" in error


def test_links_that_do_not_close(vad):
    error, hint = complaint(vad("solve", "four-bar", "--crank", "130", "--angle", "180"), 1)
    assert "miss by" in error
    assert "close for angle" in error
    assert hint.startswith("try angle")


def test_links_that_close_nowhere(vad, tmp_path):
    words = ("four-bar", "--crank", "500", "-o", str(tmp_path / "a.csv"))
    complaint(vad("sweep", *words), 1)
    assert not list(tmp_path.iterdir())


def test_a_dead_centre(vad):
    words = ("four-bar", "--ground", "4", "--crank", "3", "--coupler", "2", "--rocker", "3")
    error, _ = complaint(vad("solve", *words, "--angle", "90"), 1)
    assert "dead centre" in error


def test_a_name_with_line_breaks_stays_on_one_line(vad):
    error, _ = complaint(vad("solve", "four\nbar\x1b[31m\r\n"), 2)
    assert error == "unknown mechanism 'four bar?[31m '"


@pytest.mark.parametrize("verb", ["draw", "animate", "sweep"])
@pytest.mark.parametrize("output", ["x.xyz", "x.png.doc"])
def test_another_kind_of_file(vad, verb, output, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    complaint(vad(verb, "four-bar", "-o", output), 2)
    assert not list(tmp_path.iterdir())


def test_a_fault_of_the_program_is_no_traceback(vad, monkeypatch):
    from vad.cli import app

    def fail():
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(app, "table", fail)
    error, _ = complaint(vad("list"), 1)
    place = f"{__file__}, line {fail.__code__.co_firstlineno + 1}"
    assert error == f"internal fault (ZeroDivisionError: oh) in {place}"
    monkeypatch.setenv("VAD_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        vad("list")


def test_memory_that_is_not_there(vad, monkeypatch):
    from vad.cli import app

    def fail():
        raise MemoryError

    monkeypatch.setattr(app, "table", fail)
    assert complaint(vad("list"), 1)[0] == "out of memory"


def test_options_before_the_command(vad):
    _, hint = complaint(vad("--json", "list"), 2)
    assert "after the command" in hint


@pytest.mark.parametrize("verb", ["draw", "animate", "sweep"])
def test_a_file_s_name_that_is_too_long(vad, verb, tmp_path):
    path = tmp_path / ("x" * 300 + {"draw": ".png", "animate": ".mp4", "sweep": ".csv"}[verb])
    error, _ = complaint(vad(verb, "scotch-yoke", "-o", str(path)), 1)
    assert "name too long" in error.lower()

"""The process around a command: pipes that close, disks that are full, signals, encodings."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

VAD = f"{sys.executable} -m vad"
posix = pytest.mark.skipif(os.name != "posix", reason="signals and shells of POSIX")


@pytest.fixture
def shell(environment):
    """Call a shell with a line."""

    def call(line: str, **more: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            ["bash", "-c", line],
            capture_output=True,
            text=True,
            env={**environment, **more},
            timeout=60,
            check=False,
        )

    return call


def test_the_exit_codes_of_a_process(process):
    assert process("list").code == 0
    assert process("solve", "four-bar", "--crank", "-4").code == 1
    wrong = process("sovle")
    assert (wrong.code, wrong.out) == (2, "")
    assert wrong.err == "error: unknown command 'sovle'\nhint: did you mean 'solve'?\n"


def test_an_option_of_a_verb_that_is_not_imported_yet_is_named(process):
    wrong = process("solve", "four-bar", "--fps", "30")
    assert wrong.code == 2
    assert wrong.err == ("error: unknown option '--fps'\nhint: --fps is an option of vad animate\n")


@posix
def test_a_reader_that_goes_away_is_no_error(shell):
    for verb in ("list", "solve four-bar --json", "--help"):
        done = shell(f"{VAD} {verb} | head -0; exit ${{PIPESTATUS[0]}}")
        assert done.stderr == ""
        assert done.returncode in (0, 141)  # 0 if all was written before the reader went away


@posix
def test_closed_streams(shell):
    for closed in (">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"):
        done = shell(f"{VAD} list {closed}")
        assert (done.returncode, done.stderr) == (0, "")
    done = shell(f"{VAD} sovle 2>&-")
    assert (done.returncode, done.stdout) == (2, "")


@posix
def test_nobody_listens_to_an_error(shell):
    done = shell(f"{VAD} sovle 2>&1 >/dev/null | head -0; exit ${{PIPESTATUS[0]}}")
    assert done.returncode == 2


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no full device")
def test_a_full_disk(shell):
    done = shell(f"{VAD} list >/dev/full")
    assert done.returncode == 1
    assert done.stderr == "error: cannot write: No space left on device\n"


@pytest.mark.exhaustive(3)
@posix
@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_any_encoding_of_the_terminal(shell, encoding):
    done = shell(f"{VAD} solve slider-crank; {VAD} solve 'ω'", PYTHONIOENCODING=encoding)
    assert "Traceback" not in done.stderr
    assert done.returncode == 2
    assert "rod BC" in done.stdout


@posix
def test_a_home_that_cannot_be_written_is_not_mentioned(shell, tmp_path):
    done = shell(
        f"{VAD} sweep four-bar -o {tmp_path}/a.png",
        HOME="/nonexistent",
        XDG_CONFIG_HOME="/nonexistent",
        XDG_CACHE_HOME="/nonexistent",
        MPLCONFIGDIR="/nonexistent",
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@posix
@pytest.mark.parametrize(
    ("number", "code"),
    [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)],
    ids=["SIGINT", "SIGTERM", "SIGHUP"],
)
def test_a_signal_leaves_one_line_and_no_part_of_a_file(environment, tmp_path, number, code):
    path = tmp_path / "turn.csv"
    path.write_text("old")
    with subprocess.Popen(
        [sys.executable, "-m", "vad", "sweep", "four-bar", "--steps", "1000000", "-o", str(path)],
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
    ) as running:
        deadline = time.monotonic() + 30
        while len(list(tmp_path.iterdir())) < 2 and running.poll() is None:
            assert time.monotonic() < deadline
            time.sleep(0.01)  # until the new file is in the making
        running.send_signal(number)
        _, err = running.communicate(timeout=30)
    assert (running.returncode, err) == (code, "error: interrupted\n")
    assert [each.name for each in tmp_path.iterdir()] == ["turn.csv"]
    assert path.read_text() == "old"


@posix
def test_a_signal_that_is_ignored_stays_ignored(shell, tmp_path):
    line = f"trap '' INT; {VAD} sweep four-bar --steps 2000000 -o {tmp_path}/a.csv & "
    done = shell(line + "sleep 0.7; kill -INT $!; wait $!")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "a.csv").exists()


@pytest.mark.exhaustive
@posix
@pytest.mark.parametrize("output", ["film.mp4", "film.gif", "film/"])
def test_an_interrupt_in_mid_film(environment, tmp_path, output):
    words = ["animate", "slider-crank", "--speed", "0.1", "-o", str(tmp_path) + "/" + output]
    with subprocess.Popen(
        [sys.executable, "-m", "vad", *words], stderr=subprocess.PIPE, text=True, env=environment
    ) as running:
        deadline = time.monotonic() + 30
        while not list(tmp_path.iterdir()) and running.poll() is None:
            assert time.monotonic() < deadline
            time.sleep(0.01)
        time.sleep(0.2)
        running.send_signal(signal.SIGINT)
        _, err = running.communicate(timeout=30)
    assert (running.returncode, err) == (130, "error: interrupted\n")
    assert not list(tmp_path.iterdir())


@posix
def test_a_signal_of_which_python_makes_an_error_during_an_import(environment):
    """As where a class is made whose attributes are told their names."""
    script = (
        "import os, signal, sys\n"
        "from vad.cli import main\n"
        "class Name:\n"
        "    def __set_name__(self, owner, name):\n"
        "        os.kill(os.getpid(), signal.SIGINT)\n"
        "class Finder:\n"
        "    def find_spec(self, name, path=None, target=None):\n"
        "        if name == 'vad.cli.app':\n"
        "            type('Owner', (), {'name': Name()})\n"
        "sys.meta_path.insert(0, Finder())\n"
        "sys.argv = ['vad', 'list']\n"
        "sys.exit(main())\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        env=environment,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "error: interrupted\n")


@posix
def test_a_signal_that_a_library_makes_an_error_of(environment):
    """As numpy does while it is being imported."""
    script = (
        "import os, signal, sys\n"
        "from vad.cli import app, main\n"
        "def fail():\n"
        "    try:\n"
        "        os.kill(os.getpid(), signal.SIGINT)\n"
        "    except BaseException:\n"
        "        raise ImportError('initialization failed')\n"
        "app.table = fail\n"
        "sys.argv = ['vad', 'list']\n"
        "sys.exit(main())\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        env=environment,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "error: interrupted\n")

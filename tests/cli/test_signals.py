"""Signals: whatever comes together, one line is said and nothing half-written stays."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest

from vad.cli import process

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")

TERMINATED = 128 + 15, 128 + 1  # whichever of the two is heard first


@pytest.mark.exhaustive(6)
@pytest.mark.parametrize(
    ("words", "times"),
    [
        ("animate whitworth --speed .2 --fps 60 -o made.mp4", 1),
        ("animate whitworth --speed .2 --fps 60 -o made.gif", 1),
        ("sweep whitworth --steps 1000000 -o made.csv", 2),
    ],
    ids=["mp4", "gif", "csv"],
)
@pytest.mark.parametrize("pause", [0.0, 0.002], ids=["at once", "one soon after the other"])
def test_two_signals_together(environment, tmp_path, words, times, pause):
    """As at the end of a login."""
    for _ in range(times):
        with subprocess.Popen(
            [sys.executable, "-m", "vad", *words.split()],
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
            cwd=tmp_path,
        ) as running:
            deadline = time.monotonic() + 30
            while not list(tmp_path.iterdir()) and running.poll() is None:
                assert time.monotonic() < deadline
                time.sleep(0.01)  # until the file is in the making
            running.send_signal(signal.SIGTERM)
            time.sleep(pause)
            running.send_signal(signal.SIGHUP)
            _, err = running.communicate(timeout=30)
        assert err == "error: interrupted\n"
        assert running.returncode in TERMINATED
        assert not list(tmp_path.iterdir())


@pytest.fixture
def listening(monkeypatch):
    """Let this process turn signals into `process.Interrupted`, for the time of a test."""
    before = {number: signal.getsignal(number) for number in (signal.SIGTERM, signal.SIGHUP)}
    monkeypatch.setattr(process, "_SIGNALS", list(before))
    monkeypatch.setattr(process, "_heard", process._Heard())
    process.raise_on_signals()
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


def test_the_first_signal_is_raised(listening):
    with pytest.raises(process.Interrupted) as caught:
        os.kill(os.getpid(), signal.SIGTERM)
    assert caught.value.exit_code == 128 + signal.SIGTERM


def test_the_second_signal_ends_the_process_at_once(listening, monkeypatch, capfd):
    ends, done = [], []
    monkeypatch.setattr(os, "_exit", ends.append)
    monkeypatch.setattr(process, "_last_acts", [lambda: done.append("removed")])
    with pytest.raises(process.Interrupted), process.signals_held_back():
        os.kill(os.getpid(), signal.SIGHUP)
        os.kill(os.getpid(), signal.SIGTERM)
    assert (ends, done) == ([128 + signal.SIGTERM], ["removed"])
    assert capfd.readouterr().err == "error: interrupted\n"


#: What a command may be at when it is interrupted, whatever it is called.
WORK = {
    "checks no signal": "while True: pass",
    "holds signals back": "with process.signals_held_back():\n        while True: pass",
    "waits for a thread": "work = threading.Thread(target=time.sleep, args=(99,))\n"
    "    with process.signals_held_back():\n        work.start(); work.join()",
    "hears of it late": "try:\n        time.sleep(99)\n    finally:\n        time.sleep(99)",
}


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("work", WORK)
def test_a_second_interrupt_ends_any_command_at_once(environment, tmp_path, work):
    """Nothing half-written stays, here or where the system keeps temporary files."""
    script = (
        "import sys, threading, time, click\n"
        "from pathlib import Path\n"
        "from vad.cli import main, process\n"
        "from vad.cli.app import app\n"
        "from vad.export.files import new_file, new_folder, temporary_folder\n"
        "def act(**_):\n"
        "  with temporary_folder() as one, new_folder('two', bool) as two, new_file('three'):\n"
        "    (one / 'a').touch(); (two / 'b').touch(); Path('begun').touch()\n"
        f"    {WORK[work]}\n"
        "app.all_commands(); app.add_command(click.Command('draw', callback=act))\n"
        "sys.argv = ['vad', 'draw']\n"
        "sys.exit(main())\n"
    )
    temporary, folder = tmp_path / "temporary", tmp_path / "folder"
    temporary.mkdir()
    folder.mkdir()
    with subprocess.Popen(
        [sys.executable, "-c", script],
        stderr=subprocess.PIPE,
        text=True,
        env={**environment, "TMPDIR": str(temporary)},
        cwd=folder,
    ) as running:
        deadline = time.monotonic() + 30
        while not (folder / "begun").exists():
            assert time.monotonic() < deadline
            time.sleep(0.01)
        running.send_signal(signal.SIGINT)
        time.sleep(0.2)
        running.send_signal(signal.SIGINT)
        try:
            _, err = running.communicate(timeout=2)
        finally:
            running.kill()
    assert (running.returncode, err) == (130, "error: interrupted\n")
    assert [each.name for each in folder.iterdir()] == ["begun"]
    assert list(temporary.iterdir()) == []


def test_a_signal_that_is_held_back_is_raised_when_it_is_asked_for(listening):
    done = []
    with pytest.raises(process.Interrupted), process.signals_held_back():
        os.kill(os.getpid(), signal.SIGHUP)
        done.append("undisturbed")
        process.check_interrupt()
        done.append("too far")
    assert done == ["undisturbed"]


def test_a_signal_that_is_held_back_is_raised_at_the_end_at_the_latest(listening):
    with pytest.raises(process.Interrupted), process.signals_held_back():
        os.kill(os.getpid(), signal.SIGHUP)


def test_a_signal_that_is_lost_is_remembered_and_not_shown(environment):
    """As where Python tidies up after an import: what a finaliser raises reaches nobody."""
    script = (
        "import os, signal, sys\n"
        "from vad.cli import app, main\n"
        "class Tidied:\n"
        "    def __del__(self):\n"
        "        os.kill(os.getpid(), signal.SIGTERM)\n"
        "        sum(range(10))\n"
        "app.table = lambda: str(Tidied()) and ''\n"
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
    assert (done.returncode, done.stderr) == (143, "error: interrupted\n")


def test_a_thread_that_is_at_work_does_not_hold_back_the_end(environment):
    """Python would wait for it, and no signal is heard any more."""
    script = (
        "import sys, threading, time\n"
        "from vad.cli import app, main\n"
        "app.table = lambda: threading.Thread(target=time.sleep, args=(99,)).start() or 'done'\n"
        "sys.argv = ['vad', 'list']\n"
        "sys.exit(main())\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        env=environment,
        timeout=30,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "done\n", "")

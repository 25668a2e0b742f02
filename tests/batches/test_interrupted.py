"""A batch that is interrupted: its workers end with it, say nothing and leave nothing behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.batches.conftest import CLASS

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")

ROOT = Path(__file__).parents[2]
#: A class whose sheets are still being made when the batch is interrupted.
LARGE = CLASS.replace("key.json", "key.svg").replace("10\n", "90\n")
#: How long a terminal waits for all processes to end.
_PATIENCE = 20


@pytest.fixture
def batch(written, tmp_path):
    """Start a batch with two workers as a terminal does; it has a folder for temporary files."""
    path = written(LARGE)
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    words = ["batch", str(path), "-o", str(tmp_path / "out"), "--jobs", "2"]
    with subprocess.Popen(
        [sys.executable, "-m", "vad", *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": str(ROOT), "TMPDIR": str(temporary)},
    ) as running:
        yield running, tmp_path
        running.kill()


def ended(running: subprocess.Popen[str]) -> tuple[int, str]:
    """Return the exit code and what was said, once no process is left that could say more."""
    out, err = running.communicate(timeout=_PATIENCE)
    assert out == ""
    return running.returncode, err


def wait_for(running: subprocess.Popen[str], path: Path) -> None:
    deadline = time.monotonic() + 60
    while not path.exists() and running.poll() is None:
        assert time.monotonic() < deadline
        time.sleep(0.01)


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("pause", [0.0, 0.2, 0.4, 0.8])
@pytest.mark.parametrize(
    ("signals", "code"),
    [
        ([signal.SIGINT], 130),
        ([signal.SIGHUP], 129),
        ([signal.SIGINT, signal.SIGINT], 130),
    ],
    ids=["Ctrl+C", "the terminal is closed", "Ctrl+C twice"],
)
def test_what_a_terminal_sends_to_all_processes(batch, pause, signals, code):
    running, folder = batch
    wait_for(running, folder / "out")
    time.sleep(pause)
    for each in signals:
        os.killpg(running.pid, each)
        time.sleep(0.1)
    assert ended(running) == (code, "error: interrupted\n")
    assert list((folder / "temporary").iterdir()) == []
    assert list(folder.rglob(".vad-*")) == []


def test_the_end_of_the_main_process_is_that_of_its_workers(batch):
    running, folder = batch
    wait_for(running, folder / "out" / "001-key.svg")
    running.terminate()
    assert ended(running) == (143, "error: interrupted\n")
    assert list((folder / "temporary").iterdir()) == []


def test_workers_end_after_the_main_process_was_killed(batch):
    running, folder = batch
    wait_for(running, folder / "out" / "001-key.svg")
    time.sleep(0.5)  # until the workers work
    running.kill()
    assert ended(running) == (-9, "")


def test_what_a_killed_batch_left_is_removed_by_the_next_one_a_day_later(batch, written):
    """All processes were killed at once, so that nobody could clean up."""
    running, folder = batch
    out, temporary = folder / "out", folder / "temporary"
    wait_for(running, out / "001-key.svg")
    time.sleep(0.3)
    os.killpg(running.pid, signal.SIGKILL)
    assert ended(running) == (-9, "")
    (out / ".vad-0123abcd.part").touch()  # as where a file was being written
    assert list(temporary.iterdir()) != []
    yesterday = (time.time() - 90_000,) * 2
    for each in (*temporary.iterdir(), *out.glob(".vad-*")):
        os.utime(each, yesterday)
    written(CLASS)  # a smaller class, into the same folder
    again = [sys.executable, "-m", "vad", *running.args[3:]]
    surroundings = {**os.environ, "PYTHONPATH": str(ROOT), "TMPDIR": str(temporary)}
    assert subprocess.run(again, env=surroundings, check=False).returncode == 0
    assert list(temporary.iterdir()) == []
    assert list(folder.rglob(".vad-*")) == []

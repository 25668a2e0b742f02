"""The command: one line when it answers, nothing else, and an end in good order."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import urllib.error
import urllib.request
from pathlib import Path

from tests.test_imports import command, loaded
from vad.cli.run import run

ROOT = Path(__file__).parents[2]


def test_it_prints_its_address_and_ends_with_an_interrupt():
    process = subprocess.Popen(
        [sys.executable, "-m", "vad", "gui", "four-bar", "--crank=35", "--no-browser"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    line = process.stdout.readline()
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/\?token=[\w-]{32,}\n", line)
    try:
        urllib.request.urlopen(line.partition("?")[0], timeout=10)
    except urllib.error.HTTPError as refused:
        with refused:
            assert refused.code == 403
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=20) == ("", "")
    assert process.returncode == 0


def test_other_commands_load_no_server(tmp_path):
    path = str(tmp_path / "a.png")
    for words in (
        ("draw", "four-bar", "-o", path),
        ("gui", "--help"),
        ("gui", "four-bar", "--help"),
    ):
        assert not loaded(command(*words)) & {"starlette", "uvicorn", "anyio"}


def test_a_wrong_port_is_said(capsys):
    assert run(["gui", "--port", "70000", "--no-browser"]) == 1
    assert capsys.readouterr().err.startswith("error: --port: 70000 cannot be had")

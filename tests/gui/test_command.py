"""The command: one line when it answers, nothing else, and an end in good order."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path

import pytest

import vad
from tests.test_imports import command, loaded
from vad.cli.run import run
from vad.errors import VadError
from vad.files.examples import example_path, rotor_names

ROOT = Path(__file__).parents[2]


def started(*words: str, **environment: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "vad", "gui", *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT), **environment},
    )


def test_it_prints_its_address_and_ends_with_an_interrupt():
    process = started("four-bar", "--crank=35", "--no-browser")
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


@pytest.mark.skipif(os.name == "nt", reason="there, others cannot read a command line")
def test_the_command_line_of_the_browser_shows_no_key(tmp_path):
    log = tmp_path / "log.json"
    browser = f"{sys.executable} -m tests.gui.visitor {log} %s"
    process = started("four-bar", "--crank=35", BROWSER=browser, TMPDIR=str(tmp_path))
    token = re.search(r"token=(\S+)", process.stdout.readline())[1]
    end = time.monotonic() + 20
    while not log.exists() and time.monotonic() < end:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=20) == ("", "")
    seen = json.loads(log.read_text())
    ticket = re.search('ticket=([^"]+)', seen["leads"])[1]
    for secret in (token, ticket):
        assert secret not in " ".join(seen["words"])
    assert token not in seen["leads"]
    assert seen["modes"] == [0o600, 0o700]
    assert '"crank": 35.0' in seen["page"]
    assert not seen["left"]
    assert [each.name for each in tmp_path.iterdir()] == [log.name]


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_browser_in_the_foreground_holds_no_signal_back(number):
    process = started(BROWSER="sh -c 'sleep 8' %s")
    assert process.stdout.readline()
    time.sleep(0.5)
    begun = time.monotonic()
    process.send_signal(number)
    process.wait(timeout=20)
    assert time.monotonic() - begun < 6
    assert process.returncode == (0 if number == signal.SIGINT else 128 + number)
    process.stdout.close()
    process.stderr.close()


def test_without_a_browser_it_says_what_to_open():
    process = started(BROWSER="false %s", PATH="/nowhere", DISPLAY="", WAYLAND_DISPLAY="")
    address = process.stdout.readline().strip()
    assert process.stderr.readline().strip() == (
        f"hint: no browser can be started; open this address in one: {address}"
    )
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=20) == ("", "")


def test_other_commands_load_no_server(tmp_path):
    path = str(tmp_path / "a.png")
    for words in (
        ("draw", "four-bar", "-o", path),
        ("gui", "--help"),
        ("gui", "four-bar", "--help"),
    ):
        assert not loaded(command(*words)) & {"starlette", "uvicorn", "anyio"}


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--angle", "nan"], 1, "angle: must be a finite number, got nan"),
        (["--angle", "60 nan"], 2, "--angle: 'nan' is not a unit of angle"),
        (["--omega", "1e61"], 1, "omega: must be within ±1e+60"),
        (["--crank", "inf"], 1, "crank: must be a finite number"),
        (["--crank", "60 nan"], 2, "--crank: 'nan' is not a unit of length"),
        (["--length-unit", "nan"], 2, "--length-unit: 'nan' is not a unit of length"),
        (["--size", "1x1"], 2, "size: must be between 320x240 and"),
        (["--point", "D٣ on rod 3"], 1, "points: a name must be a capital letter"),
    ],
)
def test_what_the_page_could_not_begin_with_is_refused(capsys, monkeypatch, words, code, said):
    def never(*_: object) -> None:
        raise AssertionError("a page is served")

    monkeypatch.setattr("vad.gui.server.served", never)
    assert run(["gui", "slider-crank", "--no-browser", *words]) == code
    assert capsys.readouterr().err.startswith(f"error: {said}")


@pytest.mark.parametrize("name", rotor_names())
def test_no_window_opens_with_a_shaft_or_an_engine(capsys, name):
    assert run(["gui", str(example_path(name)), "--no-browser"]) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"error: {name}.toml: a window turns a mechanism by hand, which")
    assert f"vad draw {name}.toml -o {name}.png shows it" in said


def test_a_wrong_port_is_said(capsys):
    assert run(["gui", "--port", "70000", "--no-browser"]) == 1
    assert capsys.readouterr().err.startswith("error: --port: 70000 cannot be had")


#: Links in a row, each of which turns as the crank does; and points on a rod.
ROWS = 12
MANY_LINKS = """
[fixed]
A = [0, 0]
{pivots}
[links]
crank = {{ AB = 40 }}
{links}
[driver]
crank = {{ angle = 60, omega = 10 }}
[assembly]
{places}
"""
MANY_POINTS = """
[fixed]
A = [0, 0]
D = [100, 0]
[links]
crank = {{ AB = 40 }}
rod = {{ BC = 120, {rod} }}
rocker = {{ DC = 80, {rocker} }}
[driver]
crank = {{ angle = 60, omega = 10 }}
"""


def many_links() -> str:
    ends = ["B", *(f"C{number}" for number in range(ROWS))]
    return MANY_LINKS.format(
        pivots="\n".join(f"D{number} = [{100 * number + 100}, 0]" for number in range(ROWS)),
        links="\n".join(
            f"rod{number} = {{ {ends[number]}C{number} = 100 }}\n"
            f"rocker{number} = {{ D{number}C{number} = 40 }}"
            for number in range(ROWS)
        ),
        places="\n".join(f'C{number} = "parallel"' for number in range(ROWS)),
    )


def many_points() -> str:
    rod, rocker = (
        ", ".join(f"{start}{letter}{number} = {number + 10}" for number in range(60))
        for start, letter in (("B", "P"), ("D", "Q"))
    )
    return MANY_POINTS.format(rod=rod, rocker=rocker)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (many_links(), "the page has no room for 3 panels with 25 rows of results"),
        (many_points(), "points: a drawing has room for 60 on links, got 120"),
    ],
    ids=["links", "points"],
)
def test_a_file_that_no_page_has_room_for_is_refused(capsys, monkeypatch, tmp_path, text, said):
    def never(*_: object) -> None:
        raise AssertionError("a page is served")

    monkeypatch.setattr("vad.gui.server.served", never)
    path = tmp_path / "many.toml"
    path.write_text(text)
    assert run(["gui", str(path), "--no-browser"]) != 0
    assert capsys.readouterr().err.startswith(f"error: {said}")
    with pytest.raises(VadError, match=said):
        vad.widget(vad.load(path)())

"""What a client may cost: no question, connection or page that has gone keeps others waiting."""

from __future__ import annotations

import json
import os
import socket
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from http.client import HTTPConnection
from pathlib import Path
from threading import Event, Thread

import pytest

import vad.gui.answers
import vad.gui.connections
import vad.gui.server
from vad.gui.guard import PageKey
from vad.gui.messages import MOST_POINTS, ExportQuestion
from vad.gui.server import served

START = ExportQuestion("slider-crank")
KIND = {"content-type": "application/json"}


def for_ever(*_: object) -> None:
    while True:
        time.sleep(0)


@contextmanager
def soon(seconds: float = 8.0) -> Iterator[None]:
    begun = time.monotonic()
    yield
    assert time.monotonic() - begun < seconds


def until(holds: Callable[[], object], seconds: float = 10.0) -> None:
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.fixture
def quiet(capfd: pytest.CaptureFixture[str]) -> Iterator[None]:
    """Let nothing be printed on the terminal."""
    yield
    assert capfd.readouterr() == ("", "")


@pytest.fixture
def key(quiet: None, monkeypatch) -> Iterator[PageKey]:
    for name, seconds in (("SILENT", 0.6), ("UNASKED", 0.5), ("UNREAD", 0.5)):
        monkeypatch.setattr(vad.gui.connections, name, seconds)
    with served(START) as found:
        yield found


def asked(key: PageKey, path: str, question: object, method: str = "POST") -> HTTPConnection:
    line = HTTPConnection("127.0.0.1", key.port, timeout=20)
    headers = {**KIND, "cookie": f"{key.cookie}={key.token}"}
    line.request(method, path, json.dumps(question), headers)
    return line


def answer(key: PageKey, path: str = "/api/pose", **question: object) -> tuple[int, bytes]:
    line = asked(key, path, {"mechanism": "slider-crank", **question})
    with line.getresponse() as found:
        status, data = found.status, found.read()
    line.close()
    return status, data


def test_an_endless_pose_freezes_nobody_and_is_stopped(key, monkeypatch):
    pose = vad.gui.server.pose
    monkeypatch.setattr(
        "vad.gui.server.pose", lambda q: for_ever() if q.inputs.get("angle") == 1 else pose(q)
    )
    lines = [
        asked(key, "/api/pose", {"mechanism": "slider-crank", "inputs": {"angle": 1}})
        for _ in range(3)
    ]
    with soon():
        assert answer(key)[0] == 200
    for line in lines:
        line.close()  # nobody waits any more
    with soon():
        several = [asked(key, "/api/pose", {"mechanism": "slider-crank"}) for _ in range(8)]
        assert [line.getresponse().status for line in several] == [200] * 8
    for line in several:
        line.close()


def test_an_answer_that_takes_too_long_is_an_error(monkeypatch, quiet):
    monkeypatch.setattr("vad.gui.server.ANSWER", 0.4)
    monkeypatch.setattr("vad.gui.server.lesson", for_ever)
    with served(START) as key, soon():
        status, data = answer(key, "/api/lesson")
        assert status == 503
        error = json.loads(data)["error"]
        assert error["kind"] == "busy"
        assert error["message"] == "the answer takes longer than 0.4 s"
        assert answer(key)[0] == 200


def test_a_server_ends_while_it_works(monkeypatch, quiet):
    monkeypatch.setattr("vad.gui.server.pose", for_ever)
    monkeypatch.setattr("vad.gui.server.saved", for_ever)
    with ExitStack() as stack, soon(4):
        with served(START) as key:
            for path in ("/api/pose", "/api/export/mp4", "/api/export/png"):
                line = asked(key, path, {"mechanism": "slider-crank"})
                stack.callback(line.close)
            time.sleep(0.3)
            begun = time.monotonic()
        assert time.monotonic() - begun < 3


def test_a_film_ends_with_the_page_that_wants_it(key, monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    begun = Event()

    def slow(folder: Path) -> None:
        begun.set()
        time.sleep(0.01)

    monkeypatch.setattr(vad.gui.answers, "_check_size", slow)
    film = {"fps": 60, "speed": 0.1, "size": [640, 480], "mechanism": "slider-crank"}
    line = asked(key, "/api/export/mp4", film)
    assert begun.wait(20)
    assert answer(key, "/api/export/gif")[0] == 503
    assert answer(key, "/api/export/svg")[0] == 200  # no film
    line.close()  # the page has gone
    until(lambda: not list(tmp_path.iterdir()))
    quick = {"fps": 2, "speed": 20.0, "size": [320, 240]}
    until(lambda: answer(key, "/api/export/gif", **quick)[0] == 200)


def test_a_film_has_a_most_of_bytes(key, monkeypatch):
    monkeypatch.setattr(vad.gui.answers, "LARGEST_FILE", 20_000)
    _, data = answer(key, "/api/export/gif", size=[640, 480], fps=10)
    assert json.loads(data)["error"]["message"] == "the film takes more than 0.02 MB"


def test_what_a_killed_process_left_is_swept(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    old, new, foreign = (
        tmp_path / name for name in ("vad-0123abcd.tmp", "vad-4567abcd.tmp", "vad-mine.tmp")
    )
    for folder in (old, new, foreign):
        folder.mkdir()
        (folder / "film.mp4").write_bytes(b"half")
    for folder in (old, foreign):
        os.utime(folder, (time.time() - 2 * 86400,) * 2)
    vad.gui.answers.saved(ExportQuestion("slider-crank", size=(320, 240)), "svg")
    assert sorted(each.name for each in tmp_path.iterdir()) == sorted([new.name, foreign.name])


def test_points_have_a_most(key):
    many = {f"P{i}": ["rod", i, 0] for i in range(MOST_POINTS + 1)}
    status, data = answer(key, points=many)
    assert status == 422
    assert json.loads(data)["error"]["message"] == "points: a window takes at most 40, got 41"


def test_uploads_that_break_off_are_no_news(key):
    head = (
        "POST /api/pose HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n"
        f"Cookie: {key.cookie}={key.token}\r\nContent-Length: 100\r\n\r\n"
    )
    for sent in (head[:40], head, head + '{"mechanism"'):
        with socket.create_connection(("127.0.0.1", key.port)) as line:
            line.sendall(sent.encode())
            time.sleep(0.05)
    assert answer(key)[0] == 200
    time.sleep(0.3)


def closed(line: socket.socket) -> bytes:
    """Return all that comes until the other side closes a connection."""
    line.settimeout(10)
    data = b""
    try:
        while piece := line.recv(65536):
            data += piece
    except ConnectionResetError:
        pass
    return data


def test_silent_and_slow_clients_are_cut(key):
    head = f"POST /api/pose HTTP/1.1\r\nHost: 127.0.0.1\r\nCookie: {key.cookie}={key.token}\r\n"
    kind = "Content-Type: application/json\r\n"
    told = {
        "": b"",
        head: b"",  # half a head
        f"{head}{kind}Content-Length: 90\r\n\r\n{{": b"408",
        "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n": b"403",
    }
    for sent, status in told.items():
        with socket.create_connection(("127.0.0.1", key.port)) as line, soon():
            line.sendall(sent.encode())
            assert closed(line)[9:12] == status


def test_an_upload_without_a_key_cannot_hold_a_connection(key):
    head = b"POST /api/pose HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 9999999\r\n\r\n"
    with socket.create_connection(("127.0.0.1", key.port)) as line, soon():
        line.sendall(head)
        with pytest.raises(OSError):
            while True:
                line.sendall(b"x")
                time.sleep(0.02)


def test_an_answer_that_nobody_reads_is_given_up(key, monkeypatch):
    sending = Event()

    def large(*_: object) -> tuple[bytes, str]:
        sending.set()
        return bytes(50_000_000), "film.mp4"

    monkeypatch.setattr("vad.gui.server.saved", large)
    line = asked(key, "/api/export/mp4", {"mechanism": "slider-crank"})
    assert sending.wait(10)
    assert answer(key, "/api/export/gif")[0] == 503  # one that is not yet sent counts
    until(lambda: answer(key, "/api/export/gif")[0] == 200)
    line.close()


def test_connections_that_are_held_keep_nobody_out(key):
    resource = pytest.importorskip("resource", reason="there is no limit of files to be raised")
    most, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if most < 4000:
        most = 4000 if hard == resource.RLIM_INFINITY else min(hard, 4000)
        resource.setrlimit(resource.RLIMIT_NOFILE, (most, hard))
    with ExitStack() as stack:
        for _ in range(min(1600, (most - 400) // 2)):  # both ends are files of this process
            stack.enter_context(socket.create_connection(("127.0.0.1", key.port)))
        with soon():
            assert answer(key)[0] == 200


def test_two_clients_and_several_threads_have_the_same_answers(key, exhaustive):
    count = 10 if exhaustive else 4

    def moves(answers: list[object]) -> None:
        for angle in range(0, 10 * count, 10):
            found = json.loads(answer(key, inputs={"angle": angle})[1])
            answers.append({name: each for name, each in found.items() if name != "ms"})

    all_answers: list[list[object]] = [[] for _ in range(4)]
    threads = [Thread(target=moves, args=(each,)) for each in all_answers]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(all_answers[0]) == count
    assert all(each == all_answers[0] for each in all_answers)


def test_a_body_that_is_none_is_no_news(key):
    """The server refuses it before the question is answered, which cannot be done any more."""
    for cookie in ("", f"Cookie: {key.cookie}={key.token}\r\n"):
        head = f"POST / HTTP/1.1\r\nHost: x\r\n{cookie}Transfer-Encoding: chunked\r\n\r\n"
        with socket.create_connection(("127.0.0.1", key.port)) as line:
            line.sendall(f"{head}no chunk\r\n".encode())
            assert line.recv(1 << 16).startswith(b"HTTP/1.1 400 ")
    assert answer(key)[0] == 200

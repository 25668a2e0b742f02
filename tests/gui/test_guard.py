"""What the local server refuses, line by line as its design has it."""

from __future__ import annotations

import re
import socket
from concurrent.futures import ThreadPoolExecutor
from threading import Event

import pytest
from starlette.testclient import TestClient

import vad.gui.server
from tests.gui.conftest import HOME, PORT
from vad.errors import ExportError
from vad.gui.guard import PageKey
from vad.gui.messages import LONGEST, ExportQuestion
from vad.gui.server import served

POSE = {"mechanism": "slider-crank"}
START = ExportQuestion("slider-crank")


def test_it_listens_on_this_machine_alone():
    with served(START) as key:
        port = key.port
        socket.create_connection(("127.0.0.1", port)).close()
        with pytest.raises(OSError, match="refused"):
            socket.create_connection(("127.0.0.2", port))  # an address of this machine, too
        with pytest.raises(ExportError, match="--port") as taken, served(START, port):
            pass
        assert "--port 0" in taken.value.hint


@pytest.mark.parametrize(
    "host", ["evil.example", "evil.example:8765", "127.0.0.1.evil.example", ""]
)
def test_a_name_that_points_here_is_no_way_in(client: TestClient, host):
    for method, path in (("GET", "/"), ("POST", "/api/pose")):
        assert client.request(method, path, headers={"host": host}, json=POSE).status_code == 400


@pytest.mark.parametrize(
    "headers",
    [
        {"origin": "https://evil.example"},
        {"origin": "null"},
        {"origin": f"http://127.0.0.1:{PORT + 1}"},
        {"sec-fetch-site": "cross-site"},
        {"sec-fetch-site": "same-site"},
    ],
)
def test_other_pages_are_refused(client: TestClient, headers):
    assert client.post("/api/pose", json=POSE, headers=headers).status_code == 403
    assert client.get("/", headers=headers).status_code == 403


def test_its_own_page_is_answered(client: TestClient):
    headers = {"origin": HOME, "sec-fetch-site": "same-origin"}
    assert client.post("/api/pose", json=POSE, headers=headers).status_code == 200


def test_a_token_becomes_a_cookie_and_leaves_the_address(stranger: TestClient, key: PageKey):
    assert len(key.token) >= 32
    assert key.token not in repr(key)
    answer = stranger.get(f"/?token={key.token}", follow_redirects=False)
    assert answer.status_code == 303
    assert answer.headers["location"] == "/"
    cookie = answer.headers["set-cookie"]
    assert cookie.startswith(f"vad-{PORT}={key.token};")
    assert {"httponly", "samesite=strict"} <= set(cookie.lower().replace(" ", "").split(";"))
    assert stranger.get("/").status_code == 200


def test_a_ticket_is_good_once(stranger: TestClient, key: PageKey):
    used = []
    key.ticket.on_use = lambda: used.append(1)
    # A file leads the browser here, which is another site to it.
    cross = {"sec-fetch-site": "cross-site", "sec-fetch-mode": "navigate"}
    assert stranger.post(f"/?ticket={key.ticket.text}").status_code == 403
    assert stranger.get(f"/?ticket={key.token}", headers=cross).status_code == 403
    assert not used
    answer = stranger.get(f"/?ticket={key.ticket.text}", headers=cross)
    assert answer.status_code == 200
    assert 'content="0; url=/"' in answer.text
    assert {"httponly", "samesite=strict"} <= set(
        answer.headers["set-cookie"].lower().replace(" ", "").split(";")
    )
    assert stranger.get("/").status_code == 200
    assert used == [1]
    stranger.cookies.clear()
    assert stranger.get(f"/?ticket={key.ticket.text}").status_code == 403
    assert used == [1]
    assert key.ticket.text not in repr(key)


def test_the_printed_address_opens_as_many_tabs_as_its_owner_likes(
    stranger: TestClient, key: PageKey
):
    for _ in range(3):
        stranger.cookies.clear()
        assert stranger.get(f"/?token={key.token}").status_code == 200


def test_a_port_may_be_forwarded(client: TestClient):
    # As by ssh -L 9000:127.0.0.1:8765; there, page and questions have the same host.
    home = "http://127.0.0.1:9000"
    asked = {"host": "127.0.0.1:9000", "origin": home, "sec-fetch-site": "same-origin"}
    assert client.post("/api/pose", json=POSE, headers=asked).status_code == 200
    assert client.post("/api/pose", json=POSE, headers={"origin": home}).status_code == 403


@pytest.mark.parametrize("path", ["/", "/?token=", "/?token=x", "/?token=é", "/?ticket=é"])
def test_nobody_else_is_let_in(stranger: TestClient, path):
    assert stranger.get(path).status_code == 403
    stranger.cookies.set(f"vad-{PORT}", "x")
    assert stranger.get(path).status_code == 403
    assert stranger.post("/api/pose", json=POSE).status_code == 403


def test_only_json_is_read(client: TestClient):
    for kind in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data", ""):
        answer = client.post("/api/pose", content=b"{}", headers={"content-type": kind})
        assert answer.status_code == 400, kind
    for text in (b"", b"{", b"\xff", b"[" * 9000):
        answer = client.post(
            "/api/pose", content=text, headers={"content-type": "application/json"}
        )
        assert answer.status_code == 400, text
    for path in ("/api/pose", "/api/lesson", "/api/export/png"):
        assert client.get(path).status_code == 405
    answer = client.options("/api/pose", headers={"access-control-request-method": "POST"})
    assert not [name for name in answer.headers if name.startswith("access-control")]


@pytest.mark.parametrize(
    "path",
    ["/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/api/export/..%2f..%2fx.png", "/window.js"],
)
def test_no_request_names_a_file(client: TestClient, path):
    assert client.get(path).status_code in (404, 405)
    assert client.post(path, json=POSE).status_code in (404, 405)


def test_a_long_question_is_not_read(client: TestClient):
    body = b'{"mechanism":"' + b"x" * LONGEST + b'"}'
    kind = {"content-type": "application/json"}
    assert client.post("/api/pose", content=body, headers=kind).status_code == 400
    in_parts = (body[at : at + 4096] for at in range(0, len(body), 4096))
    assert client.post("/api/pose", content=in_parts, headers=kind).status_code == 400


def test_a_second_film_waits(client: TestClient, monkeypatch):
    begun, over = Event(), Event()

    def slow(*_: object) -> tuple[bytes, str]:
        begun.set()
        over.wait(10)
        return b"film", "film.mp4"

    monkeypatch.setattr(vad.gui.server, "saved", slow)
    with client, ThreadPoolExecutor() as pool:
        first = pool.submit(client.post, "/api/export/mp4", json=POSE)
        assert begun.wait(10)
        second = client.post("/api/export/gif", json=POSE)
        over.set()
        assert first.result().content == b"film"
    assert second.status_code == 503
    assert second.headers["retry-after"].isdecimal()


@pytest.mark.parametrize("path", ["/", "/api/pose", "/nowhere", "refused", "foreign"])
def test_every_answer_tells_the_browser_to_be_careful(client: TestClient, path):
    headers = {"refused": {"origin": "null"}, "foreign": {"host": "evil.example"}}.get(path, {})
    answer = client.get(path, headers=headers)
    policy = answer.headers["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "frame-ancestors 'none'" in policy
    assert "unsafe-inline" not in re.search("script-src[^;]*", policy)[0]
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert answer.headers["referrer-policy"] == "no-referrer"
    assert answer.headers["cross-origin-resource-policy"] == "same-origin"
    assert answer.headers["cross-origin-opener-policy"] == "same-origin"
    assert answer.headers["cache-control"] == "no-store"


def test_the_script_has_a_nonce_that_nobody_can_guess(client: TestClient):
    nonces = set()
    for _ in range(2):
        answer = client.get("/")
        nonce = re.search("'nonce-([^']+)'", answer.headers["content-security-policy"])[1]
        assert answer.text.count(f'nonce="{nonce}"') == 1
        nonces.add(nonce)
    assert len(nonces) == 2


def test_what_a_proxy_would_say_is_not_believed(client: TestClient):
    headers = {"x-forwarded-host": "evil.example", "x-forwarded-for": "10.0.0.1"}
    assert client.get("/", headers=headers).status_code == 200
    assert client.get("/", headers={**headers, "host": "evil.example"}).status_code == 400


def test_a_fault_is_one_sentence_here_and_a_traceback_in_the_terminal(
    client: TestClient, monkeypatch, capsys
):
    monkeypatch.setattr(vad.gui.messages.Question, "build", lambda _: 1 / 0)
    answer = client.post("/api/pose", json=POSE)
    assert answer.status_code == 500
    assert answer.json()["error"]["message"] == "a fault of the program; the terminal shows where"
    assert "Traceback" not in answer.text
    assert "ZeroDivisionError" in capsys.readouterr().err


def test_a_browser_without_the_key_is_told_so_in_a_page(stranger: TestClient):
    answer = stranger.get("/", headers={"accept": "text/html,*/*"})
    assert answer.status_code == 403
    assert answer.headers["content-type"].startswith("text/html")
    assert "open the address that vad gui has printed" in answer.text

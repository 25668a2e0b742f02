"""How the tests ask the server: as the page does, without a browser."""

from __future__ import annotations

from collections.abc import Callable
from threading import Event
from typing import Any

import pytest
from starlette.testclient import TestClient

from vad.gui.guard import PageKey
from vad.gui.messages import ExportQuestion
from vad.gui.server import application

PORT = 8765
HOME = f"http://127.0.0.1:{PORT}"


@pytest.fixture
def key() -> PageKey:
    return PageKey(PORT)


@pytest.fixture
def stranger(key: PageKey) -> TestClient:
    """Return a client that has no token."""
    app = application(key, ExportQuestion("slider-crank"), Event())
    return TestClient(app, HOME, raise_server_exceptions=False)


@pytest.fixture
def client(key: PageKey, stranger: TestClient) -> TestClient:
    """Return a client that has opened the printed address."""
    stranger.cookies.set(key.cookie, key.token)
    return stranger


@pytest.fixture
def ask(client: TestClient) -> Callable[..., dict[str, Any]]:
    """Ask a question, and return the answer's JSON."""

    def asked(path: str, mechanism: str, **more: object) -> dict[str, Any]:
        answer = client.post(f"/api/{path}", json={"mechanism": mechanism, **more})
        assert answer.status_code == 200, answer.text
        return answer.json()

    return asked

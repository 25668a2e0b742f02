"""The server on this machine: its routes, its address, and how it ends.

A request that the guard lets pass is answered with a page, a pose, a lesson or a file.  Poses and
lessons are calculated one at a time, because one person looks at them.  They are calculated in the
thread of the server: another thread would delay each move by half a millisecond.  A film is made in
a thread of its own, and a second film is refused until the first is complete.  The server takes
127.0.0.1 and nothing else, and there is no option that says otherwise.
"""

from __future__ import annotations

import contextlib
import json
import socket
import time
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import replace
from threading import Event, Thread
from typing import Any
from urllib.parse import quote

import anyio.to_thread
import uvicorn
from anyio import CapacityLimiter, WouldBlock
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp

from vad.errors import ExportError, VadError
from vad.gui.answers import MEDIA, lesson, pose, saved
from vad.gui.guard import HOSTS, Guard, PageKey, RefusalError, SecurityHeaders
from vad.gui.messages import ExportQuestion, LessonQuestion, PoseQuestion, Question, problem, read
from vad.gui.window import window
from vad.words import all_languages

_HOST = "127.0.0.1"
_PATIENCE = 1  # seconds for what is being sent when the server ends
_RETRY = {"retry-after": "5"}
Endpoint = Callable[[Request], Awaitable[Response]]


@contextlib.contextmanager
def served(start: ExportQuestion, port: int = 0) -> Iterator[PageKey]:
    """Serve the page while the block runs, and yield what opens it once it answers.

    Parameters
    ----------
    start
        What is set when the page opens.
    port
        0 for any that is free.

    Raises
    ------
    vad.errors.ExportError
        If the port is not free.
    """
    with contextlib.closing(_listening(port)) as listener:
        key, closing = PageKey(listener.getsockname()[1]), Event()
        config = uvicorn.Config(
            application(key, start, closing),
            ws="none",
            lifespan="off",
            log_config=None,
            access_log=False,
            proxy_headers=False,
            server_header=False,
            timeout_graceful_shutdown=_PATIENCE,
        )
        server = uvicorn.Server(config)
        thread = Thread(target=server.run, args=([listener],), name="vad gui")
        thread.start()
        try:
            # Waits until the server answers or its thread has ended.
            while not server.started and thread.is_alive():
                time.sleep(0.01)
            yield key
        finally:
            closing.set()
            server.should_exit = True
            thread.join()


def _listening(port: int) -> socket.socket:
    listener = socket.socket(proto=socket.IPPROTO_TCP)  # or else asyncio leaves Nagle's delay on
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((_HOST, port))
        listener.listen()
    except (OSError, OverflowError) as error:
        listener.close()
        reason = getattr(error, "strerror", None) or "there is no such port"
        message = f"--port: {port} cannot be had: {reason.lower()}"
        raise ExportError(message, hint="--port 0 takes one that is free") from None
    return listener


def application(key: PageKey, start: ExportQuestion, closing: Event) -> ASGIApp:
    """Return the server's application.

    Parameters
    ----------
    key
        What opens it.
    start
        What is set when the page opens.
    closing
        Set when the server is to end; a film that is being made ends, too.
    """
    filming = CapacityLimiter(1)

    async def page(request: Request) -> Response:
        code = request.query_params.get("lang", start.language)
        shown = replace(start, language=code if code in all_languages() else start.language)
        nonce = request.state.nonce
        return HTMLResponse(window(shown, nonce))

    def answer(kind: type[Question], work: Callable[[Any], dict[str, Any]]) -> Endpoint:
        async def asked(request: Request) -> Response:
            question = read(kind, await _json(request), start.kinds)
            return _reply(_answer_or_error(work, question))

        return _with_errors(asked)

    async def export(request: Request) -> Response:
        extension = request.path_params["extension"]
        if extension not in MEDIA:
            raise RefusalError(404, "there is no such format")
        question = read(ExportQuestion, await _json(request), start.kinds)
        try:
            filming.acquire_on_behalf_of_nowait(request)
        except WouldBlock:
            busy = {"message": "another file is being made", "hint": None, "kind": "busy"}
            return JSONResponse({"error": busy}, 503, _RETRY)
        try:
            data, name = await anyio.to_thread.run_sync(saved, question, extension, closing)
        except VadError as error:
            return _reply({"error": problem(error, question.fields)})
        finally:
            filming.release_on_behalf_of(request)
        headers = {"content-disposition": _attached(name)}
        return Response(data, media_type=MEDIA[extension], headers=headers)

    routes = [
        Route("/", page, methods=["GET"]),
        Route("/api/pose", answer(PoseQuestion, pose), methods=["POST"]),
        Route("/api/lesson", answer(LessonQuestion, lesson), methods=["POST"]),
        Route("/api/export/{extension}", _with_errors(export), methods=["POST"]),
    ]
    middleware = [
        Middleware(SecurityHeaders),
        Middleware(TrustedHostMiddleware, allowed_hosts=HOSTS, www_redirect=False),
        Middleware(Guard, key=key),
    ]
    return Starlette(routes=routes, middleware=middleware)


def _answer_or_error(work: Callable[[Any], dict[str, Any]], question: Question) -> dict[str, Any]:
    """Return an answer, or the error if the user can do something about it."""
    try:
        return work(question)
    except VadError as error:
        return {"error": problem(error, question.fields)}


def _with_errors(endpoint: Endpoint) -> Endpoint:
    """Answer a faulty question with its error; the page itself never asks one."""

    async def asked(request: Request) -> Response:
        try:
            return await endpoint(request)
        except VadError as error:
            return _reply({"error": problem(error)}, 422)

    return asked


def _attached(name: str) -> str:
    """Return what tells a browser to save a file under its name, which may have any letters."""
    plain = quote(name)
    return (
        f'attachment; filename="{name}"'
        if plain == name
        else f"attachment; filename*=UTF-8''{plain}"
    )


async def _json(request: Request) -> object:
    try:
        return json.loads(await request.body())
    except (ValueError, RecursionError):
        raise RefusalError(400, "the question is not JSON") from None


def _reply(data: dict[str, Any], status: int = 200) -> Response:
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return Response(text, status, media_type="application/json")

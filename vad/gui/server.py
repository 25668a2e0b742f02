"""The server on this machine: its routes, its address, and how it ends.

A request that the guard lets pass is answered with a page, a pose, a lesson or a file.  All are
worked out in threads, which are stopped when it takes too long, when nobody waits any more, and
when the server ends.  One film is made at a time, and a second one is refused until the first has
been sent.  The server takes 127.0.0.1 and nothing else, and there is no option that says otherwise.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import socket
import time
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import replace
from functools import partial
from threading import Event, Thread
from typing import Any
from urllib.parse import quote

import uvicorn
from starlette.applications import Starlette
from starlette.datastructures import Headers
from starlette.middleware import Middleware
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp, Receive, Scope, Send

from vad.errors import ExportError, VadError
from vad.gui.answers import FILMS, MEDIA, lesson, pose, saved
from vad.gui.connections import Connection, InPieces, body_of
from vad.gui.guard import HOSTS, Guard, PageKey, RefusalError, SecurityHeaders
from vad.gui.messages import (
    EntryQuestion,
    ExportQuestion,
    LessonQuestion,
    PoseQuestion,
    Question,
    as_json,
    problem,
    read,
)
from vad.gui.said import sayer
from vad.gui.shelf import Shelf
from vad.gui.window import listed, window
from vad.gui.work import ANSWER, ANSWERS, FILE, FILES, FILM, BusyError, Work
from vad.words import all_languages

_HOST = "127.0.0.1"
_PATIENCE = 1  # seconds for what is being sent when the server ends
_END = 3.0  # seconds after which nobody waits for its end any more
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
            http=Connection,
            ws="none",
            lifespan="off",
            log_config=None,
            access_log=False,
            proxy_headers=False,
            server_header=False,
            timeout_graceful_shutdown=_PATIENCE,
        )
        logging.getLogger("uvicorn").addHandler(logging.NullHandler())
        server = uvicorn.Server(config)
        thread = Thread(target=server.run, args=([listener],), name="vad gui", daemon=True)
        thread.start()
        try:
            # Waits until the server answers or its thread has ended.
            while not server.started and thread.is_alive():
                time.sleep(0.01)
            yield key
        finally:
            closing.set()
            server.should_exit = True
            thread.join(_END)


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
        Set when the server is to end; all that is being worked out is stopped then.
    """
    answers, files = Work(closing, ANSWERS), Work(closing, FILES)
    shelf = Shelf(start.kinds)

    def answered(
        given: Callable[[Request, bytes], Response],
        work: Work = answers,
        seconds: float = ANSWER,
    ) -> Endpoint:
        """Return the endpoint whose answer a function gives to a request with its body."""

        async def endpoint(request: Request) -> Response:
            body = await body_of(request)
            gone = request.is_disconnected
            try:
                return await work.done(seconds, gone, partial(given, request, body))
            except BusyError as error:
                return _busy(error, request.headers)
            except VadError as error:  # of a question that the page itself never asks
                return _reply({"error": problem(error)}, 422)

        return endpoint

    def page(request: Request, _: bytes) -> Response:
        code = request.query_params.get("lang", start.language)
        language = code if code in all_languages() else start.language
        shown = replace(start, language=language, kinds={**start.kinds, **shelf.opened})
        return HTMLResponse(window(shown, request.state.nonce))

    def posed(_: Request, body: bytes) -> Response:
        return _answer_or_error(pose, read(PoseQuestion, _json(body), shelf))

    def taught(_: Request, body: bytes) -> Response:
        return _answer_or_error(lesson, read(LessonQuestion, _json(body), shelf))

    def entered(_: Request, body: bytes) -> Response:
        return _answer_or_error(listed, read(EntryQuestion, _json(body), shelf))

    def filed(extension: str, _: Request, body: bytes) -> Response:
        question = read(ExportQuestion, _json(body), shelf)
        try:
            data, name = saved(question, extension)
        except VadError as error:
            return _reply({"error": question.problem(error)})
        headers = {"content-disposition": _attached(name)}
        return Response(data, media_type=MEDIA[extension], headers=headers)

    async def unknown(_: Request) -> Response:
        raise RefusalError(404, "there is no such format")

    one = [Middleware(OneAtATime, turn=asyncio.Lock())]
    routes = [
        Route("/", answered(page), methods=["GET"]),
        Route("/api/pose", answered(posed), methods=["POST"]),
        Route("/api/lesson", answered(taught), methods=["POST"]),
        Route("/api/entry", answered(entered), methods=["POST"]),
    ]
    for extension in MEDIA:
        path, given = f"/api/export/{extension}", partial(filed, extension)
        film = extension in FILMS
        endpoint = answered(given, files, FILM if film else FILE)
        routes += [Route(path, endpoint, methods=["POST"], middleware=one if film else None)]
    routes += [Route("/api/export/{extension}", unknown, methods=["POST"])]
    middleware = [
        Middleware(InPieces),
        Middleware(SecurityHeaders),
        Middleware(TrustedHostMiddleware, allowed_hosts=HOSTS, www_redirect=False),
        Middleware(Guard, key=key),
    ]
    return Starlette(routes=routes, middleware=middleware)


class OneAtATime:
    """Refuses a request while another one is answered; ``turn`` is the lock of those that are."""

    def __init__(self, app: ASGIApp, turn: asyncio.Lock) -> None:
        self._app = app
        self._turn = turn

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if self._turn.locked():
            busy = _busy(BusyError("another film is being made"), Headers(scope=scope))
            await busy(scope, receive, send)
        else:
            async with self._turn:
                await self._app(scope, receive, send)


def _answer_or_error(work: Callable[[Any], dict[str, Any]], question: Question) -> Response:
    """Return an answer, or the error if the user can do something about it."""
    try:
        return _reply(work(question))
    except VadError as error:
        return _reply({"error": question.problem(error)})


def _busy(error: BusyError, headers: Headers) -> Response:
    say = sayer(headers.get("accept-language", ""))
    answer = _reply({"error": problem(error, say=say)}, 503)
    answer.headers.update(_RETRY)
    return answer


def _attached(name: str) -> str:
    """Return what tells a browser to save a file under its name, which may have any letters."""
    plain = quote(name)
    return (
        f'attachment; filename="{name}"'
        if plain == name
        else f"attachment; filename*=UTF-8''{plain}"
    )


def _json(body: bytes) -> object:
    try:
        return json.loads(body)
    except (ValueError, RecursionError):
        raise RefusalError(400, "the question is not JSON") from None


def _reply(data: dict[str, Any], status: int = 200) -> Response:
    return Response(as_json(data), status, media_type="application/json")

"""What a connection may cost that is silent, slow or broken off.

Other users of the machine can open connections, too, and hold them.  So each step has a limit of
time: a request has to come, its body has to be complete, and the answer has to be read.
"""

from __future__ import annotations

import asyncio

from h11 import LocalProtocolError
from starlette.requests import ClientDisconnect, Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from uvicorn.protocols.http.h11_impl import H11Protocol

from vad.gui.guard import RefusalError

#: How long a connection may be silent, the rest of a question may be awaited, and a piece of an
#: answer may stay unread, in seconds.
SILENT, UNASKED, UNREAD = 10.0, 10.0, 20.0
#: The bytes of a piece of an answer.
_PIECE = 64 * 1024


class Connection(H11Protocol):
    """A connection that is cut where no request comes, or nobody reads the end of an answer."""

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin to look after it."""
        super().connection_made(transport)
        self._since = self.loop.time()
        self._look()

    def on_response_complete(self) -> None:
        """Begin to wait for the next request."""
        self._since = self.loop.time()
        super().on_response_complete()

    def connection_lost(self, exc: Exception | None) -> None:
        """Look after it no more."""
        self._next_look.cancel()
        super().connection_lost(exc)

    def _look(self) -> None:
        answering = self.cycle is not None and not self.cycle.response_complete
        silent = self.loop.time() - self._since >= SILENT
        if silent and (self.transport.is_closing() or not answering):
            self.transport.abort()
        self._next_look = self.loop.call_later(SILENT / 2, self._look)


class InPieces:
    """Sends long answers in pieces, and gives up where nobody reads them or can be answered."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""

        async def send_piece(message: Message) -> None:
            try:
                async with asyncio.timeout(UNREAD):
                    await send(message)
            except (TimeoutError, LocalProtocolError):  # or what came next is no request
                raise ClientDisconnect from None

        async def send_in_pieces(message: Message) -> None:
            body = message.get("body", b"")
            starts = range(0, len(body), _PIECE)
            for at in starts[:-1]:
                piece = body[at : at + _PIECE]
                await send_piece({**message, "body": piece, "more_body": True})
            await send_piece({**message, "body": body[starts[-1] :]} if starts else message)

        await self._app(scope, receive, send_in_pieces)


async def body_of(request: Request) -> bytes:
    """Return the body of a request.

    Raises
    ------
    vad.gui.guard.RefusalError
        If it takes too long.
    """
    try:
        async with asyncio.timeout(UNASKED):
            return await request.body()
    except TimeoutError:
        raise RefusalError(408, "the question takes too long") from None

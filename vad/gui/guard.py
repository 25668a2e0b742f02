"""Who may ask questions: only the page itself, opened by the person who reads the terminal.

The server is on 127.0.0.1, but so are other users of the machine, and every page of the web can
send requests there from this very browser.  What they send is refused here, before anything
reads it.
"""

from __future__ import annotations

import hmac
import secrets
import sys
import traceback
from collections.abc import Callable
from dataclasses import dataclass, field
from html import escape
from http.cookies import CookieError, SimpleCookie
from threading import Event

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import ClientDisconnect, Request
from starlette.responses import HTMLResponse, JSONResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from vad.gui.messages import LONGEST
from vad.gui.said import sayer

#: The names by which the server may be called.  A request under any other name is refused: somebody
#: may have made that name point at this machine.
HOSTS = ("127.0.0.1", "localhost")
_FOREIGN = ("cross-site", "same-site")
#: What answers a ticket: a page that goes on to the window.  A redirection would not do, because a
#: browser withholds a strict cookie where the redirection follows a file or another site.
_ON = '<!DOCTYPE html><meta http-equiv="refresh" content="0; url=/"><title>vad</title>'
_HEADERS = {
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-resource-policy": "same-origin",
    "cross-origin-opener-policy": "same-origin",
    "cache-control": "no-store",
}
_POLICY = (
    "default-src 'none'; script-src 'nonce-{nonce}'; style-src 'unsafe-inline'; font-src data:; "
    "img-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)


def _secret() -> str:
    return secrets.token_urlsafe(24)


def _same(secret: str, other: str | None) -> bool:
    """Tell whether texts are the same, in a time that does not depend on where they differ."""
    return other is not None and hmac.compare_digest(other.encode(), secret.encode())


class Ticket:
    """What opens the page once.

    Attributes
    ----------
    text
        The ticket.
    used
        Set when it has been used.
    on_use
        Called when it is used.
    """

    def __init__(self) -> None:
        self.text = _secret()
        self.used = Event()
        self.on_use: Callable[[], object] = lambda: None

    def take(self, other: str | None) -> bool:
        """Tell whether this is the ticket, used for the first time."""
        if self.used.is_set() or not _same(self.text, other):
            return False
        self.used.set()
        self.on_use()
        return True


@dataclass(frozen=True)
class PageKey:
    """What opens the page: a token in the printed address, or a ticket; then the token as a cookie.

    The token opens it as often as its owner likes.  The ticket is for the browser that the program
    starts itself.
    """

    port: int
    token: str = field(default_factory=_secret, repr=False)
    ticket: Ticket = field(default_factory=Ticket, repr=False, compare=False)

    @property
    def cookie(self) -> str:
        """The name of the cookie, with the port in it: a browser sends cookies to all ports."""
        return f"vad-{self.port}"

    @property
    def address(self) -> str:
        """What is printed."""
        return f"http://127.0.0.1:{self.port}/?token={self.token}"

    @property
    def address_with_ticket(self) -> str:
        """Where the browser is led that the program starts."""
        return f"http://127.0.0.1:{self.port}/?ticket={self.ticket.text}"

    def fits(self, other: str | None) -> bool:
        """Tell whether a token is this one."""
        return _same(self.token, other)


class RefusalError(Exception):
    """A request that is not answered, with its status and one sentence."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status

    def response(self, headers: Headers, page: bool = False) -> Response:
        """Return what is sent, in the language of the request; a browser may open a ``page``."""
        text = sayer(headers.get("accept-language", ""))(str(self))
        if page:
            said = f"<!DOCTYPE html><title>vad</title><p>vad gui: {escape(text)}.</p>"
            return HTMLResponse(said, self.status)
        error = {"message": text, "hint": None, "kind": "refused"}
        return JSONResponse({"error": error}, self.status)


class SecurityHeaders:
    """Adds security headers to every answer; a nonce marks the page's own scripts."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request; a fault is one sentence here, and more in the terminal."""
        nonce = scope.setdefault("state", {})["nonce"] = secrets.token_urlsafe(16)
        begun = False

        async def send_with_headers(message: Message) -> None:
            nonlocal begun
            if message["type"] == "http.response.start":
                begun = True
                headers = MutableHeaders(scope=message)
                headers.update(_HEADERS | {"content-security-policy": _POLICY.format(nonce=nonce)})
            await send(message)

        try:
            await self._app(scope, receive, send_with_headers)
        except ClientDisconnect:
            pass  # nobody is there who would read an answer
        except Exception as error:
            if not isinstance(error, RefusalError):
                traceback.print_exc(file=sys.stderr)
                error = RefusalError(500, "a fault of the program; the terminal shows where")
            if not begun:
                headers = Headers(scope=scope) if scope["type"] == "http" else Headers()
                page = scope.get("method") == "GET" and "text/html" in headers.get("accept", "")
                await error.response(headers, page)(scope, receive, send_with_headers)


class Guard:
    """Lets requests pass that come from the page, and refuses all others."""

    def __init__(self, app: ASGIApp, key: PageKey) -> None:
        self._app = app
        self._key = key

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request, or refuse it."""
        way_in = self._welcome(Request(scope)) if scope["type"] == "http" else None
        if way_in is not None:
            await way_in(scope, receive, send)
        else:
            await self._app(scope, _limited(receive), send)

    def _welcome(self, request: Request) -> Response | None:
        """Return what leads a request with token or ticket on, None for one with the cookie.

        Any other request is refused.
        """
        asks = request.query_params if request.method == "GET" else {}
        if self._key.ticket.take(asks.get("ticket")):  # from a file, and so from another site
            return self._with_cookie(HTMLResponse(_ON))
        _check_origin(request.headers)
        if self._key.fits(asks.get("token")):
            return self._with_cookie(RedirectResponse("/", 303))
        if not self._key.fits(_cookie(request.headers, self._key.cookie)):
            raise RefusalError(403, "open the address that vad gui has printed")
        if request.method == "POST":
            _check_body(request.headers)
        return None

    def _with_cookie(self, answer: Response) -> Response:
        name, token = self._key.cookie, self._key.token
        answer.set_cookie(name, token, path="/", httponly=True, samesite="strict")
        return answer


def _check_origin(headers: Headers) -> None:
    """Refuse what another page asks; one of the `HOSTS` is asked, on a port forwarded or not."""
    origin = headers.get("origin")
    if origin is not None and origin != f"http://{headers.get('host')}":
        raise RefusalError(403, "another site asks")
    if headers.get("sec-fetch-site") in _FOREIGN:
        raise RefusalError(403, "another site asks")


def _check_body(headers: Headers) -> None:
    """Refuse a body that is not JSON: without permission, a foreign page cannot send JSON."""
    if headers.get("content-type", "").partition(";")[0].strip().lower() != "application/json":
        raise RefusalError(400, "the question must be application/json")
    length = headers.get("content-length", "0")
    if not length.isdecimal() or int(length) > LONGEST:
        raise RefusalError(400, f"the question must have at most {LONGEST} bytes")


def _limited(receive: Receive) -> Receive:
    """Return a body that ends with a refusal where it is longer than it may be."""
    read = 0

    async def receive_part() -> Message:
        nonlocal read
        message = await receive()
        read += len(message.get("body", b""))
        if read > LONGEST:
            raise RefusalError(400, f"the question must have at most {LONGEST} bytes")
        return message

    return receive_part


def _cookie(headers: Headers, name: str) -> str | None:
    try:
        found = SimpleCookie(headers.get("cookie", "")).get(name)
    except CookieError:
        return None
    return found.value if found else None

"""Requests to the window's server that no browser sends: refused in one line, or answered.

A seed is what comes over a connection: one request or more, with strange targets, headers and
bodies, perhaps cut short.  Without token, ticket or cookie nothing is answered; a ticket is good
once.
"""

from __future__ import annotations

import http.client
import io
import json
import random
import socket
from contextlib import ExitStack, redirect_stderr
from dataclasses import dataclass
from functools import cache

from vad.cli.process import quieten
from vad.gui.guard import PageKey
from vad.gui.messages import ExportQuestion
from vad.gui.server import served

#: The most seconds that an answer may take, and in which one that need not come would have come.
LONGEST, AT_ONCE = 30.0, 0.3
#: Signs that stand for what only the server of this moment has.
TOKEN, TICKET, PORT = b"<token>", b"<ticket>", b"<port>"
METHODS = (b"GET", b"POST", b"HEAD", b"PUT", b"DELETE", b"OPTIONS", b"TRACE", b"get", b"\xff", b"")
TARGETS = (
    *(b"/", b"/", b"/?ticket=<ticket>", b"/?ticket=<ticket>", b"/?token=<token>", b"/?lang=de"),
    *(b"/?ticket=", b"/?ticket=x", b"/?ticket=%ED%A0%80", b"/?token=%00", b"/?token=%C3%A9", b"*"),
    *(b"/?lang=%00", b"/?lang=\xff", b"/?lang=../x", b"/?token=<token>&token=x", b"//x/", b"/%ff"),
    *(b"/?" + b"a=b&" * 2000, b"/" * 5000, b"http://x/", b"/api/pose", b"/api/lesson", b"x", b""),
    *(b"/api/export/svg", b"/api/export/exe", b"/api/export/%2e%2e/x", b"/?" + b"%" * 3000),
)
HEADERS = (
    *(b"Host: x", b"Host:", b"Host: localhost:<port>", b"Host: 127.0.0.1", b"Host: [::1]:<port>"),
    *(b"Host: \xff", b"Cookie: vad-<port>=<token>", b"Cookie: vad-<port>=", b"Cookie: \xff=\xfe"),
    *(b"Cookie: vad-<port>=<token>; vad-<port>=x", b'Cookie: vad-<port>="<token>"', b"Cookie: =;="),
    *(b"Cookie: " + b"a=b; " * 3000, b"Cookie: vad-<port>=\\377\xe9", b"Cookie: a b=c; [x]=y"),
    *(b"Origin: null", b"Origin: http://x", b"Origin: http://127.0.0.1:<port>", b"Origin: \xff"),
    *(b"Sec-Fetch-Site: cross-site", b"Sec-Fetch-Site: none", b"Sec-Fetch-Site: \xff", b": x"),
    *(b"Content-Type: application/json", b"Content-Type: text/plain", b"Content-Type: \xff/;"),
    *(b"Content-Type: application/json; charset=utf-7", b"Content-Encoding: gzip", b"X: \x00"),
    *(b"Content-Length: -1", b"Content-Length: 1", b"Content-Length: " + b"9" * 5000, b"no colon"),
    *(
        b"Content-Length: \xd9\xa3",
        b"Content-Length: 3, 3",
        b"Transfer-Encoding: chunked",
        b"x" * 9,
    ),
    *(b"Transfer-Encoding: gzip", b"Expect: 100-continue", b"Expect: x", b"Range: bytes=0-"),
    *(b"Connection: Upgrade\r\nUpgrade: websocket", b"Connection: close", b"Forwarded: for=x"),
    *(
        b"Upgrade: h2c",
        b"X-Forwarded-For: x",
        b" folded",
        b"X: " + b"y" * 100_000,
        b"X: y\r\n" * 300,
    ),
)
BODIES = (
    *(b"", b"{}", b"null", b"[" * 9000, b"9" * 5000, b"\xff", b'{"mechanism": "four-bar"}', b"x"),
    *(b'{"mechanism": "four-bar"' + b" " * 20_000 + b"}", b"0\r\n\r\n", b"5\r\n{}", b"z\r\n"),
)


@dataclass(frozen=True)
class Case:
    """What is sent, and whether it is a whole request, which has to be answered."""

    sent: bytes
    whole: bool


def case(seed: int) -> Case:
    """Return what comes over a connection."""
    dice = random.Random(seed)
    several = [_request(dice) for _ in range(dice.choice((1, 1, 1, 2)))]
    sent, whole = b"".join(each.sent for each in several), several[0].whole
    if dice.random() < 0.1:
        return Case(sent[: dice.randrange(1, len(sent))], False)
    if dice.random() < 0.1:
        at = dice.randrange(len(sent))
        return Case(sent[:at] + bytes([dice.randrange(256)]) + sent[at + 1 :], False)
    return Case(sent, whole)


def _request(dice: random.Random) -> Case:
    """Return a request, most often one in which little is wrong."""
    method = dice.choice(METHODS) if dice.random() < 0.3 else dice.choice((b"GET", b"POST"))
    target, body = dice.choice(TARGETS), dice.choice(BODIES) if method == b"POST" else b""
    headers = [b"Host: 127.0.0.1:<port>", b"Cookie: vad-<port>=<token>"]
    if method == b"POST":
        headers += [b"Content-Type: application/json", b"Content-Length: %d" % len(body)]
    for _ in range(dice.choice((0, 0, 1, 1, 2, 4))):
        at = dice.randrange(len(headers))
        headers[at : at + dice.randrange(2)] = dice.choice(([], [dice.choice(HEADERS)]))
        headers = headers or [dice.choice(HEADERS)]
    dice.shuffle(headers)
    version = dice.choice((b"HTTP/1.1",) * 8 + (b"HTTP/1.0", b"HTTP/2", b"HTTP/9.9", b"x"))
    head = b"\r\n".join([b" ".join([method, target, version]), *headers])
    strange = set(headers).intersection(HEADERS)
    return Case(head + b"\r\n\r\n" + body, len(headers) >= 2 and not strange)


#: Keeps the server until the process ends; what it prints.
_KEPT, _TERMINAL = ExitStack(), io.StringIO()


@cache
def key() -> PageKey:
    """Return what opens the server of this process."""
    quieten()  # as the command does
    _KEPT.enter_context(redirect_stderr(_TERMINAL))
    return _KEPT.enter_context(served(ExportQuestion("slider-crank")))


def fault(case: Case, _: int = 0) -> str | None:
    """Send what a case says; return what the answer breaks, or None."""
    mine = key()
    mine.ticket.used.clear()
    own = {TOKEN: mine.token, TICKET: mine.ticket.text, PORT: str(mine.port)}
    sent = case.sent
    for sign, text in own.items():
        sent = sent.replace(sign, text.encode())
    opens = mine.token.encode() in sent or mine.ticket.text.encode() in sent
    found = _answered(sent, opens, case.whole)
    if (
        found is None
        and b"?ticket=" + mine.ticket.text.encode() in sent
        and mine.ticket.used.is_set()
    ):
        again = b"GET /?ticket=%s HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n" % mine.ticket.text.encode()
        found = _answered(again, False, True)
    printed = _TERMINAL.getvalue()
    _TERMINAL.seek(0)
    _TERMINAL.truncate()
    if printed and found is None:
        found = f"prints {printed[-1500:]}"
    return found and f"{sent[:3000]!r}\n{found}"


def _answered(sent: bytes, opens: bool, whole: bool) -> str | None:
    """Return what is wrong with the first answer to what is sent."""
    with socket.create_connection(("127.0.0.1", key().port)) as line:
        line.settimeout(LONGEST if whole else AT_ONCE)
        answer = http.client.HTTPResponse(line, method=sent.partition(b" ")[0].decode("latin-1"))
        try:
            line.sendall(sent)
            answer.begin()
            said = answer.read()
        except TimeoutError:
            return "is not answered" if whole else None
        except (ConnectionError, http.client.HTTPException) as error:
            return f"ends with {error!r}" if whole else None
    if answer.status >= 500:
        return f"{answer.status}: {said[:300]!r}"
    if answer.status in (200, 303) and not opens:
        return f"opens without a key: {answer.status} {said[:100]!r}"
    if answer.getheader("content-type") == "application/json" and said and answer.status != 200:
        line_said = json.loads(said)["error"]["message"]
        if not line_said.isprintable() or len(line_said) > 520:
            return f"is no line: {line_said[:600]!r}"
    return None

"""The browser is started on the window, and no other user of the machine learns the key.

The command line of a process can be read by everybody, a file of mode 0600 cannot.  So the browser
is given a file, which leads it to the window with a ticket that is good once.  The file is removed
as soon as the ticket has been used.  On Windows a command line cannot be read by other users, and a
file may be opened by an editor: there the browser is given the address with the ticket.
"""

from __future__ import annotations

import os
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from html import escape
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING

from vad.export.files import temporary_folder

if TYPE_CHECKING:
    from vad.gui.guard import PageKey

#: A reason: there is none.
NO_BROWSER = "no browser can be started"
#: How many seconds a browser has to come before the user is told how else the window opens.
_SLOW = 30.0
#: Where programs are installed that see neither the folder of temporary files nor hidden folders.
_CONFINED = ("/snap", "/var/lib/snapd/snap")
_PAGE = """<!DOCTYPE html>
<meta charset="utf-8">
<meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0; url={address}">
<title>vad</title>
<a href="{address}">Open the window</a>
"""


@contextmanager
def visited(key: PageKey, missed: Callable[[str], None]) -> Iterator[None]:
    """Start the browser on the window, which is served while the block runs.

    It is started in a thread, because some browsers stay in the foreground until they are closed.

    Parameters
    ----------
    key
        What opens the window.
    missed
        Called with a reason, in that thread, if no browser comes.
    """
    with _led(key) as address:
        Thread(target=_visit, args=(key, address, missed), name="vad browser", daemon=True).start()
        yield


def _visit(key: PageKey, address: str, missed: Callable[[str], None]) -> None:
    if not webbrowser.open(address):
        missed(NO_BROWSER)
    elif not key.ticket.used.wait(_SLOW):
        missed(f"no browser has come within {_SLOW:g} s")


@contextmanager
def _led(key: PageKey) -> Iterator[str]:
    """Yield the address that the browser is given."""
    if os.name == "nt":
        yield key.address_with_ticket
        return
    with temporary_folder(_readable()) as folder:
        file = folder / "window.html"
        with open(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as stream:
            stream.write(_PAGE.format(address=escape(key.address_with_ticket)))
        key.ticket.on_use = partial(file.unlink, missing_ok=True)
        yield file.as_uri()


def _readable() -> Path | None:
    """Return the place of a folder that the browser can read; None for that of temporary files."""
    home = Path("~").expanduser()
    confined = any(map(os.path.isdir, _CONFINED))
    return home if confined and os.access(home, os.W_OK | os.X_OK) else None

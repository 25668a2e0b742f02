"""The browser is started on the window, and no other user of the machine learns the key.

The command line of a process can be read by everybody, a file of mode 0600 cannot.  So the browser
is given a file, which leads it to the window with a ticket that is good once.  The file is removed
as soon as the ticket has been used.  On Windows a command line cannot be read by other users, and a
file may be opened by an editor: there the browser is given the address with the ticket.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
import time
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from html import escape
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vad.gui.guard import PageKey

#: A reason: there is none.
NO_BROWSER = "no browser can be started"
#: How many seconds a browser has to come before the user is told how else the window opens.
_SLOW = 30.0
_PREFIX, _DAY = "vad-window-", 24 * 3600.0
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
    with _folder() as folder:
        file = folder / "window.html"
        with open(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as stream:
            stream.write(_PAGE.format(address=escape(key.address_with_ticket)))
        key.ticket.on_use = file.unlink
        yield file.as_uri()


@contextmanager
def _folder() -> Iterator[Path]:
    """Yield a new folder that its owner alone can read, and the browser of the owner."""
    home = Path("~").expanduser()
    confined = any(map(os.path.isdir, _CONFINED)) and os.access(home, os.W_OK)
    place = home if confined else Path(tempfile.gettempdir())
    _remove_leftovers(place)
    with tempfile.TemporaryDirectory(
        prefix=_PREFIX, dir=place, ignore_cleanup_errors=True
    ) as folder:
        yield Path(folder)


def _remove_leftovers(place: Path) -> None:
    """Remove folders of this kind that a killed process has left behind a day ago or earlier."""
    with contextlib.suppress(OSError):
        for folder in place.glob(f"{_PREFIX}*"):
            if folder.stat().st_mtime < time.time() - _DAY:
                shutil.rmtree(folder, ignore_errors=True)

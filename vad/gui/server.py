"""The server on this machine: in comes what the page opens on, out goes the address to open.

It takes 127.0.0.1 and nothing else, and there is no option that says otherwise.
"""

from __future__ import annotations

import contextlib
import socket
import time
from collections.abc import Iterator
from threading import Event, Thread

import uvicorn

from vad.errors import ExportError
from vad.gui.endpoints import application
from vad.gui.guard import Key
from vad.gui.messages import ExportQuestion

_HOST = "127.0.0.1"
_PATIENCE = 1  # seconds for what is being sent when the server ends


@contextlib.contextmanager
def served(start: ExportQuestion, port: int = 0) -> Iterator[str]:
    """Serve the page while the block runs, and yield its address once it answers.

    Parameters
    ----------
    start
        What is set when the page opens.
    port
        0 for any that is free.

    Raises
    ------
    vad.errors.ExportError
        If the port is not to be had.
    """
    with contextlib.closing(_listening(port)) as listener:
        key, closing = Key(listener.getsockname()[1]), Event()
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
            while not server.started and thread.is_alive():
                time.sleep(0.01)
            yield key.address
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

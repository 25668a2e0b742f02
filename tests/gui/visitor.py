"""A browser for tests of the key: it opens a file or an address, and keeps cookies.

Run as ``python -m tests.gui.visitor LOG ADDRESS`` it writes its command line, and how the file may
be read, before it opens it.
"""

from __future__ import annotations

import json
import os
import re
import sys
from html import unescape
from pathlib import Path
from urllib.parse import urljoin, urlsplit
from urllib.request import HTTPCookieProcessor, build_opener

_REFRESH = re.compile('http-equiv="refresh" content="0; url=([^"]+)"')


def visit(address: str) -> str:
    """Return the page to which an address leads."""
    opener = build_opener(HTTPCookieProcessor())
    for _ in range(4):
        text = opener.open(address, timeout=20).read().decode()
        on = _REFRESH.search(text)
        if not on:
            break
        address = urljoin(address, unescape(on[1]))
    return text


if __name__ == "__main__":
    log, address = sys.argv[1:]
    parts = urlsplit(address)
    file = Path(parts.path)
    seen = {"words": sys.argv, "leads": file.read_text()}
    seen["modes"] = [os.stat(each).st_mode & 0o777 for each in (file, file.parent)]
    seen["page"] = visit(address)
    seen["left"] = file.exists()
    Path(log).write_text(json.dumps(seen))

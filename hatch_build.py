"""The README as an index page shows it, where no file lies beside it.

Hatchling calls the hook when it makes a package.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

#: No project is at home there: an address with this host waits for the real one.
PLACEHOLDER = "//example.org"
_PICTURE = re.compile(r"!\[(?P<words>[^]]*)\]\((?P<path>[^)]+)\)")
_LINK = re.compile(r"(?<!!)\[(?P<words>[^]]*)\]\((?P<path>[^)]+)\)")


class Readme(MetadataHookInterface):
    """Sets the project's readme."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Add the readme to the project's metadata.

        Parameters
        ----------
        metadata
            The table ``project``; its url ``Repository`` is where pictures and files are found.
        """
        text = Path(self.root, "README.md").read_text("utf-8")
        address = metadata.get("urls", {}).get("Repository")
        if address is not None and PLACEHOLDER in address:
            address = None
        metadata["readme"] = {"content-type": "text/markdown", "text": on_its_own(text, address)}


def on_its_own(text: str, address: str | None) -> str:
    """Return a page whose relative links and pictures lead to a repository.

    Without an address a picture is left out and a link is its words: nothing is broken.

    Parameters
    ----------
    text
        A page in Markdown.
    address
        The repository's, with its files below ``raw/main`` and ``blob/main``.

    Examples
    --------
    >>> on_its_own("[How](README.md#how) ![it moves](film.gif)", "https://example.org/vad")
    '[How](https://example.org/vad/blob/main/README.md#how) ![it moves](https://example.org/vad/raw/main/film.gif)'
    >>> on_its_own("[How](README.md#how) it works", None)
    'How it works'
    """

    def whole(match: re.Match[str], below: str, instead: str) -> str:
        if "://" in match["path"] or match["path"].startswith("#"):
            return match[0]
        if address is None:
            return instead
        return match[0].replace(f"]({match['path']}", f"]({address}/{below}/main/{match['path']}")

    text = _PICTURE.sub(lambda match: whole(match, "raw", ""), text)
    text = _LINK.sub(lambda match: whole(match, "blob", match["words"]), text)
    return re.sub(r"\n{3,}", "\n\n", text)

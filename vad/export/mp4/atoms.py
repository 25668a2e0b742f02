"""The atoms (or boxes) of an MP4 file: in comes a file that is complete, one flag of it changes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import BinaryIO

_HEAD = 8  # bytes: length and kind
_LONG = 16  # of an atom whose length takes 64 bits
_TO_THE_END = 0
_FLAGS = 3  # where the last byte of the flags lies in an atom's content
_ENABLED = 1


def leave_off_last_track(stream: BinaryIO) -> None:
    """Let players show the last track when they are asked to, and not before."""
    film = next(place for kind, *place in _atoms(stream, 0, stream.seek(0, 2)) if kind == b"moov")
    tracks = [place for kind, *place in _atoms(stream, *film) if kind == b"trak"]
    header = next(place for kind, *place in _atoms(stream, *tracks[-1]) if kind == b"tkhd")
    stream.seek(header[0] + _FLAGS)
    flags = stream.read(1)[0]
    stream.seek(header[0] + _FLAGS)
    stream.write(bytes([flags & ~_ENABLED]))


def _atoms(stream: BinaryIO, start: int, end: int) -> Iterator[tuple[bytes, int, int]]:
    """Yield kind, start and end of the content of each atom between two places."""
    while start < end:
        stream.seek(start)
        head = stream.read(_LONG)
        length, content = int.from_bytes(head[:4], "big"), start + _HEAD
        if length == 1:
            length, content = int.from_bytes(head[8:], "big"), start + _LONG
        after = end if length == _TO_THE_END else start + length
        yield head[4:8], content, after
        start = after

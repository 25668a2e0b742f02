"""A PDF file as numbered objects: in come their contents, out go bytes and where each begins.

There are no dates and no random identifiers: the same objects give the same bytes.
"""

from __future__ import annotations

import zlib
from typing import BinaryIO


class Objects:
    """The objects of a file in the making, on a stream that need not be sought."""

    def __init__(self, target: BinaryIO) -> None:
        self._target = target
        self._length = 0
        self._offsets: dict[int, int] = {}
        self._count = 0
        self._put(b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n")

    def reserve(self) -> int:
        """Return the number of an object that is written later."""
        self._count += 1
        return self._count

    def write(self, content: str, number: int = 0) -> int:
        """Write an object and return its number, a new one unless it was reserved."""
        return self._write(content.encode("latin-1"), number)

    def stream(self, content: str, head: str = "") -> int:
        """Write a compressed stream, with what its dictionary says besides, as a new object."""
        data = zlib.compress(content.encode(), 9)
        head = f"<< {head} /Filter /FlateDecode /Length {len(data)} >>"
        return self._write(b"%b\nstream\n%b\nendstream" % (head.encode(), data))

    def close(self, catalog: int, info: int) -> None:
        """Write where every object begins."""
        start, count = self._length, self._count + 1
        rows = [b"%010d 00000 n \n" % self._offsets[number] for number in range(1, count)]
        self._put(b"xref\n0 %d\n0000000000 65535 f \n%b" % (count, b"".join(rows)))
        trailer = f"<< /Size {count} /Root {catalog} 0 R /Info {info} 0 R >>"
        self._put(f"trailer\n{trailer}\nstartxref\n{start}\n%%EOF\n".encode())

    def _write(self, content: bytes, number: int = 0) -> int:
        number = number or self.reserve()
        self._offsets[number] = self._length
        self._put(b"%d 0 obj\n%b\nendobj\n" % (number, content))
        return number

    def _put(self, data: bytes) -> None:
        self._target.write(data)
        self._length += len(data)

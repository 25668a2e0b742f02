"""As much of a PDF reader as the tests need: objects, streams, and the paths on a page."""

from __future__ import annotations

import re
import zlib

Point = tuple[float, float]


def objects(data: bytes) -> dict[int, bytes]:
    """Return the objects by number, found where the cross-reference table says."""
    start = int(data.rstrip().removesuffix(b"%%EOF").split(b"startxref")[-1])
    rows = data[start:].split(b"trailer")[0].splitlines()[3:]
    found = {}
    for number, row in enumerate(rows, 1):
        offset = int(row[:10])
        head = b"%d 0 obj\n" % number
        assert data[offset:].startswith(head)
        found[number] = data[offset + len(head) : data.index(b"\nendobj\n", offset)]
    return found


def stream(content: bytes) -> str:
    """Return what the stream of an object holds."""
    head, _, rest = content.partition(b"\nstream\n")
    length = int(re.search(rb"/Length (\d+)", head)[1])
    return zlib.decompress(rest[:length]).decode()


def pages(data: bytes) -> list[str]:
    """Return the operators of every page, with those of the forms in their places."""
    found = objects(data)

    def inlined(text: str) -> str:
        return re.sub(r"/F(\d+) Do", lambda form: inlined(stream(found[int(form[1])])), text)

    order = re.search(rb"/Kids \[(.*?)\]", found[2])[1]
    numbers = [int(number) for number in re.findall(rb"(\d+) 0 R", order)]
    contents = [int(re.search(rb"/Contents (\d+)", found[page])[1]) for page in numbers]
    return [inlined(stream(found[number])) for number in contents]


def media_box(data: bytes) -> tuple[float, ...]:
    """Return the box of the first page."""
    return tuple(map(float, re.search(rb"/MediaBox \[(.*?)\]", data)[1].split()))


def text(data: bytes, page: int = 0) -> str:
    """Return the text of a page, a line a setting, by the fonts' own tables."""
    tables = {}
    found = objects(data)
    for name, number in re.findall(rb"/(T\d+) (\d+) 0 R", found[3]):
        table = stream(found[int(re.search(rb"/ToUnicode (\d+)", found[int(number)])[1])])
        tables[name.decode()] = {
            int(code, 16): bytes.fromhex(letter).decode("utf-16-be")
            for code, letter in re.findall(r"^<(..)> <(\w+)>$", table, re.MULTILINE)
        }
    lines = []
    for block in re.findall(r"BT (.*?) ET", pages(data)[page]):
        line, font = "", ""
        for name, codes in re.findall(r"/(T\d+) |<(\w+)> Tj", block):
            font = name or font
            line += "".join(tables[font][code] for code in bytes.fromhex(codes))
        lines.append(line)
    return "\n".join(lines)


def centres(data: bytes, page: int = 0) -> list[complex]:
    """Return the middles of all circles on a page."""
    found = []
    number = r"-?[\d.]+"
    circle = rf"({number}) ({number}) m\n((?:(?:{number} ){{6}}c\n){{8}})"
    for match in re.finditer(circle, pages(data)[page]):
        ends = [complex(float(match[1]), float(match[2]))]
        for line in match[3].splitlines():
            values = list(map(float, line.split()[:6]))
            ends.append(complex(values[4], values[5]))
        found.append(sum(ends[:8]) / 8)
    return found

"""Scripts and style sheets as short as they can be sent: without comments, spaces and long names.

A page carries its script, so every page gets longer by it.  What is shortened is our own script:
each statement in it ends with a semicolon or a brace, and nothing in it is looked up by the name of
a variable.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import count, product
from string import ascii_letters

_TOKEN = re.compile(
    r"""(?P<pattern>(?<=[(=:,!&|?\[])\s*/(?!\*)(?:\\.|\[(?:\\.|[^\]\\])*\]|[^/\\\n\[])+/[a-z]*)
    |(?P<gap>(?:\s|//[^\n]*|/\*.*?\*/)+)
    |(?P<text>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
    |(?P<template>`(?:\\.|\$\{(?:[^{}`]|\{[^{}`]*\}|`(?:\\.|\$\{[^{}`]*\}|[^`\\])*`)*\}|[^`\\])*`)
    |(?P<name>[A-Za-z_$][\w$]*)
    |(?P<number>\d[\w.]*|\.\d\w*)
    |(?P<sign>=>|\?\?=|\?\?|\?\.(?!\d)|\.\.\.|.)""",
    re.VERBOSE | re.DOTALL,
)
_KEYWORDS = frozenset(
    re.findall(
        r"\w+",
        """async await break case catch class const continue default delete do else export extends
        false finally for from function get if import in instanceof let new null of return set
        static super switch this throw true try typeof undefined var void while yield""",
    )
)
#: What browsers give to scripts, as far as ours take it.
_GLOBALS = frozenset(
    re.findall(
        r"\w+",
        """AbortController Array Boolean CustomEvent DOMPoint Float64Array Infinity Int32Array JSON
        Map Math NaN Number
        Object Promise ResizeObserver Set String TextDecoder URLSearchParams Uint8Array
        addEventListener atob
        cancelAnimationFrame clearTimeout console document encodeURIComponent
        getComputedStyle getSelection history
        innerHeight innerWidth isNaN location matchMedia navigator parent performance
        requestAnimationFrame setTimeout vad
        window""",
    )
)
_GAP = re.compile(r"\$\{((?:[^{}`]|\{[^{}`]*\}|`(?:\\.|\$\{[^{}`]*\}|[^`\\])*`)*)\}")
_Token = tuple[str, str]


def shorter_style(text: str) -> str:
    """Return a style sheet without its comments and needless spaces.

    Examples
    --------
    >>> shorter_style("/* All. */ .a { top: 0;  left: 1px; }")
    '.a{top:0;left:1px}'
    """
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r"\s+", " ", text)
    text = re.sub(r" ?([{};,]) ?|(?<=:) (?=[^{]*[;}])", lambda found: found[1] or "", text)
    return text.replace(";}", "}").strip()


def shorter_script(text: str, kept: Iterable[str] = ()) -> str:
    r"""Return a script without its comments and needless spaces, with short names of variables.

    The names in ``kept`` stay.

    Examples
    --------
    >>> shorter_script("const wide = 3; // long\nfunction high(long) {\n  return wide * long;\n}")
    'const b=3;function c(a){return b*a}'
    """
    names = _renamed(text, kept)
    return _joined(_tokens(text), names)


def _tokens(text: str) -> Iterator[_Token]:
    """Yield the kind and the text of each part of a script."""
    for found in _TOKEN.finditer(text):
        yield found.lastgroup or "", found[0]


def _joined(tokens: Iterator[_Token], names: dict[str, str]) -> str:
    """Return parts of a script with short names and no more space between them than they need."""
    parts: list[str] = [";"]
    gap = ""
    for kind, text in tokens:
        if kind == "gap":
            gap = text
            continue
        last, own = parts[-1], text.strip() if kind == "pattern" else text
        if kind == "name" and not _is_member(last):
            own = names.get(own, own)
        elif kind == "template":
            own = _GAP.sub(lambda inner: f"${{{_joined(_tokens(inner[1]), names)}}}", own)
        if gap and _needs_gap(last[-1], own[0]):
            parts.append(" ")
        if own == "}" and parts[-1] == ";":
            parts.pop()
        parts.append(own)
        gap = ""
    return "".join(parts[1:])


def _needs_gap(last: str, first: str) -> bool:
    return (_is_word(last) and _is_word(first)) or (last == first and last in "+-")


def _is_word(sign: str) -> bool:
    return sign.isalnum() or sign in "_$"


def _is_member(last: str) -> bool:
    return last in (".", "?.")


def _renamed(text: str, kept: Iterable[str]) -> dict[str, str]:
    """Return a short name for each variable that is nowhere the name of a property, too."""
    tokens = [each for each in _flat(text) if each[0] != "gap"]
    taken, uses = {*_KEYWORDS, *kept}, Counter[str]()
    for number, (kind, name) in enumerate(tokens):
        if kind != "name":
            continue
        before = tokens[number - 1][1] if number else ""
        after = tokens[number + 1][1] if number + 1 < len(tokens) else ""
        uses[name] += 1
        if _is_member(before) or after == ":" or (before in ("{", ",") and after in (",", "}")):
            taken.add(name)
    declared = {name for name in uses if len(name) > 2} - taken - _GLOBALS
    others = (uses.keys() | taken) - declared
    short = (name for name in _short_names() if name not in others)
    wanted = sorted(declared, key=lambda name: (-uses[name], name))
    return dict(zip(wanted, short, strict=False))


def _flat(text: str) -> Iterator[_Token]:
    """Yield the parts of a script, and those within its templates."""
    for kind, part in _tokens(text):
        yield kind, part
        if kind == "template":
            for inner in _GAP.finditer(part):
                yield from _flat(inner[1])


def _short_names() -> Iterator[str]:
    for size in count(1):
        yield from map("".join, product(ascii_letters, repeat=size))

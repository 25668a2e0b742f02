"""Scripts and style sheets as short as they can be sent: without comments, spaces and long names.

A page carries its script, so every page gets longer by it.  What is shortened is our own script:
each statement in it ends with a semicolon or a brace, and nothing in it is looked up by the name of
a variable.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import count, product
from string import ascii_letters

_TOKEN = re.compile(
    r"""(?P<pattern>(?:(?<=[(=:,!&|?\[>])|(?<=return))\s*/(?!\*)(?:\\.|\[(?:\\.|[^\]\\])*\]|[^/\\\n\[])+/[a-z]*)
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
        """AbortController Array Boolean CustomEvent DOMPoint Error Float64Array Infinity
        Int32Array JSON Map Math MutationObserver NaN Number
        Object Promise ResizeObserver Set String TextDecoder URLSearchParams Uint16Array Uint8Array
        addEventListener cancelAnimationFrame clearTimeout console document encodeURIComponent
        getComputedStyle getSelection history
        innerHeight innerWidth isNaN location matchMedia navigator parent parseFloat performance
        requestAnimationFrame setTimeout vad
        window""",
    )
)
_OPENING, _CLOSING = frozenset("([{"), frozenset(")]}")
#: What stands before round brackets that hold no parameters, though braces follow.
_STATEMENTS = frozenset(("if", "for", "while", "switch"))
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

    Raises
    ------
    ValueError
        For a name that the script does not declare and that browsers are not known to give: it
        would be taken for a variable of the script, and renamed.

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
    taken, uses, free = {*_KEYWORDS, *kept}, Counter[str](), set[str]()
    for number, (kind, name) in enumerate(tokens):
        if kind != "name":
            continue
        before = tokens[number - 1][1] if number else ""
        after = tokens[number + 1][1] if number + 1 < len(tokens) else ""
        uses[name] += 1
        if _is_member(before) or after == ":" or (before in ("{", ",") and after in (",", "}")):
            taken.add(name)
        if not _is_member(before) and after != ":":
            free.add(name)
    unknown = free - _declared(tokens) - _KEYWORDS - _GLOBALS - {*kept}
    if unknown:
        raise ValueError(f"neither declared nor known of browsers: {', '.join(sorted(unknown))}")
    declared = {name for name in uses if len(name) > 2} - taken - _GLOBALS
    others = (uses.keys() | taken) - declared
    short = (name for name in _short_names() if name not in others)
    wanted = sorted(declared, key=lambda name: (-uses[name], name))
    return dict(zip(wanted, short, strict=False))


def _declared(tokens: Sequence[_Token]) -> set[str]:
    """Return all names that a script declares: of variables, functions and their parameters."""
    found, open_, texts = set[str](), list[int](), [text for _, text in tokens] + [""]
    for number, (kind, text) in enumerate(tokens):
        if text in _OPENING:
            open_.append(number)
        elif text in _CLOSING:
            begin = open_.pop()
            head = texts[begin - 1] if begin else ""
            if text == ")" and texts[number + 1] in ("{", "=>") and head not in _STATEMENTS:
                found |= {head, *texts[begin:number]}
        elif kind == "name" and texts[number + 1] == "=>":
            found.add(text)
        if text in ("const", "let"):
            found.update(_bound(texts, number + 1))
    return found


def _bound(texts: Sequence[str], begin: int) -> Iterator[str]:
    """Yield the names before each value of the declaration that begins with this part."""
    depth, named = 0, True
    for number in range(begin, len(texts)):
        text = texts[number]
        depth += (text in _OPENING) - (text in _CLOSING)
        if depth < 0 or (depth == 0 and text in (";", "of", "in")):
            return
        if depth == 0 and text in ("=", ","):
            named = text == ","
        if named:
            yield text


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

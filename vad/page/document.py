"""The page as one file: its parts in their places, style sheet, fonts, script and data inside.

The HTML loads nothing: its security policy forbids every request.
"""

from __future__ import annotations

import json
import lzma
import re
from base64 import b64encode
from collections.abc import Sequence
from functools import cache
from hashlib import sha256
from html import escape
from importlib.resources import files
from string import Template

from vad.lecture.followed import Followed
from vad.lecture.lesson import Lesson
from vad.page.parts import Parts, parts
from vad.page.shorter import shorter_script, shorter_style
from vad.page.solver import solver_script
from vad.page.themed import themes, variables
from vad.strokes.description import title
from vad.style import load_style
from vad.words import Language

#: The style of what is printed, if the page has it.
_PRINTED = "paper"
#: The signs of ``unpack.js``, and how many bits two of them hold.
_SIGNS = [sign for sign in map(chr, range(32, 127)) if sign not in "\"&'<"]
_BITS = 13
#: How ``unpack.js`` reads what is compressed: of all settings this takes the fewest bytes.
_LZMA = {"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "lc": 3, "lp": 0, "pb": 0}
#: What is seen only where scripts run: links that are highlighted for a while, and the player.
_LATE = (
    re.compile(r'(<g data-b="[^"]*">)((?:<g[ >](?:(?!</?g[ >]).)*</g>|(?!</?g[ >]).)*)(</g>)'),
    re.compile(r'(<div class="control"[^>]*>)(.*</dialog>\n)(</div>)', re.DOTALL),
)
# A page unpacks its script, its data and the rules for both, and only then is more than a sheet and
# a list.
_BEGIN = (
    "const packed=JSON.parse(unpack(document.getElementById('data').textContent)),"
    "[style,script]=['style','script'].map((name)=>document.createElement(name));"
    "style.textContent=packed[1];document.head.append(style);"
    "script.textContent=packed[0];document.body.append(script);"
)
_START = (
    "const root=document.querySelector('.vad'),data=packed[4];"
    # Who likes the dark is shown the board.
    "if(/\\bchalk\\b/.test(root.dataset.themes)&&"
    "matchMedia('(prefers-color-scheme: dark)').matches)root.dataset.theme='chalk';"
    "root.querySelectorAll('g[data-b]:empty,.control:empty').forEach((each,i)=>each.innerHTML=packed[3][i]);"
    "const svgs=root.querySelectorAll('.drawing > svg');"
    "packed[2].forEach((layer,i)=>svgs[i].insertAdjacentHTML('beforeend',layer));"
    "const player=mount(root,data);"
)
_PLAYED = ("flights.js", "sent.js", "stage.js", "player.js")
#: The scripts of a page that is turned, those first that others use.
_HAND = (
    "solver.js",
    "written.js",
    "labels.js",
    "scales.js",
    "picture.js",
    "reach.js",
    "hand.js",
    "dock.js",
    "rail.js",
    "curves.js",
    "rows.js",
    "described.js",
    "outside.js",
    "address.js",
)
_TURNED = (
    "const body=driven(root,solver(data.program),data.hand),dock=docked(root,body,player);"
    "curved(root,body,dock,railed(root,body,dock));hidden(root,body,dock);described(root,body,player);"
    "window.vad=outside(root,body,dock,player);body.show();addressed(root,body,dock,vad,player);"
    "if(data.turning)dock.run();"
)


@cache
def asset(name: str) -> str:
    """Return a file of the page, ``player.html``, ``.css`` or ``.js``."""
    text = (files(__package__) / name).read_text("utf-8")
    if name == "solver.js":
        text = solver_script(text)
    return shorter_style(text) if name.endswith(".css") else text


@cache
def script(turned: bool) -> str:
    """Return the script of a page, of one that is ``turned`` by hand or not."""
    text = "\n".join([scripts(turned), _START, _TURNED if turned else ""])
    return '"use strict";{' + shorter_script(text, ["packed"]) + "}"


def scripts(turned: bool) -> str:
    """Return the functions of a page's script."""
    names = (*_HAND, *_PLAYED) if turned else _PLAYED
    return "\n".join(map(asset, names)).replace("export ", "")


@cache
def beginning() -> str:
    """Return the script that unpacks the page's own."""
    return '"use strict";' + shorter_script(asset("unpack.js") + _BEGIN, ["packed"])


def packed(text: str) -> str:
    """Return a text as ``unpack.js`` reads it."""
    return signs(lzma.compress(text.encode(), lzma.FORMAT_RAW, filters=[_LZMA]))


def signs(data: bytes) -> str:
    """Return bytes as ``unpack.js`` reads them: 13 bits in two signs."""
    found: list[str] = []
    kept = many = 0
    for byte in (*data, 0, 0):  # so that the last bits are whole, too
        kept |= byte << many
        many += 8
        if many >= _BITS:
            high, low = divmod(kept % 2**_BITS, len(_SIGNS))
            found += _SIGNS[high], _SIGNS[low]
            kept >>= _BITS
            many -= _BITS
    return "".join(found)


def parted(text: str) -> tuple[str, list[str]]:
    """Return the parts of a page without what is seen only where scripts run, and that.

    The elements that hold it stay; what was in each of them is listed in their order.

    Examples
    --------
    >>> parted('<g data-s="1"><path/></g><g data-b="3 5"><g><use/></g></g>')
    ('<g data-s="1"><path/></g><g data-b="3 5"></g>', ['<g><use/></g>'])
    """
    late: list[str] = []

    def emptied(found: re.Match[str]) -> str:
        late.append(found[2])
        return found[1] + found[3]

    for pattern in _LATE:
        text = pattern.sub(emptied, text)
    return text, late


def document(
    lesson: Lesson,
    start: int = 0,
    *,
    sliders: bool = True,
    turning: bool = False,
    follow: Followed | None = None,
) -> str:
    """Return the page of a lesson.

    Parameters
    ----------
    lesson
        What is played.
    start
        How many strokes are done when it opens.
    sliders
        Whether the hand has sliders for rates and dimensions.
    turning
        Whether it opens with the mechanism running, with curves and hodographs.
    follow
        The point whose path and hodographs alone are shown; those of all points if None.
    """
    made = parts(lesson, follow=follow)
    data = {**made.data, "start": start, "turning": turning}
    layers: Sequence[str] = ()
    if made.hand:
        data |= {"hand": {**made.hand.data, "sliders": sliders}, "program": made.hand.program}
        layers = [made.hand.layers[panel.name] for panel in lesson.sheet.panels]
    run = beginning(), script(bool(made.hand))
    proofs = (b64encode(sha256(each.encode()).digest()).decode() for each in run)
    allowed = " ".join(f"'sha256-{proof}'" for proof in proofs)
    policy = (
        "default-src 'none'; style-src 'unsafe-inline'; font-src data:; "
        f"script-src {allowed}; base-uri 'none'; form-action 'none'"
    )
    seen, late = parted(section(lesson, made))
    looks, others = _used(made.looks, seen)
    bundle = packed(_json([run[1], others + asset("player.css"), layers, late, data]))
    return (
        f'<!DOCTYPE html>\n<html lang="{lesson.sheet.language}">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        '<meta name="viewport" content="width=device-width,initial-scale=1">\n'
        f"<title>{escape(title(lesson.sheet))}</title>\n"
        f"<style>\n{made.faces.rules()}{asset('page.css')}"
        f"{colours(lesson.style, len(lesson.sheet.rows))}{looks}"
        f"</style>\n</head>\n<body>\n{seen}"
        f'<script type="text/plain" id="data">{bundle}</script>\n'
        f"<script>{run[0]}</script>\n</body>\n</html>\n"
    )


def _used(looks: str, text: str) -> tuple[str, str]:
    """Return those of some rules whose classes a text has, and the others: one a line."""
    names = set(re.findall(r' class="(\w+)"', text))
    sides: tuple[list[str], list[str]] = [], []
    for rule in looks.splitlines():
        sides[rule[1 : rule.index("{")] not in names].append(rule)
    one, other = map("".join, sides)
    return one, other


def section(lesson: Lesson, made: Parts) -> str:
    """Return the parts of a lesson in their places, with its player."""
    names = " ".join(style.name for style in themes(load_style(lesson.style)))
    code, titles = lesson.sheet.language, [panel.title for panel in lesson.sheet.panels]
    strokes = Language(code).page("PLAYER")["strokes"]
    return (
        f'<main class="vad page" data-theme="{lesson.style}" data-themes="{names}">\n'
        f'<div class="board" style="{made.measures.variables}"><header>{made.head}</header>\n'
        f'<div class="panels">{made.panels}</div>\n'
        f'<div class="results">{made.table}</div>\n'
        f"{player(code, titles, made.chapters, len(lesson.steps), made.lines)}</div>\n"
        f'<aside class="rail"><section class="steps"><h2>{escape(strokes)}</h2>\n'
        f'<div class="lists">{made.steps}</div></section>'
        f'<div class="set"></div></aside>\n</main>\n'
    )


def player(
    code: str, titles: Sequence[str], chapters: str = "", count: int = 0, lines: int = 1
) -> str:
    """Return caption, scrubber and buttons in a language, for panels with these titles."""
    said = {**Language(code).page("HAND"), **Language(code).page("PLAYER")}
    return Template(asset("player.html")).substitute(
        {name.replace("-", "_"): escape(words) for name, words in said.items()},
        chapters=chapters,
        count=count,
        digits=" ".join(f"<kbd>{number}</kbd>" for number in range(1, len(titles) + 1)),
        titles=escape(" / ".join(titles)),
        lines=lines,
    )


def colours(name: str, rows: int) -> str:
    """Return the rules of the colours of a style and of its dark or light counterpart."""
    sides = sorted(themes(load_style(name)), key=lambda side: side.name != _PRINTED)
    return f".vad{{{variables(sides[0], rows)}}}\n" + "".join(
        f"@media screen{{.vad[data-theme={side.name}]{{{variables(side, rows)}}}}}\n"
        for side in sides[1:]
    )


def _json(data: object) -> str:
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"))

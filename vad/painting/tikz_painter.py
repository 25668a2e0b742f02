r"""TikZ: a picture for LaTeX, whose letters LaTeX sets, and whose styles are named by role.

The picture is one ``tikzpicture``.  A mark has a style of the name of its role and of its row of
the results, ``vad vector crank``; every stroke stands in a scope
``vad stroke={velocity:BC.line}``.  A document that has a style of such a name already keeps it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from vad.painting.latex import latex_of
from vad.plan.format import Format
from vad.plan.items import Item
from vad.plan.lettering.glyphs import width
from vad.plan.marks import Bow, Disc, Lettering, Mark, Polygon, Polyline
from vad.strokes.description import title
from vad.strokes.sheet import Sheet
from vad.style import Look, Pen

#: What cannot be in a name of TikZ.
_SIGN = re.compile(r"[^\w.:′″+-]")
#: Points of LaTeX to a page unit: labels have about 12 points, as on paper.
_UNIT = 288.0
#: Points of the letters that a node scales; no document needs letters of other sizes for it.
_TYPE = 10.0
#: How much wider than in the plan words may be, in page units.
_WIDER = 0.006
#: What the letters of LaTeX are set smaller: its usual ones are wider than those of the plan.
_SMALLER = 0.93
_HEAD = r"""% {title}
% In the preamble: \usepackage{{tikz}}.  In the text, as wide as a line:
%   \resizebox{{\linewidth}}{{!}}{{\input{{{name}}}}}
% Your own style before that takes the place of one below: \tikzset{{vad letter/.style={{red}}}}
\begingroup
\newcommand*{{\vadstyle}}[2]{{\pgfkeysifdefined{{/tikz/#1/.@cmd}}{{}}{{\tikzset{{#1/.style={{#2}}}}}}}}%
% Words of a style, at a scale or as small as their width wants, at a place:
\newcommand*{{\vadwords}}[5]{{%
  \setbox0=\hbox{{\pgfinterruptpicture\fontsize{{10}}{{12}}\selectfont#5\endpgfinterruptpicture}}%
  \pgfmathsetmacro{{\vadscale}}{{min(#2,#3/max(\wd0,1pt))}}%
  \node[vad text, #1, scale=\vadscale] at #4 {{#5}};}}%
\vadstyle{{vad stroke}}{{}}%
\vadstyle{{vad text}}{{anchor=base west, inner sep=0pt, font=\fontsize{{10}}{{12}}\selectfont}}%
"""


class TikzPainter:
    """A painter of one picture.

    Parameters
    ----------
    sheet
        What the picture shows, for its words and the names of its rows.
    name
        The name of the file, for the comment that says how to use it.

    Attributes
    ----------
    tikz
        The picture, once it is ended.
    """

    def __init__(self, sheet: Sheet, name: str = "sheet.tikz") -> None:
        self._sheet, self._name = sheet, name
        self._captions = {
            half.full(stroke.name): stroke.caption
            for half in sheet.halves
            for stroke in half.strokes
        }
        self._styles: dict[str, str] = {}
        self._colours: dict[str, None] = {}
        self._lines: list[str] = []
        self._said: set[str] = set()
        self._open = False
        self.tikz = ""

    def begin(self, form: Format, background: str) -> None:
        """Begin the picture with its ground."""
        corner = complex(form.width + form.edge, form.height + form.edge)
        self._style("vad page", f"fill={self._colour(background)}")
        self._lines.append(
            rf"\path[vad page] {_at(complex(-form.edge, -form.edge))} rectangle {_at(corner)};"
        )

    def group(self, item: Item) -> None:
        """Begin a scope for an item of a stroke, the first with its caption as a comment."""
        self._close()
        if not item.stroke:
            return
        self._open = True
        if item.stroke in self._captions and item.stroke not in self._said:
            self._said.add(item.stroke)
            self._lines.append(f"% {' '.join(self._captions[item.stroke].split())}")
        self._lines.append(rf"\begin{{scope}}[vad stroke={{{_name(item.stroke)}}}]")

    def paint(self, mark: Mark, look: Look) -> None:
        """Paint one mark."""
        style = self._named(mark, look)
        match mark.shape:
            case Lettering(runs, at, size):
                if words := latex_of(runs):
                    scale = _number(_SMALLER * size * _UNIT / _TYPE)
                    room = _number((width(runs, size) + _WIDER) * _UNIT)
                    self._lines.append(
                        rf"\vadwords{{{style}}}{{{scale}}}{{{room}}}{{{_at(at)}}}{{{words}}}"
                    )
            case Polyline(pieces):
                self._path(style, (_straight(piece) for piece in pieces))
            case Polygon(rings):
                self._path(style, (f"{_straight(ring)} -- cycle" for ring in rings))
            case Disc(centre, radius):
                self._path(style, [f"{_at(centre)} circle[radius={_length(radius)}]"])
            case Bow():
                self._path(style, [_bent(mark.shape.curve())])

    def end(self) -> None:
        """End the picture."""
        self._close()
        colours = "".join(
            rf"\definecolor{{vad{colour}}}{{HTML}}{{{colour}}}%" + "\n" for colour in self._colours
        )
        styles = "".join(
            rf"\vadstyle{{{name}}}{{{look}}}%" + "\n" for name, look in self._styles.items()
        )
        words = title(self._sheet).replace("\n", " ")
        self.tikz = (
            _HEAD.format(title=words, name=self._name)
            + colours
            + styles
            + "\\begin{tikzpicture}[x=1pt, y=1pt, miter limit=10]\n"
            + "\n".join(self._lines)
            + "\n\\end{tikzpicture}%\n\\endgroup\n"
        )

    def _path(self, style: str, parts: Iterable[str]) -> None:
        if drawn := "  ".join(part for part in parts if part):
            self._lines.append(rf"\path[{style}] {drawn};")

    def _named(self, mark: Mark, look: Look) -> str:
        """Return the style of a mark, and what it has otherwise than its usual look."""
        row = None if mark.row is None else self._sheet.rows[mark.row % len(self._sheet.rows)].key
        name = f"vad {mark.role}" + (f" {_name(row)}" if row else "")
        own = ", ".join(self._keys(look, isinstance(mark.shape, Lettering)))
        usual = self._style(name, own)
        return name if own == usual else f"{name}, {own}"

    def _style(self, name: str, look: str) -> str:
        """Return the look of a style, which is that of the first mark that has it."""
        return self._styles.setdefault(name, look)

    def _keys(self, look: Look, letters: bool) -> Iterable[str]:
        if letters:
            yield f"text={self._colour(look.fill or '#000000')}"
        else:
            if look.under:
                yield f"preaction={{{', '.join(self._line(look.under))}}}"
            if look.fill:
                yield f"fill={self._colour(look.fill)}"
            if look.pen:
                yield from self._line(look.pen)
        if look.alpha != 1.0:
            yield f"opacity={_number(look.alpha)}"

    def _line(self, pen: Pen) -> Iterable[str]:
        yield f"draw={self._colour(pen.colour)}"
        yield f"line width={_length(pen.width)}"
        if pen.dash:
            signs = ("on", "off")
            parts = (f"{signs[n % 2]} {_length(part)}" for n, part in enumerate(pen.dash))
            yield f"dash pattern={' '.join(parts)}"
        if pen.cap != "butt":
            yield f"line cap={pen.cap}"
        if pen.join != "miter":
            yield f"line join={pen.join}"

    def _colour(self, colour: str) -> str:
        self._colours.setdefault(colour.lstrip("#").upper())
        return f"vad{colour.lstrip('#').upper()}"

    def _close(self) -> None:
        if self._open:
            self._lines.append(r"\end{scope}")
        self._open = False


def _name(text: str) -> str:
    """Return a name without signs that mean something to LaTeX: a sheet may come from anywhere."""
    return _SIGN.sub("-", text)


def _number(value: float) -> str:
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _length(value: float) -> str:
    return f"{_number(value * _UNIT)}pt"


def _at(place: complex) -> str:
    return f"({_number(place.real * _UNIT)},{_number(place.imag * _UNIT)})"


def _straight(points: Iterable[complex]) -> str:
    return " -- ".join(map(_at, points))


def _bent(points: list[complex]) -> str:
    """Return Bézier curves: a point, and then two handles and a point for each."""
    first, *others = map(_at, points)
    triples = zip(others[::3], others[1::3], others[2::3], strict=True)
    return first + "".join(f" .. controls {a} and {b} .. {end}" for a, b, end in triples)

"""The window as a page: HTML with all that it needs, for the settings with which it opens.

The boxes and sliders are made from the mechanisms' own fields.
"""

from __future__ import annotations

import dataclasses
import json
import math
import string
from collections.abc import Mapping, Sequence
from functools import cache
from html import escape
from importlib.resources import files
from string import Template
from typing import Any

from vad.errors import one_of
from vad.files.loading import WrittenMechanism
from vad.files.sheet_file import sheet_in, sheet_of
from vad.gui.answers import MEDIA
from vad.gui.messages import LONGEST, EntryQuestion, ExportQuestion
from vad.gui.shelf import Shelf
from vad.kinematics.reach import closing_range
from vad.mechanisms import Mechanism
from vad.mechanisms.mechanism import NUMBERS
from vad.page.document import asset, colours, scripts
from vad.page.themed import themes
from vad.painting.svg_text import FACES, Faces
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import chosen
from vad.strokes.parameter_names import is_borne, parameter_name
from vad.style import load_style
from vad.units import scene_unit
from vad.words import Language, all_languages
from vad.written import LOW

#: The parts of its script, in order.
SCRIPTS = ("window.js", "settings.js", "standing.js", "asking.js", "buttons.js")
#: What makes the player of a page, with the mechanism in the hand.
_PLAYING = """return (root, data) => {
  const player = mount(root, data, { address: false });
  const body = driven(root, solver(data.program), data.hand), dock = docked(root, body, player);
  curved(root, body, dock, railed(root, body, dock));
  hidden(root, body, dock);
  described(root, body, player);
  return { player, body, dock, outside: outside(root, body, dock, player) };
};"""
#: The letters that the words about any mechanism may need.
_LETTERS = string.digits + string.ascii_letters + string.punctuation + " \u00a0"
_SIGNS = "ÄÖÜäöüßÀÉàâçéèêëîïôùûœ’«»−×·°′″⟂∥²³→…–₀₁₂₃₄₅₆₇₈₉αβγδθλμπρφψωΔΩ"
_TURN, _HALF = (0.0, 360.0), (-180.0, 180.0)
_LONGEST, _SHORTEST = 3.0, 0.05  # of a default length, at the ends of its slider
_FASTEST = 3.0  # of a default rate
_STEPS = 50  # of a default, at most


def window(start: ExportQuestion, nonce: str, head: str = "") -> str:
    """Return the page of the window; a browser runs its script only with this ``nonce``.

    ``head`` is further HTML for the head of the page.

    Raises
    ------
    vad.errors.UsageError
        For an unknown language, style or panel.
    """
    code, say = start.language, Language(start.language)
    texts = say.page("WINDOW")
    inks = len(load_style(start.style).inks)
    opening = {name: value for name, value in vars(start).items() if name != "kinds"}
    opening["burden"] = vars(start.burden)
    shelf = Shelf(start.kinds)
    entries = {name: entry(kind, code) for name, kind in shelf.own.items()}
    words = {**texts, "point": say.point}
    usual = [name for name, diagram in DIAGRAMS.items() if diagram.usual]
    data: dict[str, Any] = {"start": opening, "catalogue": entries, "usual": usual, "words": words}
    data["longest"] = LONGEST
    chosen(start.panels or None)
    return Template(_file("window.html")).substitute(
        {name: escape(text) for name, text in texts.items()},
        lang=code,
        nonce=nonce,
        head=head,
        style=start.style,
        themes=" ".join(style.name for style in themes(load_style(start.style))),
        rules=_faces()
        + asset("page.css")
        + asset("player.css")
        + _file("window.css")
        + colours(start.style, inks),
        mechanisms=_options({name: each["title"] for name, each in entries.items()}),
        shelf=_options(shelf.titles(code)),
        languages=_options({each: each.upper() for each in all_languages()}),
        formats="".join(_button(kind, texts.get(kind, kind.upper())) for kind in MEDIA),
        data=json.dumps(data, ensure_ascii=False).replace("<", "\\u003c"),
        script=f"const playing=(()=>{{{scripts(True)}\n{_PLAYING}}})();\n"
        + "".join(map(_file, SCRIPTS)),
    )


def _options(names: Mapping[str, str]) -> str:
    return "".join(
        f'<option value="{escape(name)}">{escape(text)}</option>' for name, text in names.items()
    )


def _button(kind: str, name: str) -> str:
    return f'<button type="button" data-save="{kind}">{escape(name)}</button>'


@cache
def _faces() -> str:
    """Return the rules of the fonts."""
    faces = Faces()
    for face in FACES:
        faces.add(face, _LETTERS + _SIGNS)
    return faces.rules()


def _file(name: str) -> str:
    return (files(__package__) / name).read_text("utf-8")


def listed(question: EntryQuestion) -> dict[str, Any]:
    """Return the name of a mechanism, and what can be set of it: its ``entry``.

    Of a file of a sheet there are its numbers, too, ``given``; see `vad.files.sheet_file.sheet_of`.

    Raises
    ------
    vad.errors.VadError
        For a mechanism that there is not, and for a file that describes none.
    """
    name, given = question.mechanism, dict[str, Any]()
    if question.text is not None and isinstance(question.kinds, Shelf):
        sheet = sheet_in(question.text, name)
        if sheet:
            name, given = sheet_of(sheet, question.kinds)
        else:
            question.kinds.open(name, question.text)
    name = one_of("mechanism", name, question.kinds)
    found = {"mechanism": name, "entry": entry(question.kinds[name], question.language)}
    return {**found, "given": given} if given else found


def entry(kind: type[Mechanism], language: str) -> dict[str, Any]:
    """Return what can be set of one mechanism.

    Returns
    -------
    dict
        ``title``; ``name`` of its files; ``unit`` of lengths;
        ``parameters`` and ``inputs`` with name, label, unit, default (null where there is none),
        the ends of the slider and its step;
        ``assemblies``, for each point that is placed (or for "", where there is one choice for the
        mechanism) its label and the choices, each with name and label, the first of them the
        default.
    """
    say, known = (
        Language(language, kind.own_names),
        {each.name: each for each in dataclasses.fields(kind)},
    )
    unit = str(known["length_unit"].default)
    numbers = [each for each in known.values() if each.metadata["quantity"] in NUMBERS]
    lengths: list[Any] = [e.default for e in numbers if e.metadata["quantity"] == "length"]
    longest = max((abs(float(each)) for each in lengths if each), default=1.0)
    texts = Language(language).page("WINDOW")
    return {
        "title": say.name(kind.title),
        "name": kind.name,
        "unit": unit,
        "parameters": [
            _box(
                each.name,
                parameter_name(kind, each.name, say),
                each.metadata["quantity"],
                unit,
                each.default,
            )
            | _slider(kind, each, longest)
            for each in numbers
        ],
        "inputs": [
            _box(name, texts[name], name, unit, value) | _travel(kind, name)
            for name, value in kind.inputs.items()
        ],
        "assemblies": [
            [point, point.translate(LOW), [[name, texts.get(name, name)] for name in names]]
            for point, names in _choices(kind).items()
        ],
    }


def _choices(kind: type[Mechanism]) -> Mapping[str, Sequence[str]]:
    """Return the ways of assembly by point; "" where they are those of the whole mechanism."""
    if issubclass(kind, WrittenMechanism):
        return kind.written.words
    field = next(each for each in dataclasses.fields(kind) if each.name == "assembly")
    return {"": field.metadata["choices"]}


def _box(name: str, label: str, quantity: str, unit: str, default: Any) -> dict[str, Any]:
    written = scene_unit(quantity, unit).replace("deg", "°").replace("^2", "²")
    return {"name": name, "label": label, "unit": written, "default": default}


def _slider(
    kind: type[Mechanism], field: dataclasses.Field[Any], longest: float
) -> dict[str, float]:
    """Return the ends of a parameter's slider, and its step."""
    if field.metadata["quantity"] in ("angle", "direction"):
        return _ends(*_HALF, 1.0)
    default: Any = field.default
    if is_borne(kind, field.name):
        usual = 2.0 * abs(default or 1.0)
        lowest = -usual if field.metadata["quantity"] in ("force", "couple") else 0.0
        return _ends(lowest, usual, _step(usual))
    usual = abs(default or longest)
    if field.metadata["signed"]:
        return _ends(-longest, longest, _step(longest))
    step = _step(usual)
    lowest = max(step, step * round(_SHORTEST * usual / step))
    return _ends(lowest, _LONGEST * usual, step)


def _travel(kind: type[Mechanism], name: str) -> dict[str, float]:
    """Return the ends of an input's slider, and its step."""
    place, speed, *_ = kind.inputs
    if name == "angle":
        return _ends(*_TURN, 1.0)
    if name == place:
        ranges = closing_range(kind())
        low, high = min(low for low, _ in ranges), max(high for _, high in ranges)
        return _ends(low, high, _step(max(-low, high)) / 10.0)
    usual = abs(kind.inputs[name]) or (kind.inputs[speed] ** 2 if name != speed else 0.0) or 1.0
    return _ends(-_FASTEST * usual, _FASTEST * usual, _step(usual))


def _ends(low: float, high: float, step: float) -> dict[str, float]:
    return {"low": low, "high": high, "step": step}


def _step(usual: float) -> float:
    """Return the step of a slider: a power of ten, so that a usual value has some tens of steps.

    Examples
    --------
    >>> _step(60.0), _step(0.7)
    (1.0, 0.01)
    """
    return 10.0 ** math.floor(math.log10(usual / _STEPS))

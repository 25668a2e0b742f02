"""The answer of a lesson about a shaft, an engine or a locomotive, in words.

It is told from the sheet alone: "X with 353.0 kg at 213.4° balances the shaft", "Over a turn the
secondary force reaches 836.0 N at 45°, 135°, 225°, 315°."
"""

from __future__ import annotations

from collections.abc import Iterator

from vad.strokes.arithmetic import Figure
from vad.strokes.sentences import Listed, Sentence, SentencePart, Unit, Voice
from vad.strokes.sheet import BELOW, Sheet, Stroke
from vad.words import Language

#: What each panel of inertia forces measures, by its phrase.
_WHATS = {
    "primary": "answer primary force",
    "primary" + BELOW: "answer primary couple",
    "secondary": "answer secondary force",
    "secondary" + BELOW: "answer secondary couple",
    "traction": "answer tractive force",
    "traction" + BELOW: "answer swaying couple",
}


def answer_of_balancing(sheet: Sheet) -> Sentence | None:
    """Return what was found: masses with their angles, or largest forces and where they are.

    None for another sheet, and for one on which nothing was to be found.
    """
    voice, between = (
        Voice(sheet.language, sheet.notation, sheet.names),
        Language(sheet.language).say("answer next"),
    )
    largest = tuple(_largest(sheet, voice))
    if largest:
        return Sentence("answer over a turn", {"results": Listed(largest, between)}, voice=voice)
    masses = tuple(_masses(sheet, voice))
    if masses:
        return Sentence("answer balances", {"masses": Listed(masses, between)}, voice=voice)
    return None


def _masses(sheet: Sheet, voice: Voice) -> Iterator[SentencePart]:
    """Yield each mass of which anything was to be found, with its size and its angle."""
    for row in sheet.rows:
        cells = row.cells.get("shaft", ())
        products = row.cells.get("force", ())
        if len(cells) != 2 or all(cell.given for cell in (*cells, *products)):
            continue
        mass, angle = cells
        loose = not (mass.given and products) or all(cell.given for cell in products)
        size, symbol = (mass, "m") if loose else (products[0], "m·r")
        parts: dict[str, SentencePart] = {
            "letter": row.letters or row.key,
            "symbol": symbol,
            "size": Figure(size.value, size.unit, size.given),
            "unit": Unit(size.unit),
            "angle": Figure(angle.value, angle.unit, angle.given),
        }
        yield Sentence("answer mass", parts, voice=voice)


def _largest(sheet: Sheet, voice: Voice) -> Iterator[SentencePart]:
    """Yield the largest force or couple over a turn of each panel, and where it is.

    What is balanced is said only where nothing else is to be said.
    """
    told: list[tuple[str, dict[str, SentencePart]]] = []
    for half in sheet.halves:
        if half.name in _WHATS:
            parts = next((each for each in map(_parts, half.strokes) if "largest" in each), {})
            if parts or any(stroke.kind == "known" for stroke in half.strokes):
                told.append((_WHATS[half.name], parts))
        if half.name == "hammer":
            blows = [each for each in map(_parts, half.strokes) if "pressing" in each]
            worst = max(blows, key=lambda each: _size(each["largest"]), default=None)
            if worst:
                more = {"where": worst["pressing"], "unit": Unit(half.unit)}
                told.append(("answer hammer blow", {**worst, **more}))
    shakes = [each for each in told if _size(each[1].get("largest"))]
    for what, parts in shakes or told:
        where = parts.get("where")
        phrase = "answer reaches" if _size(parts.get("largest")) else "answer balanced"
        if phrase == "answer reaches" and (where is None or where == Listed((), "°, ")):
            phrase = "answer steadily"
        yield Sentence(phrase, {**parts, "what": Sentence(what, parts, voice=voice)}, voice=voice)


def _size(figure: SentencePart | None) -> float:
    """Return the size of a number in a sentence; 0 where there is none."""
    return abs(figure.value) if isinstance(figure, Figure) else 0.0


def _parts(stroke: Stroke) -> dict[str, SentencePart]:
    """Return the parts of what is said of a stroke; none of a caption of the lecturer's own."""
    return dict(stroke.said.parts) if isinstance(stroke.said, Sentence) else {}

"""Type: what is italic, how wide it is, where lines break."""

from __future__ import annotations

from dataclasses import replace
from threading import Thread

import pytest

import vad
from vad.files.examples import example_path
from vad.lecture.telling import told, told_together
from vad.painting.shapes import outline
from vad.plan.board import arrange
from vad.plan.format import screen
from vad.plan.lettering.glyphs import _font, fitted, typeset, width
from vad.plan.lettering.runs import Run, roman, said, symbols
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Lettering
from vad.plan.page.changing import caption_marks, count_mark
from vad.strokes.arithmetic import Figure
from vad.strokes.sentences import Sentence, Unit, Voice
from vad.words import TextPiece, languages, text_of
from vad.written import THIN_SPACE


def italics(runs: tuple[Run, ...]) -> str:
    return " ".join(run.text for run in runs if run.face == "italic")


def test_points_are_italic_words_digits_and_primes_upright():
    assert italics(symbols("b′cₙ")) == "b c n"
    assert italics(symbols("⟂ BC")) == "BC"
    assert italics(symbols("∥ guide")) == ""
    assert italics(roman("2.308 rad/s")) == ""
    assert italics(roman("ω = 10")) == "ω"


def test_subscripts_and_superscripts_become_scripts():
    runs = symbols("b′ₙ")
    assert runs[-1] == Run("n", "italic", -1)
    assert Run("2", "roman", 1) in roman("mm/s²")


def test_a_caption_tells_points_from_words_by_what_they_are():
    """The article "a" is no point, "de" between words no vector, and seconds are no point s."""
    zero = Sentence("zero", {"point": "a", "symbol": "v"})
    assert italics(said(zero.pieces)) == "a v"
    parts = {"label": "at", "value": Figure(3.0), "unit": Unit("m/s"), "whose": "T"}
    assert italics(said(Sentence("whole", parts).pieces)) == "at T"
    parts |= {"label": "de", "whose": Sentence("velocity of", {"head": "E"})}
    french = Voice("fr").pieces(Sentence("whole", parts))
    assert text_of(french) == "de = 3.000 m/s, la vitesse de E."
    assert italics(said(french)) == "de E"


@pytest.mark.parametrize("code", languages())
def test_fixed_text_says_itself_what_is_a_symbol(code: str):
    angles = {name: Figure(3.0, "°") for name in ("tau", "delta", "ib", "ic")}
    cut = said(Voice(code).pieces(Sentence("spatial directions", angles)))
    assert set(italics(cut).split()) >= {"OA", "OD", "AOD", "BOC", "OI", "δ", "τ", "IB", "IC"}
    rates = {"turn": "2", "sum": "6", "value": "6", "unit": Unit("mm/s²"), "label": "y"}
    rates |= {"rising": Figure(1.0), "pace": Unit("mm/s")}
    about = said(Voice(code).pieces(Sentence("spatial about I acceleration", rates)))
    assert italics(about) == "y α t AH ω h OI AH h τ"


def test_a_caption_keeps_off_its_number():
    sheet = vad.draw(vad.solve(vad.load(example_path("leg-from-coordinates"))()))
    panel = sheet.panels[2]
    page, _ = arrange(replace(sheet, panels=(panel,)), screen((1280, 720)), 2)
    most = len(panel.strokes)
    for first, last in told_together(panel):
        number = count_mark(first + 1, last + 1, most, page).shape
        for marks, _ in caption_marks((told(panel, first, last),), most, page):
            words = marks[0].shape
            assert words.at.real + width(words.runs, words.size) < number.at.real - 0.015


def test_a_caption_names_every_vector_of_an_image():
    sheet = vad.draw(vad.solve(vad.load(example_path("leg-from-coordinates"))()))
    names = " ".join(italics(said(s.said.pieces)) for p in sheet.panels for s in p.strokes)
    assert {"fh", "fg", "ce"} <= set(names.split())


def test_thousands_are_parted_by_less_than_a_letter():
    parted, plain = (typeset(roman(text)).advance for text in (f"12{THIN_SPACE}345", "12345"))
    space = typeset(roman("12 345")).advance - plain
    assert 0 < parted - plain < space


def test_ink_box_bounds_the_marks():
    runs = symbols("C")
    shape = typeset(runs)
    vertices, _ = outline(Lettering(runs, 100 + 50j, 40.0))
    assert vertices[:, 0].min() == 100 + 40 * shape.left
    assert vertices[:, 1].max() == 50 + 40 * shape.top


def test_missing_letters_do_not_stop_the_painter():
    assert typeset(symbols("ä ″ 漢")).advance > 0


def test_lines_break_between_words_within_their_room():
    text = "Through the pole, parallel to the guide: the slider can move no other way"
    lines = wrap((TextPiece(text),), 28.0, 500.0)
    assert len(lines) == 2
    assert all(width(line, 28.0) <= 500.0 for line in lines)
    assert "".join(r.text for r in lines[0]) + " " + "".join(r.text for r in lines[1]) == text


def test_a_number_stays_with_its_unit():
    text = "ab = 0.3333 ft/s, so ω₃ = 1.2×10⁻⁷ rad/s, at 5 mm"
    for room in range(60, 700, 7):
        lines = ["".join(r.text for r in line) for line in wrap((TextPiece(text),), 28.0, room)]
        assert not any(line.startswith(("ft", "rad", "mm")) for line in lines)


def test_lines_are_as_few_as_fit():
    text = "sb = 0.3281 ft/s, so ω = sb/DB = 0.3281/3.8 = 0.08633 rad/s, clockwise: B from D."
    for room in range(560, 1000, 10):
        lines = wrap((TextPiece(text),), 28.0, room)
        assert len(lines) <= 2
        assert all(width(line, 28.0) <= room + 1.0 for line in lines)


def test_lines_break_at_a_colon_or_comma_and_never_in_an_equation():
    text = "ce = 153.3 mm/s, so ω = ce/CE = 153.3/300 = 0.5109 rad/s, clockwise: E moves down."
    for room in range(700, 900, 10):
        lines = ["".join(r.text for r in line) for line in wrap((TextPiece(text),), 28.0, room)]
        assert len(lines) == 2
        assert lines[0][-1] in ",:"


def test_lines_break_between_sentences_if_they_can():
    text = (
        "⟂ DC through d′: its length is not known, so c′ lies on it. c′ is where both lines cross."
    )
    for room in range(750, 950, 10):
        lines = ["".join(r.text for r in line) for line in wrap((TextPiece(text),), 28.0, room)]
        assert len(lines) == 2
        assert lines[1] == "c′ is where both lines cross."


def test_an_equation_longer_than_a_line_breaks_before_a_sign():
    text = "ω = ce/CE = 153.3/300 = 0.5109 rad/s"
    lines = ["".join(r.text for r in line) for line in wrap((TextPiece(text),), 28.0, 300.0)]
    assert len(lines) == 2
    assert lines[1][0] == "="


def test_two_lines_of_an_equation_part_at_its_equality():
    text = (
        "p′ by the acceleration image of the coupler: b′p′ = b′c′·BP/BC = 3389.2 × 20/40 = "
        "1695 mm/s²; a′p′ = 1386 mm/s², the acceleration of P."
    )
    for room in range(850, 1120, 10):
        lines = ["".join(r.text for r in line) for line in wrap((TextPiece(text),), 28.0, room)]
        assert len(lines) == 2
        assert not lines[1].startswith("×")


def test_shrinking_to_fit_stops_at_the_least_size():
    runs = roman("crank and slotted lever")
    assert fitted(runs, 40.0, 30.0, 1e6) == 40.0
    assert fitted(runs, 40.0, 30.0, 1.0) == 30.0


def test_a_letter_keeps_its_outline_while_another_thread_sets_letters():
    font = _font("roman")
    font.load_char(ord("I"))
    before = [each.tolist() for each in font.get_path()]
    thread = Thread(target=lambda: _font("roman").load_char(ord("W")))
    thread.start()
    thread.join()
    assert [each.tolist() for each in font.get_path()] == before

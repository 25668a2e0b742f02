"""A question bank as Moodle XML: numerical questions, their pictures in the file."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from html import escape
from typing import BinaryIO
from xml.etree.ElementTree import Element, ElementTree, SubElement, indent

from vad.export.quiz import Question


def write(questions: Sequence[Question], target: BinaryIO) -> None:
    """Write a question bank that Moodle imports; questions are in a category per mechanism."""
    root = Element("quiz")
    category = None
    for question in questions:
        if question.category != category:
            category = question.category
            entry = SubElement(SubElement(root, "question", type="category"), "category")
            SubElement(entry, "text").text = f"$course$/vad/{category.replace('/', '//')}"
        _add(root, question)
    indent(root)
    ElementTree(root).write(target, encoding="utf-8", xml_declaration=True)


def _add(root: Element, question: Question) -> None:
    entry = SubElement(root, "question", type="numerical")
    SubElement(SubElement(entry, "name"), "text").text = question.name
    _shown(entry, "questiontext", question.task, "problem", question.picture, question.title)
    _shown(entry, "generalfeedback", question.feedback, "key", question.key, question.title)
    for name, value in (("defaultgrade", "1"), ("penalty", "0.3333333"), ("hidden", "0")):
        SubElement(entry, name).text = value
    answer = SubElement(entry, "answer", fraction="100", format="moodle_auto_format")
    SubElement(answer, "text").text = question.answer
    SubElement(answer, "tolerance").text = question.margin
    SubElement(SubElement(answer, "feedback", format="html"), "text")
    unit = SubElement(SubElement(entry, "units"), "unit")
    SubElement(unit, "multiplier").text = "1"
    SubElement(unit, "unit_name").text = question.unit
    # The unit may be typed or left out; it is named in the question.
    for name, value in (("unitgradingtype", "0"), ("unitpenalty", "0.1"), ("showunits", "0")):
        SubElement(entry, name).text = value
    SubElement(entry, "unitsleft").text = "0"


def _shown(entry: Element, place: str, words: str, name: str, picture: bytes, title: str) -> None:
    """Add words with a picture below them."""
    part = SubElement(entry, place, format="html")
    image = f'<img src="@@PLUGINFILE@@/{name}.png" alt="{escape(title)}">'
    SubElement(part, "text").text = f"<p>{escape(words)}</p><p>{image}</p>"
    file = SubElement(part, "file", name=f"{name}.png", path="/", encoding="base64")
    file.text = b64encode(picture).decode()

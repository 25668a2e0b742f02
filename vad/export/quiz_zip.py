"""A question bank as a package of QTI 2.1, which Canvas and others import.

The package is a ZIP file with a manifest, an item for each question and the pictures.  Elements
stand in the order of the specification: 1EdTech, Question and Test Interoperability 2.1.
"""

from __future__ import annotations

import hashlib
import io
from collections.abc import Iterable, Sequence
from typing import BinaryIO
from xml.etree.ElementTree import Element, SubElement, indent, tostring
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from vad.export.quiz import Question

_QTI = "http://www.imsglobal.org/xsd/imsqti_v2p1"
_PACKAGE = "http://www.imsglobal.org/xsd/imscp_v1p1"
_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
_SCHEMA = f"{_QTI} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"
#: The date of the files in the package: the same questions give the same bytes.
_DATE = (1980, 1, 1, 0, 0, 0)


def write(questions: Sequence[Question], target: BinaryIO) -> None:
    """Write the package."""
    files: dict[str, bytes] = {}
    items: list[tuple[str, str, list[str]]] = []
    for number, question in enumerate(questions, start=1):
        pictures = [_named(question.picture), _named(question.key)]
        files |= dict(zip(pictures, (question.picture, question.key), strict=True))
        path = f"items/{number:04}.xml"
        files[path] = _text(_item(f"item-{number:04}", question, *pictures))
        items.append((f"item-{number:04}", path, pictures))
    files["imsmanifest.xml"] = _text(_manifest(items))
    package = io.BytesIO()  # a ZIP file is written with leaps, which a stream need not have
    with ZipFile(package, "w", ZIP_DEFLATED) as archive:
        for name in sorted(files):
            archive.writestr(ZipInfo(name, _DATE), files[name], ZIP_DEFLATED)
    target.write(package.getvalue())


def _named(picture: bytes) -> str:
    """Return the name of a picture in the package: equal pictures are one file."""
    return f"images/{hashlib.sha256(picture).hexdigest()[:16]}.png"


def _text(root: Element) -> bytes:
    indent(root)
    text: bytes = tostring(root, encoding="utf-8", xml_declaration=True)
    return text


def _item(identifier: str, question: Question, picture: str, key: str) -> Element:
    item = Element(
        "assessmentItem",
        {
            "xmlns": _QTI,
            "xmlns:xsi": _INSTANCE,
            "xsi:schemaLocation": _SCHEMA,
            "identifier": identifier,
            "title": question.name,
            "adaptive": "false",
            "timeDependent": "false",
        },
    )
    response = SubElement(
        item, "responseDeclaration", identifier="RESPONSE", cardinality="single", baseType="float"
    )
    SubElement(SubElement(response, "correctResponse"), "value").text = question.answer
    score = SubElement(
        item, "outcomeDeclaration", identifier="SCORE", cardinality="single", baseType="float"
    )
    SubElement(SubElement(score, "defaultValue"), "value").text = "0"
    SubElement(
        item,
        "outcomeDeclaration",
        identifier="FEEDBACK",
        cardinality="single",
        baseType="identifier",
    )
    body = SubElement(item, "itemBody")
    SubElement(body, "p").text = question.task
    SubElement(SubElement(body, "p"), "img", src=f"../{picture}", alt=question.title)
    entry = SubElement(
        SubElement(body, "p"),
        "textEntryInteraction",
        responseIdentifier="RESPONSE",
        expectedLength="12",
    )
    entry.tail = f" {question.unit}"
    _processing(item, question)
    feedback = SubElement(
        item,
        "modalFeedback",
        outcomeIdentifier="FEEDBACK",
        identifier="KEY",
        showHide="show",
    )
    SubElement(feedback, "p").text = question.feedback
    SubElement(SubElement(feedback, "p"), "img", src=f"../{key}", alt=question.title)
    return item


def _processing(item: Element, question: Question) -> None:
    """Add what gives the point: the answer within its tolerance; the key is shown in any case."""
    processing = SubElement(item, "responseProcessing")
    right = SubElement(SubElement(processing, "responseCondition"), "responseIf")
    equal = SubElement(
        right,
        "equal",
        toleranceMode="absolute",
        tolerance=f"{question.margin} {question.margin}",
    )
    SubElement(equal, "variable", identifier="RESPONSE")
    SubElement(equal, "correct", identifier="RESPONSE")
    point = SubElement(right, "setOutcomeValue", identifier="SCORE")
    SubElement(point, "baseValue", baseType="float").text = "1"
    shown = SubElement(processing, "setOutcomeValue", identifier="FEEDBACK")
    SubElement(shown, "baseValue", baseType="identifier").text = "KEY"


def _manifest(items: Iterable[tuple[str, str, list[str]]]) -> Element:
    manifest = Element("manifest", {"xmlns": _PACKAGE, "identifier": "vad-question-bank"})
    metadata = SubElement(manifest, "metadata")
    SubElement(metadata, "schema").text = "QTIv2.1 Package"
    SubElement(metadata, "schemaversion").text = "1.0.0"
    SubElement(manifest, "organizations")
    resources = SubElement(manifest, "resources")
    for identifier, path, pictures in items:
        resource = SubElement(
            resources, "resource", identifier=identifier, type="imsqti_item_xmlv2p1", href=path
        )
        for name in (path, *dict.fromkeys(pictures)):
            SubElement(resource, "file", href=name)
    return manifest

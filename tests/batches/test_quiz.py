"""Question banks: platforms read what the solver says, and no problem tells its answer."""

from __future__ import annotations

import io
import re
import zipfile
from base64 import b64decode
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image

import vad
from vad.errors import InputError, UsageError
from vad.files.examples import example_path

TEXT = """\
[sheet]
mechanism = "four-bar"
count = 2
seed = 5
language = "en"
tolerance = 0.05
ask = ["rocker.omega", "C.velocity"]
[vary]
crank = { share = 0.2 }
angle = { from = 0, to = 355, step = 5 }
"""
NAMES = [
    f"four-bar {label} {result}"
    for label in ("001", "002")
    for result in ("rocker.omega", "C.velocity")
]
_QTI = {"q": "http://www.imsglobal.org/xsd/imsqti_v2p1"}
_IMS = {"m": "http://www.imsglobal.org/xsd/imscp_v1p1"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("quiz")
    (path / "sheets.toml").write_text(TEXT)
    return path


@pytest.fixture(scope="module")
def questions(folder: Path):
    made = {kind: vad.quiz(folder / "sheets.toml", folder / f"bank.{kind}") for kind in KINDS}
    assert len({repr(each) for each in made.values()}) == 1
    return made["xml"]


KINDS = ("xml", "gift", "zip", "md")


def test_the_answers_are_those_of_the_batch(folder, questions):
    sheets = folder / "batch.toml"
    sheets.write_text(re.sub("(?m)^(ask|tolerance).*\n", "", TEXT) + "[keep]\nsine = 0.2\n")
    sheets.write_text(sheets.read_text().replace("[vary]", 'files = ["key.json"]\n[vary]'))
    made = vad.batch(sheets, folder / "out")
    assert [each.name for each in questions] == NAMES
    for done, (rate, speed) in zip(made, (questions[:2], questions[2:]), strict=True):
        assert rate.value == done.answers["links"]["rocker"]["omega"]
        assert speed.value == pytest.approx(abs(complex(*done.answers["points"]["C"]["velocity"])))
        assert rate.tolerance == pytest.approx(0.05 * abs(rate.value))
        crank = done.answers["parameters"]["crank"]
        assert f"crank {crank:g} mm" in rate.task
        assert rate.task.endswith("in rad/s; counter-clockwise is positive.")


def test_the_problem_does_not_tell_its_answer(questions):
    for each in questions:
        problem, key = (Image.open(io.BytesIO(data)) for data in (each.picture, each.key))
        assert problem.size == key.size
        told, said = problem.info["Description"], key.info["Description"]
        shown = f"{abs(each.value):.4g}"
        assert shown in said
        assert shown not in told


def test_moodle(folder, questions):
    root = ElementTree.parse(folder / "bank.xml").getroot()
    kinds = [entry.get("type") for entry in root]
    assert kinds == ["category", *["numerical"] * 4]
    assert root[0].findtext("category/text") == "$course$/vad/Four-bar"
    for entry, each in zip(root[1:], questions, strict=True):
        assert entry.findtext("name/text") == each.name
        assert entry.findtext("answer/text") == each.answer
        assert entry.findtext("answer/tolerance") == each.margin
        assert entry.findtext("units/unit/unit_name") == each.unit
        for place, picture in (("questiontext", each.picture), ("generalfeedback", each.key)):
            words = entry.findtext(f"{place}/text")
            file = entry.find(f"{place}/file")
            assert f'src="@@PLUGINFILE@@/{file.get("name")}"' in words
            assert b64decode(file.text) == picture
        assert f"<p>{each.task}</p>" in entry.findtext("questiontext/text")


def test_gift(folder, questions):
    text = (folder / "bank.gift").read_text("utf-8")
    head, *entries = text.rstrip("\n").split("\n\n")
    assert head == "$CATEGORY: vad/Four-bar"
    for entry, each in zip(entries, questions, strict=True):
        assert re.search(r"(?<!\\)[~=]", entry) is None  # each of these would begin an answer
        bare = re.sub(r"\\([~=#{}:\\])", r"\1", entry)
        assert bare.startswith(f"::{each.name}::[html]<p>{each.task}</p>")
        assert f"{{#{each.answer}:{each.margin}####<p>The drawing" in bare
        first, second = re.findall(r'base64,([^"]+)"', bare)
        assert (b64decode(first), b64decode(second)) == (each.picture, each.key)


def test_a_package_of_qti(folder, questions):
    with zipfile.ZipFile(folder / "bank.zip") as package:
        files = {name: package.read(name) for name in package.namelist()}
    manifest = ElementTree.fromstring(files["imsmanifest.xml"])
    listed = [each.get("href") for each in manifest.findall(".//m:file", _IMS)]
    assert set(listed) | {"imsmanifest.xml"} == set(files)
    items = [each.get("href") for each in manifest.findall(".//m:resource", _IMS)]
    for name, each in zip(items, questions, strict=True):
        item = ElementTree.fromstring(files[name])
        assert item.get("title") == each.name
        assert item.findtext("q:responseDeclaration/q:correctResponse/q:value", None, _QTI) == (
            each.answer
        )
        assert item.find(".//q:equal", _QTI).get("tolerance") == f"{each.margin} {each.margin}"
        pictures = [image.get("src") for image in item.findall(".//q:img", _QTI)]
        assert [files[src.removeprefix("../")] for src in pictures] == [each.picture, each.key]


def test_markdown(folder, questions):
    text = (folder / "bank.md").read_text("utf-8")
    for each in questions:
        assert f"## {each.name}\n\n{each.task}\n" in text
        assert f"**{each.answer} {each.unit}** (± {each.margin} {each.unit})" in text


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("tolerance = 0.05", "tolerance = 5", "line 6: tolerance: must be between 0 and 1, got 5"),
        ('"C.velocity"', '"C.position"', "unknown result of a question 'C.position'"),
        ('"C.velocity"', '"D.speed"', "ask: unknown result 'D.speed'"),
        ('"C.velocity"', '"foo"', "sheets.toml, line 7: ask: 'foo' is no result"),
        ('"C.velocity"', '"stroke"', "sheets.toml, line 7: ask: 'stroke' is no result"),
        ('"C.velocity"', '"drive"', "ask: unknown result of a question 'drive'"),
        ("crank = { share", "crnk = { share", "unknown parameter 'crnk'"),
    ],
)
def test_what_is_wrong_is_said(tmp_path, old, new, message):
    (tmp_path / "sheets.toml").write_text(TEXT.replace(old, new))
    with pytest.raises(InputError, match=re.escape(message)):
        vad.quiz(tmp_path / "sheets.toml", tmp_path / "bank.xml")
    assert not (tmp_path / "bank.xml").exists()


def test_another_format_is_refused_before_anything_is_made(tmp_path):
    with pytest.raises(UsageError, match="cannot be saved as") as caught:
        vad.quiz("no.toml", tmp_path / "bank.docx")
    assert caught.value.hint == "known: .gift, .md, .xml, .zip"


FIGURES = {
    "centres": ("four-bar", "", ["coupler.omega", "rocker.omega"], "θ₂ = 60°, ω₂ = 10 rad/s."),
    "turned": ("four-bar", "", ["coupler.omega", "rocker.omega"], "θ₂ = 60°, ω₂ = 10 rad/s."),
    "klein": (
        "slider-crank",
        "",
        ["rod.omega", "slider.velocity", "rod.alpha", "slider.acceleration"],
        "θ₂ = 60°, ω₂ = 10 rad/s, α₂ = 0 rad/s².",
    ),
    "velocity": ("four-bar", 'ask = ["C.velocity"]', ["C.velocity"], "θ₂ = 60°, ω₂ = 10 rad/s."),
    "position": ("four-bar", 'ask = ["rocker.angle"]', ["rocker.angle"], "rocker 80 mm, θ₂ = 60°."),
}


@pytest.mark.parametrize("panel", FIGURES)
def test_each_figure_asks_for_what_it_finds_and_gives_what_it_needs_once(tmp_path, panel):
    mechanism, words, results, given = FIGURES[panel]
    file = tmp_path / "sheets.toml"
    file.write_text(f'[sheet]\nmechanism = "{mechanism}"\npanels = ["{panel}"]\n{words}\n')
    made = vad.quiz(file, tmp_path / "bank.xml")
    assert [each.name.split()[-1] for each in made] == results
    for each in made:
        told, _, asked = each.task.partition(". ")
        assert f"{told}.".endswith(given) and asked.startswith("Find ")
        assert told.count("θ₂") == 1 and told.count("ω₂") <= 1


def test_a_question_gives_what_bodies_bear(tmp_path):
    file = tmp_path / "sheets.toml"
    file.write_text(
        '[sheet]\nmechanism = "slider-crank"\nload = "800 N @ 180 at C"\nmass = "slider 0.5 kg"\n'
        'gravity = 9.81\nfriction = "slider 0.1"\npanels = "position"\nask = "drive"\n'
    )
    (made,) = vad.quiz(file, tmp_path / "bank.xml")
    told = "P = 800 N, W₄ = 4.905 N, m₄ = 0.5 kg at C, g = 9.81 m/s², μ₄ = 0.1. Find"
    assert f"α₂ = 0 rad/s², {told}" in made.task


def test_a_sheet_from_which_nothing_is_found_is_refused(tmp_path):
    file = tmp_path / "sheets.toml"
    file.write_text('[sheet]\nmechanism = "four-bar"\npanels = ["position"]\n')
    with pytest.raises(InputError, match="ask: no panel left blank") as caught:
        vad.quiz(file, tmp_path / "bank.xml")
    assert caught.value.hint.startswith("as in ask = [")


def test_questions_have_the_names_of_the_file_in_their_language(tmp_path: Path):
    sheets = tmp_path / "sheets.toml"
    sheets.write_text('[sheet]\nmechanism = "v-engine.toml"\nlanguage = "de"\nblank = "velocity"\n')
    (tmp_path / "v-engine.toml").write_text(example_path("v-engine").read_text())
    tasks = [each.task for each in vad.quiz(sheets, tmp_path / "bank.md")]
    asked = ("des Hauptpleuels", "des Nebenpleuels", "des Kolbens B", "des Kolbens D")
    assert all(each in task for each, task in zip(asked, tasks, strict=True))

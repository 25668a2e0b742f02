"""The window in a cell of a notebook: a page in a real browser plays the notebook."""

from __future__ import annotations

import json
import webbrowser
from base64 import b64encode
from collections.abc import Iterator
from threading import Event
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest

import vad
from tests.browser import opened, until
from tests.gui.visitor import visit
from tests.test_notebook import shell
from vad import showing
from vad.errors import ExportError, InputError, UsageError
from vad.gui.answers import pose
from vad.gui.messages import PoseQuestion, read

anywidget = pytest.importorskip("anywidget", reason="anywidget comes with the extra 'notebook'")

#: A notebook: it keeps a model for the widget, and carries messages between it and Python.
NOTEBOOK = """<!doctype html><html lang="en"><title>Notebook</title><script type="module">
const source = URL.createObjectURL(new Blob([await trait("_esm")], { type: "text/javascript" }));
const { default: widget } = await import(source);
const heard = new Set(), changed = new Set();
const traits = { page: await trait("page"), title: await trait("title"), pose: {}, asked: {} };
const frame = () => document.querySelector("iframe");
const painted = () =>
  new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
const send = async (message) => {
  // The cell is resized while the frame waits for its first lesson.
  if (!frame().dataset.asked) for (const width of ["90%", "100%"]) {
    frame().style.width = frame().dataset.asked = width;
    await painted();
  }
  const [answer, data] = await python(message);
  const buffers = [new DataView(Uint8Array.from(atob(data), (each) => each.charCodeAt()).buffer)];
  heard.forEach((each) => each(answer, buffers));
};
const of = (name) => name === "msg:custom" ? heard : changed;
const model = { get: (name) => traits[name], send, set: (name, value) => { traits[name] = value; },
  save_changes: () => follow(traits.pose),
  on: (name, hear) => of(name).add(hear), off: (name, hear) => of(name).delete(hear) };
const leave = widget.render({ model, el: document.body });
window.asked = (value) => { traits.asked = value; changed.forEach((each) => each()); };
window.gone = () => { leave(); return heard.size + changed.size; };
</script>"""


@pytest.fixture(scope="module")
def cell(browser, tmp_path_factory) -> Iterator[SimpleNamespace]:
    """Return a notebook with a widget in it: its page, and the frame of the window."""
    window = vad.widget(vad.solve(vad.FourBar(crank=45), angle=75.0), style="chalk")
    sent: list[list[object]] = []
    window.send = lambda answer, buffers: sent.append([answer, b64encode(buffers[0]).decode()])

    def python(message: object) -> list[object]:
        window._handle_custom_msg(message, [])
        return sent.pop()

    path = tmp_path_factory.mktemp("notebook") / "cell.html"
    path.write_text(NOTEBOOK)
    with opened(browser, server="blob:", viewport={"width": 1100, "height": 800}) as page:
        page.expose_function("python", python)
        page.expose_function("follow", lambda pose: setattr(window, "pose", pose))
        page.expose_function("trait", lambda name: str(getattr(window, name)))
        page.goto(path.as_uri())
        until(page, lambda: page.evaluate("typeof gone == 'function'"))
        yield SimpleNamespace(page=page, frame=page.frame_locator("iframe"), window=window)


def shown(cell: SimpleNamespace, words: str) -> None:
    until(cell.page, lambda: words in cell.frame.locator(".results").inner_text())


def test_it_opens_with_the_pose_that_is_given(cell):
    shown(cell, "75°")
    assert cell.frame.locator("[name=crank]").input_value() == "45"
    assert cell.frame.locator("main").get_attribute("data-theme") == "chalk"
    assert cell.page.locator("iframe").get_attribute("title") == "vad: four-bar"


def test_what_is_set_is_solved_by_python(cell):
    cell.frame.locator("[name=angle]").fill("150")
    cell.frame.locator("[name=angle]").press("Enter")
    shown(cell, "150°")
    omega = vad.solve(vad.FourBar(crank=45), angle=150.0).link("rocker").omega
    shown(cell, f"{omega:.3f}")


def test_what_a_hand_sets_is_known_to_python(cell):
    seen: list[float] = []
    until(cell.page, lambda: cell.window.angle == 150)
    cell.window.observe(lambda change: seen.append(change["new"]), "angle")
    cell.frame.locator(".turner").focus()
    cell.page.keyboard.press("PageUp")
    until(cell.page, lambda: cell.window.angle != 150)
    turned = cell.window.angle
    assert turned == seen[-1] == pytest.approx(135)
    omega = vad.solve(vad.FourBar(crank=45), angle=turned).link("rocker").omega
    assert cell.window.motion.link("rocker").omega == omega
    cell.window.unobserve_all("angle")


def test_what_python_sets_is_shown(cell):
    cell.window.angle = 40
    assert cell.window.motion.inputs["angle"] == 40
    cell.page.evaluate("asked", cell.window.asked)
    shown(cell, "40°")
    until(cell.page, lambda: cell.window.pose.get("angle") == 40)
    assert cell.window.angle == 40


def test_the_board_is_as_wide_as_its_cell(cell):
    frame = cell.page.locator("iframe").bounding_box()
    board = cell.frame.locator(".board").bounding_box()
    rail = cell.frame.locator(".rail").bounding_box()
    assert board["width"] + rail["width"] == pytest.approx(frame["width"], abs=2)
    dock = cell.frame.locator(".control").bounding_box()
    assert dock["y"] + dock["height"] == pytest.approx(frame["y"] + frame["height"], abs=60)


def test_what_cannot_be_is_said(cell):
    cell.frame.locator("[name=crank]").fill("-4")
    cell.frame.locator("[name=crank]").press("Enter")
    says = cell.frame.locator(".message span")
    until(cell.page, lambda: "must be positive" in cell.frame.locator(".said").inner_text())
    cell.frame.locator("[name=crank]").fill("4.5 cm")
    cell.frame.locator("[name=crank]").press("Enter")
    until(cell.page, lambda: not says.is_visible())


def test_a_picture_is_saved(cell):
    cell.frame.locator(".save summary").click()
    with cell.page.expect_download() as loading:
        cell.frame.locator("[data-save=svg]").click()
    assert loading.value.suggested_filename == "four-bar.svg"
    root = ElementTree.parse(loading.value.path()).getroot()
    assert root.find("{http://www.w3.org/2000/svg}title").text.startswith("Four-bar")


def test_a_cell_that_is_gone_hears_nothing(cell):
    assert cell.page.evaluate("gone()") == 0


def test_answers_are_those_of_the_server():
    from vad.gui.widget import answer

    body = {"mechanism": "whitworth", "inputs": {"angle": 20}}
    data, media, name = answer("pose", body)
    told, expected = json.loads(data), json.loads(json.dumps(pose(read(PoseQuestion, body))))
    assert (media, name) == ("application/json", "")
    assert told | {"ms": 0} == expected | {"ms": 0}


@pytest.mark.parametrize(
    ("path", "body", "said"),
    [
        ("pose", {"mechanism": "four-bar", "parameters": {"crank": -1}}, "crank: must be positive"),
        ("pose", {"mechanism": "press"}, "press"),
        ("pose", [], "the question must be an object"),
        ("export/exe", {"mechanism": "four-bar"}, "unknown format 'exe'"),
        ("export/../svg", {"mechanism": "four-bar"}, "unknown format '../svg'"),
    ],
)
def test_errors_are_answers(path, body, said):
    from vad.gui.widget import answer

    data, media, _ = answer(path, body)
    assert media == "application/json"
    assert said in json.loads(data)["error"]["message"]


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        (None, "path: must be a text, got None"),
        ([], "path: must be a text, got None"),
        ({}, "path: must be a text, got None"),
        ({"id": 7, "body": {}}, "path: must be a text, got None"),
        ({"id": 7, "path": ["pose"]}, "path: must be a text, got ['pose']"),
        ({"id": 7, "path": "pose"}, "the question must be an object, got None"),
        ({"id": 7, "path": "lesson", "body": {}}, "mechanism: is missing"),
    ],
)
def test_any_message_is_answered(asked, said):
    window = vad.widget(vad.FourBar())
    sent: list[tuple[dict, list[bytes]]] = []
    window.send = lambda *answer: sent.append(answer)
    window._handle_custom_msg(asked, [])
    ((head, (data,)),) = sent
    assert head == {"id": asked["id"] if asked else None, "media": "application/json", "name": ""}
    assert json.loads(data)["error"]["message"] == said


def test_a_pose_that_cannot_be_is_refused():
    window = vad.widget(vad.FourBar())
    with pytest.raises(vad.VadError, match="angle"):
        window.angle = float("nan")
    window.pose = {"angle": "x"}
    window.pose = {"angle": float("inf"), "door": 3.0}
    assert window.angle == 60
    window.pose = {"angle": 15.0, "crank": 50.0}
    assert window.motion.mechanism.crank == 50
    assert window.angle == 15
    window = vad.widget(vad.solve(vad.FourBar(crank=130), angle=60))
    with pytest.raises(vad.AssemblyError, match="miss"):
        window.angle = 10
    assert window.angle == 60
    gate = vad.widget(vad.GateActuator())
    gate.position = 3.9
    assert gate.motion.inputs["position"] == 3.9


def test_it_bears_the_loads_of_its_forces():
    motion = vad.solve(vad.FourBar(), angle=50)
    loads = [{"on": "rocker", "couple": -6}]
    window = vad.widget(vad.forces(motion, loads))
    found = reply_of(window)
    assert found["results"]["forces"]["drive"] == vad.forces(motion, loads).drive
    assert window.motion.inputs["angle"] == 50


def reply_of(window) -> dict[str, object]:
    """Return the lesson for which the page asks at first."""
    from vad.gui.widget import reply

    page = window.page
    start = json.JSONDecoder().raw_decode(page, page.index('{"start"'))[0]["start"]
    known = ("mechanism", "parameters", "inputs", "burden", "panels")
    body = {name: start[name] for name in known}
    _, (data,) = reply({"path": "lesson", "body": body})
    return json.loads(data)


def test_show_of_a_mechanism_in_a_notebook_displays_the_window(monkeypatch):
    displayed = shell(monkeypatch, kernel=object())
    vad.show(vad.ScotchYoke())
    assert [each.title for each in displayed] == ["vad: scotch-yoke"]


def test_show_of_a_mechanism_elsewhere_serves_it_until_an_interrupt(monkeypatch):
    found: list[str] = []
    come = Event()

    class Interrupted:
        def wait(self) -> None:
            assert come.wait(20)
            raise KeyboardInterrupt

    def browse(address: str) -> bool:
        found.append(visit(address))
        come.set()
        return True

    monkeypatch.setattr(showing, "Event", Interrupted)
    monkeypatch.setattr(webbrowser, "open", browse)
    vad.show(vad.ScotchYoke(crank=61))
    assert '"crank": 61' in found[0]


def test_without_a_browser_show_says_how_to_get_the_address(monkeypatch):
    monkeypatch.setattr(webbrowser, "open", lambda _: False)
    with pytest.raises(ExportError, match="no browser can be started") as error:
        vad.show(vad.ScotchYoke())
    assert "vad gui scotch-yoke" in error.value.hint


@pytest.mark.parametrize(
    ("thing", "options", "kind"),
    [
        (3, {}, UsageError),
        (vad.solve(vad.FourBar(), angle=[0, 90]), {}, InputError),
        (vad.FourBar(), {"panels": "speed"}, UsageError),
        (vad.FourBar(), {"style": "neon"}, UsageError),
        (vad.FourBar(), {"language": "xx"}, UsageError),
    ],
)
def test_what_has_no_window(thing, options, kind):
    with pytest.raises(kind):
        vad.widget(thing, **options)


def test_without_anywidget_it_says_what_to_install(monkeypatch):
    monkeypatch.setattr(showing, "find_spec", lambda _: None)
    with pytest.raises(UsageError, match="needs anywidget") as error:
        vad.widget(vad.FourBar())
    assert "vad-diagrams[notebook]" in error.value.hint

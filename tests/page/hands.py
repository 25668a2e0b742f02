"""The picture that a hand moves, alone in a browser's page: mechanism after mechanism, unpacked."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import vad
from vad.page.document import asset
from vad.page.parts import parts

if TYPE_CHECKING:
    from playwright.sync_api import Page

EXAMPLES = {path.stem: path for path in (Path(vad.__file__).parent / "examples").glob("*.toml")}
NAMES = [*vad.MECHANISMS, *sorted(EXAMPLES.keys() - vad.MECHANISMS.keys())]
_SCRIPTS = ("solver.js", "written.js", "labels.js", "scales.js", "picture.js")

#: Opens a picture as ``view``.
_OPEN = """([panels, table, layers, program, data]) => {
  const root = document.querySelector("main");
  root.innerHTML = `<div>${panels}</div><div class="results">${table}</div>`;
  const svgs = root.querySelectorAll(".drawing > svg");
  layers.forEach((layer, n) => svgs[n].insertAdjacentHTML("beforeend", layer));
  window.given = data;
  window.view = picture(root, solver(program), data);
}"""

#: Moves the driver through its ranges in so many poses, and tells what is wrong.  A label is
#: known by the numbers of its members; of each the script tells where its text is.
_WALK = """(count) => {
  const { names, state, counts } = view, [unit, left, top] = given.page, near = 0.3 / 720;
  const total = given.ranges.reduce((sum, [low, high]) => sum + high - low, 0);
  const begun = { ...counts }, before = new Map(), found = {
    poses: 0, labels: names.all.length, step: 0, covering: [], astray: [], hidden: 0, most: 0,
    time: [],
  };
  for (const [low, high] of given.ranges) {
    before.clear();
    const whole = given.inputs[0] === "angle" && high - low >= 360;
    const size = Math.max(12, Math.round(count * (high - low) / total));
    for (let n = 0; n < size; n++) {
      const share = whole ? n / size : 0.002 + 0.996 * n / (size - 1);
      state[0] = low + (high - low) * share;
      const then = performance.now();
      if (n) view.paint(); else for (let k = 0; k < 40; k++) view.paint();
      found.time.push(performance.now() - then);
      found.poses++;
      check(n ? before : null);
    }
  }
  function check(before) {
    const shown = names.all.filter((each) => each.shell.style.visibility !== "hidden");
    const at = (each) => {
      const [, x, y] = /translate\\((\\S+)px, (\\S+)px\\)/.exec(each.shell.style.transform);
      return [+x / unit, -y / unit];
    };
    const here = new Map(shown.map((each) => [each, at(each)]));
    const groups = [...names.groups.values()].filter((each) => each.visible).map((group) => {
      const [x, y] = here.get(group.members[0]), [a, b] = group.spots[0];
      return { ...group, x: x - a, y: y - b };
    });
    const away = ({ x, y, wide, high }, dot) =>
      Math.hypot(Math.max(0, Math.abs(dot.u - x) - wide), Math.max(0, Math.abs(dot.v - y) - high));
    groups.forEach((one, n) => {
      for (const other of groups.slice(0, n))
        if (one.column === other.column &&
            Math.abs(one.x - other.x) < one.wide + other.wide + 0.006 - near &&
            Math.abs(one.y - other.y) < one.high + other.high + 0.006 - near)
          found.covering.push([state[0], one.key, other.key]);
      if (!one.dot) return;
      const own = Math.min(...one.members.map((dot) => away(one, dot)));
      for (const dot of names.all)
        if (dot.there && dot.dot && dot.column === one.column && !one.members.includes(dot) &&
            away(one, dot) < own - near)
          found.astray.push([state[0], one.key, dot.number]);
    });
    for (const [each, [x, y]] of here) {
      const off = [x - each.u, y - each.v], last = before?.get(each.number);
      const step = last ? 720 * Math.hypot(off[0] - last[0], off[1] - last[1]) : 0;
      found.step = Math.max(found.step, step);
    }
    before?.clear();
    for (const [each, [x, y]] of here) before?.set(each.number, [x - each.u, y - each.v]);
    found.hidden += view.hidden;
    found.most = Math.max(found.most, view.hidden);
  }
  for (const name in counts) found[name] = (counts[name] - begun[name]) / found.poses;
  found.time.sort((a, b) => a - b);
  found.time = found.time[found.time.length >> 1];
  found.hidden /= found.poses;
  return found;
}"""


@cache
def made(name: str) -> list[Any]:
    """Return what the page of a mechanism has: panels, table, layers, program and data."""
    mechanism: Any = vad.MECHANISMS.get(name) or vad.load(str(EXAMPLES[name]))
    mechanism = mechanism()
    rates = {"alpha": 3.0} if "alpha" in mechanism.inputs else {}
    lesson = vad.animate(vad.draw(vad.solve(mechanism, **rates)))
    found = parts(lesson)
    assert found.hand
    layers = [found.hand.layers[panel.name] for panel in lesson.sheet.panels]
    given = [found.panels, found.table, layers, found.hand.program, found.hand.data]
    return list(json.loads(json.dumps(given)))


def prepare(page: Page) -> None:
    """Give a page the scripts of a picture."""
    page.set_content("<!DOCTYPE html><main class='vad turned'></main>")
    page.add_script_tag(content="\n".join(asset(name) for name in _SCRIPTS))


def open_picture(page: Page, name: str) -> None:
    """Show a mechanism with all that its lesson draws; it is ``view`` in the page."""
    page.evaluate(_OPEN, made(name))


def walked(page: Page, name: str, poses: int) -> dict[str, Any]:
    """Return what is found while a mechanism moves through so many poses."""
    open_picture(page, name)
    found: dict[str, Any] = page.evaluate(_WALK, poses)
    return found

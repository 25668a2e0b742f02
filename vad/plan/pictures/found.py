"""What a polygon finds of a view: the masses of a shaft, which stand there from then on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from vad.plan.items import FOREVER, Item
from vad.plan.sketch import Sketch
from vad.strokes.reveals import finder


def found_later(items: Iterable[Item], sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield items; results of a view that a polygon finds come with the stroke that finds them."""
    moved: dict[str, tuple[str, int]] = {}
    for sketch in sketches.values():
        setting, panel = sketch.setting, sketch.setting.panel
        results = [s for s in panel.strokes if s.kind == "result" and panel.picture == "views"]
        for stroke in results:
            found = finder(setting.sheet, panel, stroke.link)
            if found:
                other, by = found
                beat = sketches[other.name].setting.during(other.number(by.name))
                later = beat - setting.during(panel.number(stroke.name))
                moved[panel.full(stroke.name)] = other.full(by.name), later
    for item in items:
        if item.stroke not in moved:
            yield item
            continue
        name, later = moved[item.stroke]
        until = FOREVER if item.until == FOREVER else item.until + later
        yield replace(item, stroke=name, since=item.since + later, until=until)

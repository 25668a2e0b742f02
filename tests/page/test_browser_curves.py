"""The curves and hodographs of a page are those of `vad.solve` over the whole turn."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import vad
from tests.browser import opened
from tests.page.lessons import show, written

HELD = """() => {
  document.querySelector("[data-do=last]").click();
  document.querySelector("[data-do=hand]").click();
}"""


def switch(page: Page, name: str) -> None:
    page.locator(".shows button", has_text=name).click()


def spots(page: Page, selector: str) -> np.ndarray:
    """Return the points of the first path of a kind."""
    data = page.locator(selector).first.get_attribute("d") or ""
    return np.array(re.findall(r"[-\d.e+]+", data), dtype=float).reshape(-1, 2)


@pytest.fixture
def page(browser: Browser, tmp_path: Path):
    with opened(browser, viewport={"width": 1280, "height": 820}) as opened_page:
        show(opened_page, tmp_path, written(vad.FourBar(), omega=10.0))
        opened_page.evaluate(HELD)
        yield opened_page


def test_a_curve_is_that_of_solve(page: Page) -> None:
    switch(page, "Curves")
    places = np.linspace(0.0, 360.0, 361)
    wanted = vad.solve(vad.FourBar(), angle=places, omega=10.0).link("rocker").omega
    figure = page.locator(".plots figure").nth(1)
    least, most = (
        float(each.replace("−", "-").split()[0])
        for each in reversed(figure.locator("span").all_inner_texts())
    )
    data = figure.locator("path[style*='ink2']").get_attribute("d") or ""
    found = np.array(re.findall(r"[-\d.e+]+", data), dtype=float).reshape(-1, 2)
    values = least + (96.0 - found[:, 1]) / 92.0 * (most - least)
    np.testing.assert_allclose(np.interp(found[:, 0], places, wanted), values, atol=0.02)
    assert np.ptp(found[:, 0]) > 359.0


def test_a_hodograph_runs_through_the_image_of_its_point(page: Page) -> None:
    switch(page, "Hodographs")
    places = np.linspace(0.0, 360.0, 361)
    wanted = vad.solve(vad.FourBar(), angle=places, omega=10.0).point("C").velocity
    all_ = page.locator(".hodograph[style*='ink2']").first.get_attribute("d") or ""
    found = np.array(re.findall(r"[-\d.e+]+", all_), dtype=float).reshape(-1, 2) @ [1.0, 1.0j]
    away = np.abs(found[:, None] - wanted[None, :]).min(axis=1)
    assert away.max() < 0.02 * np.abs(wanted).max()


def test_nothing_is_seen_before_it_is_asked_for(page: Page) -> None:
    assert not page.locator(".plots").is_visible()
    assert not page.locator(".hodograph").first.is_visible()
    page.keyboard.press("c")
    assert page.locator(".plots").is_visible()
    page.keyboard.press("Escape")
    page.wait_for_function("() => !document.querySelector('.turned')")
    assert not page.locator(".plots").is_visible()


def test_a_drag_in_a_curve_moves_the_crank(page: Page) -> None:
    switch(page, "Curves")
    box = page.locator(".plots svg").first.bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 4, box["y"] + 20)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + 20)
    page.mouse.up()
    assert page.evaluate("() => vad.state.angle") == pytest.approx(180.0, abs=1.0)
    assert page.evaluate("() => Number.isInteger(+(10 * vad.state.angle).toFixed(9))")


def test_the_curve_of_an_angle_names_the_whole_turn(page: Page) -> None:
    switch(page, "Curves")
    assert page.locator(".plots figure").first.locator("span").first.inner_text() == "360.0°"


def test_a_range_through_0_has_a_part_at_each_end_of_the_curve(
    browser: Browser, tmp_path: Path
) -> None:
    """No line joins them: there the links do not close."""
    with opened(browser, viewport={"width": 1280, "height": 820}) as page:
        show(page, tmp_path, written(vad.FourBar(crank=60, coupler=72)))
        page.evaluate(HELD)
        switch(page, "Curves")
        data = page.locator(".plots path[style*='ink2']").first.get_attribute("d") or ""
    parts = [np.array(re.findall(r"[-\d.e+]+", part), dtype=float)[::2] for part in data.split("M")]
    places = [part for part in parts if part.size]
    assert all(np.all(np.diff(part) > 0.0) for part in places)
    low, high = 360.0 - 142.4, 142.4  # where the coupler and the rocker are in line
    assert [min(map(np.min, places)), max(map(np.max, places))] == pytest.approx([0, 360], abs=0.1)
    between = np.concatenate(places)
    assert not np.any((between > high) & (between < low))


def test_a_range_that_is_not_a_turn_is_covered(browser: Browser, tmp_path: Path) -> None:
    """B of the double slider runs from one end of its guide to the other."""
    with opened(browser, viewport={"width": 1280, "height": 820}) as page:
        show(page, tmp_path, written(vad.DoubleSlider()))
        page.evaluate(HELD)
        switch(page, "Paths")
        boxes = page.evaluate("""() => [...document.querySelectorAll(".ways .path")].map((path) => {
          const box = path.getBBox(), { a } = path.transform.baseVal[0].matrix;
          return Math.max(box.width, box.height) * a;
        })""")
        view = page.locator(".drawing > svg").first.get_attribute("viewBox") or ""
    assert max(boxes) > 0.3 * float(view.split()[2])

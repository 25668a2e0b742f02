"""The examples of the documentation and of the README do what is written there."""

from __future__ import annotations

from pathlib import Path

import pytest

from docs.examples import ExampleError, blocks, commands, run_examples

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs" / "pages").rglob("*.md"))]


@pytest.mark.exhaustive(48)
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_the_examples_of_a_page_work(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    run_examples(page.read_text("utf-8"), tmp_path)


def test_every_verb_of_the_command_line_has_an_example():
    shell = [block for page in PAGES for block in blocks(page.read_text("utf-8"))]
    words = [each for block in shell if block.language == "sh" for each in commands(block)]
    verbs = {each[1] for each in words if each[0] == "vad"}
    assert {"solve", "draw", "animate", "sweep", "compare"} <= verbs


@pytest.mark.parametrize(
    "page",
    [
        "```sh\nvad slove four-bar\n```\n",
        "```console\n$ vad --version\nvad 17\n```\n",
        "```python\n>>> 1 + 1\n3\n```\n",
        "```sh\nvad list\n```\n\n```sh\npython missing.py\n```\n",
    ],
)
def test_an_example_that_is_wrong_is_found(page: str, tmp_path: Path):
    with pytest.raises(ExampleError):
        run_examples(page, tmp_path)


def test_a_program_that_fails_fails(tmp_path: Path):
    with pytest.raises(ZeroDivisionError):
        run_examples("```python\n1 / 0\n```\n", tmp_path)

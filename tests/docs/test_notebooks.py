"""The notebook and the Quarto document of the documentation run, and show what they say."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

PAGES = Path(__file__).parents[2] / "docs" / "pages" / "how-to"
_CHUNK = re.compile(r"^```\{python\}\n(.*?)^```$", re.M | re.S)


def notebook(path: Path) -> Any:
    """Return a notebook, or the chunks of a Quarto document as one."""
    nbformat = pytest.importorskip("nbformat")
    if path.suffix == ".ipynb":
        return nbformat.read(path, as_version=4)
    chunks = _CHUNK.findall(path.read_text("utf-8"))
    return nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in chunks])


@pytest.mark.parametrize("name", ["lecture.ipynb", "lecture.qmd"])
def test_it_runs_and_its_last_cell_is_a_page(name: str, tmp_path: Path):
    client = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    run = client.NotebookClient(
        notebook(PAGES / name),
        timeout=120,
        kernel_name="python3",
        resources={"metadata": {"path": str(tmp_path)}},
    )
    cells = [cell for cell in run.execute().cells if cell.cell_type == "code"]
    shown = [set(out.get("data", ())) for cell in cells for out in cell.outputs]
    texts = "".join(out.get("text", "") for cell in cells for out in cell.outputs)
    assert "rod" in texts
    assert any("image/svg+xml" in each or "text/html" in each for each in shown)
    assert "text/html" in shown[-1]


def test_no_output_is_stored_with_the_notebook():
    text = (PAGES / "lecture.ipynb").read_text("utf-8")
    assert '"outputs": []' in text
    assert '"output_type"' not in text

"""What a release demands, and that the recipe of a package asks for what the project asks for."""

from __future__ import annotations

import importlib.util
import re
import shutil
import tomllib
from pathlib import Path
from types import ModuleType

import pytest

import vad

ROOT = Path(__file__).parents[1]
OTHER_NAMES = {"matplotlib": "matplotlib-base"}


@pytest.fixture(scope="module")
def release() -> ModuleType:
    spec = importlib.util.spec_from_file_location("release", ROOT / "packaging" / "release.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """Return a copy of the files that a release looks at, in which all is ready."""
    for name in ("vad/__init__.py", "CHANGELOG.md", "CITATION.cff", "packaging/recipe.yaml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    (tmp_path / "docs" / "pages").mkdir(parents=True)
    for name in ("README.md", "docs/pages/install.md", "docs/pages/tutorial.md"):
        (tmp_path / name).write_text("`pip install vad-diagrams` installs it.\n", "utf-8")
    for name in ("SECURITY.md", "CODE_OF_CONDUCT.md"):
        (tmp_path / name).write_text("Write to <people@forge.test>.\n", "utf-8")
    project = (ROOT / "pyproject.toml").read_text("utf-8")
    (tmp_path / "pyproject.toml").write_text(project.replace("//example.org", "//forge.test"))
    changes = (ROOT / "CHANGELOG.md").read_text("utf-8")
    dated = changes.replace("(unreleased)", "(2027-01-31)")
    (tmp_path / "CHANGELOG.md").write_text(dated, "utf-8")
    return tmp_path


def test_a_tree_that_is_ready(release, tree):
    assert list(release.missing(tree, f"v{vad.__version__}")) == []


@pytest.mark.parametrize(
    ("name", "old", "new", "said"),
    [
        ("pyproject.toml", "//forge.test", "//example.org", "project.urls.Repository is a placeh"),
        ("SECURITY.md", "@forge.test", "@example.org", "SECURITY.md: the address of the maint"),
        ("CODE_OF_CONDUCT.md", "@forge.test", "@example.org", "CODE_OF_CONDUCT.md: the address"),
        ("README.md", "`", "Once it is released, `", "README.md: says 'Once it is released': "),
        ("docs/pages/install.md", "`", "Once the package is released, `", "install.md: says"),
        ("docs/pages/tutorial.md", "`", "in the folder of the program `", "tutorial.md: says"),
        ("CHANGELOG.md", "(2027-01-31)", "(unreleased)", "CHANGELOG.md: begins with"),
        ("CITATION.cff", "version: 0", "version: 7", "CITATION.cff: names the version 7"),
        ("packaging/recipe.yaml", 'version: "0', 'version: "7', "recipe.yaml: names the version 7"),
        ("vad/__init__.py", '__version__ = "0', '__version__ = "7', "it must be v7"),
    ],
)
def test_what_is_missing_is_said(release, tree, name, old, new, said):
    path = tree / name
    path.write_text(path.read_text("utf-8").replace(old, new), "utf-8")
    assert any(said in line for line in release.missing(tree, f"v{vad.__version__}"))


def test_the_recipe_asks_for_what_the_project_asks_for():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    wanted = {"python": ">=" + project["requires-python"].removeprefix(">=")}
    for each in project["dependencies"]:
        name, version = re.fullmatch(r"([\w.-]+)(>=[\d.]+)", each).groups()
        wanted[OTHER_NAMES.get(name, name)] = version
    recipe = (ROOT / "packaging" / "recipe.yaml").read_text("utf-8")
    run = recipe.partition("\n  run:\n")[2].partition("\ntests:")[0]
    assert dict(re.findall(r"- ([\w.-]+) (>=[\d.]+)", run)) == wanted

"""What is handed out: the wheel has the program alone, the sdist what its own tests need."""

from __future__ import annotations

import email
import re
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from email.message import Message
from pathlib import Path

import pytest

import vad
from hatch_build import on_its_own

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the packages as they are handed out."""
    folder = tmp_path_factory.mktemp("packages")
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-d", str(folder)],
        cwd=ROOT,
        check=True,
        capture_output=True,
        timeout=120,
    )
    return folder


@pytest.fixture(scope="module")
def in_wheel(packages: Path) -> dict[str, bytes]:
    (path,) = packages.glob("*.whl")
    with zipfile.ZipFile(path) as wheel:
        return {name: wheel.read(name) for name in wheel.namelist()}


@pytest.fixture(scope="module")
def in_sdist(packages: Path) -> set[str]:
    (path,) = packages.glob("*.tar.gz")
    with tarfile.open(path) as sdist:
        return {name.partition("/")[2] for name in sdist.getnames()}


@pytest.fixture(scope="module")
def metadata(in_wheel: dict[str, bytes]) -> Message:
    (name,) = (name for name in in_wheel if name.endswith("METADATA"))
    return email.message_from_bytes(in_wheel[name])


def files(folder: str, pattern: str) -> set[str]:
    found = (path for path in (ROOT / folder).rglob(pattern) if "__pycache__" not in path.parts)
    return {path.relative_to(ROOT).as_posix() for path in found}


def test_the_wheel_has_the_program_and_its_licence_alone(in_wheel):
    assert {name.partition("/")[0].partition("-")[0] for name in in_wheel} == {
        "vad",
        "vad_diagrams",
    }
    assert files("vad", "*.py") | files("vad", "*.toml") | {"vad/py.typed"} <= set(in_wheel)
    assert any(name.endswith("/LICENSE") for name in in_wheel)


def test_the_sdist_has_what_its_tests_need(in_sdist):
    for folder, pattern in (("vad", "*.py"), ("tests", "*.*"), ("gallery", "*.*")):
        assert files(folder, pattern) <= in_sdist
    beside = {"README.md", "CONTRIBUTING.md", "SECURITY.md", "CITATION.cff", "LICENSE"}
    assert {*beside, "pyproject.toml", "hatch_build.py"} <= in_sdist


def test_the_cases_with_thirty_digits_are_in_the_repository_alone(in_wheel, in_sdist):
    handed_out = {*in_wheel, *in_sdist}
    assert not {name for name in handed_out if name.startswith("cases/") or name.endswith(".xz")}


def test_an_index_page_shows_no_link_that_leads_nowhere(metadata):
    assert metadata["Description-Content-Type"] == "text/markdown"
    page = str(metadata.get_payload(decode=True), "utf-8")
    assert page.startswith("# vad\n")
    targets = re.findall(r"\]\(([^)]+)\)", page)
    assert [each for each in targets if not each.startswith(("https://", "#"))] == []


def test_with_an_address_the_pictures_are_found():
    page = on_its_own((ROOT / "README.md").read_text("utf-8"), "https://example.org/vad")
    pictures = re.findall(r"!\[[^]]*\]\(([^)]+)\)", page)
    below = "https://example.org/vad/raw/main/"
    assert len(pictures) >= 2
    for picture in pictures:
        assert picture.startswith(below)
        assert (ROOT / picture.removeprefix(below)).is_file()


def test_the_links_of_the_readme_lead_somewhere():
    text = (ROOT / "README.md").read_text("utf-8")
    for target in re.findall(r"\]\(([^)#]+)[^)]*\)", text):
        assert "://" in target or (ROOT / target).exists(), target


def test_a_citation_names_this_version():
    fields = dict(re.findall(r"^(\w[\w-]*): *(.+)$", (ROOT / "CITATION.cff").read_text(), re.M))
    assert fields["version"] == vad.__version__
    assert fields["license"] == PROJECT["license"]


def test_each_extra_stands_in_the_table_of_the_readme_with_its_lowest_versions():
    table = (ROOT / "README.md").read_text("utf-8").partition("| extra |")[2].partition("\n\n")[0]
    for extra, packages in PROJECT["optional-dependencies"].items():
        assert f"`{extra}`" in table, extra
        own = (each for each in packages if not each.startswith("vad-diagrams["))
        assert all(">=" in each for each in own), extra

"""Say whether this tree can be released: ``python packaging/release.py [--tag v0.1.0]``.

It changes nothing.  It prints what is missing, a line each, and exits with 1 if anything is.
"""

from __future__ import annotations

import argparse
import datetime
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

from hatch_build import PLACEHOLDER  # noqa: E402

#: No mail arrives there: an address with this host waits for that of the maintainers.
NO_MAIL = "@example.org"
#: What a page says about an install as long as nothing is released.
BEFORE_A_RELEASE = {
    "README.md": "Once it is released",
    "docs/pages/install.md": "Once the package is released",
    "docs/pages/tutorial.md": "in the folder of the program",
}


def missing(root: Path, tag: str | None = None) -> Iterator[str]:
    """Yield what is missing for a release, in words.

    Parameters
    ----------
    root
        The folder of the project.
    tag
        The tag of the release, where there is one already.
    """
    project = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]
    for name, address in project.get("urls", {}).items():
        if PLACEHOLDER in address:
            yield f"pyproject.toml: project.urls.{name} is a placeholder: {address}"
    for name in ("SECURITY.md", "CODE_OF_CONDUCT.md"):
        if NO_MAIL in (root / name).read_text("utf-8"):
            yield f"{name}: the address of the maintainers is a placeholder"
    for name, words in BEFORE_A_RELEASE.items():
        if words in (root / name).read_text("utf-8"):
            yield f"{name}: says '{words}': write that `pip install vad-diagrams` installs it"
    version = _found(r'^__version__ = "(.+)"$', root / "vad" / "__init__.py")
    if tag is not None and tag != f"v{version}":
        yield f"the tag is {tag}, the version of vad is {version}: it must be v{version}"
    heading = _found(r"^## (.+)$", root / "CHANGELOG.md")
    today = datetime.date.today().isoformat()
    if not re.fullmatch(rf"{re.escape(version)} \(\d{{4}}-\d\d-\d\d\)", heading):
        yield f"CHANGELOG.md: begins with '{heading}', not with '{version} ({today})'"
    cited = _found(r"^version: (.+)$", root / "CITATION.cff")
    if cited != version:
        yield f"CITATION.cff: names the version {cited}, not {version}"
    recipe = _found(r'^  version: "(.+)"$', root / "packaging" / "recipe.yaml")
    if recipe != version:
        yield f"packaging/recipe.yaml: names the version {recipe}, not {version}"


def changed(root: Path) -> list[str]:
    """Return the files that are not as they were committed."""
    done = subprocess.run(
        ["git", "status", "--porcelain"], cwd=root, capture_output=True, text=True, check=True
    )
    return done.stdout.splitlines()


def _found(pattern: str, path: Path) -> str:
    match = re.search(pattern, path.read_text("utf-8"), re.MULTILINE)
    return match[1] if match else ""


def main() -> int:
    """Print what is missing; return 1 if anything is."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--tag", help="the tag of the release")
    wanted = [*missing(ROOT, parser.parse_args().tag)]
    wanted += [f"not committed: {line}" for line in changed(ROOT)]
    print("\n".join(wanted) or "ready to be released")
    return 1 if wanted else 0


if __name__ == "__main__":
    sys.exit(main())

"""Packages of other people: a tiny one is installed in a folder, and Python is called beside it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parents[1]


def install(folder: Path, name: str, modules: Mapping[str, str], entry_points: str) -> Path:
    """Install a package in a folder as an installer leaves it, and return the folder.

    Parameters
    ----------
    folder
        Where it is installed.
    name
        The name under which it is imported.
    modules
        The text of its modules by their names.
    entry_points
        The text of its ``entry_points.txt``.
    """
    package, metadata = folder / name, folder / f"{name}-1.0.dist-info"
    package.mkdir()
    metadata.mkdir()
    for module, text in {"__init__": "", **modules}.items():
        (package / f"{module}.py").write_text(text, "utf-8")
    title = name.replace("_", "-")
    (metadata / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {title}\nVersion: 1.0\n")
    (metadata / "entry_points.txt").write_text(entry_points)
    return folder


def call_beside(installed: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Call Python where a package is installed."""
    return subprocess.run(
        [sys.executable, *words],
        capture_output=True,
        text=True,
        cwd=installed,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(installed)])},
        timeout=120,
        check=False,
    )

"""How the tests of the command line call it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from vad.cli.run import run

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Result:
    """What one call left behind."""

    code: int
    out: str
    err: str


@pytest.fixture
def vad(capsys: pytest.CaptureFixture[str]) -> Callable[..., Result]:
    """Call the command line within this process."""

    def call(*words: str) -> Result:
        code = run(words)
        return Result(code, *capsys.readouterr())

    return call


@pytest.fixture
def environment() -> dict[str, str]:
    """Return the environment of a process that imports this very source tree."""
    return {**os.environ, "PYTHONPATH": str(ROOT)}


@pytest.fixture
def process(environment: dict[str, str]) -> Callable[..., Result]:
    """Call the command line in a process of its own."""

    def call(*words: str, **options: object) -> Result:
        done = subprocess.run(
            [sys.executable, "-m", "vad", *words],
            capture_output=True,
            text=True,
            env=environment,
            check=False,
            timeout=120,
            **options,
        )
        return Result(done.returncode, done.stdout, done.stderr)

    return call

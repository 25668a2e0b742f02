"""The manual page is that of today's commands, and man reads it."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from docs.manual import PAGE, manual
from vad.cli.app import app


def test_the_page_is_that_of_today() -> None:
    assert PAGE.read_text("utf-8") == manual(), "python -m docs.manual writes it anew"


@pytest.mark.skipif(shutil.which("nroff") is None, reason="there is no nroff")
def test_every_verb_is_read_without_a_warning() -> None:
    done = subprocess.run(
        ["nroff", "-man", "-ww", "-Tutf8", str(PAGE)], capture_output=True, text=True, check=True
    )
    assert done.stderr == ""
    page = re.sub(r".\x08", "", done.stdout)  # bold letters are struck twice
    for verb in app.all_commands():
        assert f"VAD {verb.upper()}" in page
    assert "--omega" in page

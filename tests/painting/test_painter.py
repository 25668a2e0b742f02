"""How marks look to every painter."""

from __future__ import annotations

from dataclasses import replace

import pytest

from vad.painting.painter import Looks
from vad.plan.lettering.runs import roman
from vad.plan.marks import Lettering, Mark
from vad.plan.pictures.dimming import PALE
from vad.style import load_style, style_names


@pytest.mark.parametrize("style", style_names())
def test_the_halo_of_letters_is_gone_before_they_are(style: str) -> None:
    """A number that fades on a link would hide the letters there as long as it is not gone."""
    looks, number = Looks(load_style(style)), Mark(Lettering(roman("4.793"), 0j, 0.03), "tag", 0)
    whole = looks(number)
    pale, fading = (looks(replace(number, alpha=ink)) for ink in (PALE, 0.2))
    assert whole.under and pale == replace(whole, alpha=PALE)
    assert fading == replace(whole, under=None, alpha=0.2)

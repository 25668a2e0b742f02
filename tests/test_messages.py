"""What an error says: on one line, with names that help, and no more of a value than is read."""

from __future__ import annotations

import pickle

import pytest

from vad.errors import InputError, UsageError, VadError, one_of, quoted, unknown

OPTIONS = ["--ground", "--omega", "--output", "--size", "--style"]


@pytest.mark.parametrize("text", ["two\nlines", "a\r\nb", "\x1b[31mred", "a\u2028b", "\udc80"])
def test_any_message_is_one_line_that_can_be_printed(text):
    error = VadError(f"crank: {text}", hint=f"try {text}")
    for line in (str(error), error.hint):
        assert line.isprintable()
        assert len(line.splitlines()) == 1


def test_a_message_keeps_its_beginning_and_its_end():
    error = InputError("crank: " + "9" * 130_000 + " is not a number")
    assert str(error).startswith("crank: 999")
    assert str(error).endswith("999 is not a number")
    assert len(str(error)) == 500


def test_an_error_survives_the_way_between_processes():
    error = pickle.loads(pickle.dumps(UsageError("crank: no", hint="try 40")))
    assert (type(error), str(error), error.hint) == (UsageError, "crank: no", "try 40")


@pytest.mark.parametrize(
    ("given", "hint"),
    [
        ("--o", "did you mean '--omega' or '--output'?"),
        ("--st", "did you mean '--style'?"),
        ("--omgea", "did you mean '--omega'?"),
        ("--SIZE", "did you mean '--size'?"),
        ("-", "known: " + ", ".join(OPTIONS)),
        ("", "known: " + ", ".join(OPTIONS)),
        (0, "known: " + ", ".join(OPTIONS)),
        (None, "known: " + ", ".join(OPTIONS)),
    ],
)
def test_the_names_that_may_be_meant(given, hint):
    assert unknown("option", given, OPTIONS).hint == hint


@pytest.mark.parametrize("given", [0, None, [], {}, ["--size"], b"--size", float("nan"), object()])
def test_what_is_no_name_is_none_of_the_known(given):
    with pytest.raises(UsageError, match=r"^unknown option "):
        one_of("option", given, OPTIONS)


def test_a_value_that_cannot_say_what_it_is():
    class Mute:
        def __repr__(self):
            raise RuntimeError

    assert quoted(Mute()) == "a Mute"
    assert quoted(10**5000) == "an int"

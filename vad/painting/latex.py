"""Words for LaTeX: runs of letters become text and mathematics, which LaTeX sets in its own fonts.

Only commands of plain LaTeX are used.  A letter that is none of Latin or Greek stands as it is, for
LuaLaTeX or XeLaTeX with a font that has it.
"""

from __future__ import annotations

import re

from vad.plan.lettering.runs import DOTS, Run, Runs

_GREEK = {
    **dict(zip("αβγδεζηθικλμνξπρστυφχψω", (
        *("alpha", "beta", "gamma", "delta", "varepsilon", "zeta", "eta", "theta", "iota"),
        *("kappa", "lambda", "mu", "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "varphi"),
        *("chi", "psi", "omega"),
    ), strict=True)),
    **dict(zip("ΓΔΘΛΞΠΣΥΦΨΩ", (
        *("Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi"),
        "Omega",
    ), strict=True)),
    "ς": "varsigma", "ϑ": "vartheta", "ϕ": "phi", "ϵ": "epsilon", "µ": "mu",
}  # fmt: skip
#: Signs that LaTeX has in mathematics only.
_MATHS = {
    **{letter: f"\\{name} " for letter, name in _GREEK.items()},
    **{"′": "'", "″": "''", "−": "-", "×": r"\times ", "·": r"\cdot ", "°": r"{}^\circ "},
    **{"⟂": r"\perp ", "∥": r"\parallel ", "∠": r"\angle ", "→": r"\to ", "←": r"\gets "},
    **{"±": r"\pm ", "∞": r"\infty ", "≈": r"\approx ", "≤": r"\le ", "≥": r"\ge ", "≠": r"\ne "},
    **{"∑": r"\sum ", "∫": r"\int ", "√": r"\surd ", "↦": r"\mapsto ", "↺": r"\circlearrowleft "},
    **{"↻": r"\circlearrowright ", "<": "<", ">": ">"},
}
#: Signs of text that LaTeX would read as something else, and those without a key.
_TEXT = {
    **{sign: f"\\{sign}" for sign in "{}$&#_%"},
    **{"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"},
    **{"|": r"\textbar{}", "\N{NO-BREAK SPACE}": "~", "\N{NARROW NO-BREAK SPACE}": r"\,"},
    **{"\N{THIN SPACE}": r"\,", "–": "--", "—": "---", "…": r"\dots{}", '"': r"\textquotedbl{}"},
}
_ACCENTS = dict(zip(DOTS, (r"\dot", r"\ddot"), strict=True))
_SPACES = re.compile(r" {2,}")


def latex_of(runs: Runs) -> str:
    r"""Return a line of text for LaTeX.

    Examples
    --------
    >>> from vad.plan.lettering.runs import roman, symbols
    >>> print(latex_of(symbols("b′cₙ")), latex_of(roman("3005 mm/s², 45°")))
    $b'c_{n}$ 3005 mm/s${}^{2}$, 45${}^\circ $
    >>> print(latex_of(roman("50 % & more_or_less")))
    50 \% \& more\_or\_less
    """
    pieces: list[tuple[bool, str]] = []  # whether it is mathematics, and what stands there
    scripted = 0
    for run in runs:
        found = _script(run, scripted) if run.script else _line(run)
        scripted = run.script
        if run.text[:1] in _ACCENTS and not run.script and pieces:
            pieces[-1] = _accented(pieces[-1], _ACCENTS[run.text[0]])
            found = _line(Run(run.text[1:], run.face))
        pieces += found if run.shown else [(False, rf"\phantom{{{_joined(found)}}}")]
    text = _joined(pieces)
    if any(run.face in ("bold", "bolditalic") for run in runs):
        return rf"{{\bfseries\boldmath {text}}}"
    return text


def _line(run: Run) -> list[tuple[bool, str]]:
    """Return the pieces of a run on the line."""
    italic = run.face in ("italic", "bolditalic")
    found = []
    for sign in run.text:
        if sign in _MATHS:
            found.append((True, _MATHS[sign]))
        elif italic and sign.isascii() and sign.isalnum():
            found.append((True, sign))
        else:
            found.append((False, _TEXT.get(sign, sign)))
    return found


def _script(run: Run, before: int) -> list[tuple[bool, str]]:
    """Return a run above or below the line; ``{}`` bears it where there is one already."""
    inside = "".join(
        _MATHS.get(sign, sign if run.face != "roman" or sign.isdigit() else rf"\mathrm{{{sign}}}")
        for sign in run.text
    )
    base = "{}" if before or run.script > 0 else ""
    return [(True, f"{base}{'^' if run.script > 0 else '_'}{{{inside}}}")]


def _accented(piece: tuple[bool, str], accent: str) -> tuple[bool, str]:
    """Return the last letter of a piece with a dot or two above it."""
    _, text = piece
    whole = text.rstrip()
    at = whole.rfind("\\") if whole.startswith("\\") else len(whole) - 1
    return True, f"{whole[:at]}{accent}{{{whole[at:]}}}"


def _joined(pieces: list[tuple[bool, str]]) -> str:
    """Return pieces in one line, with dollars about what is mathematics."""
    found, inside = "", False
    for maths, text in pieces:
        if maths != inside:
            found, inside = found + "$", maths
        found += text
    found += "$" if inside else ""
    return _SPACES.sub(lambda spaces: r"\quad " if len(spaces[0]) > 2 else r"\enspace ", found)

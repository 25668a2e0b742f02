"""How the program does on its own cases: ``python -m cases.summary`` writes it into README.md."""

from __future__ import annotations

from cases.answer import answers
from cases.check import HERE, MECHANISMS, Found, cases, check, quantity

GROUPS = (
    ("position", "angle"),
    ("velocity", "omega"),
    ("acceleration", "coriolis"),
    ("alpha",),
)
README = HERE / "README.md"
HEAD = "|---|---|---|---|---|---|---|---|\n"


def line(mechanism: str) -> str:
    """Return the line of a mechanism."""
    rows = list(cases(mechanism))
    found = check(rows, answers(mechanism, rows))
    counts = [len(rows)]
    counts += [sum(x.answers for x in found.values()), sum(x.beyond for x in found.values())]
    cells = [f"`{mechanism}`", *(f"{count:,}" for count in counts)]
    return f"| {' | '.join([*cells, *(worst(found, group) for group in GROUPS)])} |\n"


def worst(found: dict[str, Found], group: tuple[str, ...]) -> str:
    """Return the largest error of some quantities in ε·κ."""
    sizes = [each.worst for name, each in found.items() if quantity(name) in group]
    return f"{max(sizes):.3g}" if sizes else ""


def main() -> None:
    """Write the table anew."""
    before, _, rest = README.read_text("utf-8").partition(HEAD)
    after = rest[rest.index("\n## ") :] if not rest.startswith("\n## ") else rest
    table = "".join(map(line, MECHANISMS))
    README.write_text(f"{before}{HEAD}{table}{after}", "utf-8")


if __name__ == "__main__":
    main()

"""``python -m benchmarks.errors``: look for the largest errors, for so many seconds.

--seed S       where the random numbers begin
--seconds N    how long to look, for each of the kinds
--results N    or how many results to compare, at most
--only KIND    planar, chains, space or examples
--findings F   append what is beyond its bound to a file
--table        know the worst of each result exactly, and write the table of the errors anew

It fails where more than one result in a million is beyond its bound, but for the classes of which
the accuracy page says so.
"""

from __future__ import annotations

import argparse
import sys
import time

import gmpy2

from benchmarks.errors import chains, examples, plane, space, table
from benchmarks.errors.tally import Tally
from tests.kinematics.families import SAMPLERS

KINDS = {"planar": plane, "chains": chains, "space": space, "examples": examples}

MECHANISMS = {
    "planar": {name for name, _ in SAMPLERS.values()},
    "chains": {table.CHAINS},
    "space": set(space.KINDS),
    "examples": {f"{name}.toml" for name in examples.NAMES},
}
#: Of so many results one may be beyond its bound.
ALLOWED = 1e6
#: Where double precision cannot hold them: docs/pages/explanation/accuracy.md has the figures.
NOT_HELD = {("chains", "four decades")}
NOT_HELD |= {("spherical-four-bar", "coincidence"), ("spatial-four-bar", "coincidence")}


def look(
    kind: str, seed: int, seconds: float, results: float = float("inf"), exactly: bool = False
) -> Tally:
    """Compare random poses until the time or the number is used up.

    To know the worst ``exactly`` takes longer, and begins with the poses of the table.
    """
    module, tally = KINDS[kind], Tally(exactly=exactly)
    end = time.monotonic() + seconds
    with gmpy2.context(gmpy2.get_context(), trap_divzero=True):
        if exactly:
            for name, given in table.known(MECHANISMS[kind]):
                module.compare(tally, *module.again(name, given))
        for family, drawn in module.poses(seed):
            if time.monotonic() > end or tally.results >= results:
                break
            module.compare(tally, family, drawn)
    return tally


def report(kind: str, tally: Tally) -> None:
    """Print what was found: a line for each class of errors, and one for each result."""
    beyond = sum(tally.beyond.values())
    print(f"{kind}: {tally.poses} poses, {tally.results} results, {beyond} beyond their bounds")
    for (what, name), count in sorted(tally.others.items()):
        print(f"    {count} poses of {name}: {what}")
    for (name, family), count in sorted(tally.families.items()):
        print(f"    {count} results of {name}, {family}: {tally.beyond[name, family]} beyond")
    for (name, part, quantity), record in sorted(tally.records.items()):
        if record.worst:
            print(f"  {name:20} {part:20} {quantity:12} {record.worst:8.3g} {record.where}")


def broken(tally: Tally) -> bool:
    """Say whether more results are beyond their bounds than are allowed."""
    return any(
        tally.beyond[place] > 1 + count / ALLOWED
        for place, count in tally.families.items()
        if place not in NOT_HELD
    )


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.errors",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--results", type=float, default=float("inf"))
    parser.add_argument("--only", choices=KINDS)
    parser.add_argument("--findings")
    parser.add_argument("--table", action="store_true")
    given = parser.parse_args()
    failed = False
    for kind in [given.only] if given.only else KINDS:
        tally = look(kind, given.seed, given.seconds, given.results, given.table)
        if given.table:
            table.write(MECHANISMS[kind], tally)
        report(kind, tally)
        failed = failed or broken(tally)
        if given.findings:
            with open(given.findings, "a", encoding="utf-8") as file:
                file.writelines(f"{text}\n" for text in tally.texts())
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())

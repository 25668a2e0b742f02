"""How large the errors of random chains of three to five dyads are, in units of ε·κ.

``python -m benchmarks.chains [CHAINS [FIRST]]`` prints the worst of each quantity and the chain in
which it occurs; ``tests/kinematics/test_chains.py`` looks at a few of them.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator

from tests.kinematics.chains import KINDS, STARTS, Chain, errors
from tests.kinematics.families import Draw
from tests.kinematics.worst_cases import BOUNDS


def chains(count: int, first: int = 0) -> Iterator[tuple[str, Chain]]:
    """Yield random chains with what they are made of."""
    for seed in range(first, first + count):
        draw = Draw(str(seed))
        kinds = [draw.choice(KINDS) for _ in range(draw.randint(3, 5))]
        start = draw.choice(STARTS)
        yield f"{seed}: {', '.join([start, *kinds])}", Chain(draw, start, kinds)


def main(count: int = 1000, first: int = 0) -> None:
    """Print the worst error of each quantity."""
    worst = {quantity: (0.0, "") for quantity in BOUNDS}
    beyond = total = 0
    for name, chain in chains(count, first):
        for key, size in errors(chain):
            total += 1
            beyond += not size <= BOUNDS[key[2]]
            worst[key[2]] = max(worst[key[2]], (size, f"{' '.join(key[:2])} of {name}"))
    print(f"{count} chains, {total} quantities, {beyond} beyond their bounds")
    for quantity, (size, where) in worst.items():
        print(f"{quantity:14}{size:10.3g}{BOUNDS[quantity]:6}  {where}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))

"""How large the errors are: random mechanisms against a hundred digits, by the million.

``python -m benchmarks.errors --seconds 60`` draws mechanisms in the plane, chains of dyads and
mechanisms in space, solves each with the program and with an oracle, and keeps the worst of
every result.  The oracles know the loop equations alone.  They find the pose by Newton's method
and the rates from power series in time: no closed form of the program is in them.
"""

"""Poses of which plainer formulas say something that is beyond its bound, one of each class.

Their truth is Newton's method with a hundred digits on two walks along the axes.
"""

from __future__ import annotations

import json

import gmpy2
import pytest

from benchmarks.errors import space
from benchmarks.errors.tally import Tally

SPHERICAL, SPATIAL, BALLS = "spherical-four-bar", "spatial-four-bar", "rssr"
POSES = {
    "a crank that hardly turns its pin": (
        SPHERICAL,
        '{"ground": 23.772550420279728, "crank": 1.153067270097678e-11, '
        '"coupler": 52.999015109555515, "rocker": 43.86074409342007, "angle": 459.2965482190556, '
        '"omega": 7.28293185101006, "alpha": -33.55273430712602, "assembly": "crossed"}',
    ),
    "a ground that is almost nothing": (
        SPHERICAL,
        '{"ground": 0.0007623486989307617, "crank": 168.56011555250365, '
        '"coupler": 77.22867916268589, "rocker": 103.28888027100788, '
        '"angle": -55.73463779956256, "omega": 0.3425263814395965, "alpha": 0.0, '
        '"assembly": "crossed"}',
    ),
    "an angle at C that turns evenly": (
        SPHERICAL,
        '{"ground": 90.0, "crank": 90.0, "coupler": 89.99987642022202, '
        '"rocker": 90.00002968505099, "angle": 120.0, "omega": 0.2972459633698619, '
        '"alpha": 0.0, "assembly": "open"}',
    ),
    "a crank twisted by almost nothing": (
        SPATIAL,
        '{"ground": 33.17464328314715, "crank": -35.09231065169323, '
        '"coupler": -40.606415497136524, "rocker": -57.84074855725096, '
        '"ground_twist": 122.71907800200283, "crank_twist": 1.7287568767270596e-12, '
        '"coupler_twist": 49.26321167173572, "rocker_twist": 157.62510330654231, '
        '"angle": 379.5234363393039, "omega": -0.5625943216646222, '
        '"alpha": 38.89875378255126, "assembly": "crossed"}',
    ),
    "a ground twisted by almost nothing": (
        SPATIAL,
        '{"ground": 0.0, "crank": 0.0, "coupler": -19.902810376223954, '
        '"rocker": -32.763432282731934, "ground_twist": 1.9150966979940788e-11, '
        '"crank_twist": 124.13818384098661, "coupler_twist": 47.63506479323841, '
        '"rocker_twist": 114.65287284689413, "angle": 84.53396113946741, '
        '"omega": -0.21266015606492586, "alpha": 715.852560229134, "assembly": "crossed"}',
    ),
    "a ground twisted by almost nothing, and a fast start": (
        SPATIAL,
        '{"ground": 0.0, "crank": -12.441981118970602, "coupler": 83.32054502083628, '
        '"rocker": 0.0, "ground_twist": 2.2053619064751855e-08, '
        '"crank_twist": 161.49174124505362, "coupler_twist": 114.31586172959207, '
        '"rocker_twist": 55.49902551265545, "angle": -61.05842736840225, '
        '"omega": -0.34482631026306515, "alpha": -2638.071487310488, "assembly": "open"}',
    ),
    "a rocker that turns almost with the crank": (
        SPATIAL,
        '{"ground": -57.3358250849024, "crank": -24.085258436333373, "coupler": 0.0, '
        '"rocker": 12.256078192431124, "ground_twist": 1.3213220850022425e-05, '
        '"crank_twist": 0.7920715159778207, "coupler_twist": 83.33308149501417, '
        '"rocker_twist": 83.72342588748592, "angle": 605.73358315627, '
        '"omega": -0.7223564518327942, "alpha": 0.0, "assembly": "open"}',
    ),
    "a dead centre across, but for the last digits": (
        SPATIAL,
        '{"ground": 87.09581283758972, "crank": -17.383557086214047, '
        '"coupler": 56.7833761127184, "rocker": 0.0, "ground_twist": 102.78632157256999, '
        '"crank_twist": 84.48580769624274, "coupler_twist": 9.463324429308656, '
        '"rocker_twist": 103.51758795739704, "angle": 267.08082459353443, '
        '"omega": 5.416015079044581, "alpha": -2621.5213696580377, "assembly": "crossed"}',
    ),
    "twists that are almost half a turn": (
        SPATIAL,
        '{"ground": 79.83065542634994, "crank": -77.55165044436303, '
        '"coupler": 43.32642816288258, "rocker": 18.889132591519804, '
        '"ground_twist": 7.530253787930301, "crank_twist": 5.542076385728327, '
        '"coupler_twist": 169.0809761687942, "rocker_twist": 168.87456464397178, '
        '"angle": -271.73812214761267, "omega": -68.62235005935557, "alpha": 0.0, '
        '"assembly": "open"}',
    ),
    "a dead centre, but for the last digits": (
        SPATIAL,
        '{"ground": 23.939058550479515, "crank": -21.838624773724913, '
        '"coupler": 83.95787912135533, "rocker": -10.520733596577475, '
        '"ground_twist": 20.319433048431883, "crank_twist": 163.77559193582894, '
        '"coupler_twist": 60.22946605400328, "rocker_twist": 115.48354267820784, '
        '"angle": 184.07143528060703, "omega": -0.11121687602445285, "alpha": 0.0, '
        '"assembly": "crossed"}',
    ),
    "twists that are almost right angles": (
        SPATIAL,
        '{"ground": 7.999999999997948, "crank": 0.1, "coupler": 3.999999999837715, '
        '"rocker": -2.0, "ground_twist": 90.0, "crank_twist": 90.0, "coupler_twist": 90.0, '
        '"rocker_twist": 90.00000018974781, "angle": 45.0, "omega": -28.848585195067717, '
        '"alpha": 0.0, "assembly": "open"}',
    ),
    "circles about one axis": (
        BALLS,
        '{"crank": 41.80980034596126, "coupler": 71.98189057838974, '
        '"rocker": 52.715511552409886, "ground": 0.0, "crank_offset": 0.0, '
        '"rocker_offset": -41.03880809327005, "ground_twist": 1.2689705506495863e-12, '
        '"angle": 73.39217551759378, "omega": 0.17030285840794174, "alpha": 0.0, '
        '"assembly": "crossed"}',
    ),
    "circles about one axis, in one plane": (
        BALLS,
        '{"crank": 12.954830160773984, "coupler": 56.7121952490568, '
        '"rocker": 64.07119462963583, "ground": 0.0, "crank_offset": 0.0, "rocker_offset": 0.0, '
        '"ground_twist": 2.8513622258834577e-05, "angle": 602.8989067728131, '
        '"omega": -0.2484422264520963, "alpha": 0.0, "assembly": "crossed"}',
    ),
    "circles about one axis, turned over": (
        BALLS,
        '{"crank": 68.71814363117163, "coupler": 20.461897328273455, '
        '"rocker": 57.235865702563316, "ground": 0.0, "crank_offset": 0.0, "rocker_offset": 0.0, '
        '"ground_twist": -179.9999935306792, "angle": -267.7327784219365, '
        '"omega": -5.629865977731899, "alpha": 0.0, "assembly": "open"}',
    ),
}


@pytest.mark.parametrize("what", POSES)
def test_nothing_is_beyond_its_bound(what: str) -> None:
    name, text = POSES[what]
    tally = Tally()
    with gmpy2.context(gmpy2.get_context(), trap_divzero=True):
        space.compare(tally, *space.again(name, json.loads(text)))
    assert tally.results > 10
    assert not tally.texts()

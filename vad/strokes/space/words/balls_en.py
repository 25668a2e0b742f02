"""What the teacher says of the ball-jointed four-bar, in English."""

PHRASES = {
    # position
    "balls A": "Below, the crank as seen along the axis of A.",
    "balls crank path": "There B runs on a circle in true shape.",
    "balls crank": "The crank AB = {size} {unit} stands at {angle}°.",
    "balls crank angle": "Its angle is measured from the common normal of both axes.",
    "balls D": "Above, the rocker as seen along the axis of D.",
    "balls rocker path": "There C runs on a circle in true shape.",
    "balls A front": "A in this view.",
    "balls B front": "B in this view: straight above.",
    "balls AB front": "The crank in this view.",
    "balls compass": (
        "B stands {height} {unit} {side} the plane of the circle of C: seen from here, C is "
        "√({size}² − {height}²) = {reach} {unit} from B."
    ),
    "balls C": "C is where both circles meet.",
    "balls BC front": "The coupler BC.",
    "balls rocker": "The rocker DC stands at {theta} = {angle}°.",
    "balls rocker angle": "Its angle is measured from the common normal, too.",
    "balls C top": "C in the view below: straight below.",
    "balls D top": "D in the view below.",
    "balls DC top": "The rocker in the view below, its circle on edge or at a slant.",
    "balls BC top": "The coupler in the view below.",
    "balls BC third": (
        "To the right, seen square to BC and to the path of C: both are there in true length."
    ),
    "balls plane": "The plane through B square to BC is there seen as a line.",
    "balls line": "The path of C: its velocity lies along this line.",
    "balls ahead": "in front of",
    "balls behind": "behind",
    "balls front": "seen along D",
    "balls top": "seen along A",
    "balls third": "BC and path of C in true length",
    # polygons
    "balls path": "path of C",
    "balls remark": "seen as BC to the right of the views; the coupler does not spin about BC",
    "balls tangential velocity": (
        "{label} is the velocity of B, {symbol}·{ends} = {rate} × {size} = {value} {unit}: this "
        "view sees {seen} {unit} of it."
    ),
    "balls tangential acceleration": (
        "{label} is {symbol}·{ends} = {rate} × {size} = {value} {unit}, square to {ends}: this "
        "view sees {seen} {unit} of it."
    ),
    "balls normal": (
        "{label} is {symbol}²·{ends} = {rate} × {size} = {value} {unit}, from {head} towards "
        "{tail}: this view sees {seen} {unit} of it."
    ),
    "balls normal BC": (
        "{label} = {speed}/{size} = {seen} {unit}, the square of the velocity of C relative to B "
        "over BC, from C towards B in true length."
    ),
    "balls line BC velocity": (
        "Through {point}, perpendicular to BC: the coupler keeps its length, so {meeting} lies in "
        "a plane square to BC, which is this line."
    ),
    "balls line DC velocity": (
        "Through {point}, parallel to the path of C: C can move no other way, so {meeting} lies on "
        "this line, which is in true length."
    ),
    "balls line BC acceleration": (
        "Through {point}, perpendicular to BC: along BC all is laid off, so {meeting} lies in a "
        "plane square to BC, which is this line."
    ),
    "balls line DC acceleration": (
        "Through {point}, parallel to the path of C: the tangential part {symbol}·DC is not known "
        "yet, so {meeting} lies on this line."
    ),
    "balls coupler velocity": (
        "{label} = {value} {unit} here and {off} {unit} off the paper: together {whole} {unit}, so "
        "{symbol} = {whole}/{size} = {rate} rad/s."
    ),
    "balls coupler acceleration": (
        "{label} = {value} {unit} here and {off} {unit} off the paper: together {whole} {unit}, so "
        "{symbol} = {whole}/{size} = {rate} rad/s²."
    ),
    "balls rocker velocity": (
        "{label} = {value} {unit} is the velocity of C, so {symbol} = {label}/DC = {value}/{size} "
        "= {rate} rad/s, {sense}."
    ),
    "balls rocker acceleration": (
        "{label} = {value} {unit}, so {symbol} = {label}/DC = {value}/{size} = {rate} rad/s², "
        "{sense}."
    ),
    "balls whole": "{label} = {value} {unit} in this view, {whose}.",
}

NAMES = {
    "ground_twist": "twist",
    "crank_offset": "crank offset",
    "rocker_offset": "rocker offset",
}

GENDERS: dict[str, str] = {}

"""What the teacher says, in English."""

PHRASES = {
    # the page
    "results": "Results",
    "given": "given",
    "coriolis rule": "Coriolis: v turned 90° with ω",
    # a turn
    "stroke": "stroke",
    "forward": "forward",
    "return": "return",
    "ratio": "ratio",
    "swings": "{part} swings between {low} and {high}",
    "slides": "{part} moves between {low} and {high}",
    # position
    "fixed": "{letter} is a fixed pivot.",
    "fixed point": "{letter}, where the guides cross, is fixed.",
    "guide": "{head} can only move along its guide.",
    "slot": "{head} slides in the slot of the {link}.",
    "driven bar": "The {link} {bar} = {size} {unit} stands at {angle}.",
    "driven slide": "{head} stands at {value} {unit} on its guide.",
    "angle": "The angle of the {link}, measured counter-clockwise from the x axis.",
    "compass": "{head} lies on the circle about {tail} with radius {bar} = {size} {unit}.",
    "lever line": "The {link} from {tail} passes through {pin}.",
    "slot line": "{head} lies below or above {pin}, in the direction of the slot.",
    "found": "{letter} is where they meet.",
    "on guide": "{letter} is where the circle meets the guide.",
    "on lever": "{letter} is the point of the {link} under {pin}.",
    "bar": "The {link} {bar}: θ = {angle}.",
    "block": "The {slide} {head}: {symbol} = {value} {unit}.",
    "tip": "{letter} lies on the {link}, {size} {unit} from {tail}.",
    "tip against": "{letter} lies on the {link}, {size} {unit} from {tail} on the other side.",
    # polygons
    "pole velocity": "The pole: every fixed point has the velocity zero, so {letters} lie here.",
    "pole acceleration": "The pole: fixed points have no acceleration, so {letters} lie here.",
    "pole velocity one": "The pole: the fixed point {letters} has the velocity zero.",
    "pole acceleration one": "The pole: the fixed point {letters} has no acceleration.",
    "still": "The driver stands still, and so does everything else: the polygon is its pole.",
    "tangential velocity": "{label} = {omega}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar}",
    "normal": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, from {head} towards {tail}"
    ),
    "tangential acceleration": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar}"
    ),
    "sliding velocity": "{label} = {value} {unit}, {way}, the given velocity along {line}",
    "sliding acceleration": "{label} = {value} {unit}, {way}, the given acceleration along {line}",
    "coriolis": (
        "{label} = 2·{omega}·v = 2 × {rate} × {speed} = {value} {unit}, v turned 90° with {omega}"
    ),
    "across velocity": (
        "Through {point}, perpendicular to {bar}: relative to {tail}, {head} can move no other "
        "way, so {meeting} lies on this line."
    ),
    "across velocity strut": (
        "Through {point}, perpendicular to {bar}: besides sliding along {bar}, {head} can only "
        "move across it, so {meeting} lies on this line."
    ),
    "across acceleration": (
        "Through {point}, perpendicular to {bar}: the tangential part {alpha}·{bar} is not known "
        "yet, so {meeting} lies on this line."
    ),
    "along velocity": (
        "Through {point}, parallel to {line}: the {slide} can move no other way, so {meeting} "
        "lies on this line."
    ),
    "along velocity slot": (
        "Through {point}, parallel to {line}: in the slot the {slide} can move no other way, so "
        "{meeting} lies on this line."
    ),
    "along velocity link": (
        "Through {point}, parallel to {line}: on the {link} the {slide} can move no other way, so "
        "{meeting} lies on this line."
    ),
    "along acceleration": (
        "Through {point}, parallel to {line}: the sliding part is not known yet, so {meeting} "
        "lies on this line."
    ),
    "crossing": "Where the two lines cross lies {letter}.",
    "pole crossing": "Where the two lines cross lies the pole {letter}: that point stands still.",
    "measured omega": (
        "{label} = {value} {unit}, so {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: {head} moves {way} as seen from {tail}."
    ),
    "measured omega strut": (
        "{label} = {value} {unit}, so {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: across {bar}, {head} moves {way}."
    ),
    "measured alpha": (
        "{label} = {value} {unit}, so {alpha} = {label}/{bar} = {value}/{size} = {rate} rad/s², "
        "{sense}."
    ),
    "measured sliding velocity": (
        "{label} = {value} {unit}: the {slide} slides {way}, {symbol} = {rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way}: the {slide} has {symbol} = {rate} {unit}."
    ),
    "whole relative": "{label} = {value} {unit}, the acceleration of {head} relative to {tail}.",
    "whole absolute": "{label} = {value} {unit}, the acceleration of {head}.",
    "image": (
        "{letter} by the image: {part}/{whole} = {bar}/{base} = {size}/{length}; "
        "{label} = {value} {unit}"
    ),
    "image against": (
        "{letter} by the image, on the other side: {part}/{whole} = {bar}/{base} = "
        "{size}/{length}; {label} = {value} {unit}"
    ),
    # words
    "the pole": "the pole",
    "the guide": "the guide",
    "the guide of": "the guide of {head}",
    "the slot": "the slot",
    "the link": "the {link}",
    "∥ guide": "∥ guide",
    "∥ guide of": "∥ guide of {head}",
    "∥ slot": "∥ slot",
    "∥ link": "∥ {link}",
    "counter-clockwise": "counter-clockwise",
    "clockwise": "clockwise",
    "right": "to the right",
    "left": "to the left",
    "up": "upwards",
    "down": "downwards",
}

#: Names of links and slides that differ from the program's own.
NAMES: dict[str, str] = {}

#: The article that is also the name of a point, which stands in italics.
ARTICLE = "a"

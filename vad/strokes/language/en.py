"""What the teacher says, in English."""

PHRASES = {
    # the page
    "results": "Results",
    "given": "given",
    "colon": ": ",
    "legend": "grey: given",
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
    "fixed point": "{letter} is a fixed point.",
    "guides cross": "{letter}, where the guides cross, is fixed.",
    "guide": "{head} can only move along its guide.",
    "guide point": "{head} can only move along its guide; {tail} is a fixed point of the guide.",
    "slot": "{head} slides in the slot of the {link}.",
    "driven bar": "The {link} {bar} = {size} {unit} stands at {angle}°.",
    "driven slide": "The {slide} {head} stands at {symbol} = {value} {unit} on its guide.",
    "driven slide from": (
        "The {slide} {head} stands at {symbol} = {value} {unit} on its guide, measured from {tail}."
    ),
    "angle": "The angle of the {link} is measured counter-clockwise from the x axis.",
    "compass": "{head} lies on the circle about {tail} with radius {bar} = {size} {unit}.",
    "compass strut": (
        "{head} lies on the circle about {tail} with radius {bar} = {size} {unit}, the given "
        "length of the {link}."
    ),
    "lever line": "The {link} from {tail} passes through {pin}.",
    "slot line": "The slot of the {link} passes through {pin}, and {head} lies on its line.",
    "found": "{letter} is where they meet.",
    "arcs cross": "{letter} is where the two arcs cross.",
    "on guide": "{letter} is where the arc meets the guide.",
    "on slot": "{letter} is where the line of the slot meets the guide.",
    "on lever": "{letter} is the point of the {link} that lies under {pin} in this pose.",
    "bar": "The {link} {bar} stands at {symbol} = {angle}°.",
    "block": "The {slide} {head} stands at {symbol} = {value} {unit}.",
    "block from": "The {slide} {head} stands at {symbol} = {value} {unit}, measured from {tail}.",
    "plate": "The {link} is one rigid piece with the corners {corners}.",
    "third point": "{letter} is where the two arcs cross: the triangle {corners} keeps its sense.",
    "on link slot": "{letter} is where the arc meets the line of the slot.",
    "in slot": "{head} lies on the line of the slot of the {link}.",
    "tip": "{letter} lies on the {link}, {size} {unit} from {tail}.",
    "tip against": "{letter} lies on the {link}, {size} {unit} from {tail} on the other side.",
    # polygons
    "pole velocity": "The pole: every fixed point has zero velocity, so {letters} lie here.",
    "pole acceleration": (
        "The pole: every fixed point has zero acceleration, so {letters} lie here."
    ),
    "pole velocity one": (
        "The pole: the fixed point {point} has zero velocity, so {letters} lies here."
    ),
    "pole acceleration one": (
        "The pole: the fixed point {point} has zero acceleration, so {letters} lies here."
    ),
    "on the guide": "{letter} ({point} on the guide)",
    "still": "The driver stands still, and so does everything else: the polygon is its pole.",
    "velocity of": "the velocity of {head}",
    "velocity of relative": "the velocity of {head} relative to {tail}",
    "acceleration of": "the acceleration of {head}",
    "acceleration of relative": "the acceleration of {head} relative to {tail}",
    "tangential velocity whole": (
        "{label} = {omega}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} in the sense of "
        "{omega}: {whose}."
    ),
    "normal": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, from {head} towards {tail}."
    ),
    "normal whole": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, from {head} towards {tail}: "
        "{whose}."
    ),
    "tangential acceleration": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} in the sense of "
        "{alpha}."
    ),
    "tangential acceleration whole": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} in the sense of "
        "{alpha}: {whose}."
    ),
    "sliding velocity": "{label} = {value} {unit}, {way}: the given velocity along the {line}.",
    "sliding acceleration": (
        "{label} = {value} {unit}, {way}: the given acceleration along the {line}."
    ),
    "coriolis": (
        "{label} = 2·{omega}·v = 2 × {rate} × {speed} = {value} {unit}, v turned 90° with {omega}."
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
        "Through {point}, parallel to the {line}: the {slide} {head} can move no other way, so "
        "{meeting} lies on this line."
    ),
    "along velocity slot": (
        "Through {point}, parallel to the {line}: in the {line} the {slide} {head} can move no "
        "other way, so {meeting} lies on this line."
    ),
    "along velocity link": (
        "Through {point}, parallel to the {line}: on the {line} the {slide} {head} can move no "
        "other way, so {meeting} lies on this line."
    ),
    "along acceleration": (
        "Through {point}, parallel to the {line}: the sliding part is not known yet, so {meeting} "
        "lies on this line."
    ),
    "crossing": "{letter} is where the two lines cross.",
    "crossing zero": "{letter} is where the two lines cross: {found}.",
    "zero": "at {point}, so {symbol} is zero",
    "pole crossing": "The pole {letter} is where the two lines cross: {point} stands still.",
    "measured omega": (
        "{label} = {value} {unit}, so {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: {head} moves {way} as seen from {tail}."
    ),
    "measured omega absolute": (
        "{label} = {value} {unit}, so {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: {label} is the velocity of {head}, {way}."
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
        "{label} = {value} {unit}: the {slide} {head} slides {way} along the {line}, "
        "{symbol} = {rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way}: along the {line} the {slide} {head} has "
        "{symbol} = {rate} {unit}."
    ),
    "whole": "{label} = {value} {unit}, {whose}.",
    "image velocity": "the velocity image",
    "image acceleration": "the acceleration image",
    "image": (
        "{letter} by {image} of the {link}: {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image against": (
        "{letter} by {image} of the {link}, on the other side: {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image similar": (
        "{letter} by {image} of the {link}: {triangle} is similar to {corners}, lettered in the "
        "same sense: {part} = {whole}·{bar}/{base} = {known} × {size}/{length} = {own} {unit}."
    ),
    "image line": (
        "Through {point} at the angle {corner} = {angle}° from {side}, in the sense of the link: "
        "{meeting} lies on this line."
    ),
    "image alike velocity": (
        "{letter} falls on {point}: the {link} does not turn at this instant, so all its points "
        "have the same velocity."
    ),
    "image alike acceleration": (
        "{letter} falls on {point}: all points of the {link} have the same acceleration at this "
        "instant."
    ),
    "image whose": ", {whose}",
    "image other": "; {label} = {value} {unit}",
    # words
    "and": "{first} and {last}",
    "the pole": "the pole",
    "of point": "of {head}",
    "parallel": "∥ {line}",
    "counter-clockwise": "counter-clockwise",
    "clockwise": "clockwise",
    "right": "to the right",
    "left": "to the left",
    "up": "upwards",
    "down": "downwards",
}

#: Names of links, slides and parameters that differ from the program's own.
NAMES = {"guide_a": "guide A", "guide_b": "guide B"}

#: Nouns have no gender, and all the same article.
GENDERS: dict[str, str] = {}
ARTICLES: dict[str, dict[str, str]] = {}

#: The decimal sign.
POINT = "."

#: The article that is also the name of a point, which stands in italics.
UPRIGHT = r"a(?= (?!(?:and|lies?)\b)[a-z]{3,})"

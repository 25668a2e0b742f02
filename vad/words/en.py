"""What captions, boards and pages say, in English: the file from which a translation is made.

How a phrase is written:

- ``{link}`` is a gap, which the program fills in; in a language with genders ``{link:der}``
  asks for a noun with its article (`ARTICLES`), ``{link:Der}`` at the beginning of a sentence;
- ``*v*`` is a symbol: its letters are set in italics and read out one by one;
- ``{rad/s²}``, a gap with a stroke in it, is that unit;
- everything else is said as it stands.

What another language leaves out of a table is said as it stands here.
"""

#: What is said of strokes, and what stands on the board.
PHRASES = {
    # the page
    "results": "Results",
    "given": "given",
    "colon": ": ",
    "legend": "grey: given",
    "legend sense": "positive",
    "coriolis rule": "Coriolis: *v* turned 90° in the sense of *ω*",
    # a problem sheet
    "name": "Name",
    "class": "Class",
    "working": "Calculation",
    "task": "Draw {panels} to the given scale, and find {found}.",
    "task draw": "Draw {panels} to the given scale.",
    "task given": "Given: {given}.",
    "given inertia": "{size} at {point}",
    "given spin": "{size} about {point}",
    "task position": "the mechanism",
    "task velocity": "the velocity polygon",
    "task acceleration": "the acceleration polygon",
    "task force": "the force polygons",
    "task more": "Further dimensions: {given}.",
    "task measure": "Measure the other dimensions in the drawing.",
    "task centres": "the instantaneous centres",
    "task klein": "Klein’s construction",
    "task turned": "the turned velocities",
    "task drive": "the forces on the driven body",
    "task shaft": "the shaft with its masses",
    "task couple": "the polygon of couples",
    "task engine": "the engine with its cranks",
    "task primary": "the polygons of primary forces and couples",
    "task secondary": "the polygons of secondary forces and couples",
    "task traction": "the tractive force and the swaying couple",
    "task hammer": "the hammer blow",
    # a question of a question bank
    "quiz given": "{title}: {given}.",
    "quiz angle": "Find the angle of the {link} in degrees, counter-clockwise from *x*.",
    "quiz omega": (
        "Find the angular velocity of the {link} in {unit}; counter-clockwise is positive."
    ),
    "quiz alpha": (
        "Find the angular acceleration of the {link} in {unit}; counter-clockwise is positive."
    ),
    "quiz position": "Find the position of the {slide} in {unit}.",
    "quiz velocity": (
        "Find the velocity of the {slide} in {unit}; it is positive where its position grows."
    ),
    "quiz acceleration": (
        "Find the acceleration of the {slide} in {unit}; it is positive in the direction in which "
        "its position grows."
    ),
    "quiz coriolis": "Find the size of the Coriolis acceleration at the {slide} in {unit}.",
    "quiz point velocity": "Find the size of the velocity of {point} in {unit}.",
    "quiz point acceleration": "Find the size of the acceleration of {point} in {unit}.",
    "quiz force": "Find the size of the force of the {one} on the {other} in {unit}.",
    "quiz torque": (
        "Find the torque that must act on the {link} in {unit}, positive counter-clockwise."
    ),
    "quiz push": (
        "Find the force that must act on the {slide} in {unit}, positive where its position grows."
    ),
    "quiz found mass": "Find the mass of {point} in kg.",
    "quiz found radius": "Find the radius at which {point} turns, in {unit}.",
    "quiz found angle": "Find the angle of {point} in degrees.",
    "quiz found plane": "Find the plane of {point} in {unit}.",
    "quiz found primary force": "Find the largest primary force over a turn in {unit}.",
    "quiz found secondary force": "Find the largest secondary force over a turn in {unit}.",
    "quiz found primary couple": "Find the largest primary couple over a turn in {unit}.",
    "quiz found secondary couple": "Find the largest secondary couple over a turn in {unit}.",
    "quiz found hammer blow": "Find the hammer blow of the wheel {point} in {unit}.",
    "quiz found tractive force": "Find the largest change of the tractive force in {unit}.",
    "quiz found swaying couple": "Find the largest swaying couple in {unit}.",
    "quiz key": "The drawing with all answers:",
    # a turn
    "stroke": "stroke",
    "after touch-down": "after touch-down",
    "broken vectors": "Broken vectors are longer than drawn.",
    "stance": "stance",
    "swing": "swing",
    "lift": "lift",
    "forward": "forward",
    "return": "return",
    "ratio": "ratio",
    "mean": "mean {value}",
    "flywheel": "flywheel for {share}: {value}",
    "swings": "{part} swings between {low} and {high}",
    "slides": "{part} moves between {low} and {high}",
    "law of swing": "as the sine of the time, not uniformly",
    # position
    "fixed": "{letter} is a fixed pivot.",
    "fixed point": "{letter} is a fixed point.",
    "guides cross": "{letter}, where the guides cross, is fixed.",
    "guide": "{head} slides along this guide.",
    "guide point": "{head} slides along this guide; {tail} is a fixed point of it.",
    "slot": "{head} slides in the slot of the {link}.",
    "driven bar": "The {link} {bar} = {size} {unit} stands at {angle}°.",
    "driven slide": "The {slide} {head} stands at {symbol} = {value} {unit} on its guide.",
    "driven slide from": (
        "The {slide} {head} stands at {symbol} = {value} {unit} on its guide, measured from {tail}."
    ),
    "angle": "Angles are measured counter-clockwise from *x*.",
    "compass": "{head} lies on the circle about {tail}, radius {bar} = {size} {unit}.",
    "compass corner": (
        "{head} lies on the circle about {tail}, radius {bar} = {size} {unit} (from ∠{corner})."
    ),
    "compass strut": (
        "{head} lies on the circle about {tail}, radius {bar} = {size} {unit}, the length of "
        "the {link}."
    ),
    "lever line": "The {link} from {tail} passes through {pin}.",
    "slot line": "The slot of the {link} passes through {pin}, and {head} lies on its line.",
    "found": "{letter} is where they meet.",
    "arcs cross": "{letter} is the {which}crossing of both arcs.",
    "crossing right": "right ",
    "crossing left": "left ",
    "crossing up": "upper ",
    "crossing down": "lower ",
    "on guide": "{letter} is where the arc meets the guide.",
    "on slot": "{letter} is where the line of the slot meets the guide.",
    "on lever": "{letter} is the point of the {link} that is now under {pin}.",
    "bar": "The {link} {bar} stands at {symbol} = {angle}°.",
    "bar backward": (
        "The {link} {bar} stands at {symbol} = {angle}°: {end} is on the other side of {tail}."
    ),
    "block towards": (
        "The {slide} {head} stands at {symbol} = {value} {unit}, measured from {tail} towards "
        "{end}."
    ),
    "block": "The {slide} {head} stands at {symbol} = {value} {unit}.",
    "block from": "The {slide} {head} stands at {symbol} = {value} {unit}, measured from {tail}.",
    "block beside": (
        "The {slide} {head} stands at {symbol} = {value} {unit}, measured along the slot from its "
        "point nearest to {tail}."
    ),
    "plate": "The {link} is one rigid piece with the corners {corners}.",
    "third point": "{letter} is where both arcs cross, with {corners} {sense}.",
    "on link slot": "{letter} is where the arc meets the line of the slot.",
    "in slot": "{head} lies on the line of the slot of the {link}.",
    "tip": "{letter} lies on the {link}, {size} {unit} from {tail}.",
    "tip against": "{letter} lies on the {link}, {size} {unit} beyond {tail}.",
    # polygons
    "pole velocity": "The pole: fixed points have no velocity, so {letters} lie here.",
    "pole acceleration": "The pole: fixed points have no acceleration, so {letters} lie here.",
    "pole velocity one": (
        "The pole: the fixed point {point} has no velocity, so {letters} lies here."
    ),
    "pole acceleration one": (
        "The pole: the fixed point {point} has no acceleration, so {letters} lies here."
    ),
    "pole turning": "{said} At {count} rpm, {omega} = 2π·*n*/60 = {rate} {rad/s}.",
    "pole steady": "{said} Along the {line}, {symbol} is zero.",
    "pole steady point": "{said} Along the {line}, {symbol} is zero, so {letter} lies here, too.",
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
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, from {head} towards "
        "{tail}{also}."
    ),
    "double prime": "; ″ tells {other} from {one}",
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
    "sliding velocity": "{label} = {value} {unit}, {way}: given along the {line}.",
    "sliding velocity strut": ("{label} = {value} {unit}, {way}: given, as if {bar} did not turn."),
    "sliding acceleration": (
        "{label} = {value} {unit}, {way}: the given acceleration along the {line}."
    ),
    "coriolis": (
        "{label} = 2·{omega}·*v* = 2 × {rate} × {speed} = {value} {unit}, the Coriolis "
        "acceleration: *v* turned 90° in the sense of {omega}."
    ),
    "across velocity": (
        "⟂ {bar} through {point}: relative to {tail}, {head} can move no other way, so {meeting} "
        "lies on it."
    ),
    "across velocity strut": (
        "⟂ {bar} through {point}: besides sliding along {bar}, {head} can only move across it, so "
        "{meeting} lies on it."
    ),
    "across acceleration": (
        "⟂ {bar} through {point}: {alpha}·{bar} has this direction, so {meeting} lies on it."
    ),
    "along velocity": (
        "∥ {line} through {point}: the {slide} {head} can move no other way, so {meeting} lies on "
        "it."
    ),
    "along velocity slot": (
        "∥ {line} through {point}: in the {line} the {slide} {head} can move no other way, so "
        "{meeting} lies on it."
    ),
    "along velocity link": (
        "∥ {line} through {point}: on the {line} the {slide} {head} can move no other way, so "
        "{meeting} lies on it."
    ),
    "along acceleration": (
        "∥ {line} through {point}: the sliding acceleration has this direction, so {meeting} lies "
        "on it."
    ),
    "without normal": "As {zero} is zero, there is no normal component. {said}",
    "without coriolis": "As {zero} is zero, there is no Coriolis component. {said}",
    "crossing": "{letter} is where both lines cross.",
    "crossing zero": "{letter} is where both lines cross: {found}.",
    "lines and crossing": "{one}; {other}. {crossing}",
    "lines that cross": "{one}; {other}. They cross at {crossing}.",
    "line and crossing": "{one}. {crossing}",
    "line alone": "{one}.",
    "zero": "at {point}, so {symbol} is zero",
    "zeros": "{one}; {other}",
    "pole crossing": "The pole {letter} is where both lines cross: {point} stands still.",
    "measured omega": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense}: {head} moves {way} "
        "as seen from {tail}."
    ),
    "measured omega absolute": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense}: {head} moves {way}."
    ),
    "measured omega strut": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense}: across {bar}, {head} "
        "moves {way}."
    ),
    "measured alpha": "{alpha} = {label}/{bar} = {value}/{size} = {rate} {rad/s²}, {sense}.",
    "measured sliding velocity": (
        "{label} = {value} {unit}: the {slide} {head} slides {way} along the {line}, {symbol} = "
        "{rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way}: along the {line} the {slide} {head} has {symbol} = "
        "{rate} {unit}."
    ),
    "whole": "{label} = {value} {unit}, {whose}.",
    "too small": "{said} This vector is too short to be seen at this scale.",
    "image velocity": "the velocity image",
    "image acceleration": "the acceleration image",
    "image": (
        "{letter} by {image} of the {link}: {part} = {whole}·{bar}/{base} = {known} × "
        "{size}/{length} = {own} {unit}{also}."
    ),
    "image against": (
        "{letter} by {image} of the {link}, beyond {tail}: {part} = {whole}·{bar}/{base} = {known} "
        "× {size}/{length} = {own} {unit}{also}."
    ),
    "image similar": (
        "{letter} by {image} of the {link}: {triangle} is directly similar to {corners}: "
        "{part} = {whole}·{bar}/{base} = {known} × {size}/{length} = {own} {unit}."
    ),
    "image line": (
        "Through {point} at ∠{corner} = {angle}°, {sense} from {side}, as on the {link}: {meeting} "
        "lies on it."
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
    # the answer
    "answer": "Answer",
    "answer at angle": "At {value}°",
    "answer at place": "At {symbol} = {value} {unit}",
    "answer here": "In this pose",
    "answer turns": "{place} the {name} {of} turns {way} at {rate} {unit}{trend}.",
    "answer moves": "{place} the {name} {of} moves {way} at {rate} {unit}{trend}.",
    "answer measures": "{place} the {name} {of} has {symbol} = {rate} {unit}{trend}.",
    "answer rests": "{place} the {name} {of} stands still for an instant.",
    "answer point": "{place} point {of} has {rates} from *x*.",
    "answer point rate": "{symbol} = {rate} {unit} at {way}°",
    "answer shifts": "{place} the {name} {of} moves {way} at {rate} {unit} without turning.",
    "answer pushes": (
        "{place} the drive must push the ends of {of} apart with {symbol} = {value} {unit}."
    ),
    "answer pulls": (
        "{place} the drive must pull the ends of {of} together with {symbol} = {value} {unit}."
    ),
    "answer torque": (
        "{place} the torque *{symbol}* = {value} {unit}, {way}, must act on the {name} {of}."
    ),
    "answer force": "{place} the force {symbol} = {value} {unit} must drive the {name} {of} {way}.",
    "answer undriven": "{place} the {name} {of} needs no drive.",
    "answer gains": " and gains speed",
    "answer loses": " and loses speed",
    "answer steady": "",
    "answer next": "; ",
    "page stepped": "This page is played stroke by stroke. Its drawing is not turned by hand.",
    "answer balances": "The shaft is balanced by {masses}.",
    "answer mass": "{letter} with {symbol} = {size} {unit} at {angle}°",
    "answer over a turn": "Over a turn {results}.",
    "answer reaches": "{what} reaches {largest} {unit} at {where}°",
    "answer steadily": "{what} is {largest} {unit} all the time",
    "answer balanced": "{what} is balanced",
    "answer primary force": "the primary force",
    "answer secondary force": "the secondary force",
    "answer primary couple": "the primary couple",
    "answer secondary couple": "the secondary couple",
    "answer tractive force": "the change of the tractive force",
    "answer swaying couple": "the swaying couple",
    "answer hammer blow": "the hammer blow of {letter}",
    "loop": "{panel}, loop {number}",
    # words
    "and": "{first} and {last}",
    "the pole": "the pole",
    "of point": "of {head}",
    "parallel": "∥ {line}",
    "square": "⟂ {line}",
    "degrees": "{angle}°",
    "counter-clockwise": "counter-clockwise",
    "clockwise": "clockwise",
    "extending": "from {tail} towards {head} (extending)",
    "retracting": "from {head} towards {tail} (retracting)",
    "outwards": "from {tail} towards {head}",
    "inwards": "from {head} towards {tail}",
    "right": "to the right",
    "left": "to the left",
    "up": "upwards",
    "down": "downwards",
    # --- the spherical four-bar, and polygons of bodies
    # position
    "spherical along": "along {axis}",
    "spherical frame": (
        "The fixed axes pierce the sphere about *O* at *A* and *D*, {size}° apart; *OA*, *OD* lie "
        "in the paper."
    ),
    "spherical crank angle": (
        "Seen along *AO*, the crank stands at {angle}°, counter-clockwise from *AD*."
    ),
    "spherical crank": (
        "*B* turns about *OA* on a circle seen as a line: the crank is *AB* = {size}°."
    ),
    "spherical C": (
        "*C* is where two circles cross: about *B* with *BC* = {coupler}°, about *D* with "
        "*DC* = {rocker}°, seen as a line."
    ),
    "spherical bars": (
        "The coupler *BC* stands at *θ_B* = {b}° from *AB* produced; from *CD* to *CB*, "
        "*θ_C* = {c}°."
    ),
    "spherical rocker angle": (
        "Seen along *DO*, the rocker stands at {symbol} = {angle}° from *AD*, produced beyond *D*."
    ),
    "spherical I": (
        "The great circles of *BC* and *AD* meet at *I* at the angle *δ* = {delta}°; *AI* = {ai}°, "
        "*DI* = {di}°. The rocker turns about *OI* relative to the crank."
    ),
    "spherical laid": "Turned about *OI* into the paper, *OB* is {b}° and *OC* is {c}° from *OI*.",
    # polygons of bodies
    "bodies remark": (
        "Triangle 1 2 4 in the plane of the frame; 2 3 4 in that of the coupler, turned into "
        "the paper"
    ),
    "bodies pole": "The pole is the frame, {frame}; {symbol} = {value} {unit}, along {axis}.",
    "bodies pole steady": ("The pole: the frame, 1′, and 2′, as *α₂* = {value} is given."),
    "bodies measured": "{symbol} = {value} {unit}.",
    "bodies whole": "|{symbol}| = {value} {unit}, from {tail} to {head}.",
    "bodies whole steady": (
        "|{symbol}| = {value} {unit}, from {tail} to {head}: as *α₂* = 0, it is the vector *α₄*."
    ),
    "bodies turned frame": (
        "|{symbol}·*τ̇*| = {omega} × ({apart}·cos *δ*)/sin({delta}°) = {value} {unit}, ⟂ *OI*. "
        "The bracket is the part of *ω₃* in *BOC* ⟂ *OI*, by the distances of 3 and 1 from 2 4."
    ),
    "bodies turned coupler": (
        "|{symbol}·*τ̇₃*| = {omega} × ({apart}·cos *δ*)/sin({delta}°) = {value} {unit}, ⟂ *OI*. "
        "The bracket is the part in *AOD*."
    ),
    "bodies turned paced": (
        "|{symbol}·*τ̇*| = {omega} × {pace} = {value} {unit}, ⟂ *OI*, which turns at *τ̇* = "
        "(*ω₄₂*·sin *IB*·sin *IC*/sin {bc}° − *ω₂*·sin *τ*·cos *δ*)/sin *δ* = {signed} {rad/s}."
    ),
    "bodies line 24 velocity": (
        "∥ *OI* through {point}, as the rocker turns about *OI* relative to the crank"
    ),
    "bodies line 14 velocity": "∥ *OD* through {point}, as it turns about *OD*",
    "bodies line 23 velocity": (
        "∥ *OB* through {point}, {arc}° from *OI*, the axis of the coupler on the crank"
    ),
    "bodies line 43 velocity": "∥ *OC* through {point}, {arc}° from *OI*, its axis on the rocker",
    "bodies line 24 acceleration": "∥ *OI* through {point}, along *α₄₂ₜ*",
    "bodies line 14 acceleration": "∥ *OD* through {point}, along *α₄*",
    "bodies line 23 acceleration": "∥ *OB* through {point}, {arc}° from *OI*, along *α₃₂*",
    "bodies line 43 acceleration": "∥ *OC* through {point}, {arc}° from *OI*, along *α₃₄*",
    "bodies fold": (
        "The plane of the coupler is turned about *OI* into the paper: *OB* and *OC* are true "
        "there."
    ),
    "bodies fold again": "Again the plane is turned about *OI* into the paper.",
    "bodies sines": (
        "{symbol} = *ω₂*·sin *AI* / sin *DI* = {crank} × sin({ai}°) / sin({di}°) = {value} {unit}."
    ),
    # --- shafts and engines
    "balance axis": "{axis} is the axis of the shaft, seen from its end.",
    "balance reference": "Angles are measured from this line.",
    "balance mass": "Mass {letter}: {mass} kg at {radius} {unit}, at {angle}°.",
    "balance open": "Mass {letter} at {radius} {unit} is to be found.",
    "balance side": "Seen from the side: the planes along the shaft.",
    "balance plane": "The plane of {letter}.",
    "balance forces": "The vectors *m·r* add up to zero.",
    "balance couples": "The vectors *m·r·l* about the plane of {reference} add up to zero.",
    "balance known force": "{letter}: *m·r* = {mass} × {radius} = {value} {unit}, outwards.",
    "balance known couple": (
        "{letter}: *m·r·l* = {mass} × {radius} × {arm} = {value} {unit}, outwards."
    ),
    "balance known couple inward": (
        "{letter}: *m·r·l* = {mass} × {radius} × {arm} = {value} {unit}, inwards: "
        "its plane is on the other side."
    ),
    "balance from couples force": "{letter} is known from the couples: *m·r* = {value} {unit}.",
    "balance from couples couple": "{letter}: *m·r·l* = {value} {unit}.",
    "balance closes": "The closing line is {letter}: {value} {unit} at {angle}°.",
    "balance line": "{letter} lies along this line.",
    "balance arc": "{letter} is {value} {unit} long: an arc of that radius.",
    "balance meet": "They meet: the polygon closes.",
    "balance meet twice": (
        "They meet: the polygon closes. They meet a second time, in the mirrored answer: "
        "choice {choice}."
    ),
    "balance other": "a mirrored answer balances it, too: choice {choice}",
    "balance about other": (
        "about the plane of {reference}; a mirrored answer balances it, too: choice {choice}"
    ),
    "balance about": "about the plane of {reference}",
    "engine zero": (
        "It closes here; over a turn the resultant is at most {largest} {unit}, at {where}°."
    ),
    "engine rod": "The rod and the piston of {letter}.",
    "engine stroke": "The line of stroke of {letter}.",
    "engine crank": "The crank of {letter} stands at {angle}°.",
    "engine forces": "The forces are laid tip to tail.",
    "engine couples": "The couples about the plane of reference are laid tip to tail.",
    "engine primary": "{letter}: {value} {unit} at the angle of its crank, {angle}°.",
    "engine secondary": "{letter}: {value} {unit} at twice the angle of its crank, {angle}°.",
    "engine direct": "Direct crank of {letter}: half of it, {value} {unit}, at {angle}°.",
    "engine reverse": "Reverse crank of {letter}: half of it, {value} {unit}, at {angle}°.",
    "engine turning": "Mass {letter} turns with the shaft: {value} {unit} at {angle}°.",
    "engine resultant": "The resultant {letter} is {value} {unit} at {angle}°.",
    "engine ellipse": (
        "Over a turn its end runs on this ellipse: {letter} is at most {largest} {unit}, at "
        "{where}°, and at least {least} {unit}."
    ),
    "engine circle": "Its end runs on this circle: {letter} is {largest} {unit} all the time.",
    "engine straight": (
        "Its end runs to and fro on this line: {letter} is at most {largest} {unit}, at {where}°."
    ),
    "engine turned": "The shaft has turned by {angle}°.",
    "engine closing primary": (
        "The closing vector {letter} is {value} {unit} at {angle}°. It turns with the crank."
    ),
    "engine closing secondary": (
        "The closing vector {letter} is {value} {unit} at {angle}°. It turns twice as fast as the "
        "crank."
    ),
    "engine across": "Only its part along the line of stroke acts.",
    "engine nothing": (
        "No part of it acts here; over a turn {letter} reaches {largest} {unit}, at {where}°."
    ),
    "engine resultant in line": (
        "{letter} = {value} {unit} along the line of stroke; over a turn at most {largest} "
        "{unit}, at {where}°."
    ),
    "engine left out": (
        "Both terms leave out at most {value} {unit} of the exact force, at {angle}°."
    ),
    "engine balanced": "The polygon closes: balanced.",
    "traction forces": (
        "What is left unbalanced to and fro pulls along the track: the tractive force changes."
    ),
    "traction couples": (
        "It sways the locomotive about its middle: the couples are laid tip to tail."
    ),
    "hammer blows": "What the wheels balance along the track, they add across it: the hammer blow.",
    "hammer vector": (
        "{mass} kg of {letter} balance what goes to and fro; they pull with {value} {unit}, "
        "at {angle}°."
    ),
    "hammer across": "Only the part across the track acts on the rail.",
    "hammer nothing": (
        "Wheel {letter} neither lifts nor presses here; it presses with {largest} {unit} at "
        "{pressing}°."
    ),
    "hammer lifts": (
        "Wheel {letter} is lifted with {value} {unit}; it presses with {largest} {unit} at "
        "{pressing}°."
    ),
    "hammer presses": (
        "Wheel {letter} presses on the rail with {value} {unit}; at most with {largest} "
        "{unit}, at {pressing}°."
    ),
    "balance found": "{letter} = {value} {unit} at {angle}°.",
    # --- Hooke’s joint
    # position
    "hooke along": "seen along shaft 2",
    "hooke plan": "plane of the shafts",
    "hooke shafts": (
        "The shafts 2 and 4 meet at *O*, *β* = {angle}° apart: below in true size, above seen "
        "along shaft 2."
    ),
    "hooke P": (
        "*P*, the pin of yoke 2, runs on this circle and stands at {angle}°; *OP* is one arm of "
        "the cross, 3."
    ),
    "hooke ellipse": (
        "*Q*, the pin of yoke 4, turns about shaft 4: its circle is seen as an ellipse, narrowed "
        "by the factor cos {angle}°."
    ),
    "hooke Q": (
        "*OP* lies in the paper, so its right angle with *OQ* is seen true: *Q* is where this "
        "line meets the ellipse."
    ),
    "hooke theta 4": (
        "*Q* is moved to the circle, parallel to the plane of the shafts: there {theta} = {value}° "
        "is in true size, tan {theta} = {ratio}."
    ),
    "hooke ratio": "tan {theta} / cos {shafts}",
    "hooke speed range": "*ω₄*/*ω₂* = {low} … {high}",
    "hooke tangent": "tan {theta}",
    "hooke plan view": (
        "Below, as *OP* = *OQ* = 1, *Q* is sin *ψ_P* = sin *β*·sin *θ₄* off the plane ⟂ shaft 2, "
        "*P* sin *ψ_Q* = sin *β*·cos *θ₂* off that ⟂ 4: the cross swings by *ψ_P* = {at_p}°, "
        "*ψ_Q* = {at_q}°."
    ),
    "hooke T": "The line through {one} and {other} meets the plane of the shafts at *T*.",
    "hooke other end": "the other end of *O*{pin}",
    "hooke OT": (
        "*T*, taken straight down, gives *OT*, where the planes of cross and shafts meet: in "
        "proportion tan *τ* = tan {shafts}°·sin² {theta}°, *τ* = {tau}°."
    ),
    "hooke tau": "*τ*",
    "hooke laid": (
        "Turned about *OT* into the plane of the shafts, *OP* is {at_p}° from *OT*, with the "
        "cosine cos *τ*·cos *θ₂*, and *OQ*, ⟂ *OP*, {at_q}°."
    ),
    # the polygons
    "hooke speeds": "*ω₂*, *ω₄* laid off at each *θ₂*",
    "hooke shaft": "shaft {shaft}",
    "hooke line 24 velocity": (
        "∥ *OT* through {point}, as *ω₄₂* of shaft 4 relative to 2 lies in both planes"
    ),
    "hooke line 14 velocity": "∥ shaft 4 through {point}, as yoke 4 turns about it",
    "hooke line 23 velocity": "∥ *OP* through {point}, as the cross turns about *OP* in yoke 2",
    "hooke line 43 velocity": "∥ *OQ* through {point}, as it turns about *OQ* in yoke 4",
    "hooke line 24 acceleration": "∥ *OT* through {point}, along *α₄₂ₜ*",
    "hooke line 14 acceleration": "∥ shaft 4 through {point}, along *α₄*",
    "hooke cross": (
        "{symbol} = {value} {unit}; *OP* is ⟂ shaft 2, so *ω₃* = √({crank}² + {size}²) = {whole} "
        "{unit}; 1 3 joins two planes and is not *ω₃*."
    ),
    "hooke driven": "{symbol} = {value} {unit}; over a turn it is {low} to {high} times *ω₂*.",
    "hooke fold": "*OP* and *OQ* stay turned into the plane of the shafts.",
    "hooke turned paced": (
        "|{symbol}·*τ̇*| = {omega} × {pace} = {value} {unit}, ⟂ *OT*, which turns at *τ̇* = "
        "*ω₂*·tan *β*·sin 2*θ₂*·cos² *τ*, by differentiating tan *τ*."
    ),
    # Klein's construction
    "klein rod": "The line of the rod {b}{c}, produced.",
    "klein square": "Through {a}, square to the guide.",
    "klein M": "*M* is where both lines cross: {a}{b}*M* is the velocity polygon, turned by 90°.",
    "klein rod 1": (
        "{side} = {size}: of {c} relative to {b}, *v* = {omega}·{side} = {rate} × {size} = {value} "
        "{unit}."
    ),
    "klein slider 1": (
        "{side} = {size}: the slider has *v* = {omega}·{side} = {rate} × {size} = {value} {unit}."
    ),
    "klein circle M": "A circle about {b} through *M*.",
    "klein circle rod": "A circle whose diameter is the rod {b}{c}.",
    "klein K": "*K* is where the two circles cross.",
    "klein L": "*L* is where they cross again.",
    "klein chord": "The chord *KL* is square to the rod.",
    "klein Q": "*Q* is where *KL* crosses the rod: {b}*Q* is its normal acceleration, over ω².",
    "klein guide": "Through {a}, along the guide.",
    "klein N": (
        "*N* is where *KL* crosses this line: {a}{b}*QN* is the acceleration polygon, turned by "
        "180°."
    ),
    "klein rod 2": (
        "{side} = {size}: of {c} relative to {b}, *a*ₜ = {omega}²·{side} = {rate} × {size} = "
        "{value} {unit}."
    ),
    "klein slider 2": (
        "{side} = {size}: the slider has *a* = {omega}²·{side} = {rate} × {size} = {value} {unit}."
    ),
    "klein remark": "{a}{b} : {b}*M* : {a}*M*   and   {a}{b} : {b}*Q* : *QN* : {a}*N*",
    # instantaneous centres
    "centre bodies": "{count} bodies have {all} centres: one for every two of them.",
    "centre in": "{letter} in {point}",
    "centre pins": "The pins are centres: {centres}.",
    "centre all pins": "Every pin is the centre of the bodies that it joins.",
    "centre slide": "{letter} lies far away, square to the {line}: one body slides on the other.",
    "centre line": "Three centres of three bodies: {letter} is in line with {one} and {other}.",
    "centre line far": (
        "{letter} is in line with {one} and {other}, which is far away and gives the direction."
    ),
    "centre found": "{letter} is where both lines cross.",
    "centre away": "{letter} is where both lines cross, {size} {unit} from {other}.",
    "centre away label": "{letter}: {size} {unit} from {other}",
    "centre far": "Both lines are parallel: {letter} is far away.",
    "centre far label": "{letter} far away",
    "centre alike": "Both bodies turn alike: {letter} is far away on this line.",
    "centre ratio": (
        "{symbol} = {omega}·{first}/{second} = {rate} × {one}/{other} = {value} {unit}, {sense}."
    ),
    "centre speed": (
        "{both} is a point of both bodies: *v* = {omega}·{first} = {rate} × {one} = {value} {unit}."
    ),
    "centre turning": (
        "{both} is a point of both bodies: {symbol} = *v*/{second} = {rate}/{other} = {value} "
        "{unit}, {sense}."
    ),
    "centre cylinder": (
        "Rod and barrel turn alike: {symbol} = *v*/{second} = {rate}/{other} = {value} {unit}, "
        "{sense}."
    ),
    "centre still": "{letter} is far away: the {link} does not turn in this pose.",
    "centre same": "{both} is far away: both bodies have the same motion in this pose.",
    "centrode fixed": "In all poses {letter} lies on this curve: the fixed centrode.",
    "centrode under": "On the {link}, {letter} lies on this curve in all poses.",
    "centrode moving": (
        "On the {link}, {letter} lies on this curve: the moving centrode, which rolls on the other."
    ),
    # the turned velocity polygon
    "turned pole": "The pole lies in {pivot}: velocities are turned by 90° and divided by {omega}.",
    "turned crank": "So {label} is the {crank} {bar} itself.",
    "turned along": "A velocity square to {bar} lies along {bar} when it is turned.",
    "turned square": "A velocity along the {line} lies square to it when it is turned.",
    "turned crossing": "{letter} is where both lines cross.",
    "turned omega": (
        "{label} = {size}, so {symbol} = {omega}·{label}/{bar} = {rate} × {size}/{length} = "
        "{turning} {rad/s}, {sense}."
    ),
    "turned speed": "{label} = {size}: *v* = {omega}·{label} = {rate} × {size} = {value} {unit}.",
    # forces
    "force nothing": "No joint bears a force: the loads act on the driver alone.",
    "force force": "{label} = {value} {unit}, the load on the {link} at {point}.",
    "force weight": "{label} = {value} {unit}, the weight of the {link} at {point}.",
    "force inertia": (
        "{label} = *m*·*a* = {mass} {heavy} × {size} {fast} = {value} {unit}, the inertia force of "
        "the {link}, against the acceleration of {point}."
    ),
    "force couple": "{label} = {value} {unit}, {sense}, the couple on the {link}.",
    "force spin": (
        "{label} = *I*·{symbol} = {inertia} {heavy} × {alpha} {turning} = {value} {unit}, {sense}, "
        "the inertia couple of the {link}, against {symbol}."
    ),
    "force moved": (
        "Moved by *h* = {couple}/{label} = {moment} {turning}/({value} {unit}) = {arm} {length}, "
        "{label} alone has the moment of {couple}, too."
    ),
    "force friction": "{label} = {value} {unit}, the friction on the {link} at {point}.",
    "force joint": (
        "{label} = {value} {unit}: the {other} acts back on the {link}, opposite to {opposite}."
    ),
    "force along": "{label} = {value} {unit} holds what acts on the {link} along its line.",
    "force moments": (
        "Moments about {point}: {label} = {moment} {turning}/({size} {length}) = {value} {unit}, "
        "⟂ {bar}."
    ),
    "force square": "{label} is square to the line on which the {link} slides.",
    "force two": "The {link} {bar} has two forces only: both lie along {bar}.",
    "force line": "The line of action of {label}.",
    "force meeting": (
        "Three forces in equilibrium meet in a point: on the {link} {label} and {force} meet in "
        "{letter}."
    ),
    "force three": "{label} passes through {point} and {meeting}, too.",
    "force rest": "The rest of the force, {label}, lies along {bar}.",
    "drive along": "{label} lies along the line on which the {link} slides.",
    "drive force": "{label} = {value} {unit} must drive the {link} along its line.",
    "force closes": "The two lines cross: the polygon closes.",
    "force part": "{label} = {value} {unit}, measured.",
    "force pushes": "{label} = {value} {unit}: the {one} pushes the {other}.",
    "force pulls": "{label} = {value} {unit}: the {one} pulls the {other}.",
    "force on": "{label} = {value} {unit}: the force of the {one} on the {other}.",
    "force arm": "*h* = {arm} {length} is the distance of {point} from this line.",
    "torque none": "The moments about {point} add up to zero: no torque is needed.",
    "torque": "Moments about {point}: *T* = {torque} {turning}, {sense}, must act on the {link}.",
    "torque sum": (
        "Moments about {point}: *T* = {terms} = {torque} {turning}, {sense}, must act on the "
        "{link}."
    ),
    "superposed part": "{label} = {value} {unit} is due to {loads} alone.",
    "superposed alone": "{loads} alone: {said}",
    "drive superposed": (
        "{label} = {symbols} = {terms} = {value} {unit} must drive the {link} along its line."
    ),
    "superposed sum": (
        "{label} = {terms} = {value} {unit} as vectors: the force of the {one} on the {other}."
    ),
    "torque superposed": (
        "*T* = {symbols} = {terms} = {torque} {turning}, {sense}, must act on the {link}."
    ),
    "power one": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt}; {symbols} = {taken} "
        "{watt}: together zero."
    ),
    "power": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt}; {symbols} = {terms} "
        "= {taken} {watt}: together zero."
    ),
    "power all": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt}; the power of all "
        "loads is {taken} {watt}: together zero."
    ),
    "force torque": (
        "*T* = {label}·*h* = {value} {unit} × {arm} {length} = {torque} {turning}, {sense}, must "
        "act on the {link}."
    ),
    "force whole": (
        "{label} = √({known}² + {found}²) = {value} {unit}: the force of the {one} on the {other}."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
    # --- the spatial four-bar
    # position
    "spatial star": "along *DA*",
    "spatial rose": "along *A*",
    "spatial rose D": "along *D*",
    "spatial frame": (
        "*AD* = {size} {unit} is the common normal of the axes at *A* and *D*, twisted by "
        "{twist}°; at *D* the rocker also slides."
    ),
    "spatial crank": (
        "The crank *AB* = {size} {unit} stands at {angle}° from *AD*, seen along its axis."
    ),
    "spatial b": (
        "The axis at *B* is ⟂ *AB*, {twist}° from that at *A*; on it the coupler turns and slides."
    ),
    "spatial directions": (
        "*OA* to *OD* are ∥ the axes: the planes *AOD*, *BOC* meet in *OI* at *δ* = {delta}°, "
        "*τ* = {tau}° from *OA*; *IB* = {ib}°, *IC* = {ic}°."
    ),
    "spatial slides": "Three slides close the loop: *s_B* = {b}, *s_C* = {c}, *s_D* = {d} {unit}.",
    "spatial bars": (
        "The coupler *BC* = {coupler} {unit}, and the rocker *DC* = {rocker} {unit} at *θ₄* = "
        "{theta}°."
    ),
    "spatial H": (
        "Relative to the crank the rocker turns about *I* ∥ *OI* and slides along it; *I* is ⟂ "
        "*BC* and, at *H*, ⟂ *AD*: *AH* = {height} {unit}."
    ),
    # the lower polygons
    "spatial pole velocity": (
        "Below, seen along *DA*: *A* as a point of the rocker, its velocity *aa₄*."
    ),
    "spatial pole acceleration": ("*ay* and *ya₄* turn with *OI* and change length."),
    "spatial about I velocity": (
        "{label} = |*ω₄₂*·*AH*| = {turn} × {lever} = {value} {unit}, ⟂ *OI*: *A* turns about *I*."
    ),
    "spatial turned": "{label} = *aa₄*·|*τ̇*| = {speed} × {pace} = {value} {unit}, ⟂ *aa₄*.",
    "spatial about I acceleration": (
        "{label} = |*α₄₂ₜ*·*AH* + *ω₄₂*·*ḣ*| = {sum} = {value} {unit}, ⟂ *OI*; *AH* grows at *ḣ* = "
        "{rising} {pace}, the dual part of *τ̇*."
    ),
    "spatial about D velocity": (
        "{label} = |{symbol}|·*AD* = {turn} × {lever} = {value} {unit}, ⟂ *OD*: *A* turns about "
        "*D*, too."
    ),
    "spatial about D acceleration": (
        "{label} = |{symbol}|·*AD* = {turn} × {lever} = {value} {unit}, ⟂ *OD*."
    ),
    "spatial along I": "∥ *OI* through {point}",
    "spatial along D velocity": "∥ *OD* through {point}, as *A* slides along both",
    "spatial along D acceleration": "∥ *OD* through {point}",
    # --- the ball-jointed four-bar
    # position
    "balls ahead": "in front of",
    "balls behind": "behind",
    "balls crank": (
        "Below, seen along the axis of *A*: the crank *AB* = {size} {unit} stands at {angle}° from "
        "the common normal of the axes."
    ),
    "balls path of C": (
        "Above, seen along the axis of *D*: *C* runs on this circle with *DC* = {size} {unit}; *A* "
        "and *B* stand straight above."
    ),
    "balls compass": (
        "*B* stands {height} {unit} {side} the plane of this circle, so here *BC* is √({size}² − "
        "{height}²) = {reach} {unit} long."
    ),
    "balls compass square": (
        "*B* stands {offset} + {crank}·sin {angle}° = {height} {unit} behind the plane of this "
        "circle, so here *BC* is √({size}² − {height}²) = {reach} {unit} long."
    ),
    "balls offset": "{size}",
    "balls C": "*C* is where both circles cross; the rocker *DC* stands at {theta} = {angle}°.",
    "balls top": "Straight below, *C* completes the lower view.",
    "balls third": (
        "Turned about the tangent to the path of *C*, the plane of this tangent and *BC* is seen "
        "in true size, and the plane ⟂ *BC* as a line."
    ),
    "balls askew": (
        "Projections: *p_AB* = {seen_AB}, *p_DC* = {seen_DC}, *p_BT* = {seen_BT} (*BT* is *AB* "
        "turned by 90°); positive into the paper, *h_AB* = {off_AB}, *h_DC* = {off_DC}, *h_BT* = "
        "{off_BT} {unit}."
    ),
    "balls along D": "seen along *D*",
    "balls along A": "seen along *A*",
    "balls along both": "plane of *BC* and path of *C* in true size",
    # polygons
    "balls path": "path of *C*",
    "balls remark": (
        "in the plane of *BC* and the path of *C*; the coupler does not spin about *BC*"
    ),
    "balls tangential": "{label} = {symbol}·*p_BT* = {rate} × {size} = {value} {unit}, ∥ *BT*.",
    "balls normal": (
        "{label} = {symbol}²·{length} = {rate} × {size} = {value} {unit}, from {head} to {tail}."
    ),
    "balls line BC velocity": "⟂ *BC* through {point}, as *BC* keeps its length",
    "balls line DC velocity": "∥ the path of *C* through {point}",
    "balls line BC acceleration": "⟂ *BC* through {point}, along {symbol}·*BC*",
    "balls line DC acceleration": "∥ the path of *C* through {point}, along {symbol}·*DC*",
    "balls coupler velocity": "{symbol} = {label}/*BC* = {value}/{size} = {rate} {rad/s}.",
    "balls coupler velocity askew": (
        "{label} = {value} {unit} in this view, into the paper {sum} = {off} {unit}: together "
        "{symbol} = {whole}/{size} = {rate} {rad/s}."
    ),
    "balls coupler acceleration": "{symbol} = {label}/*BC* = {value}/{size} = {rate} {rad/s²}.",
    "balls coupler acceleration askew": (
        "{label} = {value} {unit} in this view, into the paper {sum} = {off} {unit}: together "
        "{symbol} = {whole}/{size} = {rate} {rad/s²}."
    ),
    "balls rocker velocity": "{symbol} = {label}/*DC* = {value}/{size} = {rate} {rad/s}, {sense}.",
    "balls rocker acceleration": (
        "{symbol} = {label}/*DC* = {value}/{size} = {rate} {rad/s²}, {sense}."
    ),
    "balls whole": "{label} = {value} {unit} here.",
    # plots and tables of sweeps, and figures of merit
    "angle of the driver": "angle of the {link}",
    "position of the driver": "position of the {link}",
    "force of one on another": "{one} on {other}",
    "transmission angle": "transmission angle",
    "time ratio": "time ratio",
    "forward angle": "forward angle",
    "return angle": "return angle",
    "mechanical advantage": "mechanical advantage",
    "does not close": "does not close",
    "merit output": "output",
    "merit grashof": "Grashof",
    "merit ranges": "closes for",
    "merit dead": "dead centres",
    "merit least": "least transmission angle",
    "merit largest": "largest transmission angle",
    "merit none": "none",
    "merit every angle": "every angle",
    "merit and": "{first} and {last}",
    "merit at": "{value} at {place}",
    "grashof crank-rocker": "crank-rocker",
    "grashof double-crank": "double-crank",
    "grashof double-rocker": "double-rocker",
    "grashof rocker-crank": "rocker-crank",
    "grashof triple-rocker": "triple-rocker",
    "grashof change point": "change point",
    "merit rubbing": "rubbing at a pin",
    "merit pair": "{pin}: {one} on {other}",
    "merit diameter": "diameter",
    "merit velocity": "velocity",
    "merit slowest": "slowest point",
    "merit distance": "from its first end",
    "merit speed": "speed",
    "merit on link": "on the link",
    "merit yes": "yes",
    "merit no": "no",
    "merit extremes": "extremes",
    "merit minimum": "least",
    "merit maximum": "largest",
    "merit place": "at",
}

#: Names of mechanisms, diagrams, links, slides and parameters that differ from the program's own.
NAMES = {
    "engine_cylinder": "cylinder",
    "coupled": "coupled axles",
    "guide_a": "guide A",
    "guide_b": "guide B",
    "driving": "driving shaft",
    "driven": "driven shaft",
    "shaft_angle": "shaft angle β",
    "ground_angle": "ground angle from x",
    "ground_twist": "angle of axes",
    "crank_offset": "crank offset",
    "rocker_offset": "rocker offset",
    "{}_angle": "{} angle",
    "{}_offset": "{} offset",
}

#: The gender of nouns, which chooses their article: English has none.
GENDERS: dict[str, str] = {}

#: By gender, what becomes of the article for which a phrase asks.
ARTICLES: dict[str, dict[str, str]] = {}

#: The decimal sign.
POINT = "."

#: Buttons and texts of a lesson's page.
PLAYER = {
    "play": "Play",
    "pause": "Pause",
    "first": "To the start",
    "back": "Back one stroke",
    "forward": "Forward one stroke",
    "last": "To the end",
    "speed": "Speed",
    "strokes": "All strokes",
    "theme": "Board or paper",
    "full-screen": "Full screen",
    "large": "Enlarge a panel",
    "keys": "Keys",
    "letters": "Single-key shortcuts",
    "travels": "Vectors travel",
    "close": "Close",
    "scrub": "Strokes drawn",
    "drawn": "{panel}: {done} of {count} strokes drawn",
    "begin": "Play the lesson, or take one stroke at a time.",
    "controls": "Player",
    "parts": "Diagrams",
    "key-space": "Space",
    "key-home": "Home",
    "key-end": "End",
    "key-up": "PgUp",
    "key-down": "PgDn",
}

#: Words of a page on which a mechanism is turned by hand.
HAND = {
    "lesson": "Lesson",
    "hand": "Hand",
    "mode": "Lesson or hand",
    "undo": "Undo",
    "redo": "Redo",
    "turn-crank": "You turn the crank.",
    "turn-link": "You turn the driving link.",
    "move-slide": "You move the driver.",
    "runs": "The mechanism runs by itself.",
    "shown": "Shown is what is drawn up to {panel} {step}.",
    "return": "Back to {panel} {step}",
    "return-short": "Back",
    "return-lesson": "Back to the lesson",
    "show-all": "Show all",
    "limit": "Limit position at {place}: {why}.",
    "parted": "beyond it the links part",
    "parting-bars": "{one} and {other} are in line",
    "parting-guide": "{one} is perpendicular to its guide",
    "parting-slot": "{one} is perpendicular to the slot",
    "parting-spherical-four-bar": "B, C and D lie on one great circle",
    "parting-rssr": "the coupler BC is perpendicular to the path of C",
    "other-assembly": "Go on in the other assembly",
    "dead": "Dead centre at {place}: here velocities have no value.",
    "unclosed": "{name} {place}: the links do not close; they close for {ranges}",
    "unclosed-nowhere": "{name} {place}: the links close nowhere with these dimensions",
    "guarded": "The picture does not hold beyond {name} {value}: the slider stops here.",
    "try": "try {name} {value}",
    "unknown": "{name}: this page has no such input",
    "known": "it has {names}",
    "no-number": "{name}: must be a finite number, got {value}",
    "positive": "{name}: must be positive, got {value}",
    "beyond": "{name}: must be from {low} to {high} {unit}, where numbers are right, got {value}",
    "assembly": "assembly: must be {names} in this page, got {value}",
    "other-page": "it has a page of its own: vad draw --assembly {value}",
    "or": " or ",
    "assemblies": "Assembly",
    "request": "must be an object of names and numbers",
    "crank": "Crank angle",
    "link": "Angle of the driving link",
    "slide": "Place of the driver",
    "far-back": "A quarter turn back",
    "far-on": "A quarter turn on",
    "little-back": "1° back",
    "little-on": "1° on",
    "more-back": "A quarter of the way back",
    "more-on": "A quarter of the way on",
    "step-back": "One step back",
    "step-on": "One step on",
    "degrees": "{value} degrees",
    "motion": "Motion",
    "dimensions": "Dimensions",
    "more": "{count} more dimensions",
    "show": "Show",
    "curves": "Curves",
    "hodographs": "Hodographs",
    "paths": "Paths",
    "names": "Letters",
    "step": "step: must be a step of the lesson, got {value}",
    "unheld": "with these dimensions this page would draw something false",
    "steps-are": "a number from 0 to {count}, or as in velocity:4",
    "pole": "{name} is the pole",
    "vertex": "{name} {size} at {angle}",
    "hide-row": "Show or hide {name}",
    "settings": "Settings",
    "no-polygon": "no polygon in this position",
    "key-escape": "Esc",
    "page-keys": "15° back / on",
    "fine": "0.1° at a time",
    "ring": "Drag the ring",
    "and": " and ",
}

#: Signs as they are read out; "^" is a power.
SPOKEN = {
    "√": "square root of ",
    "∠": "angle",
    "⟂": "perpendicular to",
    "∥": "parallel to",
    "′": " prime",
    "̇": " dot",
    "̈": " double dot",
    "″": " double prime",
    "·": " times ",
    "×": " times ",
    "+": " plus ",
    "−": "minus ",
    "=": "equals",
    "|": " ",
    "/": " over ",
    "/s": " per second",
    "°": " degrees",
    "^": "to the power {}",
    "^2": "squared",
    "α": "alpha",
    "β": "beta",
    "θ": "theta",
    "δ": "delta",
    "τ": "tau",
    "ψ": "psi",
    "ω": "omega",
    "φ": "phi",
}

#: What the window of ``vad gui`` says.
WINDOW = {
    "title": "vad: velocity and acceleration polygons",
    "language": "Language",
    "mechanism": "Mechanism",
    "dimensions": "Dimensions",
    "assembly": "Assembly",
    "motion": "Input motion",
    "angle": "angle θ",
    "omega": "ω",
    "alpha": "α",
    "position": "position",
    "velocity": "v",
    "acceleration": "a",
    "open": "open",
    "crossed": "crossed",
    "upper": "upper",
    "lower": "lower",
    "left": "left",
    "right": "right",
    "parallel": "parallel",
    "draw": "Draw it",
    "reset": "Reset",
    "link": "Copy link",
    "linked": "The link is copied.",
    "save": "Save as",
    "saving": "Saving …",
    "saved": "Saved: {name}",
    "command": "Copy the command",
    "copied": "Copied: {line}",
    "retry": "Try again",
    "try": "try {values}",
    "stopped": "vad gui has stopped. Start it again in the terminal.",
    "large": "{name} is too large: the window opens files of less than {most} kB.",
    "examples": "Examples",
    "turn": "Turn",
    "problem": "Problem sheet",
    "file": "Open …",
    "controls": "What is set",
    "slider": "{name}, slider",
}

#: What the solutions of a design are described with.
DESIGN = {
    "slider-crank": "Slider–crank from its stroke and time ratio",
    "quick-return": "Quick return from its stroke and time ratio",
    "crank-rocker": "Crank–rocker from the swing of its rocker and its time ratio",
    "three-positions": "Four-bar through three positions of its coupler",
    "function": "Four-bar for three pairs of angles of crank and rocker",
    "solution": "solution",
    "mechanism": "mechanism",
    "assembly": "assembly",
    "origin": "A at x, y",
    "position": "position",
    "dead centre": "dead centre",
    "sense": "the crank turns",
    "forwards": "counter-clockwise",
    "backwards": "clockwise",
    "slow": "slow stroke",
    "slow out": "away from the crank",
    "slow in": "towards the crank",
    "slow right": "to the right",
    "slow left": "to the left",
    "slow with": "with the crank",
    "slow against": "against the crank",
    "driven": "driven at",
    "driven first": "the first pivot",
    "driven second": "the second pivot",
    "back": "points back",
    "back crank": "the crank",
    "back rocker": "the rocker",
    "back both": "crank and rocker",
    "faults": "faults",
    "none": "none",
    "fault assembly": "changes its assembly",
    "fault range": "cannot move from one position to another",
    "fault order": "another order of positions",
    "grashof": "Grashof",
    "stroke": "stroke or swing",
    "time ratio": "time ratio",
    "least transmission": "least transmission angle (at)",
    "largest transmission": "largest transmission angle (at)",
    "kind crank-rocker": "crank-rocker",
    "kind double-crank": "double-crank",
    "kind double-rocker": "double-rocker",
    "kind rocker-crank": "rocker-crank",
    "kind triple-rocker": "triple-rocker",
    "kind change point": "change point",
}

"""What the teacher says of Hooke's joint, in English."""

PHRASES = {
    # position
    "hooke along": "seen along shaft 2",
    "hooke plan": "plane of the shafts",
    "hooke shaft 2": "Below, the plane of the shafts in true size: shaft 2 drives.",
    "hooke bearing": "Shaft {shaft} turns in the frame.",
    "hooke shaft 4": "Shaft 4 is driven.",
    "hooke axes": "The shafts meet at O.",
    "hooke angle": "The angle between the shafts is {angle}°.",
    "hooke O": "Above, O as seen along shaft 2.",
    "hooke plane": "Seen along shaft 2, the plane of the shafts is the horizontal line.",
    "hooke circle": "P turns about shaft 2: seen along it, on a circle.",
    "hooke OP": "P, the pin of yoke 2, stands at {angle}°: OP is one arm of the cross.",
    "hooke theta 2": "Its angle is measured from the plane of the shafts.",
    "hooke ellipse": (
        "Q turns about shaft 4: this circle is seen as an ellipse, its width times cos {angle}°."
    ),
    "hooke OQ": (
        "OQ is square to OP; P stands in the plane of this view, so the right angle is seen: Q is "
        "on this line."
    ),
    "hooke Q": "Q, the pin of yoke 4, is where the line meets the ellipse.",
    "hooke arm": "OQ is the other arm of the cross.",
    "hooke turned": "Parallel to the plane of the shafts, Q is turned into this view.",
    "hooke theta 4": "There its angle is true: {theta} = {value}°, for tan {theta} = {ratio}.",
    "hooke projectors": "P and Q in the plan: straight below.",
    "hooke P plan": "The arm of P in the plan.",
    "hooke Q plan": (
        "The arm of Q in the plan: cross 3 swings by ψ = {at_p}° about P and {at_q}° about Q."
    ),
    "hooke yoke": "Yoke {shaft} holds the pin {pin}.",
    "hooke fork": "Yoke {shaft} as seen along shaft 2.",
    "hooke PQ": "The line from {one} to {other}, on the far side of the plane of the shafts.",
    "hooke T": "It pierces that plane at T.",
    "hooke T plan": "T in the plan: straight below.",
    "hooke OT": "OT is where the plane of the cross cuts that of the shafts.",
    # velocity
    "hooke speeds": "speeds over a turn",
    "hooke pole velocity": "The pole: the frame, 1, does not turn.",
    "hooke given velocity": "12 = {symbol} = {value} rad/s, along shaft 2.",
    "hooke along OT": (
        "Through 2, parallel to OT: against yoke 2, yoke 4 can turn only about lines in the plane "
        "of the cross; in the plane of the shafts only OT is one, so 4 lies on this line."
    ),
    "hooke shaft": "shaft {shaft}",
    "hooke along shaft": (
        "Through the pole, parallel to shaft 4: it turns about no other line, so {meeting} lies "
        "on this line."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
    "hooke laid over": (
        "The plane of the cross, laid over about 24. Through 2, parallel to {arm}: about {arm} "
        "the cross turns against yoke 2, so 3 lies on this line."
    ),
    "hooke thales": (
        "Through 4, parallel to {arm}, square to the other line: 3 lies on the circle over 24."
    ),
    # acceleration
    "hooke pole acceleration": "The pole: the frame, 1′, has no angular acceleration.",
    "hooke given acceleration": "1′2′ = {symbol} = {value} rad/s², along shaft 2.",
    "hooke turning": (
        "2′4ₙ = {label} = {omega} × {tau} = {value} rad/s², square to OT: {symbol} turns with OT."
    ),
    "hooke along OT acceleration": (
        "Through 4ₙ, parallel to OT: by how much {symbol} grows along OT is not known yet, so 4′ "
        "lies on this line."
    ),
}

NAMES = {
    "Hooke's joint": "Hooke’s joint",
    "driving": "driving shaft",
    "driven": "driven shaft",
    "shaft_angle": "shaft angle",
}

GENDERS: dict[str, str] = {}

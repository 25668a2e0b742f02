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
        "The arm of Q in the plan: cross 3 swings by ψ_P = {at_p}° about P, "
        "by ψ_Q = {at_q}° about Q."
    ),
    "hooke yoke": "Yoke {shaft} holds the pin {pin}.",
    "hooke fork": "Yoke {shaft} as seen along shaft 2.",
    "hooke PQ": "The line from {one} to {other}, on the far side of the plane of the shafts.",
    "hooke T": "It pierces that plane at T.",
    "hooke T below": "T is taken down into the plan.",
    "hooke T plan": "Straight below, T stands in the plan.",
    "hooke OT": "OT is where the plane of the cross cuts that of the shafts.",
    # the polygons
    "hooke speeds": "speeds over a turn",
    "hooke shaft": "shaft {shaft}",
    "hooke line 24 velocity": (
        "Through {point}, parallel to OT: against yoke 2, yoke 4 can turn only about lines in the "
        "plane of the cross; in the plane of the shafts only OT is one, so {meeting} lies on this "
        "line."
    ),
    "hooke line 24 acceleration": (
        "Through {point}, parallel to OT: by how much the turning grows along OT is not known "
        "yet, so {meeting} lies on this line."
    ),
    "hooke line 14": (
        "Through {point}, parallel to shaft 4: it turns about no other line, so {meeting} lies on "
        "this line."
    ),
    "hooke fold": "The plane of the cross is laid over into that of the shafts, about OT.",
    "hooke line 23": (
        "Through {point}, parallel to OP as laid over: about OP the cross turns against yoke 2, so "
        "{meeting} lies on this line."
    ),
    "hooke line 43": (
        "Through {point}, parallel to OQ, square to the other line: {meeting} lies on the circle "
        "over 24."
    ),
    "hooke turned frame": (
        "{label} = {symbol}·τ̇ = {omega} × {tau} = {value} {unit}, ⟂ OT: {symbol} turns with OT."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
}

NAMES = {
    "driving": "driving shaft",
    "driven": "driven shaft",
    "shaft_angle": "shaft angle",
}

GENDERS: dict[str, str] = {}

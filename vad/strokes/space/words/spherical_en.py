"""What the teacher says of the spherical four-bar and of polygons of bodies, in English."""

PHRASES = {
    # position
    "spherical along": "along {axis}",
    "spherical outline": (
        "The sphere, seen square to the plane of the frame: its outline is the great circle of "
        "the frame."
    ),
    "spherical axes": "The axes OA and OD lie in the paper: their directions are true.",
    "spherical O": "All axes meet at O, the centre of the sphere.",
    "spherical shaft": "A link turns about O{letter}.",
    "spherical bearing": "Its shaft is held in the frame.",
    "spherical fixed": "{letter} is where a fixed axis pierces the sphere.",
    "spherical ground": "A and D are the fixed axes, {size}° apart.",
    "spherical circle": "B turns about OA: its circle is seen on edge.",
    "spherical rose": "Seen along {axis}, the angle is true.",
    "spherical reference A": "It is measured from the arc AD.",
    "spherical reference D": "It is measured from the arc AD, prolonged beyond D.",
    "spherical true A": "The crank stands at {angle}°.",
    "spherical angle A": "Its angle counts counter-clockwise, seen from outside.",
    "spherical true D": "The rocker stands at {symbol} = {angle}°.",
    "spherical angle D": "It is {symbol}.",
    "spherical crank": "The crank AB = {size}° stands at {angle}°.",
    "spherical B": "B is at its end.",
    "spherical about B": "C lies on the circle about B with radius BC = {size}°.",
    "spherical about D": (
        "C lies on the circle about D with radius DC = {size}°, which is seen on edge."
    ),
    "spherical C": "C is where the two circles cross.",
    "spherical coupler": "The coupler BC: it stands at {b}° at B and at {c}° at C.",
    "spherical rocker": "The rocker DC.",
    "spherical great circle": "The great circle of the coupler is followed to the outline.",
    "spherical I": "There, at I, it meets the great circle of the frame.",
    "spherical OI": (
        "The planes of coupler and frame meet in OI: about it the rocker turns against the crank."
    ),
    # polygons of bodies
    "bodies remark": "1 2 4 in the plane of the frame, 2 3 4 in that of the coupler, laid over",
    "bodies pole velocity": "The pole: the frame, 1, does not turn.",
    "bodies pole acceleration": "The pole: the frame, 1′, has no angular acceleration.",
    "bodies given": "{label} = {symbol} = {value} {unit}, along {axis}.",
    "bodies turned frame": (
        "{label} = {symbol}·τ̇ = {omega} × {tau} = {value} {unit}, ⟂ OI: {symbol} turns with OI in "
        "the plane of the frame."
    ),
    "bodies turned coupler": (
        "{label} = {symbol}·τ̇₃ = {omega} × {tau} = {value} "
        "{unit}, ⟂ OI: in the plane of the coupler {symbol} turns with OI, too."
    ),
    "bodies line 24 velocity": (
        "Through {point}, parallel to OI: in the planes of frame and coupler alike lies OI alone, "
        "so about it body 4 turns against body 2, and {meeting} lies on this line."
    ),
    "bodies line 24 acceleration": (
        "Through {point}, parallel to OI: by how much the turning grows along OI is not known "
        "yet, so {meeting} lies on this line."
    ),
    "bodies line 14": (
        "Through {point}, parallel to OD: the rocker turns about no other line, so {meeting} lies "
        "on this line."
    ),
    "bodies fold": (
        "The plane of the coupler is laid over into the paper, about OI: OB and OC lie in true "
        "direction."
    ),
    "bodies line 23": (
        "Through {point}, parallel to OB as laid over, {arc}° from OI: about OB the coupler turns "
        "against the crank, so {meeting} lies on this line."
    ),
    "bodies line 43": (
        "Through {point}, parallel to OC, {arc}° from OI: about OC the coupler turns against the "
        "rocker, so {meeting} lies on this line."
    ),
    "bodies sines": (
        "{label} = {symbol} = {value} {unit}: ω₄/ω₂ = sin AI / sin DI = sin {ai}° / sin {di}°."
    ),
}

NAMES: dict[str, str] = {}

GENDERS: dict[str, str] = {}

"""What the teacher says of the spatial four-bar, in English."""

PHRASES = {
    # position
    "spatial star": "along DA",
    "spatial rose": "along OA",
    "spatial a": "The axis a of the crank is fixed.",
    "spatial d": "So is the axis d of the rocker.",
    "spatial AD": "AD = {size} {unit} is their common normal; d is twisted against a by {twist}°.",
    "spatial shaft": "The crank turns about a.",
    "spatial bearing": "It is held in a bearing: it does not slide.",
    "spatial A": "A is where the common normal meets a.",
    "spatial D sleeve": "In its sleeve in the frame the rocker turns about d and slides along it.",
    "spatial D": "D is where the common normal meets d.",
    "spatial crank": "The crank AB = {size} {unit} stands at {angle}°.",
    "spatial circle": "Seen along a, B runs on a circle.",
    "spatial reference": "The angle is measured from AD.",
    "spatial true": "Here the crank is seen in true direction.",
    "spatial angle": "Its angle is {angle}°.",
    "spatial b": "Its axis at B is square to AB, and twisted against a by {twist}°.",
    "spatial B sleeve": "In its sleeve at B the coupler turns and slides.",
    "spatial directions": (
        "The directions are those of the spherical four-bar with arcs {ground}°, {crank}°, "
        "{coupler}°, {rocker}°: lengths turn nothing."
    ),
    "spatial true directions": "Seen along DA, they lie in the paper: OA and OD are true.",
    "spatial I": (
        "There the planes of frame and coupler meet in OI, τ = {tau}° from OA: about it the rocker "
        "turns against the crank."
    ),
    "spatial c": "From there the axis at C has its direction.",
    "spatial slides B": "Three lengths close the loop: s_B = {b}, s_C = {c}, s_D = {d} {unit}.",
    "spatial slides C": "s_C = {c} {unit}, from the rocker to the foot of BC.",
    "spatial slides D": "s_D = {d} {unit}, from D to the foot of the rocker.",
    "spatial coupler": (
        "The coupler: from its shaft in B along the common normal BC = {size} {unit}."
    ),
    "spatial C sleeve": "At C it holds the rocker in a sleeve.",
    "spatial rocker": "The rocker DC = {size} {unit} with its shafts in C and D: θ₄ = {theta}°.",
    "spatial C": "C is the foot of BC on its axis.",
    "spatial screw": "About I the rocker turns against the crank, and it slides along I.",
    "spatial H": "I crosses AD at H, square to it: AH = {height} {unit}.",
    # the lower polygons
    "spatial pole velocity": (
        "Below, A as a point of the rocker; at the pole A and D of the frame, which stand still."
    ),
    "spatial pole acceleration": (
        "Below, A as a point of the rocker; at the pole A and D of the frame, which stand still."
    ),
    "spatial about I velocity": (
        "{label} = ω₄₂·AH = {turn} × {lever} = {value} {unit}, ⟂ OI: A as a point of the rocker "
        "turns against the crank about I."
    ),
    "spatial about I acceleration": (
        "{label} = α₄₂ₜ·AH + ω₄₂·ḣ + v₄₂·τ̇ = {sum} = {value} {unit}, ⟂ OI: "
        "it turns faster about I, and I itself moves."
    ),
    "spatial about D": (
        "{label} = {symbol}·AD = {turn} × {lever} = {value} {unit}, ⟂ OD: with the rocker it turns "
        "about D."
    ),
    "spatial along I velocity": (
        "Through {point}, parallel to OI: how fast it slides along I is not known yet, so "
        "{meeting} lies on this line."
    ),
    "spatial along I acceleration": (
        "Through {point}, parallel to OI: what is along I is not known yet, so {meeting} lies on "
        "this line."
    ),
    "spatial along D velocity": (
        "Through {point}, parallel to OD: how fast it slides along d is not known yet, so "
        "{meeting} lies on this line."
    ),
    "spatial along D acceleration": (
        "Through {point}, parallel to OD: what is along d is not known yet, so {meeting} lies on "
        "this line."
    ),
}

NAMES: dict[str, str] = {}

GENDERS: dict[str, str] = {}

"""Ce que dit le professeur du joint de Cardan, en français."""

PHRASES = {
    # position
    "hooke along": "vu suivant l’arbre 2",
    "hooke plan": "plan des arbres",
    "hooke shaft 2": "En bas, le plan des arbres en vraie grandeur : l’arbre 2 est moteur.",
    "hooke bearing": "L’arbre {shaft} tourne dans le bâti.",
    "hooke shaft 4": "L’arbre 4 est mené.",
    "hooke axes": "Les arbres se coupent en O.",
    "hooke angle": "L’angle de brisure entre les arbres vaut {angle}°.",
    "hooke O": "En haut, O vu suivant l’arbre 2.",
    "hooke plane": "Vu suivant l’arbre 2, le plan des arbres est l’horizontale.",
    "hooke circle": "P tourne autour de l’arbre 2 : vu suivant lui, sur un cercle.",
    "hooke OP": ("P, le tourillon de la fourche 2, est à {angle}° : OP est un bras du croisillon."),
    "hooke theta 2": "Son angle se mesure à partir du plan des arbres.",
    "hooke ellipse": (
        "Q tourne autour de l’arbre 4 : ce cercle est vu comme une ellipse, de largeur multipliée "
        "par cos {angle}°."
    ),
    "hooke OQ": (
        "OQ est perpendiculaire à OP ; P est dans le plan de cette vue, donc l’angle droit se "
        "voit : Q est sur cette droite."
    ),
    "hooke Q": (
        "Q, le tourillon de la fourche 4, est à l’intersection de la droite et de l’ellipse."
    ),
    "hooke arm": "OQ est l’autre bras du croisillon.",
    "hooke turned": "Parallèlement au plan des arbres, Q est ramené dans cette vue.",
    "hooke theta 4": (
        "Là, son angle est en vraie grandeur : {theta} = {value}°, car tan {theta} = {ratio}."
    ),
    "hooke projectors": "P et Q dans le plan : à l’aplomb.",
    "hooke P plan": "Le bras de P dans le plan.",
    "hooke Q plan": (
        "Le bras de Q dans le plan : le croisillon 3 pivote de ψ_P = {at_p}° autour de P, "
        "de ψ_Q = {at_q}° autour de Q."
    ),
    "hooke yoke": "La fourche {shaft} tient le tourillon {pin}.",
    "hooke fork": "La fourche {shaft}, vue suivant l’arbre 2.",
    "hooke PQ": "La droite de {one} à {other}, de l’autre côté du plan des arbres.",
    "hooke T": "Elle perce ce plan en T.",
    "hooke T below": "T est reporté dans le plan.",
    "hooke T plan": "À l’aplomb, T est dans le plan.",
    "hooke OT": "OT est l’intersection du plan du croisillon et de celui des arbres.",
    # polygones
    "hooke speeds": "vitesses sur un tour",
    "hooke shaft": "l’arbre {shaft}",
    "hooke line 24 velocity": (
        "Par {point}, parallèlement à OT : par rapport à la fourche 2, la fourche 4 ne peut "
        "tourner qu’autour de droites du plan du croisillon ; dans le plan des arbres, OT est la "
        "seule, donc {meeting} est sur cette droite."
    ),
    "hooke line 24 acceleration": (
        "Par {point}, parallèlement à OT : la croissance de la rotation suivant OT n’est pas "
        "encore connue, donc {meeting} est sur cette droite."
    ),
    "hooke line 14": (
        "Par {point}, parallèlement à l’arbre 4 : il ne tourne autour d’aucune autre droite, donc "
        "{meeting} est sur cette droite."
    ),
    "hooke fold": "Le plan du croisillon est rabattu sur celui des arbres autour de OT.",
    "hooke line 23": (
        "Par {point}, parallèlement à OP rabattu : autour de OP, le croisillon tourne par rapport "
        "à la fourche 2, donc {meeting} est sur cette droite."
    ),
    "hooke line 43": (
        "Par {point}, parallèlement à OQ, perpendiculairement à l’autre droite : {meeting} est "
        "sur le cercle de diamètre 24."
    ),
    "hooke turned frame": (
        "{label} = {symbol}·τ̇ = {omega} × {tau} = {value} {unit}, ⟂ OT : {symbol} tourne avec OT."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
}

NAMES = {
    "Hooke’s joint": "Joint de Cardan",
    "driving": "arbre moteur",
    "driven": "arbre mené",
    "cross": "croisillon",
    "shaft_angle": "angle de brisure",
}

GENDERS = {"driving": "m", "driven": "m", "cross": "m"}

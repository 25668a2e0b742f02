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
        "Le bras de Q dans le plan : le croisillon 3 pivote de ψ = {at_p}° autour de P et "
        "{at_q}° autour de Q."
    ),
    "hooke yoke": "La fourche {shaft} tient le tourillon {pin}.",
    "hooke fork": "La fourche {shaft}, vue suivant l’arbre 2.",
    "hooke PQ": "La droite de {one} à {other}, de l’autre côté du plan des arbres.",
    "hooke T": "Elle perce ce plan en T.",
    "hooke T plan": "T dans le plan : à l’aplomb.",
    "hooke OT": "OT est l’intersection du plan du croisillon et de celui des arbres.",
    # vitesse
    "hooke speeds": "vitesses sur un tour",
    "hooke pole velocity": "Le pôle : le bâti, 1, ne tourne pas.",
    "hooke given velocity": "12 = {symbol} = {value} rad/s, suivant l’arbre 2.",
    "hooke along OT": (
        "Par 2, parallèlement à OT : par rapport à la fourche 2, la fourche 4 ne peut tourner "
        "qu’autour de droites du plan du croisillon ; dans le plan des arbres, OT est la seule, "
        "donc 4 est sur cette droite."
    ),
    "hooke shaft": "arbre {shaft}",
    "hooke along shaft": (
        "Par le pôle, parallèlement à l’arbre 4 : il ne tourne autour d’aucune autre droite, donc "
        "{meeting} est sur cette droite."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
    "hooke laid over": (
        "Le plan du croisillon, rabattu autour de 24. Par 2, parallèlement à {arm} : autour de "
        "{arm}, le croisillon tourne par rapport à la fourche 2, donc 3 est sur cette droite."
    ),
    "hooke thales": (
        "Par 4, parallèlement à {arm}, perpendiculairement à l’autre droite : 3 est sur le cercle "
        "de diamètre 24."
    ),
    # accélération
    "hooke pole acceleration": "Le pôle : le bâti, 1′, n’a pas d’accélération angulaire.",
    "hooke given acceleration": "1′2′ = {symbol} = {value} rad/s², suivant l’arbre 2.",
    "hooke turning": (
        "2′4ₙ = {label} = {omega} × {tau} = {value} rad/s², perpendiculaire à OT : {symbol} tourne "
        "avec OT."
    ),
    "hooke along OT acceleration": (
        "Par 4ₙ, parallèlement à OT : la croissance de {symbol} suivant OT n’est pas encore "
        "connue, donc 4′ est sur cette droite."
    ),
}

NAMES = {
    "Hooke’s joint": "Joint de Cardan",
    "driving": "arbre moteur",
    "driven": "arbre mené",
    "cross": "croisillon",
    "shaft_angle": "angle de brisure",
}

GENDERS = {"driving": "m", "driven": "m", "cross": "m"}

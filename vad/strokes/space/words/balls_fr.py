"""Ce que le professeur dit du quadrilatère à rotules, en français."""

PHRASES = {
    # position
    "balls A": "En bas, la manivelle vue suivant l’axe de A.",
    "balls crank path": "B y décrit un cercle en vraie grandeur.",
    "balls crank": "La manivelle AB = {size} {unit} est à {angle}°.",
    "balls crank angle": "Son angle est mesuré depuis la perpendiculaire commune aux deux axes.",
    "balls D": "En haut, le balancier vu suivant l’axe de D.",
    "balls rocker path": "C y décrit un cercle en vraie grandeur.",
    "balls A front": "A dans cette vue.",
    "balls B front": "B dans cette vue : juste au-dessus.",
    "balls AB front": "La manivelle dans cette vue.",
    "balls compass": (
        "B est à {height} {unit} {side} le plan du cercle de C : vu d’ici, C est à "
        "√({size}² − {height}²) = {reach} {unit} de B."
    ),
    "balls C": "C est à l’intersection des deux cercles.",
    "balls BC front": "La bielle BC.",
    "balls rocker": "Le balancier DC est à {theta} = {angle}°.",
    "balls rocker angle": "Son angle aussi est mesuré depuis la perpendiculaire commune.",
    "balls C top": "C dans la vue du bas : juste au-dessous.",
    "balls D top": "D dans la vue du bas.",
    "balls DC top": "Le balancier dans la vue du bas.",
    "balls BC top": "La bielle dans la vue du bas.",
    "balls BC third": (
        "À droite, vus perpendiculairement à BC et à la trajectoire de C : tous deux en vraie "
        "grandeur."
    ),
    "balls plane": "Le plan passant par B et perpendiculaire à BC y est vu comme une droite.",
    "balls line": "La trajectoire de C : sa vitesse est suivant cette droite.",
    "balls ahead": "devant",
    "balls behind": "derrière",
    "balls front": "vu suivant D",
    "balls top": "vu suivant A",
    "balls third": "BC et trajectoire de C en vraie grandeur",
    # polygones
    "balls path": "trajectoire de C",
    "balls remark": "vu comme BC à droite des vues ; la bielle ne tourne pas autour de BC",
    "balls tangential velocity": (
        "{label} est la vitesse de B, {symbol}·{ends} = {rate} × {size} = {value} {unit} : cette "
        "vue en montre {seen} {unit}."
    ),
    "balls tangential acceleration": (
        "{label} est {symbol}·{ends} = {rate} × {size} = {value} {unit}, perpendiculaire à "
        "{ends} : cette vue en montre {seen} {unit}."
    ),
    "balls normal": (
        "{label} est {symbol}²·{ends} = {rate} × {size} = {value} {unit}, de {head} vers {tail} : "
        "cette vue en montre {seen} {unit}."
    ),
    "balls normal BC": (
        "{label} = {speed}/{size} = {seen} {unit}, le carré de la vitesse de C par rapport à B "
        "divisé par BC, de C vers B en vraie grandeur."
    ),
    "balls line BC velocity": (
        "Par {point}, perpendiculairement à BC : la bielle garde sa longueur, donc {meeting} est "
        "dans un plan perpendiculaire à BC, qui est cette droite."
    ),
    "balls line DC velocity": (
        "Par {point}, parallèlement à la trajectoire de C : C ne peut pas se déplacer autrement, "
        "donc {meeting} est sur cette droite, vue en vraie grandeur."
    ),
    "balls line BC acceleration": (
        "Par {point}, perpendiculairement à BC : suivant BC tout est porté, donc {meeting} est "
        "dans un plan perpendiculaire à BC, qui est cette droite."
    ),
    "balls line DC acceleration": (
        "Par {point}, parallèlement à la trajectoire de C : la partie tangentielle {symbol}·DC "
        "n’est pas encore connue, donc {meeting} est sur cette droite."
    ),
    "balls coupler velocity": (
        "{label} = {value} {unit} ici et {off} {unit} hors du papier : en tout {whole} {unit}, "
        "donc {symbol} = {whole}/{size} = {rate} rad/s."
    ),
    "balls coupler acceleration": (
        "{label} = {value} {unit} ici et {off} {unit} hors du papier : en tout {whole} {unit}, "
        "donc {symbol} = {whole}/{size} = {rate} rad/s²."
    ),
    "balls rocker velocity": (
        "{label} = {value} {unit} est la vitesse de C, donc {symbol} = {label}/DC = "
        "{value}/{size} = {rate} rad/s, {sense}."
    ),
    "balls rocker acceleration": (
        "{label} = {value} {unit}, donc {symbol} = {label}/DC = {value}/{size} = {rate} rad/s², "
        "{sense}."
    ),
    "balls whole": "{label} = {value} {unit} dans cette vue, {whose}.",
}

NAMES = {
    "Spatial four-bar with ball joints": "Quadrilatère spatial à rotules",
    "ground_twist": "angle des axes",
    "crank_offset": "décalage de la manivelle",
    "rocker_offset": "décalage du balancier",
}

GENDERS: dict[str, str] = {}

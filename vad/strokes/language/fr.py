"""Ce que dit le professeur, en français."""

_PHRASES = {
    # la page
    "results": "Résultats",
    "given": "donné",
    "legend": "gris : donné",
    "colon": " : ",
    "coriolis rule": "Coriolis : v tournée de 90° dans le sens de ω",
    # un tour
    "stroke": "course",
    "forward": "aller",
    "return": "retour",
    "ratio": "rapport",
    "swings": "{part} oscille entre {low} et {high}",
    "slides": "{part} se déplace entre {low} et {high}",
    # position
    "fixed": "{letter} est un pivot fixe.",
    "fixed point": "{letter} est un point fixe.",
    "guides cross": "{letter}, où se croisent les glissières, est fixe.",
    "guide": "{head} ne peut se déplacer que le long de sa glissière.",
    "guide point": (
        "{head} ne peut se déplacer que le long de sa glissière ; {tail} est un point fixe de la "
        "glissière."
    ),
    "slot": "{head} glisse dans la rainure {link:du}.",
    "driven bar": "{link:Le} {bar} = {size} {unit} fait un angle de {angle}° avec l’axe x.",
    "driven slide": "{slide:Le} {head} se trouve en {symbol} = {value} {unit} sur sa glissière.",
    "driven slide from": (
        "{slide:Le} {head} se trouve en {symbol} = {value} {unit} sur sa glissière, mesuré depuis "
        "{tail}."
    ),
    "angle": "L’angle {link:du} se mesure depuis l’axe x, dans le sens trigonométrique.",
    "compass": "{head} est sur le cercle de centre {tail} et de rayon {bar} = {size} {unit}.",
    "compass strut": (
        "{head} est sur le cercle de centre {tail} et de rayon {bar} = {size} {unit}, la longueur "
        "donnée {link:du}."
    ),
    "lever line": "{link:Le} part de {tail} et passe par {pin}.",
    "slot line": "La rainure {link:du} passe par {pin}, et {head} est sur son axe.",
    "found": "{letter} est à leur intersection.",
    "arcs cross": "{letter} est à l’intersection des deux arcs.",
    "on guide": "{letter} est à l’intersection de l’arc et de la glissière.",
    "on slot": "{letter} est à l’intersection de la glissière et de l’axe de la rainure.",
    "on lever": "{letter} est le point {link:du} qui se trouve sous {pin} dans cette position.",
    "bar": "{link:Le} {bar} fait un angle {symbol} = {angle}° avec l’axe x.",
    "block": "{slide:Le} {head} se trouve en {symbol} = {value} {unit}.",
    "block from": "{slide:Le} {head} se trouve en {symbol} = {value} {unit}, mesuré depuis {tail}.",
    "plate": "{link:Le} est une pièce rigide de sommets {corners}.",
    "third point": (
        "{letter} est à l’intersection des deux arcs : le triangle {corners} garde son sens."
    ),
    "on link slot": "{letter} est à l’intersection de l’arc et de l’axe de la rainure.",
    "in slot": "{head} est sur l’axe de la rainure {link:du}.",
    "tip": "{letter} est sur {link:le}, à {size} {unit} de {tail}.",
    "tip against": "{letter} est sur {link:le}, à {size} {unit} de {tail}, de l’autre côté.",
    # polygones
    "pole velocity": "Le pôle : la vitesse de tout point fixe est nulle, donc {letters} sont ici.",
    "pole acceleration": (
        "Le pôle : l’accélération de tout point fixe est nulle, donc {letters} sont ici."
    ),
    "pole velocity one": (
        "Le pôle : la vitesse du point fixe {point} est nulle, donc {letters} est ici."
    ),
    "pole acceleration one": (
        "Le pôle : l’accélération du point fixe {point} est nulle, donc {letters} est ici."
    ),
    "on the guide": "{letter} ({point} sur la glissière)",
    "still": (
        "L’élément moteur est immobile, et tout le reste aussi : le polygone se réduit à son pôle."
    ),
    "velocity of": "la vitesse de {head}",
    "velocity of relative": "la vitesse de {head} par rapport à {tail}",
    "acceleration of": "l’accélération de {head}",
    "acceleration of relative": "l’accélération de {head} par rapport à {tail}",
    "tangential velocity whole": (
        "{label} = {omega}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} dans le sens de "
        "{omega} : {whose}."
    ),
    "normal": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, de {head} vers {tail}."
    ),
    "normal whole": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, de {head} vers {tail} : "
        "{whose}."
    ),
    "tangential acceleration": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} dans le sens de "
        "{alpha}."
    ),
    "tangential acceleration whole": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} dans le sens de "
        "{alpha} : {whose}."
    ),
    "sliding velocity": "{label} = {value} {unit}, {way} : la vitesse donnée le long {line:du}.",
    "sliding acceleration": (
        "{label} = {value} {unit}, {way} : l’accélération donnée le long {line:du}."
    ),
    "coriolis": (
        "{label} = 2·{omega}·v = 2 × {rate} × {speed} = {value} {unit}, "
        "v tournée de 90° dans le sens de {omega}."
    ),
    "across velocity": (
        "Par {point}, perpendiculairement à {bar} : par rapport à {tail}, {head} ne peut pas se "
        "déplacer autrement, donc {meeting} est sur cette droite."
    ),
    "across velocity strut": (
        "Par {point}, perpendiculairement à {bar} : hormis son glissement le long de {bar}, {head} "
        "ne peut se déplacer qu’en travers, donc {meeting} est sur cette droite."
    ),
    "across acceleration": (
        "Par {point}, perpendiculairement à {bar} : la composante tangentielle {alpha}·{bar} n’est "
        "pas encore connue, donc {meeting} est sur cette droite."
    ),
    "along velocity": (
        "Par {point}, parallèlement {line:au} : {slide:le} {head} ne peut pas se déplacer "
        "autrement, donc {meeting} est sur cette droite."
    ),
    "along velocity slot": (
        "Par {point}, parallèlement {line:au} : dans {line:le}, {slide:le} {head} ne peut pas se "
        "déplacer autrement, donc {meeting} est sur cette droite."
    ),
    "along velocity link": (
        "Par {point}, parallèlement {line:au} : sur {line:le}, {slide:le} {head} ne peut pas se "
        "déplacer autrement, donc {meeting} est sur cette droite."
    ),
    "along acceleration": (
        "Par {point}, parallèlement {line:au} : la composante de glissement n’est pas encore "
        "connue, donc {meeting} est sur cette droite."
    ),
    "crossing": "{letter} est à l’intersection des deux droites.",
    "crossing zero": "{letter} est à l’intersection des deux droites : {found}.",
    "zero": "en {point}, donc {symbol} vaut zéro",
    "pole crossing": (
        "Le pôle {letter} est à l’intersection des deux droites : {point} est immobile."
    ),
    "measured omega": (
        "{label} = {value} {unit}, donc {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense} : vu de {tail}, {head} se déplace {way}."
    ),
    "measured omega absolute": (
        "{label} = {value} {unit}, donc {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense} : {label} est la vitesse de {head}, {way}."
    ),
    "measured omega strut": (
        "{label} = {value} {unit}, donc {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense} : perpendiculairement à {bar}, {head} se déplace {way}."
    ),
    "measured alpha": (
        "{label} = {value} {unit}, donc {alpha} = {label}/{bar} = {value}/{size} = {rate} rad/s², "
        "{sense}."
    ),
    "measured sliding velocity": (
        "{label} = {value} {unit} : {slide:le} {head} glisse {way} le long {line:du}, "
        "{symbol} = {rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way} : le long {line:du}, l’accélération {slide:du} {head} est "
        "{symbol} = {rate} {unit}."
    ),
    "whole": "{label} = {value} {unit}, {whose}.",
    "image velocity": "l’image des vitesses",
    "image acceleration": "l’image des accélérations",
    "image": (
        "{letter} par {image} {link:du} : {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image against": (
        "{letter} par {image} {link:du}, de l’autre côté : {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image similar": (
        "{letter} par {image} {link:du} : {triangle} est semblable à {corners}, désigné dans le "
        "même sens : {part} = {whole}·{bar}/{base} = {known} × {size}/{length} = {own} {unit}."
    ),
    "image line": (
        "Par {point}, à l’angle {corner} = {angle}° de {side}, dans le sens de la pièce : "
        "{meeting} est sur cette droite."
    ),
    "image alike velocity": (
        "{letter} tombe sur {point} : {link:le} ne tourne pas à cet instant, tous ses points ont "
        "la même vitesse."
    ),
    "image alike acceleration": (
        "{letter} tombe sur {point} : tous les points {link:du} ont à cet instant la même "
        "accélération."
    ),
    "image whose": ", {whose}",
    "image other": " ; {label} = {value} {unit}",
    # mots
    "and": "{first} et {last}",
    "the pole": "le pôle",
    "of point": "de {head}",
    "parallel": "∥ {line}",
    "counter-clockwise": "dans le sens trigonométrique",
    "clockwise": "dans le sens horaire",
    "right": "vers la droite",
    "left": "vers la gauche",
    "up": "vers le haut",
    "down": "vers le bas",
}

#: Aucune ligne ne commence par un deux-points ou un point-virgule.
PHRASES = {
    key: phrase.replace(" :", "\N{NO-BREAK SPACE}:").replace(" ;", "\N{NO-BREAK SPACE};")
    for key, phrase in _PHRASES.items()
}

#: Titres, pièces et dimensions.
NAMES = {
    "Position": "Position",
    "Velocity": "Vitesse",
    "Acceleration": "Accélération",
    "Four-bar": "Quadrilatère articulé",
    "Slider–crank": "Bielle-manivelle",
    "Crank and slotted lever": "Coulisse oscillante",
    "Whitworth quick return": "Coulisse tournante de Whitworth",
    "Elliptical trammel": "Ellipsographe",
    "Scotch yoke": "Joug écossais",
    "Double slider": "Double coulisseau",
    "Gate actuator": "Vérin de portail",
    "crank": "manivelle",
    "coupler": "bielle",
    "rocker": "balancier",
    "rod": "bielle",
    "lever": "coulisse",
    "link": "barre",
    "arm": "bras",
    "actuator": "vérin",
    "cylinder": "vérin",
    "piston": "piston",
    "pin": "axe",
    "ground": "bâti",
    "slider": "coulisseau",
    "block": "coulisseau",
    "ram": "bélier",
    "yoke": "joug",
    "stroke": "course",
    "guide": "glissière",
    "slot": "rainure",
    "offset": "désaxage",
    "tracer": "point traceur",
    "ram_height": "hauteur du bélier",
    "ground_angle": "angle du bâti",
    "guide_a": "glissière A",
    "guide_b": "glissière B",
}

#: Le genre de ce dont parlent les phrases.
GENDERS = {
    "crank": "f",
    "coupler": "f",
    "rocker": "m",
    "rod": "f",
    "lever": "f",
    "link": "f",
    "arm": "m",
    "actuator": "m",
    "cylinder": "m",
    "piston": "m",
    "pin": "m",
    "slider": "m",
    "block": "m",
    "ram": "m",
    "yoke": "m",
    "guide": "f",
    "slot": "f",
}

#: L’article masculin que demande une phrase, et ce qu’il devient selon le genre.
ARTICLES = {
    "m": {"le": "le {}", "du": "du {}", "au": "au {}"},
    "f": {"le": "la {}", "du": "de la {}", "au": "à la {}"},
}

#: Le signe décimal.
POINT = ","

#: Une lettre élidée.
UPRIGHT = r"[a-z](?=’)\b"

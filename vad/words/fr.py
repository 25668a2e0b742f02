"""Ce que dit le professeur, au tableau et sur la page, en français (notation : voir en.py)."""

#: Ce qui se dit des traits, et ce qui est écrit au tableau.
PHRASES = {
    # la page
    "results": "Résultats",
    "given": "donné",
    "legend": "en gris : données",
    "legend sense": "positif",
    "colon": " : ",
    "coriolis rule": "Coriolis : *v* tournée de 90° dans le sens de *ω*",
    # une feuille d’exercice
    "name": "Nom",
    "class": "Classe",
    "working": "Calculs",
    "task": "Tracer {panels} à l’échelle indiquée et trouver {found}.",
    "task draw": "Tracer {panels} à l’échelle indiquée.",
    "task given": "Données : {given}.",
    "given inertia": "{size} en {point}",
    "given spin": "{size} autour de {point}",
    "task position": "le mécanisme",
    "task velocity": "le polygone des vitesses",
    "task acceleration": "le polygone des accélérations",
    "task force": "les polygones des forces",
    "task more": "Autres dimensions : {given}.",
    "task measure": "Mesurer les autres dimensions sur le dessin.",
    "task centres": "les centres instantanés",
    "task klein": "la construction de Klein",
    "task turned": "les vitesses tournées",
    "task drive": "les forces sur l’élément menant",
    "task shaft": "l’arbre avec ses masses",
    "task couple": "le polygone des moments",
    "task engine": "le moteur avec ses manivelles",
    "task primary": "les polygones des forces et des moments primaires",
    "task secondary": "les polygones des forces et des moments secondaires",
    "task traction": "l’effort de traction et le moment de lacet",
    "task hammer": "le martèlement des roues",
    # une question d’une banque de questions
    "quiz given": "{title} : {given}.",
    "quiz angle": "Trouver l’angle {link:du} en degrés, dans le sens antihoraire depuis *x*.",
    "quiz omega": (
        "Trouver la vitesse angulaire {link:du} en {unit}, positive dans le sens antihoraire."
    ),
    "quiz alpha": (
        "Trouver l’accélération angulaire {link:du} en {unit}, positive dans le sens antihoraire."
    ),
    "quiz position": "Trouver la position {slide:du} en {unit}.",
    "quiz velocity": (
        "Trouver la vitesse {slide:du} en {unit}, positive quand sa position augmente."
    ),
    "quiz acceleration": (
        "Trouver l’accélération {slide:du} en {unit}, positive dans la direction où sa position "
        "augmente."
    ),
    "quiz coriolis": "Trouver la norme de l’accélération de Coriolis {slide:du} en {unit}.",
    "quiz point velocity": "Trouver la norme de la vitesse de {point} en {unit}.",
    "quiz point acceleration": "Trouver la norme de l’accélération de {point} en {unit}.",
    "quiz force": "Trouver la norme de la force {one:du} sur {other:le} en {unit}.",
    "quiz torque": (
        "Trouver le couple qui doit agir sur {link:le} en {unit}, positif dans le sens antihoraire."
    ),
    "quiz push": (
        "Trouver la force qui doit agir sur {slide:le} en {unit}, positive dans la direction où sa "
        "position augmente."
    ),
    "quiz found mass": "Trouver la masse de {point} en kg.",
    "quiz found radius": "Trouver le rayon de {point} en {unit}.",
    "quiz found angle": "Trouver l’angle de {point} en degrés.",
    "quiz found plane": "Trouver le plan de {point} en {unit}.",
    "quiz found primary force": "Trouver la plus grande force primaire dans un tour en {unit}.",
    "quiz found secondary force": (
        "Trouver la plus grande force secondaire dans un tour en {unit}."
    ),
    "quiz found primary couple": ("Trouver le plus grand couple primaire dans un tour en {unit}."),
    "quiz found secondary couple": (
        "Trouver le plus grand couple secondaire dans un tour en {unit}."
    ),
    "quiz found hammer blow": "Trouver le martèlement de la roue {point} en {unit}.",
    "quiz found tractive force": (
        "Trouver la plus grande variation de l’effort de traction en {unit}."
    ),
    "quiz found swaying couple": "Trouver le plus grand couple de lacet en {unit}.",
    "quiz key": "Le tracé avec toutes les réponses :",
    # un tour
    "stroke": "course",
    "after touch-down": "après la pose",
    "broken vectors": "Les vecteurs interrompus sont plus longs.",
    "stance": "appui",
    "swing": "envol",
    "lift": "levée",
    "forward": "aller",
    "return": "retour",
    "ratio": "rapport",
    "mean": "moyenne {value}",
    "flywheel": "volant pour {share} : {value}",
    "swings": "{part} oscille entre {low} et {high}",
    "slides": "{part} se déplace entre {low} et {high}",
    "law of swing": "comme le sinus du temps, non uniformément",
    # position
    "fixed": "{letter} est un pivot fixe.",
    "fixed point": "{letter} est un point fixe.",
    "guides cross": "{letter}, où se croisent les glissières, est fixe.",
    "guide": "{head} glisse le long de cette glissière.",
    "guide point": "{head} glisse le long de cette glissière ; {tail} en est un point fixe.",
    "slot": "{head} glisse dans la rainure {link:du}.",
    "driven bar": "{link:Le} {bar} = {size} {unit} fait un angle de {angle}° avec l’axe *x*.",
    "driven slide": "{slide:Le} {head} se trouve en {symbol} = {value} {unit} sur sa glissière.",
    "driven slide from": (
        "{slide:Le} {head} se trouve en {symbol} = {value} {unit} sur sa glissière, mesuré depuis "
        "{tail}."
    ),
    "angle": "L’angle se mesure depuis *x*, dans le sens trigonométrique.",
    "compass": "{head} est sur le cercle de centre {tail}, de rayon {bar} = {size} {unit}.",
    "compass corner": (
        "{head} est sur le cercle de centre {tail}, de rayon {bar} = {size} {unit} (d’après "
        "∠{corner})."
    ),
    "compass strut": (
        "{head} est sur le cercle de centre {tail}, de rayon {bar} = {size} {unit}, la longueur "
        "donnée {link:du}."
    ),
    "lever line": "{link:Le} part de {tail} et passe par {pin}.",
    "slot line": "La rainure {link:du} passe par {pin}, et {head} est sur son axe.",
    "found": "{letter} est à leur intersection.",
    "arcs cross": "{letter} est à l’intersection {which}des deux arcs.",
    "crossing right": "droite ",
    "crossing left": "gauche ",
    "crossing up": "supérieure ",
    "crossing down": "inférieure ",
    "on guide": "{letter} est à l’intersection de l’arc et de la glissière.",
    "on slot": "{letter} est à l’intersection de la glissière et de l’axe de la rainure.",
    "on lever": "{letter} est le point {link:du} qui est maintenant sous {pin}.",
    "bar": "{link:Le} {bar} fait un angle {symbol} = {angle}° avec l’axe *x*.",
    "bar backward": (
        "{link:Le} {bar} fait un angle {symbol} = {angle}° avec l’axe *x* : {end} est au-delà de "
        "{tail}."
    ),
    "block towards": (
        "{slide:Le} {head} se trouve en {symbol} = {value} {unit}, mesuré de {tail} vers {end}."
    ),
    "block": "{slide:Le} {head} se trouve en {symbol} = {value} {unit}.",
    "block from": "{slide:Le} {head} se trouve en {symbol} = {value} {unit}, mesuré depuis {tail}.",
    "block beside": (
        "{slide:Le} {head} se trouve en {symbol} = {value} {unit}, mesuré dans la rainure depuis "
        "son point le plus proche de {tail}."
    ),
    "plate": "{link:Le} est une pièce rigide de sommets {corners}.",
    "third point": "{letter} est l’intersection où {corners} se suivent {sense}.",
    "on link slot": "{letter} est à l’intersection de l’arc et de l’axe de la rainure.",
    "in slot": "{head} est sur l’axe de la rainure {link:du}.",
    "tip": "{letter} est sur {link:le}, à {size} {unit} de {tail}.",
    "tip against": "{letter} est sur {link:le}, à {size} {unit} au-delà de {tail}.",
    # polygones
    "pole velocity": "Le pôle : {letters} sont ici, car la vitesse des points fixes est nulle.",
    "pole acceleration": (
        "Le pôle : {letters} sont ici, car l’accélération des points fixes est nulle."
    ),
    "pole velocity one": (
        "Le pôle : le point fixe {point} n’a pas de vitesse, donc {letters} est ici."
    ),
    "pole acceleration one": (
        "Le pôle : le point fixe {point} n’a pas d’accélération, donc {letters} est ici."
    ),
    "pole turning": "{said} À {count} tr/min, {omega} = 2π·*n*/60 = {rate} {rad/s}.",
    "pole steady": "{said} Le long {line:du}, {symbol} est nulle.",
    "pole steady point": (
        "{said} Le long {line:du}, {symbol} est nulle, donc {letter} est ici aussi."
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
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, de {head} vers {tail}{also}."
    ),
    "double prime": " ; ″ distingue {other} de {one}",
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
    "sliding velocity strut": ("{label} = {value} {unit}, {way} : donnée, sans rotation de {bar}."),
    "sliding acceleration": (
        "{label} = {value} {unit}, {way} : l’accélération donnée le long {line:du}."
    ),
    "coriolis": (
        "{label} = 2·{omega}·*v* = 2 × {rate} × {speed} = {value} {unit}, l’accélération de "
        "Coriolis : *v* tournée de 90° dans le sens de {omega}."
    ),
    "across velocity": (
        "Par {point}, la perpendiculaire à {bar} : par rapport à {tail}, {head} ne peut pas se "
        "déplacer autrement, donc {meeting} s’y trouve."
    ),
    "across velocity strut": (
        "Par {point}, la perpendiculaire à {bar} : de plus, {head} ne peut se déplacer qu’en "
        "travers, donc {meeting} s’y trouve."
    ),
    "across acceleration": (
        "Par {point}, la perpendiculaire à {bar}, direction de {alpha}·{bar} : {meeting} s’y "
        "trouve."
    ),
    "along velocity": (
        "Par {point}, la parallèle {line:au} : {slide:le} {head} ne peut pas se déplacer "
        "autrement, donc {meeting} s’y trouve."
    ),
    "along velocity slot": (
        "Par {point}, la parallèle {line:au} : dans {line:le}, {slide:le} {head} ne peut pas se "
        "déplacer autrement, donc {meeting} s’y trouve."
    ),
    "along velocity link": (
        "Par {point}, la parallèle {line:au} : sur {line:le}, {slide:le} {head} ne peut pas se "
        "déplacer autrement, donc {meeting} s’y trouve."
    ),
    "along acceleration": (
        "Par {point}, la parallèle {line:au}, direction de l’accélération de glissement : "
        "{meeting} s’y trouve."
    ),
    "without normal": "Comme {zero} est nulle, il n’y a pas de composante normale. {said}",
    "without coriolis": "Comme {zero} est nulle, il n’y a pas d’accélération de Coriolis. {said}",
    "crossing": "{letter} est à l’intersection des deux droites.",
    "crossing zero": "{letter} est à l’intersection des deux droites : {found}.",
    "lines and crossing": "{one} ; {other}. {crossing}",
    "lines that cross": "{one} ; {other}. Elles se coupent en {crossing}.",
    "line and crossing": "{one}. {crossing}",
    "line alone": "{one}.",
    "zero": "en {point}, donc {symbol} vaut zéro",
    "zeros": "{one} ; {other}",
    "pole crossing": (
        "Le pôle {letter} est à l’intersection des deux droites : {point} est immobile."
    ),
    "measured omega": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense} : vu de {tail}, "
        "{head} se déplace {way}."
    ),
    "measured omega absolute": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense} : {head} se déplace "
        "{way}."
    ),
    "measured omega strut": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense} : perpendiculairement "
        "à {bar}, {head} se déplace {way}."
    ),
    "measured alpha": "{alpha} = {label}/{bar} = {value}/{size} = {rate} {rad/s²}, {sense}.",
    "measured sliding velocity": (
        "{label} = {value} {unit} : {slide:le} {head} glisse {way} le long {line:du}, {symbol} = "
        "{rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way} : le long {line:du}, {symbol} = {rate} {unit} pour "
        "{slide:le} {head}."
    ),
    "whole": "{label} = {value} {unit}, {whose}.",
    "too small": "{said} À cette échelle, ce vecteur est trop court pour être visible.",
    "image velocity": "l’image des vitesses",
    "image acceleration": "l’image des accélérations",
    "image": (
        "{letter} par {image} {link:du} : {part} = {whole}·{bar}/{base} = {known} × "
        "{size}/{length} = {own} {unit}{also}."
    ),
    "image against": (
        "{letter} par {image} {link:du}, au-delà de {tail} : {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image similar": (
        "{letter} par {image} {link:du} : {triangle} est directement semblable à {corners} : "
        "{part} = {whole}·{bar}/{base} = {known} × {size}/{length} = {own} {unit}."
    ),
    "image line": (
        "Par {point}, à ∠{corner} = {angle}°, {sense} depuis {side}, comme sur {link:le} : "
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
    # la réponse
    "answer": "Réponse",
    "answer at angle": "À {value}°",
    "answer at place": "En {symbol} = {value} {unit}",
    "answer here": "Dans cette position",
    "answer turns": "{place}, {name:le} {of} tourne {way} à {rate} {unit}{trend}.",
    "answer moves": "{place}, {name:le} {of} se déplace {way} à {rate} {unit}{trend}.",
    "answer measures": "{place}, {name:le} {of} a {symbol} = {rate} {unit}{trend}.",
    "answer rests": "{place}, {name:le} {of} est immobile un instant.",
    "answer point": "{place}, le point {of} a {rates} de *x*.",
    "answer point rate": "{symbol} = {rate} {unit} à {way}°",
    "answer shifts": "{place}, {name:le} {of} se déplace {way} à {rate} {unit} sans tourner.",
    "answer pushes": (
        "{place}, le moteur doit écarter les extrémités de {of} avec {symbol} = {value} {unit}."
    ),
    "answer pulls": (
        "{place}, le moteur doit rapprocher les extrémités de {of} avec {symbol} = {value} {unit}."
    ),
    "answer torque": (
        "{place}, le couple *{symbol}* = {value} {unit} doit agir sur {name:le} {of}, {way}."
    ),
    "answer force": (
        "{place}, la force {symbol} = {value} {unit} doit entraîner {name:le} {of} {way}."
    ),
    "answer undriven": "{place}, {name:le} {of} ne demande aucun effort moteur.",
    "answer gains": " et accélère",
    "answer loses": " et ralentit",
    "answer steady": "",
    "answer next": " ; ",
    "page stepped": "Cette page se joue trait par trait. Le dessin ne se tourne pas à la main.",
    "answer balances": "L’arbre est équilibré par {masses}.",
    "answer mass": "{letter} avec {symbol} = {size} {unit} à {angle}°",
    "answer over a turn": "Dans un tour : {results}.",
    "answer reaches": "{what} atteint {largest} {unit} à {where}°",
    "answer steadily": "{what} vaut toujours {largest} {unit}",
    "answer balanced": "{what} est nul à tout instant",
    "answer primary force": "l’effort primaire",
    "answer secondary force": "l’effort secondaire",
    "answer primary couple": "le couple primaire",
    "answer secondary couple": "le couple secondaire",
    "answer tractive force": "l’écart de l’effort de traction",
    "answer swaying couple": "le couple de lacet",
    "answer hammer blow": "le martèlement de {letter}",
    "loop": "{panel}, boucle {number}",
    # mots
    "and": "{first} et {last}",
    "the pole": "le pôle",
    "of point": "de {head}",
    "parallel": "∥ {line}",
    "square": "⟂ {line}",
    "degrees": "{angle}°",
    "counter-clockwise": "dans le sens trigonométrique",
    "clockwise": "dans le sens horaire",
    "extending": "de {tail} vers {head} (le vérin sort)",
    "retracting": "de {head} vers {tail} (le vérin rentre)",
    "outwards": "de {tail} vers {head}",
    "inwards": "de {head} vers {tail}",
    "right": "vers la droite",
    "left": "vers la gauche",
    "up": "vers le haut",
    "down": "vers le bas",
    # --- le quadrilatère sphérique et les polygones de corps
    # position
    "spherical along": "suivant {axis}",
    "spherical frame": (
        "Les axes fixes percent la sphère de centre *O* en *A* et en *D*, à {size}° ; *OA* et "
        "*OD* sont dans la feuille."
    ),
    "spherical crank angle": (
        "Vue suivant *AO*, la manivelle est à {angle}° de l’arc *AD*, dans le sens trigonométrique."
    ),
    "spherical crank": (
        "*B* tourne autour de *OA* sur ce cercle, vu par la tranche : *AB* = {size}°."
    ),
    "spherical C": (
        "*C* est à l’intersection de deux cercles : autour de *B*, *BC* = {coupler}° ; autour de "
        "*D*, *DC* = {rocker}°, vu par la tranche."
    ),
    "spherical bars": (
        "La bielle *BC* est à *θ_B* = {b}° de l’arc *AB* prolongé ; de *CD* à *CB*, *θ_C* = {c}°."
    ),
    "spherical rocker angle": (
        "Vu suivant *DO*, le balancier est à {symbol} = {angle}° de l’arc *AD* prolongé."
    ),
    "spherical I": (
        "Les grands cercles de *BC* et *AD* se coupent en *I* sous *δ* = {delta}° ; *AI* = "
        "{ai}°, *DI* = {di}°. *OI* est l’axe du balancier par rapport à la manivelle."
    ),
    "spherical laid": (
        "Rabattus autour de *OI* sur la feuille, *OB* est à {b}° et *OC* à {c}° de *OI*."
    ),
    # polygones de corps
    "bodies remark": (
        "Triangle 1 2 4 dans le plan du bâti ; 2 3 4 dans celui de la bielle, rabattu"
    ),
    "bodies pole": "Le pôle est le bâti, {frame} ; {symbol} = {value} {unit}, suivant {axis}.",
    "bodies pole steady": ("Le pôle : le bâti, 1′, et 2′, car *α₂* = {value} est donné."),
    "bodies measured": "{symbol} = {value} {unit}.",
    "bodies whole": "|{symbol}| = {value} {unit}, de {tail} à {head}.",
    "bodies whole steady": (
        "|{symbol}| = {value} {unit}, de {tail} à {head} : comme *α₂* = 0, c’est le vecteur *α₄*."
    ),
    "bodies turned frame": (
        "|{symbol}·*τ̇*| = {omega} × ({apart}·cos *δ*)/sin({delta}°) = {value} {unit}, ⟂ *OI*. "
        "Parenthèse : composante de *ω₃* dans *BOC* ⟂ *OI*, par les distances de 3 et 1 à 2 4."
    ),
    "bodies turned coupler": (
        "|{symbol}·*τ̇₃*| = {omega} × ({apart}·cos *δ*)/sin({delta}°) = {value} {unit}, ⟂ *OI*. "
        "Parenthèse : composante dans *AOD*."
    ),
    "bodies turned paced": (
        "|{symbol}·*τ̇*| = {omega} × {pace} = {value} {unit}, ⟂ *OI*, avec *τ̇* = (*ω₄₂*·sin "
        "*IB*·sin *IC*/sin {bc}° − *ω₂*·sin *τ*·cos *δ*)/sin *δ* = {signed} {rad/s}."
    ),
    "bodies line 24 velocity": "∥ *OI* par {point}, axe du balancier par rapport à la manivelle",
    "bodies line 14 velocity": "∥ *OD* par {point}, son axe par rapport au bâti",
    "bodies line 23 velocity": (
        "∥ *OB* par {point}, à {arc}° de *OI*, axe de la bielle sur la manivelle"
    ),
    "bodies line 43 velocity": "∥ *OC* par {point}, à {arc}° de *OI*, son axe sur le balancier",
    "bodies line 24 acceleration": "∥ *OI* par {point}, suivant *α₄₂ₜ*",
    "bodies line 14 acceleration": "∥ *OD* par {point}, suivant *α₄*",
    "bodies line 23 acceleration": "∥ *OB* par {point}, à {arc}° de *OI*, suivant *α₃₂*",
    "bodies line 43 acceleration": "∥ *OC* par {point}, à {arc}° de *OI*, suivant *α₃₄*",
    "bodies fold": (
        "Le plan de la bielle est rabattu sur la feuille autour de *OI* : *OB* et *OC* y sont "
        "vrais."
    ),
    "bodies fold again": "De nouveau, ce plan est rabattu autour de *OI*.",
    "bodies sines": (
        "{symbol} = *ω₂*·sin *AI* / sin *DI* = {crank} × sin({ai}°) / sin({di}°) = {value} {unit}."
    ),
    # --- arbres et moteurs
    "balance axis": "{axis} est l’axe de l’arbre, vu de son bout.",
    "balance reference": "Les angles se mesurent à partir de cette droite.",
    "balance mass": "Masse {letter} : {mass} kg à {radius} {unit}, à {angle}°.",
    "balance open": "La masse {letter}, à {radius} {unit}, est à trouver.",
    "balance side": "Vu de côté : les plans le long de l’arbre.",
    "balance plane": "Le plan de {letter}.",
    "balance forces": "La somme des vecteurs *m·r* est nulle.",
    "balance couples": ("La somme des vecteurs *m·r·l* autour du plan de {reference} est nulle."),
    "balance known force": (
        "{letter} : *m·r* = {mass} × {radius} = {value} {unit}, vers l’extérieur."
    ),
    "balance known couple": (
        "{letter} : *m·r·l* = {mass} × {radius} × {arm} = {value} {unit}, vers l’extérieur."
    ),
    "balance known couple inward": (
        "{letter} : *m·r·l* = {mass} × {radius} × {arm} = {value} {unit}, vers l’intérieur : "
        "son plan est de l’autre côté."
    ),
    "balance from couples force": ("{letter} est connu par les moments : *m·r* = {value} {unit}."),
    "balance from couples couple": "{letter} : *m·r·l* = {value} {unit}.",
    "balance closes": "Le vecteur qui ferme est {letter} : {value} {unit} à {angle}°.",
    "balance line": "{letter} est sur cette droite.",
    "balance arc": "{letter} mesure {value} {unit} : un arc de ce rayon.",
    "balance meet": "Ils se coupent : le polygone se ferme.",
    "balance meet twice": (
        "Ils se coupent : le polygone se ferme. Ils se coupent une seconde fois, dans la solution "
        "symétrique : choice {choice}."
    ),
    "balance other": "une solution symétrique équilibre aussi : choice {choice}",
    "balance about other": (
        "autour du plan de {reference} ; une solution symétrique équilibre aussi : choice {choice}"
    ),
    "balance about": "autour du plan de {reference}",
    "engine zero": (
        "Ici il se ferme ; dans un tour la résultante atteint {largest} {unit}, à {where}°."
    ),
    "engine rod": "La bielle et le piston de {letter}.",
    "engine stroke": "L’axe du cylindre {letter}.",
    "engine crank": "La manivelle de {letter} est à {angle}°.",
    "engine forces": "Les forces se portent bout à bout.",
    "engine couples": "Les moments autour du plan de référence se portent bout à bout.",
    "engine primary": "{letter} : {value} {unit} à l’angle de sa manivelle, {angle}°.",
    "engine secondary": "{letter} : {value} {unit} au double de l’angle de sa manivelle, {angle}°.",
    "engine direct": "Manivelle directe de {letter} : la moitié, {value} {unit}, à {angle}°.",
    "engine reverse": "Manivelle inverse de {letter} : la moitié, {value} {unit}, à {angle}°.",
    "engine turning": "La masse {letter} tourne avec l’arbre : {value} {unit} à {angle}°.",
    "engine resultant": "La résultante {letter} est {value} {unit} à {angle}°.",
    "engine ellipse": (
        "Dans un tour son extrémité décrit cette ellipse : {letter} vaut au plus {largest} "
        "{unit}, à {where}°, et au moins {least} {unit}."
    ),
    "engine circle": "Son extrémité décrit ce cercle : {letter} vaut toujours {largest} {unit}.",
    "engine straight": (
        "Son extrémité va et vient sur cette droite : "
        "{letter} vaut au plus {largest} {unit}, à {where}°."
    ),
    "engine turned": "L’arbre a tourné de {angle}°.",
    "engine closing primary": (
        "Le vecteur de fermeture {letter} est {value} {unit} à {angle}°. Il tourne avec la "
        "manivelle."
    ),
    "engine closing secondary": (
        "Le vecteur de fermeture {letter} est {value} {unit} à {angle}°. Il tourne deux fois plus "
        "vite que la manivelle."
    ),
    "engine across": "Seule sa part selon la course agit.",
    "engine nothing": (
        "Ici rien n’en agit ; dans un tour {letter} atteint {largest} {unit}, à {where}°."
    ),
    "engine resultant in line": (
        "{letter} = {value} {unit} selon la course ; dans un tour au plus {largest} {unit}, à "
        "{where}°."
    ),
    "engine left out": (
        "Les deux termes négligent au plus {value} {unit} de la force exacte, à {angle}°."
    ),
    "engine balanced": "Le polygone se ferme : équilibré.",
    "traction forces": (
        "Ce qui va et vient sans être équilibré tire le long de la voie : l’effort de "
        "traction varie."
    ),
    "traction couples": (
        "Il fait tourner la locomotive autour de son milieu : les couples sont mis bout à bout."
    ),
    "hammer blows": (
        "Ce que les roues équilibrent le long de la voie, elles l’ajoutent en travers : le "
        "martèlement."
    ),
    "hammer vector": (
        "{mass} kg de {letter} équilibrent ce qui va et vient ; ils tirent avec {value} "
        "{unit} à {angle}°."
    ),
    "hammer across": "Seule la part perpendiculaire à la voie agit sur le rail.",
    "hammer nothing": (
        "La roue {letter} n’est ici ni soulevée ni pressée ; elle presse avec {largest} "
        "{unit} à {pressing}°."
    ),
    "hammer lifts": (
        "La roue {letter} est soulevée avec {value} {unit} ; elle presse avec {largest} "
        "{unit} à {pressing}°."
    ),
    "hammer presses": (
        "La roue {letter} presse le rail avec {value} {unit} ; au plus avec {largest} "
        "{unit}, à {pressing}°."
    ),
    "balance found": "{letter} = {value} {unit} à {angle}°.",
    # --- le joint de Cardan
    # position
    "hooke along": "vu suivant l’arbre 2",
    "hooke plan": "plan des arbres",
    "hooke shafts": (
        "Les arbres 2 et 4 se coupent en *O* sous *β* = {angle}° : en bas en vraie grandeur, en "
        "haut vus suivant l’arbre 2."
    ),
    "hooke P": (
        "*P*, le tourillon de la fourche 2, décrit ce cercle et se trouve à {angle}° ; *OP* est "
        "un bras du croisillon, 3."
    ),
    "hooke ellipse": (
        "*Q*, le tourillon de la fourche 4, tourne autour de l’arbre 4 : son cercle est vu comme "
        "une ellipse, rétrécie par le facteur cos {angle}°."
    ),
    "hooke Q": (
        "*OP* est dans la feuille, donc son angle droit avec *OQ* se voit en vraie grandeur : "
        "cette droite coupe l’ellipse en *Q*."
    ),
    "hooke theta 4": (
        "*Q* est ramené sur le cercle, parallèlement au plan des arbres : {theta} = {value}° y est "
        "en vraie grandeur, tan {theta} = {ratio}."
    ),
    "hooke ratio": "tan {theta} / cos {shafts}",
    "hooke speed range": "*ω₄*/*ω₂* = {low} … {high}",
    "hooke tangent": "tan {theta}",
    "hooke plan view": (
        "En bas, avec *OP* = *OQ* = 1, *Q* est à sin *ψ_P* = sin *β*·sin *θ₄* du plan ⟂ l’arbre "
        "2, *P* à sin *ψ_Q* = sin *β*·cos *θ₂* de celui ⟂ 4 : le croisillon a *ψ_P* = {at_p}°, "
        "*ψ_Q* = {at_q}°."
    ),
    "hooke T": "La droite qui joint {one} et {other} perce le plan des arbres en *T*.",
    "hooke other end": "l’autre bout de *O*{pin}",
    "hooke OT": (
        "*T*, reporté à l’aplomb, donne *OT*, où le plan du croisillon coupe celui des arbres : "
        "par Thalès, tan *τ* = tan {shafts}°·sin² {theta}°, *τ* = {tau}°."
    ),
    "hooke tau": "*τ*",
    "hooke laid": (
        "Rabattus autour de *OT* sur le plan des arbres, *OP* est à {at_p}° de *OT*, de cosinus "
        "cos *τ*·cos *θ₂*, et *OQ*, ⟂ *OP*, à {at_q}°."
    ),
    # polygones
    "hooke speeds": "*ω₂*, *ω₄* portées à chaque *θ₂*",
    "hooke shaft": "l’arbre {shaft}",
    "hooke line 24 velocity": (
        "∥ *OT* par {point}, car *ω₄₂* de l’arbre 4 par rapport à 2 est dans les deux plans"
    ),
    "hooke line 14 velocity": "∥ l’arbre 4 par {point}, axe de la fourche 4",
    "hooke line 23 velocity": "∥ *OP* par {point}, axe du croisillon dans la fourche 2",
    "hooke line 43 velocity": "∥ *OQ* par {point}, son axe dans la fourche 4",
    "hooke line 24 acceleration": "∥ *OT* par {point}, suivant *α₄₂ₜ*",
    "hooke line 14 acceleration": "∥ l’arbre 4 par {point}, suivant *α₄*",
    "hooke cross": (
        "{symbol} = {value} {unit} ; *OP* est ⟂ l’arbre 2, donc *ω₃* = √({crank}² + {size}²) = "
        "{whole} {unit} ; 1 3 joint deux plans et n’est pas *ω₃*."
    ),
    "hooke driven": "{symbol} = {value} {unit} ; sur un tour, de {low} à {high} fois *ω₂*.",
    "hooke fold": "*OP* et *OQ* restent ainsi rabattus.",
    "hooke turned paced": (
        "|{symbol}·*τ̇*| = {omega} × {pace} = {value} {unit}, ⟂ *OT*, qui tourne à *τ̇* = *ω₂*·tan "
        "*β*·sin 2*θ₂*·cos² *τ*, en dérivant tan *τ*."
    ),
    # la construction de Klein
    "klein rod": "La droite de la bielle {b}{c}, prolongée.",
    "klein square": "Par {a}, perpendiculaire à la glissière.",
    "klein M": (
        "*M* est où les deux droites se coupent : {a}{b}*M* est le polygone des vitesses, tourné "
        "de 90°."
    ),
    "klein rod 1": (
        "{side} = {size} : {c} a, par rapport à {b}, *v* = {omega}·{side} = {rate} × {size} = "
        "{value} {unit}."
    ),
    "klein slider 1": (
        "{side} = {size} : le coulisseau a *v* = {omega}·{side} = {rate} × {size} = {value} {unit}."
    ),
    "klein circle M": "Un cercle de centre {b} par *M*.",
    "klein circle rod": "Un cercle dont la bielle {b}{c} est le diamètre.",
    "klein K": "*K* est où les deux cercles se coupent.",
    "klein L": "*L* est où ils se coupent encore.",
    "klein chord": "La corde *KL* est perpendiculaire à la bielle.",
    "klein Q": (
        "*Q* est où *KL* coupe la bielle : {b}*Q* est son accélération normale, divisée par ω²."
    ),
    "klein guide": "Par {a}, le long de la glissière.",
    "klein N": (
        "*N* est où *KL* coupe cette droite : {a}{b}*QN* est le polygone des accélérations, tourné "
        "de 180°."
    ),
    "klein rod 2": (
        "{side} = {size} : {c} a, par rapport à {b}, *a*ₜ = {omega}²·{side} = {rate} × {size} = "
        "{value} {unit}."
    ),
    "klein slider 2": (
        "{side} = {size} : le coulisseau a *a* = {omega}²·{side} = {rate} × {size} = {value} "
        "{unit}."
    ),
    "klein remark": "{a}{b} : {b}*M* : {a}*M*   et   {a}{b} : {b}*Q* : *QN* : {a}*N*",
    # centres instantanés
    "centre bodies": "{count} corps ont {all} centres instantanés : un pour deux d’entre eux.",
    "centre in": "{letter} en {point}",
    "centre pins": "Les articulations sont des centres : {centres}.",
    "centre all pins": "Chaque articulation est le centre des corps qu’elle joint.",
    "centre slide": "{letter} est à l’infini, en travers {line:du} : un corps glisse sur l’autre.",
    "centre line": "Trois corps ont leurs centres alignés : {letter} avec {one} et {other}.",
    "centre line far": (
        "{letter} est aligné avec {one} et {other}, qui est à l’infini et donne la direction."
    ),
    "centre found": "{letter} est où les deux droites se coupent.",
    "centre away": "{letter} est où les deux droites se coupent, à {size} {unit} de {other}.",
    "centre away label": "{letter} : {size} {unit} de {other}",
    "centre far": "Les deux droites sont parallèles : {letter} est à l’infini.",
    "centre far label": "{letter} à l’infini",
    "centre alike": "Les deux corps tournent de même : {letter} est à l’infini sur cette droite.",
    "centre ratio": (
        "{symbol} = {omega}·{first}/{second} = {rate} × {one}/{other} = {value} {unit}, {sense}."
    ),
    "centre speed": (
        "{both} est un point des deux corps : *v* = {omega}·{first} = {rate} × {one} = {value} "
        "{unit}."
    ),
    "centre turning": (
        "{both} est un point des deux corps : {symbol} = *v*/{second} = {rate}/{other} = {value} "
        "{unit}, {sense}."
    ),
    "centre cylinder": (
        "Tige et cylindre tournent de même : {symbol} = *v*/{second} = {rate}/{other} = {value} "
        "{unit}, {sense}."
    ),
    "centre still": "{letter} est à l’infini : {link:le} ne tourne pas dans cette position.",
    "centre same": "{both} est à l’infini : les deux corps ont ici le même mouvement.",
    "centrode fixed": "Dans toutes les positions {letter} est sur cette courbe : la base.",
    "centrode under": "Vu {link:du}, {letter} est sur cette courbe dans toutes les positions.",
    "centrode moving": (
        "Vu {link:du}, {letter} est sur cette courbe : la roulante, qui roule sur l’autre."
    ),
    # le polygone des vitesses tourné
    "turned pole": (
        "Le pôle est en {pivot} : les vitesses sont tournées de 90° et divisées par {omega}."
    ),
    "turned crank": "Ainsi {label} est {crank:le} {bar} même.",
    "turned along": "Une vitesse perpendiculaire à {bar}, tournée, est le long de {bar}.",
    "turned square": "Une vitesse le long {line:du}, tournée, lui est perpendiculaire.",
    "turned crossing": "{letter} est où les deux droites se coupent.",
    "turned omega": (
        "{label} = {size}, donc {symbol} = {omega}·{label}/{bar} = {rate} × {size}/{length} = "
        "{turning} {rad/s}, {sense}."
    ),
    "turned speed": "{label} = {size} : *v* = {omega}·{label} = {rate} × {size} = {value} {unit}.",
    # forces
    "force nothing": "Aucune liaison ne porte d’effort : seul l’entraînement est chargé.",
    "force force": "{label} = {value} {unit}, la charge appliquée {link:au} en {point}.",
    "force weight": "{label} = {value} {unit}, le poids {link:du} en {point}.",
    "force inertia": (
        "{label} = *m*·*a* = {mass} {heavy} × {size} {fast} = {value} {unit}, la force d’inertie "
        "{link:du}, opposée à l’accélération de {point}."
    ),
    "force couple": "{label} = {value} {unit}, {sense}, le couple appliqué {link:au}.",
    "force spin": (
        "{label} = *I*·{symbol} = {inertia} {heavy} × {alpha} {turning} = {value} {unit}, {sense}, "
        "le couple d’inertie {link:du}, opposé à {symbol}."
    ),
    "force moved": (
        "Déplacée de *h* = {couple}/{label} = {moment} {turning}/({value} {unit}) = {arm} "
        "{length}, {label} a aussi, à elle seule, le moment de {couple}."
    ),
    "force friction": "{label} = {value} {unit}, le frottement appliqué {link:au} en {point}.",
    "force joint": (
        "{label} = {value} {unit} : la réaction {other:du} appliquée {link:au}, opposée à "
        "{opposite}."
    ),
    "force along": "{label} = {value} {unit} retient ce qui agit {link:au} suivant sa ligne.",
    "force moments": (
        "Moments autour de {point} : {label} = {moment} {turning}/({size} {length}) = {value} "
        "{unit}, ⟂ {bar}."
    ),
    "force square": "{label} est perpendiculaire à la ligne sur laquelle {link:le} coulisse.",
    "force two": (
        "Deux forces seulement agissent sur {link:le} {bar} : elles sont portées par {bar}."
    ),
    "force line": "La ligne d’action de {label}.",
    "force meeting": (
        "Trois forces en équilibre passent par un même point : sur {link:le}, {label} et {force} "
        "se coupent en {letter}."
    ),
    "force three": "{label} passe donc aussi par {point} et {meeting}.",
    "force rest": "Le reste de la force, {label}, est porté par {bar}.",
    "drive along": "{label} est suivant la ligne sur laquelle {link:le} coulisse.",
    "drive force": "{label} = {value} {unit} doit entraîner {link:le} suivant sa ligne.",
    "force closes": "Les deux droites se coupent : le polygone se ferme.",
    "force part": "{label} = {value} {unit}, mesurée.",
    "force pushes": "{label} = {value} {unit} : {one:le} pousse {other:le}.",
    "force pulls": "{label} = {value} {unit} : {one:le} tire {other:le}.",
    "force on": "{label} = {value} {unit} : l’effort {one:du} sur {other:le}.",
    "force arm": "*h* = {arm} {length} est la distance de {point} à cette droite.",
    "torque none": "Les moments autour de {point} s’annulent : aucun couple n’est nécessaire.",
    "torque": (
        "Moments autour de {point} : *T* = {torque} {turning}, {sense}, doit agir sur {link:le}."
    ),
    "torque sum": (
        "Moments autour de {point} : *T* = {terms} = {torque} {turning}, {sense}, doit agir sur "
        "{link:le}."
    ),
    "superposed part": "{label} = {value} {unit} est due à {loads} seul.",
    "superposed alone": "{loads} seul : {said}",
    "drive superposed": (
        "{label} = {symbols} = {terms} = {value} {unit} doit entraîner {link:le} suivant sa ligne."
    ),
    "superposed sum": (
        "{label} = {terms} = {value} {unit}, en vecteurs : l’effort {one:du} sur {other:le}."
    ),
    "torque superposed": (
        "*T* = {symbols} = {terms} = {torque} {turning}, {sense}, doit agir sur {link:le}."
    ),
    "power one": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt} ; {symbols} = {taken} "
        "{watt} : au total zéro."
    ),
    "power": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt} ; {symbols} = {terms} "
        "= {taken} {watt} : au total zéro."
    ),
    "power all": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt} ; la puissance de "
        "toutes les charges est {taken} {watt} : au total zéro."
    ),
    "force torque": (
        "*T* = {label}·*h* = {value} {unit} × {arm} {length} = {torque} {turning}, {sense}, doit "
        "agir sur {link:le}."
    ),
    "force whole": (
        "{label} = √({known}² + {found}²) = {value} {unit} : l’effort {one:du} sur {other:le}."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
    # --- le quadrilatère spatial
    # position
    "spatial star": "suivant *DA*",
    "spatial rose": "suivant *A*",
    "spatial rose D": "suivant *D*",
    "spatial frame": (
        "*AD* = {size} {unit} est la normale commune des axes en *A* et en *D*, à {twist}° ; en "
        "*D* le balancier glisse aussi."
    ),
    "spatial crank": (
        "La manivelle *AB* = {size} {unit} est à {angle}° de *AD*, vue suivant son axe."
    ),
    "spatial b": (
        "L’axe en *B* est ⟂ *AB*, à {twist}° de celui en *A* ; la bielle y tourne et y glisse."
    ),
    "spatial directions": (
        "*OA* à *OD* sont ∥ les axes : les plans *AOD*, *BOC* se coupent en *OI* sous *δ* = "
        "{delta}°, à *τ* = {tau}° de *OA* ; *IB* = {ib}°, *IC* = {ic}°."
    ),
    "spatial slides": (
        "Trois longueurs ferment la chaîne : *s_B* = {b}, *s_C* = {c}, *s_D* = {d} {unit}."
    ),
    "spatial bars": (
        "La bielle *BC* = {coupler} {unit}, le balancier *DC* = {rocker} {unit} à *θ₄* = {theta}°."
    ),
    "spatial H": (
        "Par rapport à la manivelle, le balancier tourne autour de *I* ∥ *OI* et y glisse ; *I* "
        "est ⟂ *BC* et, en *H*, ⟂ *AD* : *AH* = {height} {unit}."
    ),
    # les polygones du bas
    "spatial pole velocity": (
        "En bas, vu suivant *DA* : *A* comme point du balancier, de vitesse *aa₄*."
    ),
    "spatial pole acceleration": ("*ay* et *ya₄* tournent avec *OI* et varient."),
    "spatial about I velocity": (
        "{label} = |*ω₄₂*·*AH*| = {turn} × {lever} = {value} {unit}, ⟂ *OI* : *A* tourne autour "
        "de *I*."
    ),
    "spatial turned": "{label} = *aa₄*·|*τ̇*| = {speed} × {pace} = {value} {unit}, ⟂ *aa₄*.",
    "spatial about I acceleration": (
        "{label} = |*α₄₂ₜ*·*AH* + *ω₄₂*·*ḣ*| = {sum} = {value} {unit}, ⟂ *OI* ; *AH* croît de "
        "*ḣ* = {rising} {pace}, partie duale de *τ̇*."
    ),
    "spatial about D velocity": (
        "{label} = |{symbol}|·*AD* = {turn} × {lever} = {value} {unit}, ⟂ *OD* : aussi "
        "autour de *D*."
    ),
    "spatial about D acceleration": (
        "{label} = |{symbol}|·*AD* = {turn} × {lever} = {value} {unit}, ⟂ *OD*."
    ),
    "spatial along I": "∥ *OI* par {point}",
    "spatial along D velocity": "∥ *OD* par {point}, car *A* glisse sur les deux",
    "spatial along D acceleration": "∥ *OD* par {point}",
    # --- le quadrilatère à rotules
    # position
    "balls ahead": "devant",
    "balls behind": "derrière",
    "balls crank": (
        "En bas, vue suivant l’axe de *A* : la manivelle *AB* = {size} {unit}, à {angle}° de la "
        "normale commune."
    ),
    "balls path of C": (
        "En haut, vu suivant l’axe de *D* : *C* décrit ce cercle, *DC* = {size} {unit} ; *A* et "
        "*B* sont au-dessus."
    ),
    "balls compass": (
        "*B* est à {height} {unit} {side} le plan de ce cercle : ici *BC* = √({size}² − "
        "{height}²) = {reach} {unit}."
    ),
    "balls compass square": (
        "*B* est à {offset} + {crank}·sin {angle}° = {height} {unit} derrière le plan du cercle "
        ": ici *BC* = √({size}² − {height}²) = {reach} {unit}."
    ),
    "balls offset": "{size}",
    "balls C": "Les cercles se coupent en *C* ; le balancier *DC* est à {theta} = {angle}°.",
    "balls top": "Au-dessous, *C* complète la vue du bas.",
    "balls third": (
        "Rabattu autour de la tangente à la trajectoire de *C*, le plan de celle-ci et de *BC* "
        "est en vraie grandeur ; le plan ⟂ *BC* est une droite."
    ),
    "balls askew": (
        "Projections : *p_AB* = {seen_AB}, *p_DC* = {seen_DC}, *p_BT* = {seen_BT} (*BT* : *AB* "
        "tournée de 90°) ; positif vers l’arrière *h_AB* = {off_AB}, *h_DC* = {off_DC}, *h_BT* = "
        "{off_BT} {unit}."
    ),
    "balls along D": "vu suivant *D*",
    "balls along A": "vu suivant *A*",
    "balls along both": "plan de *BC* et de la trajectoire de *C* en vraie grandeur",
    # polygones
    "balls path": "trajectoire de *C*",
    "balls remark": (
        "dans le plan de *BC* et de la trajectoire de *C* ; la bielle ne tourne pas autour de *BC*"
    ),
    "balls tangential": "{label} = {symbol}·*p_BT* = {rate} × {size} = {value} {unit}, ∥ *BT*.",
    "balls normal": (
        "{label} = {symbol}²·{length} = {rate} × {size} = {value} {unit}, de {head} vers {tail}."
    ),
    "balls line BC velocity": "⟂ *BC* par {point}, car *BC* garde sa longueur",
    "balls line DC velocity": "∥ la trajectoire de *C* par {point}",
    "balls line BC acceleration": "⟂ *BC* par {point}, suivant {symbol}·*BC*",
    "balls line DC acceleration": "∥ la trajectoire de *C* par {point}, suivant {symbol}·*DC*",
    "balls coupler velocity": "{symbol} = {label}/*BC* = {value}/{size} = {rate} {rad/s}.",
    "balls coupler velocity askew": (
        "{label} = {value} {unit} ici, vers l’arrière {sum} = {off} {unit} : en tout {symbol} = "
        "{whole}/{size} = {rate} {rad/s}."
    ),
    "balls coupler acceleration": "{symbol} = {label}/*BC* = {value}/{size} = {rate} {rad/s²}.",
    "balls coupler acceleration askew": (
        "{label} = {value} {unit} ici, vers l’arrière {sum} = {off} {unit} : en tout {symbol} = "
        "{whole}/{size} = {rate} {rad/s²}."
    ),
    "balls rocker velocity": "{symbol} = {label}/*DC* = {value}/{size} = {rate} {rad/s}, {sense}.",
    "balls rocker acceleration": (
        "{symbol} = {label}/*DC* = {value}/{size} = {rate} {rad/s²}, {sense}."
    ),
    "balls whole": "{label} = {value} {unit} ici.",
    # images et tableaux de balayages, et caractéristiques
    "angle of the driver": "angle {link:du}",
    "position of the driver": "position {link:du}",
    "force of one on another": "{one} sur {other}",
    "transmission angle": "angle de transmission",
    "time ratio": "rapport des temps",
    "forward angle": "angle de l’aller",
    "return angle": "angle du retour",
    "mechanical advantage": "avantage mécanique",
    "does not close": "ne se ferme pas",
    "merit output": "sortie",
    "merit grashof": "Grashof",
    "merit ranges": "se ferme pour",
    "merit dead": "points morts",
    "merit least": "plus petit angle de transmission",
    "merit largest": "plus grand angle de transmission",
    "merit none": "aucun",
    "merit every angle": "tout angle",
    "merit and": "{first} et {last}",
    "merit at": "{value} à {place}",
    "grashof crank-rocker": "manivelle-balancier",
    "grashof double-crank": "double manivelle",
    "grashof double-rocker": "double balancier à bielle tournante",
    "grashof rocker-crank": "balancier-manivelle",
    "grashof triple-rocker": "triple balancier",
    "grashof change point": "point de changement",
    "merit rubbing": "glissement à l’axe",
    "merit pair": "{pin} : {one} sur {other}",
    "merit diameter": "diamètre",
    "merit velocity": "vitesse",
    "merit slowest": "point le plus lent",
    "merit distance": "depuis la première extrémité",
    "merit speed": "vitesse",
    "merit on link": "sur la pièce",
    "merit yes": "oui",
    "merit no": "non",
    "merit extremes": "extrêmes",
    "merit minimum": "minimum",
    "merit maximum": "maximum",
    "merit place": "à",
}

#: Noms des mécanismes, des diagrammes, des pièces et des dimensions.
NAMES = {
    "drive": "entraînement",
    "joint": "liaison",
    "Shaft": "Arbre",
    "Couples": "Moments",
    "Engine": "Moteur",
    "Tractive force": "Effort de traction",
    "Hammer blow": "Martèlement",
    "Primary forces": "Forces primaires",
    "Secondary forces": "Forces secondaires",
    "engine_cylinder": "cylindre",
    "largest": "maximum",
    "resultant": "résultante",
    "Position": "Position",
    "Velocity": "Vitesse",
    "Acceleration": "Accélération",
    "Drive": "Entraînement",
    "Instantaneous centres": "Centres instantanés",
    "Klein’s construction": "Construction de Klein",
    "Turned velocities": "Vitesses tournées",
    "Forces": "Forces",
    "loads": "charges",
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
    "actuator_rod": "tige",
    "cylinder_rod": "tige",
    "frame": "bâti",
    "mass": "masse",
    "inertia": "moment d’inertie",
    "friction": "frottement",
    "angle": "angle",
    "radius": "rayon de giration",
    "piston": "piston",
    "pin": "axe",
    "ground": "bâti",
    "slider": "coulisseau",
    "block": "coulisseau",
    "ram": "coulant",
    "yoke": "joug",
    "length": "longueur",
    "guide": "glissière",
    "slot": "rainure",
    "offset": "désaxage",
    "tracer": "point traceur",
    "ram_height": "hauteur du coulant",
    "ground_angle": "angle du bâti avec x",
    "guide_a": "glissière A",
    "guide_b": "glissière B",
    "Spherical four-bar": "Quadrilatère sphérique",
    "Hooke’s joint": "Joint de Cardan",
    "driving": "arbre moteur",
    "driven": "arbre mené",
    "cross": "croisillon",
    "shaft_angle": "angle de brisure β",
    "Spatial four-bar": "Quadrilatère spatial",
    "axis": "axe",
    "Spatial four-bar with ball joints": "Quadrilatère spatial à rotules",
    "ground_twist": "angle des axes",
    "crank_offset": "décalage de la manivelle",
    "rocker_offset": "décalage du balancier",
    "ratio": "rapport",
    "coupled": "essieux accouplés",
    "reference": "plan de référence",
    "rotating": "masse tournante",
    "balance_radius": "rayon d’équilibrage",
    "wheel_diameter": "diamètre des roues",
    "wheel_load": "charge par roue",
    "coupling": "masse d’accouplement",
    "coupling_radius": "rayon des tourillons d’accouplement",
    "coupling_angle": "angle des tourillons d’accouplement",
    "{}_angle": "angle {}",
    "{}_offset": "décalage {}",
    "{}_mass": "masse {}",
    "{}_radius": "rayon {}",
    "{}_crank": "angle de manivelle {}",
    "{}_plane": "plan {}",
    "{}_line": "angle du cylindre {}",
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
    "actuator_rod": "f",
    "cylinder_rod": "f",
    "frame": "m",
    "piston": "m",
    "pin": "m",
    "slider": "m",
    "block": "m",
    "ram": "m",
    "yoke": "m",
    "guide": "f",
    "slot": "f",
    "driving": "mv",
    "driven": "mv",
    "cross": "m",
    "axis": "m",
}

#: L’article masculin que demande une phrase, et ce qu’il devient selon le genre.
ARTICLES = {
    "m": {"le": "le {}", "du": "du {}", "au": "au {}"},
    "mv": {"le": "l’{}", "du": "de l’{}", "au": "à l’{}"},
    "f": {"le": "la {}", "du": "de la {}", "au": "à la {}"},
}

#: Le signe décimal.
POINT = ","

#: Aucune ligne ne commence par ces signes : l’espace qui les précède est insécable.
TIED = (" :", " ;")

#: Boutons et textes de la page d’une leçon.
PLAYER = {
    "play": "Lire",
    "pause": "Pause",
    "first": "Au début",
    "back": "Un trait en arrière",
    "forward": "Un trait en avant",
    "last": "À la fin",
    "speed": "Vitesse",
    "strokes": "Tous les traits",
    "theme": "Tableau ou papier",
    "full-screen": "Plein écran",
    "large": "Agrandir une figure",
    "keys": "Touches",
    "letters": "Raccourcis d’un seul signe",
    "travels": "Les vecteurs voyagent",
    "close": "Fermer",
    "scrub": "Traits dessinés",
    "drawn": "{panel} : {done} traits dessinés sur {count}",
    "begin": "Lire la leçon, ou avancer trait par trait.",
    "controls": "Lecteur",
    "parts": "Diagrammes",
    "key-space": "Espace",
    "key-home": "Début",
    "key-end": "Fin",
    "key-up": "Page↑",
    "key-down": "Page↓",
}

#: Les mots d’une page où l’on tourne un mécanisme à la main.
HAND = {
    "lesson": "Leçon",
    "hand": "Main",
    "mode": "Leçon ou main",
    "undo": "Annuler",
    "redo": "Rétablir",
    "turn-crank": "Vous tournez la manivelle.",
    "turn-link": "Vous tournez la pièce menante.",
    "move-slide": "Vous déplacez la pièce menante.",
    "runs": "Le mécanisme tourne seul.",
    "shown": "On voit ce qui est dessiné jusqu’à {panel} {step}.",
    "return": "Retour à {panel} {step}",
    "return-short": "Retour",
    "return-lesson": "Retour à la leçon",
    "show-all": "Tout montrer",
    "limit": "Position limite à {place} : {why}.",
    "parted": "au-delà, les pièces se séparent",
    "parting-bars": "{one} et {other} sont alignés",
    "parting-guide": "{one} est perpendiculaire à la glissière",
    "parting-slot": "{one} est perpendiculaire à la coulisse",
    "parting-spherical-four-bar": "B, C et D sont sur un grand cercle",
    "parting-rssr": "la bielle BC est perpendiculaire à la trajectoire de C",
    "other-assembly": "Continuer dans l’autre montage",
    "dead": "Point mort à {place} : ici les vitesses n’ont pas de valeur.",
    "unclosed": "{name} {place} : les pièces ne ferment pas ; elles ferment pour {ranges}",
    "unclosed-nowhere": "{name} {place} : avec ces dimensions, les pièces ne ferment nulle part",
    "guarded": "Au-delà de {name} {value} l’image ne vaut plus : le curseur s’arrête ici.",
    "try": "essayez {name} {value}",
    "unknown": "{name} : cette page n’a pas une telle entrée",
    "known": "elle a {names}",
    "no-number": "{name} : il faut un nombre fini, pas {value}",
    "positive": "{name} : il faut un nombre positif, pas {value}",
    "beyond": "{name} : il faut de {low} à {high} {unit}, où les nombres sont justes, pas {value}",
    "assembly": "assembly : doit être {names} dans cette page, et non {value}",
    "other-page": "il a sa propre page : vad draw --assembly {value}",
    "or": " ou ",
    "assemblies": "Montage",
    "request": "il faut un objet de noms et de nombres",
    "crank": "Angle de la manivelle",
    "link": "Angle de la pièce menante",
    "slide": "Place de la pièce menante",
    "far-back": "Un quart de tour en arrière",
    "far-on": "Un quart de tour en avant",
    "little-back": "1° en arrière",
    "little-on": "1° en avant",
    "more-back": "Un quart de la course en arrière",
    "more-on": "Un quart de la course en avant",
    "step-back": "Un pas en arrière",
    "step-on": "Un pas en avant",
    "degrees": "{value} degrés",
    "motion": "Mouvement",
    "dimensions": "Dimensions",
    "more": "{count} autres dimensions",
    "show": "Montrer",
    "curves": "Courbes",
    "hodographs": "Hodographes",
    "paths": "Trajectoires",
    "names": "Lettres",
    "step": "step : il faut une étape de la leçon, pas {value}",
    "unheld": "avec ces dimensions, cette page dessinerait du faux",
    "steps-are": "un nombre de 0 à {count}, ou comme velocity:4",
    "pole": "{name} est le pôle",
    "vertex": "{name} {size} à {angle}",
    "hide-row": "Montrer ou cacher {name}",
    "settings": "Réglages",
    "no-polygon": "pas de plan dans cette position",
    "key-escape": "Échap",
    "page-keys": "15° en arrière / en avant",
    "fine": "par 0,1°",
    "ring": "Tirer l’anneau",
    "and": " et ",
}

#: Les signes tels qu’on les lit à voix haute ; « ^ » est une puissance.
SPOKEN = {
    "√": "racine de ",
    "∠": "angle",
    "⟂": "perpendiculaire à",
    "∥": "parallèle à",
    "′": " prime",
    "̇": " point",
    "̈": " deux points",
    "″": " seconde",
    "·": " fois ",
    "×": " fois ",
    "+": " plus ",
    "−": "moins ",
    "=": "égale",
    "|": " ",
    "/": " sur ",
    "/s": " par seconde",
    "°": " degrés",
    "^": "puissance {}",
    "^2": "au carré",
    "α": "alpha",
    "β": "bêta",
    "θ": "thêta",
    "δ": "delta",
    "τ": "tau",
    "ψ": "psi",
    "ω": "oméga",
    "φ": "phi",
}

#: Ce que dit la fenêtre de ``vad gui``.
WINDOW = {
    "title": "vad : polygones des vitesses et des accélérations",
    "language": "Langue",
    "mechanism": "Mécanisme",
    "dimensions": "Dimensions",
    "assembly": "Montage",
    "motion": "Mouvement d’entrée",
    "angle": "angle θ",
    "position": "position",
    "open": "ouvert",
    "crossed": "croisé",
    "upper": "en haut",
    "lower": "en bas",
    "left": "à gauche",
    "right": "à droite",
    "parallel": "parallèle",
    "draw": "Tracer",
    "reset": "Réinitialiser",
    "link": "Copier le lien",
    "linked": "Le lien est copié.",
    "save": "Enregistrer en",
    "saving": "Enregistrement …",
    "saved": "Enregistré : {name}",
    "command": "Copier la commande",
    "copied": "Copié : {line}",
    "retry": "Réessayer",
    "try": "essayer {values}",
    "stopped": "vad gui est arrêté. Relancez-le dans le terminal.",
    "large": "{name} est trop grand : la fenêtre ouvre des fichiers de moins de {most} ko.",
    "examples": "Exemples",
    "turn": "Tour",
    "problem": "Énoncé",
    "file": "Ouvrir …",
    "controls": "Ce qui est réglé",
    "slider": "{name}, curseur",
}

# Ce que la fenêtre dit à la place des phrases anglaises.
ERRORS = {
    "'{text}' is not a number": "« {text} » n’est pas un nombre",
    "'{text}' is not {what}": "« {text} » n’est pas une unité qui convient ici",
    "try {input} {value}": "essayez {input} {value}",
    "try {units}": "essayez {units}",
    "with a point, as in 1.5": "avec une virgule, comme dans 1,5",
    "write 60 or '60 {unit}'": "écrivez 60 ou 60 {unit}",
    "must be a finite number, got {value}": "doit être un nombre fini, pas {value}",
    "must be positive, got {value}": "doit être positif, pas {value}",
    "must be within ±{most}, got {value}": "doit être entre −{most} et {most}, pas {value}",
    "must be between {low} and {high}, got {value}": "doit être entre {low} et {high}, pas {value}",
    "must be at least {low}, got {value}": "doit être au moins {low}, pas {value}",
    "at {places} both axes are one": "à {places} les deux axes n’en font qu’un",
    "at {place} it locks": "à {place} il se bloque",
    "parallel axes make a four-bar in the plane": (
        "des axes parallèles donnent un quadrilatère plan"
    ),
    "must differ from {other}, got {value}, which is the same line": (
        "doit être différent de {other} : {value} est la même droite"
    ),
    "{input} {place}: the links miss by {miss}; they close for {input} {ranges}": (
        "À {place} il manque {miss} aux pièces ; elles ferment pour {input} {ranges}"
    ),
    "{input} {place}: the links miss by {miss}; with these lengths they close at no {input}": (
        "À {place} il manque {miss} aux pièces ; avec ces dimensions elles ne ferment nulle part"
    ),
    "with these lengths the links close nowhere": (
        "avec ces dimensions, les pièces ne ferment nulle part"
    ),
    "dead centre: the construction lines of {lines} are parallel and do not cross": (
        "point mort : les droites de construction de {lines} sont parallèles et ne se coupent pas"
    ),
    "the result is undetermined at this dead centre": "à ce point mort, c’est indéterminé",
    "the result leaves the range of double precision": "le résultat est trop grand à calculer",
    "cannot be drawn, for its longest vector has {length}": (
        "ne peut être dessiné, car le plus long vecteur a {length}"
    ),
    "draw other panels, or with other rates": "dessinez autre chose, ou avec d’autres vitesses",
    "parallel needs the coupler as long as the ground and the rocker as the crank": (
        "parallèle demande une bielle aussi longue que le bâti "
        "et un balancier aussi long que la manivelle"
    ),
    "try coupler {coupler} and rocker {rocker}": "essayez bielle {coupler} et balancier {rocker}",
    "the answer takes longer than {seconds} s": "la réponse prend plus de {seconds} s",
    "try fewer points, or a file": "essayez moins de points, ou un fichier",
    "another film is being made": "un autre film est en cours",
    "too much is being worked out already": "trop de calculs sont déjà en cours",
    "try again in a while": "réessayez plus tard",
    "the film takes more than {size}": "le film dépasse {size}",
    "try a smaller size, or vad animate": "essayez plus petit, ou vad animate",
    "open the address that vad gui has printed": (
        "vad gui a redémarré. Ouvrez l’adresse qu’il a affichée"
    ),
    "a fault of the program; the terminal shows where": (
        "une erreur du programme ; le terminal montre où"
    ),
    "{file}, line {line}": "{file}, ligne {line}",
    "is no TOML from column {column} on: {detail}": (
        "n’est plus du TOML à partir de la colonne {column} : {detail}"
    ),
    "is no TOML at its end: {detail}": "n’est plus du TOML à la fin : {detail}",
    "is nested too deep": "est trop profondément imbriqué",
    "has a number of more than {count} digits": "a un nombre de plus de {count} chiffres",
    "write it as {number}": "écrivez-le comme {number}",
    'text stands in quotes: "{text}"': 'un texte est entre guillemets : "{text}"',
    "a name is one word, as in {name}": "un nom est un seul mot, comme dans {name}",
    "did you mean {names}?": "est-ce {names} ?",
    "known: {names}": "connus : {names}",
    "as in {example}": "comme dans {example}",
    "must be a number, got {value}": "doit être un nombre, pas {value}",
    "must be one number to be opened here, got {value}": (
        "doit être ici un seul nombre, pas {value}"
    ),
    "must be one word": "doit être un seul mot",
    "must be a line of text, got {value}": "doit être une ligne de texte, pas {value}",
    "must be one word, got {value}": "doit être un seul mot, pas {value}",
    "must be one point": "doit être un seul point",
    "must name two points or more, got {value}": ("doit nommer deux points ou plus, pas {value}"),
    "is empty": "est vide",
    "{point} is no point": "{point} n’est pas un point",
    "{point} is fixed twice": "{point} est fixé deux fois",
    "{tail} and {head} are at the same place": "{tail} et {head} sont au même endroit",
    "the triangle {points} with sides {sides} does not close": (
        "le triangle {points} de côtés {sides} ne se ferme pas"
    ),
    "no distance leads to {point}": "aucune distance ne mène à {point}",
    "{pair} does not lead to another point of the link": (
        "{pair} ne mène à aucun autre point de la pièce"
    ),
    "the distance of {point} from {other} is missing": (
        "il manque la distance de {other} à {point}"
    ),
    "a cylinder has two points": "un vérin a deux points",
    "no link has both {one} and {other}": "aucune pièce n’a {one} et {other}",
    "is longer than {count} bytes": "dépasse {count} octets",
    "is no text in UTF-8": "n’est pas du texte en UTF-8",
    "must be a table": "doit être un tableau",
    "must be a line, got {value}": "doit être une droite, pas {value}",
    "must say how it moves": "doit dire comment il se meut",
    "must be distances of its points, got {value}": (
        "doit avoir les distances de ses points, pas {value}"
    ),
    "there is no link": "il n’y a aucune pièce",
    "there is no fixed point": "il n’y a aucun point fixe",
    "there are two numbers of this name": "deux nombres portent ce nom",
    "has no {word}": "n’a pas de {word}",
    "has no line": "n’a pas de droite",
    "has one place only": "n’a qu’une position",
    "needs a distance": "a besoin d’une distance",
    "cannot read {text}": "{text} est illisible",
    "is a fixed point already": "est déjà un point fixe",
    "is pinned to the frame at {points}, so it cannot move": (
        "est fixé au bâti en {points} et ne peut pas bouger"
    ),
    "slides, but no link has this point": "glisse, mais aucune pièce n’a ce point",
    "drives nothing else": "n’entraîne rien d’autre",
    "hangs on points that stand still": "tient à des points immobiles",
    "loads: are not kept in the file of a sheet": (
        "les charges ne sont pas gardées dans le fichier d’une feuille"
    ),
    "name them on the command line, as in --load": "nommez-les dans la commande, comme avec --load",
    "unknown {what} {name}": "{name} est inconnu",
    "{verb} no point with the rest": "aucun point commun avec le reste",
    "with these lengths {point} cannot be reached at the driver's place: it misses by {miss}": (
        "avec ces longueurs, {point} est hors d’atteinte à cette position de la pièce menante : "
        "il manque {miss}"
    ),
    "dead centre: B, C and D lie on one great circle": (
        "point mort : B, C et D sont sur un seul grand cercle"
    ),
    "dead centre: the coupler BC is square to the path of C": (
        "point mort : la bielle BC est perpendiculaire à la trajectoire de C"
    ),
    "dead centre: the axes at B, C and D are parallel to one plane": (
        "point mort : les axes en B, C et D sont parallèles à un même plan"
    ),
    "{angle} of arc": "{angle} d’arc",
    "{text} is no number and no expression": "{text} n’est ni un nombre ni une expression",
    "write 60, '6 cm', or 'a/2' with a in [dimensions]": (
        "écrivez 60, '6 cm' ou 'a/2' avec a dans [dimensions]"
    ),
    "{text} has no value": "{text} n’a pas de valeur",
    "write {name} = 100 under [dimensions]": "écrivez {name} = 100 sous [dimensions]",
    "write the expression where it is used": "écrivez l’expression là où elle sert",
    "{text} must be positive, got {value}": "{text} doit être positif, pas {value}",
    "{text} must be between {low} and {high}, got {value}": (
        "{text} doit être entre {low} et {high}, pas {value}"
    ),
    "must be one number here, got an array": "doit être ici un seul nombre",
    "must be the name of a unit, got {value}": "doit être le nom d’une unité, pas {value}",
    "must not be negative, got {value}": "ne doit pas être négatif, donc pas {value}",
    "must be a line of text, without {signs}": "doit être une ligne de texte, sans {signs}",
    "has {count} letters, and may have {most}": "a {count} lettres et peut en avoir {most}",
    "has {sign}, as no name may have": "contient {sign}, qu’aucun nom ne peut avoir",
    "write {name} ({signs})": "écrivez {name} ({signs})",
    "is a word of the program's own": "est un mot du programme",
    "call it {name}": "nommez-le {name}",
    "[{table}] has more than {most} entries": "[{table}] a plus de {most} entrées",
    "has more than {most} entries": "a plus de {most} entrées",
    "must be a table, got {value}": "doit être un tableau, pas {value}",
    "write [{table}]": "écrivez [{table}]",
    "write [{table}] and below it {example}": "écrivez [{table}] et en dessous {example}",
    "{code} is no language": "{code} n’est pas une langue",
    "the two letters of a language, as in [names.de]": (
        "les deux lettres d’une langue, comme dans [names.de]"
    ),
    "write a name, or leave it out": "écrivez un nom, ou laissez-le de côté",
    "must be two coordinates, got {value}": "doit avoir deux coordonnées, pas {value}",
    "write {point} = [0, 0]": "écrivez {point} = [0, 0]",
    "write {point} = [0, 0] or {example}": "écrivez {point} = [0, 0] ou {example}",
    "is no place": "n’est pas une position",
    "{value} is no place": "{value} n’est pas une position",
    "upper, lower, left, right, parallel, or coordinates near it": (
        "upper (en haut), lower (en bas), left (à gauche), right (à droite), parallel, ou des "
        "coordonnées proches"
    ),
    "from {point}, which is no fixed point above it": (
        "depuis {point}, qui n’est pas un point fixe écrit au-dessus"
    ),
    "a capital letter, or a letter with a number: O2": (
        "une majuscule, ou une lettre avec un chiffre : O2"
    ),
    "the pose does not say where {point} is": "la pose ne dit pas où se trouve {point}",
    "add {point} = [0, 0] to [pose], or write its distances": (
        "ajoutez {point} = [0, 0] à [pose], ou écrivez ses distances"
    ),
    "is no line": "n’est pas une droite",
    "a line is {examples} or {last}": "une droite est {examples} ou {last}",
    "{point} is neither a fixed point nor one that slides": (
        "{point} n’est ni un point fixe ni un point qui glisse"
    ),
    "along = 'DC' is the slot of a link that turns": (
        "along = 'DC' est la rainure d’une pièce qui tourne"
    ),
    "must be two points of a link, got {value}": "doit nommer deux points d’une pièce, pas {value}",
    "{links} have both": "{links} ont les deux points",
    "{link} is a cylinder, which has no slot": "{link} est un vérin, qui n’a pas de rainure",
    "{point} is a point of {link} itself": "{point} est lui-même un point de {link}",
    "only a link has a point under the block": "seule une pièce a un point sous le coulisseau",
    "must be one point, got {value}": "doit être un seul point, pas {value}",
    "there is a point {point} already": "il y a déjà un point {point}",
    "give it a name": "donnez-lui un nom",
    "{pair} is {other}, which is given already": "{pair} est {other}, déjà donné",
    "two letters are a distance, three an angle": "deux lettres sont une distance, trois un angle",
    "write 'clockwise' or 'counter-clockwise'": (
        "écrivez 'clockwise' (sens horaire) ou 'counter-clockwise'"
    ),
    "fix the others to its neighbours": "fixez les autres à ses voisins",
    "only a cylinder has one": "seul un vérin en a une",
    "only a cylinder's one length varies": "seule la longueur d’un vérin varie",
    "{pair} is fixed already by the other distances": (
        "{pair} est déjà fixé par les autres distances"
    ),
    "give {pair}": "donnez {pair}",
    "add {pair} = 100": "ajoutez {pair} = 100",
    "the longest side must be less than {length}": (
        "le plus long côté doit être inférieur à {length}"
    ),
    "join {link} to another link": "reliez {link} à une autre pièce",
    "has {points} in common with {link}, so both are one link": (
        "a {points} en commun avec {link} : les deux ne font qu’une pièce"
    ),
    "{one} and {other} both have {points}: one link": (
        "{one} et {other} ont tous deux {points} : une seule pièce"
    ),
    "is held at one point, {point}, only": "ne tient qu’à un point, {point}",
    "a link that only repeats a parallelogram can be left out": (
        "une pièce qui ne fait que répéter un parallélogramme peut être omise"
    ),
    (
        "{links} can only be found together: a triad (Assur group of class III) or more, not "
        "a pair that two arcs or lines locate"
    ): (
        "{links} ne se trouvent qu’ensemble : un groupe d’Assur de classe III ou plus, pas une "
        "dyade que deux arcs ou droites déterminent"
    ),
    "driven at the {links} it is dyads alone": "menée par {links}, ce ne sont que des dyades",
    "no other driver makes it dyads": "aucune autre pièce menante n’en fait des dyades",
    "add the links that it moves, as in {example}": (
        "ajoutez les pièces qu’elle meut, comme dans {example}"
    ),
    "one of its points must be on the {driver}, or on what the {driver} moves": (
        "un de ses points doit être sur {driver}, ou sur ce que {driver} meut"
    ),
    "one link or slide drives, not {count}": (
        "une seule pièce ou un seul coulisseau est moteur, pas {count}"
    ),
    "one link or slide drives, and none does": (
        "une pièce ou un coulisseau est moteur, et il n’y en a pas"
    ),
    "neither of its two places is {place}, at {places}": (
        "aucune de ses deux positions n’est {place} : {places}"
    ),
    "nearer to {place}": "plus proche de {place}",
    "say {words}": "écrivez {words}",
    "begin with the driver elsewhere, where they lie apart": (
        "commencez par une autre position de la pièce menante, où elles sont distinctes"
    ),
    "cannot be so while {point} is {place}": "ne peut être ainsi tant que {point} est « {place} »",
    "one of them is enough": "une des deux suffit",
    "with {point} at its other place it would close": (
        "avec {point} à son autre position, cela fermerait"
    ),
    "two places have {points}": "deux positions ont {points}",
    "must be places by point, got {value}": "doit donner des positions par point, pas {value}",
    "the links miss by {miss}": "il manque {miss} aux pièces",
    "{pair} and the side opposite it differ by {length}": (
        "{pair} et le côté opposé diffèrent de {length}"
    ),
    "a parallelogram has equal opposite sides": (
        "dans un parallélogramme, les côtés opposés sont égaux"
    ),
    "a parallelogram has two known sides and two unknown ones": (
        "un parallélogramme a deux côtés connus et deux inconnus"
    ),
    "{point} stands on the pivot {pivot}, where the {link} may point anywhere": (
        "{point} est sur le pivot {pivot}, où {link} peut prendre toute direction"
    ),
    "loop {number}": "boucle {number}",
    "give the lines different directions": "donnez aux droites des directions différentes",
    "stands still, for {driver} does not move it": "reste immobile, car {driver} ne la meut pas",
    "the angle of {link}": "l’angle de {link}",
    "the length of {link}": "la longueur de {link}",
    "slides along two lines": "glisse sur deux droites",
    "point {point}": "point {point}",
    "its distance": "sa distance",
    "its angle": "son angle",
    "its distance must not be 0": "sa distance ne doit pas être 0",
    "there is the first end of the link": "là se trouve la première extrémité de la pièce",
    "the mechanism has a point {point} already": "le mécanisme a déjà un point {point}",
    "free are {points} …": "sont libres {points} …",
    "points are marked on links in the plane alone": (
        "seules les pièces planes reçoivent des points"
    ),
    "is missing; a ram needs a rod and a ram_height": (
        "manque ; un coulant demande rod et ram_height"
    ),
    "must have a force, a couple or a table": "doit avoir une force, un couple ou une table",
    "must be places and loads, or a file beside this": (
        "doit contenir des positions et des charges, ou nommer un fichier à côté"
    ),
    "must be words and numbers, got {value}": "doit avoir des mots et des nombres, pas {value}",
    "must be one number or two, got {value}": "doit être un ou deux nombres, pas {value}",
    "mass of {body}": "masse de {body}",
    "load {number}": "charge {number}",
    "{point} is no point of {link}": "{point} n’est pas un point de {link}",
    "{point} is a point of {links}": "{point} est un point de {links}",
    "{point} is on {links}": "{point} est sur {links}",
    "say on which it acts: {examples}": "dites sur laquelle elle agit : {examples}",
    "{body} does not turn: its guide takes the couple": (
        "{body} ne tourne pas : sa glissière reprend le couple"
    ),
    "{body} does not turn, so it has no moment of inertia": (
        "{body} ne tourne pas et n’a donc pas de moment d’inertie"
    ),
    "a couple needs a body": "un couple demande un corps",
    "a couple acts on {bodies}": "un couple agit sur {bodies}",
    "reaches from {low} to {high}, and the driver is at {place}": (
        "va de {low} à {high}, et la pièce menante est à {place}"
    ),
    "a table needs two rows or more": "une table demande deux lignes ou plus",
    "has {count} columns, not two": "a {count} colonnes au lieu de deux",
    "has more than {count} rows": "a plus de {count} lignes",
    "two columns: the driver's place, and the load there": (
        "deux colonnes : la position de la pièce menante, et la charge à cet endroit"
    ),
    "{text} is no pair of numbers": "{text} n’est pas une paire de nombres",
    "its places must ascend, but {place} follows {other}": (
        "ses positions doivent croître, mais {place} suit {other}"
    ),
    "must be at most {most}, got {value}": "doit être au plus {most}, pas {value}",
    "a window takes at most {most}, got {count}": (
        "une fenêtre en prend au plus {most}, pas {count}"
    ),
    "a window takes at most {most} loads, got {count}": (
        "une fenêtre prend au plus {most} charges, pas {count}"
    ),
    (
        "the page has no room for {panels} panels with {rows} rows of results and captions "
        "of {lines} lines"
    ): (
        "la page n’a pas la place pour {panels} dessins avec {rows} lignes de résultats et "
        "{lines} lignes de texte"
    ),
    "draw fewer panels": "dessinez moins de panneaux",
    "a drawing has room for {most} on links, got {count}": (
        "un dessin a la place pour {most} sur les pièces, pas {count}"
    ),
    "the program is ending": "le programme se termine",
    "the planes of the shafts and of the cross are one": (
        "point mort : les arbres et le croisillon sont dans un seul plan"
    ),
    "{owner} is called {name} already": "{owner} s’appelle déjà {name}",
    "a rod": "une tige",
    "a slide": "un coulisseau",
    "a link": "une pièce",
    "is held at no point": "ne tient à aucun point",
    "{count}, not 1": "{count} au lieu de 1",
    "{links} links and {joints} joints give {sum} degrees of freedom": (
        "{links} pièces et {joints} liaisons donnent {sum} degrés de liberté"
    ),
    "the {side} one": "« {side} »",
    "{line} under [assembly]": "{line} sous [assembly]",
    "the lines of {slides} are parallel": "les droites de {slides} sont parallèles",
    "{lines}, so that all between them slides along without a limit": (
        "{lines} : tout ce qui est entre elles glisse sans fin"
    ),
    "{lines} and never cross": "{lines} et ne se coupent jamais",
    "must be one number, got {value}": "doit être un seul nombre, pas {value}",
    "a window turns a mechanism by hand, which a shaft or an engine is not": (
        "une fenêtre fait tourner à la main un mécanisme, mais ni un arbre ni un moteur"
    ),
    "vad draw {example} shows it": "vad draw {example} le montre",
    "vad example {name} makes a file to begin with": (
        "vad example {name} fait un fichier pour commencer"
    ),
    "on {bodies}": "sur {bodies}",
    "unknown {what} in {table} {name}": "{name} est inconnu dans {table}",
    "unknown {what} of {owner} {name}": "{name} est inconnu pour {owner}",
    "unknown {what} with two places {name}": "{name} n’a pas deux positions",
    "as in {example}, where {name} is its name": "comme dans {example}, où {name} est son nom",
    "{point} is no point of a link": "{point} n’est pas un point d’une pièce",
}

#: Ce qui décrit les solutions d'une synthèse.
DESIGN = {
    "slider-crank": "Bielle-manivelle d'après sa course et le rapport des temps",
    "quick-return": "Retour rapide d'après sa course et le rapport des temps",
    "crank-rocker": "Manivelle-balancier d'après l'oscillation et le rapport des temps",
    "three-positions": "Quatre barres par trois positions de sa bielle",
    "function": "Quatre barres pour trois paires d'angles de la manivelle et du balancier",
    "solution": "solution",
    "mechanism": "mécanisme",
    "assembly": "montage",
    "origin": "A en x, y",
    "position": "position",
    "dead centre": "point mort",
    "sense": "la manivelle tourne",
    "forwards": "dans le sens direct",
    "backwards": "dans le sens horaire",
    "slow": "course lente",
    "slow out": "en s'éloignant de la manivelle",
    "slow in": "vers la manivelle",
    "slow right": "vers la droite",
    "slow left": "vers la gauche",
    "slow with": "dans le sens de la manivelle",
    "slow against": "en sens contraire de la manivelle",
    "driven": "entraîné",
    "driven first": "à la première articulation",
    "driven second": "à la seconde articulation",
    "back": "pointe en arrière",
    "back crank": "la manivelle",
    "back rocker": "le balancier",
    "back both": "la manivelle et le balancier",
    "faults": "défauts",
    "none": "aucun",
    "fault assembly": "change de montage",
    "fault range": "ne peut passer d'une position à l'autre",
    "fault order": "autre ordre des positions",
    "grashof": "Grashof",
    "stroke": "course ou oscillation",
    "time ratio": "rapport des temps",
    "least transmission": "plus petit angle de transmission (à)",
    "largest transmission": "plus grand angle de transmission (à)",
    "kind crank-rocker": "manivelle-balancier",
    "kind double-crank": "double manivelle",
    "kind double-rocker": "double balancier",
    "kind rocker-crank": "manivelle-balancier, entraîné au balancier",
    "kind triple-rocker": "triple balancier",
    "kind change point": "points de changement",
}

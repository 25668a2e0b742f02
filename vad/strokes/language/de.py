"""Was der Lehrer sagt, auf Deutsch."""

PHRASES = {
    # Seite
    "results": "Ergebnisse",
    "given": "gegeben",
    "coriolis rule": "Coriolis: v um 90° mit ω gedreht",
    # Umlauf
    "stroke": "Hub",
    "forward": "Hinlauf",
    "return": "Rücklauf",
    "ratio": "Verhältnis",
    "swings": "{part} schwingt zwischen {low} und {high}",
    "slides": "{part} läuft zwischen {low} und {high}",
    # Lageplan
    "fixed": "{letter} ist ein festes Gelenk.",
    "fixed point": "{letter}, wo sich die Führungen schneiden, ist fest.",
    "guide": "{head} kann sich nur längs seiner Führung bewegen.",
    "slot": "{head} gleitet im Schlitz ({link}).",
    "driven bar": "{link} {bar} = {size} {unit} steht unter {angle}.",
    "driven slide": "{head} steht bei {value} {unit} auf seiner Führung.",
    "angle": "Der Winkel ({link}), von der x-Achse gegen den Uhrzeigersinn gemessen.",
    "compass": "{head} liegt auf dem Kreis um {tail} mit dem Radius {bar} = {size} {unit}.",
    "lever line": "{link}: die Gerade von {tail} durch {pin}.",
    "slot line": "{head} liegt in Richtung des Schlitzes unter oder über {pin}.",
    "found": "{letter} liegt im Schnittpunkt.",
    "on guide": "{letter} liegt, wo der Kreis die Führung schneidet.",
    "on lever": "{letter} ist der Punkt unter {pin} ({link}).",
    "bar": "{link} {bar}: θ = {angle}.",
    "block": "Der {slide} {head}: {symbol} = {value} {unit}.",
    "tip": "{letter} ({link}) liegt {size} {unit} von {tail} entfernt.",
    "tip against": (
        "{letter} ({link}) liegt {size} {unit} von {tail} entfernt auf der anderen Seite."
    ),
    # Polygone
    "pole velocity": (
        "Der Pol: feste Punkte haben die Geschwindigkeit null, also liegen {letters} hier."
    ),
    "pole acceleration": "Der Pol: feste Punkte sind unbeschleunigt, also liegen {letters} hier.",
    "pole velocity one": "Der Pol: der feste Punkt {letters} hat die Geschwindigkeit null.",
    "pole acceleration one": "Der Pol: der feste Punkt {letters} ist unbeschleunigt.",
    "still": "Der Antrieb steht still und mit ihm alles andere: das Polygon ist sein Pol.",
    "tangential velocity": "{label} = {omega}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar}",
    "normal": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, von {head} nach {tail}"
    ),
    "tangential acceleration": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar}"
    ),
    "sliding velocity": (
        "{label} = {value} {unit}, {way}, die gegebene Geschwindigkeit parallel {line}"
    ),
    "sliding acceleration": (
        "{label} = {value} {unit}, {way}, die gegebene Beschleunigung parallel {line}"
    ),
    "coriolis": (
        "{label} = 2·{omega}·v = 2 × {rate} × {speed} = {value} {unit}, "
        "v um 90° mit {omega} gedreht"
    ),
    "across velocity": (
        "Durch {point} senkrecht zu {bar}: gegenüber {tail} kann sich {head} nur so bewegen, "
        "also liegt {meeting} auf dieser Geraden."
    ),
    "across velocity strut": (
        "Durch {point} senkrecht zu {bar}: außer längs {bar} zu gleiten kann sich {head} nur quer "
        "dazu bewegen, also liegt {meeting} auf dieser Geraden."
    ),
    "across acceleration": (
        "Durch {point} senkrecht zu {bar}: der Tangentialanteil {alpha}·{bar} ist noch unbekannt, "
        "also liegt {meeting} auf dieser Geraden."
    ),
    "along velocity": (
        "Durch {point} parallel {line}: anders kann sich der {slide} nicht bewegen, also liegt "
        "{meeting} auf dieser Geraden."
    ),
    "along velocity slot": (
        "Durch {point} parallel {line}: im Schlitz kann sich der {slide} nur so bewegen, also "
        "liegt {meeting} auf dieser Geraden."
    ),
    "along velocity link": (
        "Durch {point} parallel {line}: auf der {link} kann sich der {slide} nur so bewegen, also "
        "liegt {meeting} auf dieser Geraden."
    ),
    "along acceleration": (
        "Durch {point} parallel {line}: der Gleitanteil ist noch unbekannt, also liegt "
        "{meeting} auf dieser Geraden."
    ),
    "crossing": "Im Schnittpunkt der beiden Geraden liegt {letter}.",
    "pole crossing": (
        "Im Schnittpunkt der beiden Geraden liegt der Pol {letter}: dieser Punkt ruht."
    ),
    "measured omega": (
        "{label} = {value} {unit}, also {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: von {tail} aus gesehen läuft {head} {way}."
    ),
    "measured omega strut": (
        "{label} = {value} {unit}, also {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: quer zu {bar} läuft {head} {way}."
    ),
    "measured alpha": (
        "{label} = {value} {unit}, also {alpha} = {label}/{bar} = {value}/{size} = {rate} rad/s², "
        "{sense}."
    ),
    "measured sliding velocity": (
        "{label} = {value} {unit}: der {slide} gleitet {way}, {symbol} = {rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way}: der {slide} hat {symbol} = {rate} {unit}."
    ),
    "whole relative": "{label} = {value} {unit}, die Beschleunigung von {head} gegenüber {tail}.",
    "whole absolute": "{label} = {value} {unit}, die Beschleunigung von {head}.",
    "image": (
        "{letter} aus der Ähnlichkeit: {part}/{whole} = {bar}/{base} = {size}/{length}; "
        "{label} = {value} {unit}"
    ),
    "image against": (
        "{letter} aus der Ähnlichkeit, auf der anderen Seite: {part}/{whole} = {bar}/{base} = "
        "{size}/{length}; {label} = {value} {unit}"
    ),
    # Wörter
    "the pole": "den Pol",
    "the guide": "zur Führung",
    "the guide of": "zur Führung von {head}",
    "the slot": "zum Schlitz",
    "the link": "zur {link}",
    "∥ guide": "∥ Führung",
    "∥ guide of": "∥ Führung von {head}",
    "∥ slot": "∥ Schlitz",
    "∥ link": "∥ {link}",
    "counter-clockwise": "gegen den Uhrzeigersinn",
    "clockwise": "im Uhrzeigersinn",
    "right": "nach rechts",
    "left": "nach links",
    "up": "nach oben",
    "down": "nach unten",
}

#: Titel, Glieder, Schieber und Maße.
NAMES = {
    "Position": "Lage",
    "Velocity": "Geschwindigkeit",
    "Acceleration": "Beschleunigung",
    "Four-bar": "Gelenkviereck",
    "Slider–crank": "Schubkurbel",
    "Crank and slotted lever": "Schwingende Kurbelschleife",
    "Whitworth quick return": "Umlaufende Kurbelschleife",
    "Elliptical trammel": "Ellipsenzirkel",
    "Scotch yoke": "Kreuzschubkurbel",
    "Double slider": "Doppelschieber",
    "Gate actuator": "Torantrieb",
    "crank": "Kurbel",
    "coupler": "Koppel",
    "rocker": "Schwinge",
    "rod": "Stange",
    "lever": "Schleife",
    "link": "Glied",
    "arm": "Arm",
    "actuator": "Spindel",
    "ground": "Gestell",
    "slider": "Schieber",
    "block": "Stein",
    "ram": "Stößel",
    "yoke": "Kreuzschieber",
    "offset": "Versatz",
    "tracer": "Zeichenpunkt",
    "ram_height": "Stößelhöhe",
    "ground_angle": "Gestellwinkel",
    "guide_a": "Führung A",
    "guide_b": "Führung B",
}

#: Kein Artikel heißt wie ein Punkt.
ARTICLE = ""

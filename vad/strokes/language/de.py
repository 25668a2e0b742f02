"""Was der Lehrer sagt, auf Deutsch."""

PHRASES = {
    # Seite
    "results": "Ergebnisse",
    "given": "gegeben",
    "colon": ": ",
    "legend": "grau: gegeben",
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
    "fixed point": "{letter} ist ein fester Punkt.",
    "guides cross": "{letter}, wo sich die Führungen schneiden, ist fest.",
    "guide": "{head} kann sich nur längs seiner Führung bewegen.",
    "guide point": (
        "{head} kann sich nur längs seiner Führung bewegen; {tail} ist ein fester Punkt "
        "der Führung."
    ),
    "slot": "{head} gleitet im Schlitz {link:des}.",
    "driven bar": "{link:Der} {bar} = {size} {unit} steht bei {angle}°.",
    "driven slide": "{slide:Der} {head} steht bei {symbol} = {value} {unit} auf seiner Führung.",
    "driven slide from": (
        "{slide:Der} {head} steht bei {symbol} = {value} {unit} auf seiner Führung, von {tail} aus "
        "gemessen."
    ),
    "angle": "Der Winkel {link:des} wird von der x-Achse gegen den Uhrzeigersinn gemessen.",
    "compass": "{head} liegt auf dem Kreis um {tail} mit dem Radius {bar} = {size} {unit}.",
    "compass strut": (
        "{head} liegt auf dem Kreis um {tail} mit dem Radius {bar} = {size} {unit}, der gegebenen "
        "Länge {link:des}."
    ),
    "lever line": "{link:Der} geht von {tail} aus durch {pin}.",
    "slot line": "Der Schlitz {link:des} geht durch {pin}, und {head} liegt auf seiner Geraden.",
    "found": "{letter} liegt im Schnittpunkt.",
    "arcs cross": "{letter} liegt, wo sich die beiden Bögen schneiden.",
    "on guide": "{letter} liegt, wo der Bogen die Führung schneidet.",
    "on slot": "{letter} liegt, wo die Gerade des Schlitzes die Führung schneidet.",
    "on lever": "{letter} ist der Punkt {link:des}, der in dieser Lage unter {pin} liegt.",
    "bar": "{link:Der} {bar} steht bei {symbol} = {angle}°.",
    "block": "{slide:Der} {head} steht bei {symbol} = {value} {unit}.",
    "block from": (
        "{slide:Der} {head} steht bei {symbol} = {value} {unit}, von {tail} aus gemessen."
    ),
    "plate": "{link:Der} ist ein starres Stück mit den Ecken {corners}.",
    "third point": (
        "{letter} liegt, wo sich die beiden Bögen schneiden: das Dreieck {corners} behält seinen "
        "Sinn."
    ),
    "on link slot": "{letter} liegt, wo der Bogen die Gerade des Schlitzes schneidet.",
    "in slot": "{head} liegt auf der Geraden des Schlitzes {link:des}.",
    "tip": "{letter} liegt auf {link:dem}, {size} {unit} von {tail} entfernt.",
    "tip against": (
        "{letter} liegt auf {link:dem}, {size} {unit} von {tail} entfernt auf der anderen Seite."
    ),
    # Polygone
    "pole velocity": (
        "Der Pol: feste Punkte haben die Geschwindigkeit null, also liegen {letters} hier."
    ),
    "pole acceleration": (
        "Der Pol: feste Punkte haben die Beschleunigung null, also liegen {letters} hier."
    ),
    "pole velocity one": (
        "Der Pol: der feste Punkt {point} hat die Geschwindigkeit null, also liegt {letters} hier."
    ),
    "pole acceleration one": (
        "Der Pol: der feste Punkt {point} hat die Beschleunigung null, also liegt {letters} hier."
    ),
    "on the guide": "{letter} ({point} auf der Führung)",
    "still": "Der Antrieb steht still und mit ihm alles andere: das Polygon ist sein Pol.",
    "velocity of": "die Geschwindigkeit von {head}",
    "velocity of relative": "die Geschwindigkeit von {head} gegenüber {tail}",
    "acceleration of": "die Beschleunigung von {head}",
    "acceleration of relative": "die Beschleunigung von {head} gegenüber {tail}",
    "tangential velocity whole": (
        "{label} = {omega}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} im Sinn von {omega}: "
        "{whose}."
    ),
    "normal": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, von {head} nach {tail}."
    ),
    "normal whole": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, von {head} nach {tail}: "
        "{whose}."
    ),
    "tangential acceleration": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} im Sinn von {alpha}."
    ),
    "tangential acceleration whole": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} im Sinn von {alpha}: "
        "{whose}."
    ),
    "sliding velocity": (
        "{label} = {value} {unit}, {way}: die gegebene Geschwindigkeit längs {line:des}."
    ),
    "sliding acceleration": (
        "{label} = {value} {unit}, {way}: die gegebene Beschleunigung längs {line:des}."
    ),
    "coriolis": (
        "{label} = 2·{omega}·v = 2 × {rate} × {speed} = {value} {unit}, "
        "v um 90° mit {omega} gedreht."
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
        "Durch {point} parallel {line:zum}: anders kann sich {slide:der} {head} nicht bewegen, "
        "also liegt {meeting} auf dieser Geraden."
    ),
    "along velocity slot": (
        "Durch {point} parallel {line:zum}: {line:im} kann sich {slide:der} {head} nur so bewegen, "
        "also liegt {meeting} auf dieser Geraden."
    ),
    "along velocity link": (
        "Durch {point} parallel {line:zum}: auf {line:dem} kann sich {slide:der} {head} nur so "
        "bewegen, also liegt {meeting} auf dieser Geraden."
    ),
    "along acceleration": (
        "Durch {point} parallel {line:zum}: der Gleitanteil ist noch unbekannt, also liegt "
        "{meeting} auf dieser Geraden."
    ),
    "crossing": "{letter} liegt, wo sich die beiden Geraden schneiden.",
    "crossing zero": "{letter} liegt, wo sich die beiden Geraden schneiden: {found}.",
    "zero": "bei {point}, also ist {symbol} null",
    "pole crossing": (
        "Der Pol {letter} liegt, wo sich die beiden Geraden schneiden: {point} steht still."
    ),
    "measured omega": (
        "{label} = {value} {unit}, also {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: von {tail} aus gesehen läuft {head} {way}."
    ),
    "measured omega absolute": (
        "{label} = {value} {unit}, also {omega} = {label}/{bar} = {value}/{size} = {rate} rad/s, "
        "{sense}: {label} ist die Geschwindigkeit von {head}, {way}."
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
        "{label} = {value} {unit}: {slide:der} {head} gleitet längs {line:des} {way}, "
        "{symbol} = {rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way}: längs {line:des} hat {slide:der} {head} die "
        "Beschleunigung {symbol} = {rate} {unit}."
    ),
    "whole": "{label} = {value} {unit}, {whose}.",
    "image velocity": "dem Geschwindigkeitsbild",
    "image acceleration": "dem Beschleunigungsbild",
    "image": (
        "{letter} aus {image} {link:des}: {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image against": (
        "{letter} aus {image} {link:des}, auf der anderen Seite: {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image similar": (
        "{letter} aus {image} {link:des}: {triangle} ist ähnlich zu {corners}, im gleichen "
        "Sinn beschriftet: {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}."
    ),
    "image line": (
        "Durch {point} unter dem Winkel {corner} = {angle}° gegen {side}, im Sinn des Glieds: "
        "{meeting} liegt auf dieser Geraden."
    ),
    "image alike velocity": (
        "{letter} fällt auf {point}: {link:der} dreht sich in diesem Augenblick nicht, alle Punkte "
        "haben dieselbe Geschwindigkeit."
    ),
    "image alike acceleration": (
        "{letter} fällt auf {point}: alle Punkte {link:des} haben in diesem Augenblick dieselbe "
        "Beschleunigung."
    ),
    "image whose": ", {whose}",
    "image other": "; {label} = {value} {unit}",
    # Wörter
    "and": "{first} und {last}",
    "the pole": "den Pol",
    "of point": "von {head}",
    "parallel": "∥ {line}",
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
    "actuator": "Zylinder",
    "cylinder": "Zylinder",
    "piston": "Kolben",
    "pin": "Bolzen",
    "ground": "Gestell",
    "slider": "Schieber",
    "block": "Stein",
    "ram": "Stößel",
    "yoke": "Kreuzschieber",
    "stroke": "Hub",
    "guide": "Führung",
    "slot": "Schlitz",
    "offset": "Versatz",
    "tracer": "Zeichenpunkt",
    "ram_height": "Stößelhöhe",
    "ground_angle": "Gestellwinkel",
    "guide_a": "Führung A",
    "guide_b": "Führung B",
}

#: Das Geschlecht dessen, wovon Sätze sprechen.
GENDERS = {
    "crank": "f",
    "coupler": "f",
    "rocker": "f",
    "rod": "f",
    "lever": "f",
    "link": "n",
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
    "slot": "m-es",
}

#: Der männliche Artikel, nach dem ein Satz fragt, und was daraus je nach Geschlecht wird.
_M = {"der": "der {}", "des": "des {}s", "dem": "dem {}", "zum": "zum {}", "im": "im {}"}
ARTICLES = {
    "m": _M,
    "m-es": _M | {"des": "des {}es"},
    "f": {"der": "die {}", "des": "der {}", "dem": "der {}", "zum": "zur {}", "im": "in der {}"},
    "n": _M | {"der": "das {}"},
}

#: Das Dezimalzeichen.
POINT = ","

#: Kein Wort heißt wie ein Punkt.
UPRIGHT = ""

"""Was der Lehrer zum räumlichen Viergelenk mit Kugelgelenken sagt, auf Deutsch."""

PHRASES = {
    # Lageplan
    "balls A": "Unten die Kurbel, längs der Achse von A gesehen.",
    "balls crank path": "Dort läuft B auf einem Kreis in wahrer Gestalt.",
    "balls crank": "Die Kurbel AB = {size} {unit} steht bei {angle}°.",
    "balls crank angle": "Ihr Winkel wird vom gemeinsamen Lot beider Achsen aus gemessen.",
    "balls D": "Oben die Schwinge, längs der Achse von D gesehen.",
    "balls rocker path": "Dort läuft C auf einem Kreis in wahrer Gestalt.",
    "balls A front": "A in dieser Ansicht.",
    "balls B front": "B in dieser Ansicht: senkrecht darüber.",
    "balls AB front": "Die Kurbel in dieser Ansicht.",
    "balls compass": (
        "B steht {height} {unit} {side} der Ebene des Kreises von C: von hier gesehen ist "
        "C um √({size}² − {height}²) = {reach} {unit} von B entfernt."
    ),
    "balls C": "C liegt, wo sich die beiden Kreise schneiden.",
    "balls BC front": "Die Koppel BC.",
    "balls rocker": "Die Schwinge DC steht bei {theta} = {angle}°.",
    "balls rocker angle": "Auch ihr Winkel wird vom gemeinsamen Lot aus gemessen.",
    "balls C top": "C in der unteren Ansicht: senkrecht darunter.",
    "balls D top": "D in der unteren Ansicht.",
    "balls DC top": "Die Schwinge in der unteren Ansicht.",
    "balls BC top": "Die Koppel in der unteren Ansicht.",
    "balls BC third": (
        "Rechts, senkrecht zu BC und zur Bahn von C gesehen: beide dort in wahrer Länge."
    ),
    "balls plane": "Die Ebene durch B senkrecht zu BC erscheint dort als Gerade.",
    "balls line": "Die Bahn von C: ihre Richtung hat die Geschwindigkeit von C.",
    "balls ahead": "vor",
    "balls behind": "hinter",
    "balls front": "längs D gesehen",
    "balls top": "längs A gesehen",
    "balls third": "BC und Bahn von C in wahrer Länge",
    # Pläne
    "balls path": "Bahn von C",
    "balls remark": "gesehen wie BC rechts im Lageplan; die Koppel dreht sich nicht um BC",
    "balls tangential velocity": (
        "{label} ist die Geschwindigkeit von B, {symbol}·{ends} = {rate} × {size} = {value} "
        "{unit}: diese Ansicht zeigt davon {seen} {unit}."
    ),
    "balls tangential acceleration": (
        "{label} ist {symbol}·{ends} = {rate} × {size} = {value} {unit}, senkrecht zu {ends}: "
        "diese Ansicht zeigt davon {seen} {unit}."
    ),
    "balls normal": (
        "{label} ist {symbol}²·{ends} = {rate} × {size} = {value} {unit}, von {head} nach {tail}: "
        "diese Ansicht zeigt davon {seen} {unit}."
    ),
    "balls normal BC": (
        "{label} = {speed}/{size} = {seen} {unit}, das Quadrat der Geschwindigkeit von C gegenüber "
        "B durch BC, von C nach B in wahrer Länge."
    ),
    "balls line BC velocity": (
        "Durch {point} senkrecht zu BC: die Koppel behält ihre Länge, also liegt {meeting} in "
        "einer Ebene senkrecht zu BC, und die ist diese Gerade."
    ),
    "balls line DC velocity": (
        "Durch {point} parallel zur Bahn von C: C kann sich nur so bewegen, also liegt {meeting} "
        "auf dieser Geraden, die in wahrer Länge erscheint."
    ),
    "balls line BC acceleration": (
        "Durch {point} senkrecht zu BC: längs BC ist alles angetragen, also liegt {meeting} in "
        "einer Ebene senkrecht zu BC, und die ist diese Gerade."
    ),
    "balls line DC acceleration": (
        "Durch {point} parallel zur Bahn von C: der tangentiale Teil {symbol}·DC ist noch "
        "unbekannt, also liegt {meeting} auf dieser Geraden."
    ),
    "balls coupler velocity": (
        "{label} = {value} {unit} hier und {off} {unit} aus dem Papier heraus: zusammen {whole} "
        "{unit}, also {symbol} = {whole}/{size} = {rate} rad/s."
    ),
    "balls coupler acceleration": (
        "{label} = {value} {unit} hier und {off} {unit} aus dem Papier heraus: zusammen {whole} "
        "{unit}, also {symbol} = {whole}/{size} = {rate} rad/s²."
    ),
    "balls rocker velocity": (
        "{label} = {value} {unit} ist die Geschwindigkeit von C, also {symbol} = {label}/DC = "
        "{value}/{size} = {rate} rad/s, {sense}."
    ),
    "balls rocker acceleration": (
        "{label} = {value} {unit}, also {symbol} = {label}/DC = {value}/{size} = {rate} rad/s², "
        "{sense}."
    ),
    "balls whole": "{label} = {value} {unit} in dieser Ansicht, {whose}.",
}

NAMES = {
    "Spatial four-bar with ball joints": "Räumliches Viergelenk mit Kugelgelenken",
    "ground_twist": "Kreuzungswinkel",
    "crank_offset": "Kurbelversatz",
    "rocker_offset": "Schwingenversatz",
}

GENDERS: dict[str, str] = {}

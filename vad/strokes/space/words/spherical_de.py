"""Was der Lehrer zum sphärischen Viergelenk und zu Plänen von Körpern sagt, auf Deutsch."""

PHRASES = {
    # Lageplan
    "spherical along": "längs {axis}",
    "spherical outline": (
        "Die Kugel, senkrecht zur Gestellebene gesehen: ihr Umriss ist der Großkreis des Gestells."
    ),
    "spherical axes": "Die Achsen OA und OD liegen im Blatt: ihre Richtungen sind wahr.",
    "spherical O": "Alle Achsen schneiden sich in O, der Mitte der Kugel.",
    "spherical shaft": "Ein Glied dreht sich um O{letter}.",
    "spherical bearing": "Seine Welle ist im Gestell gelagert.",
    "spherical fixed": "In {letter} durchstößt eine feste Achse die Kugel.",
    "spherical ground": "A und D sind die festen Achsen, {size}° voneinander entfernt.",
    "spherical circle": "B dreht sich um OA: sein Kreis erscheint als Strecke.",
    "spherical rose": "Längs {axis} gesehen erscheint der Winkel in wahrer Größe.",
    "spherical reference A": "Er wird vom Bogen AD aus gemessen.",
    "spherical reference D": "Er wird vom Bogen AD aus gemessen, der über D hinaus verlängert ist.",
    "spherical true A": "Die Kurbel steht bei {angle}°.",
    "spherical angle A": "Ihr Winkel zählt von außen gesehen gegen den Uhrzeigersinn.",
    "spherical true D": "Die Schwinge steht bei {symbol} = {angle}°.",
    "spherical angle D": "Es ist {symbol}.",
    "spherical crank": "Die Kurbel AB = {size}° steht bei {angle}°.",
    "spherical B": "An ihrem Ende liegt B.",
    "spherical about B": "C liegt auf dem Kreis um B mit dem Radius BC = {size}°.",
    "spherical about D": (
        "C liegt auf dem Kreis um D mit dem Radius DC = {size}°, der als Strecke erscheint."
    ),
    "spherical C": "C liegt, wo sich die beiden Kreise schneiden.",
    "spherical coupler": "Die Koppel BC: sie steht in B bei {b}° und in C bei {c}°.",
    "spherical rocker": "Die Schwinge DC.",
    "spherical great circle": "Der Großkreis der Koppel wird bis zum Umriss verfolgt.",
    "spherical I": "Dort, in I, trifft er den Großkreis des Gestells.",
    "spherical OI": (
        "Die Ebenen von Koppel und Gestell schneiden sich in OI: um diese Achse dreht sich die "
        "Schwinge gegenüber der Kurbel."
    ),
    # Pläne von Körpern
    "bodies remark": "1 2 4 in der Gestellebene, 2 3 4 in der Koppelebene, umgeklappt",
    "bodies pole velocity": "Der Pol: das Gestell, 1, dreht sich nicht.",
    "bodies pole acceleration": "Der Pol: das Gestell, 1′, hat keine Winkelbeschleunigung.",
    "bodies given": "{label} = {symbol} = {value} {unit}, längs {axis}.",
    "bodies turned frame": (
        "{label} = {symbol}·τ̇ = {omega} × {tau} = {value} {unit}, ⟂ OI: {symbol} dreht sich mit OI "
        "in der Gestellebene."
    ),
    "bodies turned coupler": (
        "{label} = {symbol}·τ̇₃ = {omega} × {tau} = {value} {unit}, "
        "⟂ OI: auch in der Koppelebene dreht sich {symbol} mit OI."
    ),
    "bodies line 24 velocity": (
        "Durch {point} parallel zu OI: nur OI liegt in der Gestellebene und in der Koppelebene, "
        "also dreht sich Körper 4 gegenüber Körper 2 um OI, und {meeting} liegt auf dieser Geraden."
    ),
    "bodies line 24 acceleration": (
        "Durch {point} parallel zu OI: um wie viel die Drehung längs OI wächst, ist noch "
        "unbekannt, also liegt {meeting} auf dieser Geraden."
    ),
    "bodies line 14": (
        "Durch {point} parallel zu OD: um eine andere Gerade dreht sich die Schwinge nicht, also "
        "liegt {meeting} auf dieser Geraden."
    ),
    "bodies fold": (
        "Die Koppelebene wird um OI in das Blatt umgeklappt: OB und OC liegen in wahrer Richtung."
    ),
    "bodies line 23": (
        "Durch {point} parallel zum umgeklappten OB, {arc}° von OI: um OB dreht sich die Koppel "
        "gegenüber der Kurbel, also liegt {meeting} auf dieser Geraden."
    ),
    "bodies line 43": (
        "Durch {point} parallel zu OC, {arc}° von OI: um OC dreht sich die Koppel gegenüber der "
        "Schwinge, also liegt {meeting} auf dieser Geraden."
    ),
    "bodies sines": (
        "{label} = {symbol} = {value} {unit}: ω₄/ω₂ = sin AI / sin DI = sin {ai}° / sin {di}°."
    ),
}

NAMES = {"Spherical four-bar": "Sphärisches Viergelenk"}

GENDERS: dict[str, str] = {}

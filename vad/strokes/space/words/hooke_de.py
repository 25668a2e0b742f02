"""Was der Lehrer zum Kreuzgelenk sagt, auf Deutsch."""

PHRASES = {
    # Lageplan
    "hooke along": "längs Welle 2 gesehen",
    "hooke plan": "Ebene der Wellen",
    "hooke shaft 2": "Unten die Ebene der Wellen in wahrer Größe: Welle 2 treibt an.",
    "hooke bearing": "Welle {shaft} dreht sich im Gestell.",
    "hooke shaft 4": "Welle 4 wird angetrieben.",
    "hooke axes": "Die Wellen schneiden sich in O.",
    "hooke angle": "Der Beugewinkel zwischen den Wellen ist {angle}°.",
    "hooke O": "Oben O, längs Welle 2 gesehen.",
    "hooke plane": "Längs Welle 2 gesehen ist die Ebene der Wellen die Waagerechte.",
    "hooke circle": "P dreht sich um Welle 2: längs ihr gesehen auf einem Kreis.",
    "hooke OP": "P, der Zapfen von Gabel 2, steht bei {angle}°: OP ist ein Arm des Kreuzes.",
    "hooke theta 2": "Sein Winkel wird von der Ebene der Wellen aus gemessen.",
    "hooke ellipse": (
        "Q dreht sich um Welle 4: dieser Kreis erscheint als Ellipse, in der Breite mal "
        "cos {angle}°."
    ),
    "hooke OQ": (
        "OQ steht senkrecht auf OP; P liegt in der Ebene dieser Ansicht, also erscheint der "
        "rechte Winkel als solcher: Q liegt auf dieser Geraden."
    ),
    "hooke Q": "Q, der Zapfen von Gabel 4, liegt, wo die Gerade die Ellipse schneidet.",
    "hooke arm": "OQ ist der andere Arm des Kreuzes.",
    "hooke turned": "Parallel zur Ebene der Wellen wird Q in diese Ansicht gedreht.",
    "hooke theta 4": (
        "Dort ist sein Winkel in wahrer Größe zu sehen: {theta} = {value}°, denn "
        "tan {theta} = {ratio}."
    ),
    "hooke projectors": "P und Q im Grundriss: senkrecht darunter.",
    "hooke P plan": "Der Arm von P im Grundriss.",
    "hooke Q plan": (
        "Der Arm von Q im Grundriss: Kreuz 3 schwenkt um ψ_P = {at_p}° um P, um ψ_Q = {at_q}° um Q."
    ),
    "hooke yoke": "Gabel {shaft} hält den Zapfen {pin}.",
    "hooke fork": "Gabel {shaft}, längs Welle 2 gesehen.",
    "hooke PQ": "Die Gerade von {one} nach {other} auf der anderen Seite der Ebene der Wellen.",
    "hooke T": "Sie durchstößt diese Ebene in T.",
    "hooke T below": "T wird in den Grundriss gelotet.",
    "hooke T plan": "Senkrecht darunter liegt T im Grundriss.",
    "hooke OT": "In OT schneidet die Ebene des Kreuzes die der Wellen.",
    # Polygone
    "hooke speeds": "Drehzahlen über einen Umlauf",
    "hooke shaft": "Welle {shaft}",
    "hooke line 24 velocity": (
        "Durch {point} parallel zu OT: gegenüber Gabel 2 kann sich Gabel 4 nur um Geraden in der "
        "Ebene des Kreuzes drehen; in der Ebene der Wellen ist nur OT eine, also liegt {meeting} "
        "auf dieser Geraden."
    ),
    "hooke line 24 acceleration": (
        "Durch {point} parallel zu OT: um wie viel die Drehung längs OT wächst, ist noch "
        "unbekannt, also liegt {meeting} auf dieser Geraden."
    ),
    "hooke line 14": (
        "Durch {point} parallel zu Welle 4: um eine andere Gerade dreht sie sich nicht, also liegt "
        "{meeting} auf dieser Geraden."
    ),
    "hooke fold": "Die Ebene des Kreuzes wird um OT in die der Wellen umgeklappt.",
    "hooke line 23": (
        "Durch {point} parallel zum umgeklappten OP: um OP dreht sich das Kreuz gegenüber Gabel 2, "
        "also liegt {meeting} auf dieser Geraden."
    ),
    "hooke line 43": (
        "Durch {point} parallel zu OQ, senkrecht zur anderen Geraden: {meeting} liegt auf dem "
        "Thaleskreis über 24."
    ),
    "hooke turned frame": (
        "{label} = {symbol}·τ̇ = {omega} × {tau} = {value} {unit}, ⟂ OT: {symbol} dreht sich mit OT."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
}

NAMES = {
    "Hooke’s joint": "Kreuzgelenk",
    "driving": "Antriebswelle",
    "driven": "Abtriebswelle",
    "cross": "Kreuz",
    "shaft_angle": "Beugewinkel",
}

GENDERS = {"driving": "f", "driven": "f", "cross": "n-es"}

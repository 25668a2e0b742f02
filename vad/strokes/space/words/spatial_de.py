"""Was der Dozent zum räumlichen Viergelenk sagt, auf Deutsch."""

PHRASES = {
    # Lage
    "spatial star": "längs DA",
    "spatial rose": "längs OA",
    "spatial a": "Die Achse a der Kurbel liegt fest.",
    "spatial d": "Ebenso die Achse d der Schwinge.",
    "spatial AD": (
        "AD = {size} {unit} ist ihre gemeinsame Normale; d ist gegen a um {twist}° geschränkt."
    ),
    "spatial shaft": "Die Kurbel dreht sich um a.",
    "spatial bearing": "Ein Lager hält sie: sie gleitet nicht.",
    "spatial A": "A ist der Fußpunkt der gemeinsamen Normalen auf a.",
    "spatial D sleeve": "In ihrer Hülse im Gestell dreht sich die Schwinge um d und gleitet auf d.",
    "spatial D": "D ist der Fußpunkt der gemeinsamen Normalen auf d.",
    "spatial crank": "Die Kurbel AB = {size} {unit} steht bei {angle}°.",
    "spatial circle": "Längs a gesehen läuft B auf einem Kreis.",
    "spatial reference": "Der Winkel zählt von AD an.",
    "spatial true": "Hier erscheint die Kurbel in wahrer Richtung.",
    "spatial angle": "Ihr Winkel ist {angle}°.",
    "spatial b": "Ihre Achse in B steht senkrecht auf AB und ist gegen a um {twist}° geschränkt.",
    "spatial B sleeve": "In ihrer Hülse bei B dreht sich und gleitet die Koppel.",
    "spatial directions": (
        "Die Richtungen sind die des sphärischen Viergelenks mit den Bögen {ground}°, {crank}°, "
        "{coupler}°, {rocker}°: Längen drehen nichts."
    ),
    "spatial true directions": "Längs DA gesehen liegen OA und OD in der Zeichenebene.",
    "spatial I": (
        "Dort schneiden sich Gestellebene und Koppelebene in OI, τ = {tau}° von OA: um OI dreht "
        "sich die Schwinge gegenüber der Kurbel."
    ),
    "spatial c": "Von dort hat die Achse in C ihre Richtung.",
    "spatial slides B": "Drei Längen schließen die Kette: s_B = {b}, s_C = {c}, s_D = {d} {unit}.",
    "spatial slides C": "s_C = {c} {unit}, von der Schwinge bis zum Fußpunkt von BC.",
    "spatial slides D": "s_D = {d} {unit}, von D bis zum Fußpunkt der Schwinge.",
    "spatial coupler": (
        "Die Koppel: von ihrer Welle in B längs der gemeinsamen Normalen BC = {size} {unit}."
    ),
    "spatial C sleeve": "Bei C führt sie die Schwinge in einer Hülse.",
    "spatial rocker": (
        "Die Schwinge DC = {size} {unit} mit ihren Wellen in C und D: θ₄ = {theta}°."
    ),
    "spatial C": "C ist der Fußpunkt von BC auf seiner Achse.",
    "spatial screw": "Um I dreht sich die Schwinge gegenüber der Kurbel, und sie gleitet längs I.",
    "spatial H": "I schneidet AD rechtwinklig in H: AH = {height} {unit}.",
    # die unteren Polygone
    "spatial pole velocity": (
        "Darunter A als Punkt der Schwinge; im Pol A und D des Gestells, die stillstehen."
    ),
    "spatial pole acceleration": (
        "Darunter A als Punkt der Schwinge; im Pol A und D des Gestells, die stillstehen."
    ),
    "spatial about I velocity": (
        "{label} = ω₄₂·AH = {turn} × {lever} = {value} {unit}, ⟂ OI: als Punkt der Schwinge dreht "
        "sich A gegenüber der Kurbel um I."
    ),
    "spatial about I acceleration": (
        "{label} = α₄₂ₜ·AH + ω₄₂·ḣ + v₄₂·τ̇ = {sum} = {value} {unit}, ⟂ OI: A dreht sich schneller "
        "um I, und I bewegt sich selbst."
    ),
    "spatial about D": (
        "{label} = {symbol}·AD = {turn} × {lever} = {value} {unit}, ⟂ OD: mit der Schwinge dreht "
        "sich A um D."
    ),
    "spatial along I velocity": (
        "Durch {point} parallel zu OI: wie schnell A längs I gleitet, ist noch unbekannt, also "
        "liegt {meeting} auf dieser Geraden."
    ),
    "spatial along I acceleration": (
        "Durch {point} parallel zu OI: der Anteil längs I ist noch unbekannt, also liegt {meeting} "
        "auf dieser Geraden."
    ),
    "spatial along D velocity": (
        "Durch {point} parallel zu OD: wie schnell A längs d gleitet, ist noch unbekannt, also "
        "liegt {meeting} auf dieser Geraden."
    ),
    "spatial along D acceleration": (
        "Durch {point} parallel zu OD: der Anteil längs d ist noch unbekannt, also liegt {meeting} "
        "auf dieser Geraden."
    ),
}

NAMES = {"Spatial four-bar": "Räumliches Viergelenk", "axis": "Achse"}

GENDERS = {"axis": "f"}

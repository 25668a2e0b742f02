"""Was die Lehrerin sagt und was auf Tafel und Seite steht, auf Deutsch (Schreibweise: en.py)."""

#: Was zu den Strichen gesagt wird, und was an der Tafel steht.
PHRASES = {
    # Seite
    "results": "Ergebnisse",
    "given": "gegeben",
    "colon": ": ",
    "legend": "grau: gegeben",
    "legend sense": "positiv",
    "coriolis rule": "Coriolis: *v* um 90° im Drehsinn von *ω* gedreht",
    # ein Aufgabenblatt
    "name": "Name",
    "class": "Klasse",
    "working": "Rechnung",
    "task": "Zeichnen Sie {panels} im angegebenen Maßstab und bestimmen Sie {found}.",
    "task draw": "Zeichnen Sie {panels} im angegebenen Maßstab.",
    "task given": "Gegeben: {given}.",
    "given inertia": "{size} in {point}",
    "given spin": "{size} um {point}",
    "task position": "den Lageplan",
    "task velocity": "den Geschwindigkeitsplan",
    "task acceleration": "den Beschleunigungsplan",
    "task force": "die Kräftepläne",
    "task more": "Weitere Maße: {given}.",
    "task measure": "Entnehmen Sie die übrigen Maße der Zeichnung.",
    "task centres": "die Momentanpole",
    "task klein": "die Konstruktion nach Klein",
    "task turned": "die gedrehten Geschwindigkeiten",
    "task drive": "die Kräfte am Antriebsglied",
    "task shaft": "die Welle mit ihren Massen",
    "task couple": "das Momentenpolygon",
    "task engine": "den Motor mit seinen Kurbeln",
    "task primary": "die Polygone der Kräfte und Momente 1. Ordnung",
    "task secondary": "die Polygone der Kräfte und Momente 2. Ordnung",
    "task traction": "die Zugkraftschwankung und das Schlingermoment",
    "task hammer": "den Hammerschlag der Räder",
    # eine Frage eines Fragenkatalogs
    "quiz given": "{title}: {given}.",
    "quiz angle": "Gesucht: der Winkel {link:des} in Grad, gegen den Uhrzeigersinn von *x* aus.",
    "quiz omega": (
        "Gesucht: die Winkelgeschwindigkeit {link:des} in {unit}, gegen den Uhrzeigersinn positiv."
    ),
    "quiz alpha": (
        "Gesucht: die Winkelbeschleunigung {link:des} in {unit}, gegen den Uhrzeigersinn positiv."
    ),
    "quiz position": "Gesucht: die Lage {slide:des} in {unit}.",
    "quiz velocity": (
        "Gesucht: die Geschwindigkeit {slide:des} in {unit}, positiv, wenn die Lage zunimmt."
    ),
    "quiz acceleration": (
        "Gesucht: die Beschleunigung {slide:des} in {unit}, positiv in der Richtung, in der die "
        "Lage zunimmt."
    ),
    "quiz coriolis": "Gesucht: der Betrag der Coriolisbeschleunigung {slide:des} in {unit}.",
    "quiz point velocity": "Gesucht: der Betrag der Geschwindigkeit von {point} in {unit}.",
    "quiz point acceleration": "Gesucht: der Betrag der Beschleunigung von {point} in {unit}.",
    "quiz force": "Gesucht: der Betrag der Kraft {one:des} {other:am} in {unit}.",
    "quiz torque": (
        "Gesucht: das Moment, das {link:am} wirken muss, in {unit}, gegen den Uhrzeigersinn "
        "positiv."
    ),
    "quiz push": (
        "Gesucht: die Kraft, die {slide:am} wirken muss, in {unit}, positiv in der Richtung, "
        "in der die Lage zunimmt."
    ),
    "quiz found mass": "Gesucht: die Masse von {point} in kg.",
    "quiz found radius": "Gesucht: der Halbmesser von {point} in {unit}.",
    "quiz found angle": "Gesucht: der Winkel von {point} in Grad.",
    "quiz found plane": "Gesucht: die Ebene von {point} in {unit}.",
    "quiz found primary force": ("Gesucht: die größte Kraft 1. Ordnung im Umlauf in {unit}."),
    "quiz found secondary force": ("Gesucht: die größte Kraft 2. Ordnung im Umlauf in {unit}."),
    "quiz found primary couple": ("Gesucht: das größte Moment 1. Ordnung im Umlauf in {unit}."),
    "quiz found secondary couple": ("Gesucht: das größte Moment 2. Ordnung im Umlauf in {unit}."),
    "quiz found hammer blow": "Gesucht: der Hammerschlag des Rades {point} in {unit}.",
    "quiz found tractive force": "Gesucht: die größte Schwankung der Zugkraft in {unit}.",
    "quiz found swaying couple": ("Gesucht: das größte Drehmoment um die Hochachse in {unit}."),
    "quiz key": "Die Zeichnung mit allen Ergebnissen:",
    # Umlauf
    "stroke": "Hub",
    "after touch-down": "nach dem Aufsetzen",
    "broken vectors": "Unterbrochene Vektoren sind länger.",
    "stance": "Standphase",
    "swing": "Schwungphase",
    "lift": "Hub",
    "forward": "Hinlauf",
    "return": "Rücklauf",
    "ratio": "Verhältnis",
    "mean": "Mittel {value}",
    "flywheel": "Schwungrad für {share}: {value}",
    "swings": "{part} schwingt zwischen {low} und {high}",
    "slides": "{part} läuft zwischen {low} und {high}",
    "law of swing": "als Sinus der Zeit, nicht gleichförmig",
    # Lageplan
    "fixed": "{letter} ist ein Gestellgelenk.",
    "fixed point": "{letter} ist ein fester Punkt.",
    "guides cross": "{letter}, wo sich die Führungen schneiden, ist fest.",
    "guide": "Auf dieser Führung gleitet {head}.",
    "guide point": "Auf dieser Führung gleitet {head}; {tail} ist ein fester Punkt von ihr.",
    "slot": "{head} gleitet im Schlitz {link:des}.",
    "driven bar": "{link:Der} {bar} = {size} {unit} steht bei {angle}°.",
    "driven slide": "{slide:Der} {head} steht bei {symbol} = {value} {unit} auf seiner Führung.",
    "driven slide from": (
        "{slide:Der} {head} steht bei {symbol} = {value} {unit} auf seiner Führung, von {tail} aus "
        "gemessen."
    ),
    "angle": "Winkel zählen von *x* aus gegen den Uhrzeigersinn.",
    "compass": "{head} liegt auf dem Kreis um {tail}, Radius {bar} = {size} {unit}.",
    "compass corner": (
        "{head} liegt auf dem Kreis um {tail}, Radius {bar} = {size} {unit} (aus ∠{corner})."
    ),
    "compass strut": (
        "{head} liegt auf dem Kreis um {tail}, Radius {bar} = {size} {unit}, der gegebenen Länge "
        "{link:des}."
    ),
    "lever line": "{link:Der} geht von {tail} durch {pin}.",
    "slot line": "Der Schlitz {link:des} geht durch {pin}, und {head} liegt auf seiner Geraden.",
    "found": "{letter} liegt im Schnittpunkt.",
    "arcs cross": "{letter} ist der {which}Schnittpunkt der Bögen.",
    "crossing right": "rechte ",
    "crossing left": "linke ",
    "crossing up": "obere ",
    "crossing down": "untere ",
    "on guide": "{letter} ist der Schnittpunkt von Bogen und Führung.",
    "on slot": "{letter} ist der Schnittpunkt des Schlitzes mit der Führung.",
    "on lever": "{letter} ist der Punkt {link:des}, der jetzt unter {pin} liegt.",
    "bar": "{link:Der} {bar} steht bei {symbol} = {angle}°.",
    "bar backward": (
        "{link:Der} {bar} steht bei {symbol} = {angle}°: {end} liegt jenseits von {tail}."
    ),
    "block towards": (
        "{slide:Der} {head} steht bei {symbol} = {value} {unit}, gemessen von {tail} nach {end}."
    ),
    "block": "{slide:Der} {head} steht bei {symbol} = {value} {unit}.",
    "block from": ("{slide:Der} {head} steht bei {symbol} = {value} {unit}, von {tail} aus."),
    "block beside": (
        "{slide:Der} {head} steht bei {symbol} = {value} {unit}, im Schlitz vom Punkt aus "
        "gemessen, der {tail} am nächsten ist."
    ),
    "plate": "{link:Der} ist der starre Körper {corners}.",
    "third point": "{letter} ist der Schnittpunkt der Bögen, mit {corners} {sense}.",
    "on link slot": "{letter} ist der Schnittpunkt des Bogens mit der Geraden des Schlitzes.",
    "in slot": "{head} liegt auf der Geraden des Schlitzes {link:des}.",
    "tip": "{letter} liegt auf {link:dem}, {size} {unit} von {tail}.",
    "tip against": "{letter} liegt auf {link:dem}, {size} {unit} jenseits von {tail}.",
    # Polygone
    "pole velocity": "Der Pol: hier liegen {letters}, denn feste Punkte ruhen.",
    "pole acceleration": "Der Pol: hier liegen {letters}, denn feste Punkte bleiben in Ruhe.",
    "pole velocity one": (
        "Der Pol: der feste Punkt {point} hat keine Geschwindigkeit, also liegt {letters} hier."
    ),
    "pole acceleration one": (
        "Der Pol: der feste Punkt {point} hat keine Beschleunigung, also liegt {letters} hier."
    ),
    "pole turning": "{said} Bei {count} U/min ist {omega} = 2π·*n*/60 = {rate} {rad/s}.",
    "pole steady": "{said} Längs {line:des} ist {symbol} null.",
    "pole steady point": (
        "{said} Längs {line:des} ist {symbol} null, also liegt auch {letter} hier."
    ),
    "on the guide": "{letter} ({point} auf der Führung)",
    "still": "Der Antrieb steht still und mit ihm alles andere: das Polygon ist sein Pol.",
    "velocity of": "die Geschwindigkeit von {head}",
    "velocity of relative": "die Geschwindigkeit von {head} relativ zu {tail}",
    "acceleration of": "die Beschleunigung von {head}",
    "acceleration of relative": "die Beschleunigung von {head} relativ zu {tail}",
    "tangential velocity whole": (
        "{label} = {omega}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} im Drehsinn von "
        "{omega}: {whose}."
    ),
    "normal": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, von {head} nach {tail}{also}."
    ),
    "double prime": "; ″ unterscheidet {other} von {one}",
    "normal whole": (
        "{label} = {omega}²·{bar} = {rate} × {size} = {value} {unit}, von {head} nach {tail}: "
        "{whose}."
    ),
    "tangential acceleration": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} im Drehsinn von "
        "{alpha}."
    ),
    "tangential acceleration whole": (
        "{label} = {alpha}·{bar} = {rate} × {size} = {value} {unit}, ⟂ {bar} im Drehsinn von "
        "{alpha}: {whose}."
    ),
    "sliding velocity": ("{label} = {value} {unit}, {way}: längs {line:des} gegeben."),
    "sliding velocity strut": ("{label} = {value} {unit}, {way}: gegeben, ohne Drehung von {bar}."),
    "sliding acceleration": (
        "{label} = {value} {unit}, {way}: die gegebene Beschleunigung längs {line:des}."
    ),
    "coriolis": (
        "{label} = 2·{omega}·*v* = 2 × {rate} × {speed} = {value} {unit}, "
        "Coriolisbeschleunigung: *v* um 90° im Drehsinn von {omega} gedreht."
    ),
    "across velocity": (
        "⟂ {bar} durch {point}: relativ zu {tail} bewegt sich {head} nur so, also liegt {meeting} "
        "darauf."
    ),
    "across velocity strut": (
        "⟂ {bar} durch {point}: außer längs {bar} kann sich {head} nur quer bewegen, also liegt "
        "{meeting} darauf."
    ),
    "across acceleration": (
        "⟂ {bar} durch {point}, Richtung von {alpha}·{bar}: {meeting} liegt darauf."
    ),
    "along velocity": (
        "∥ {line} durch {point}: anders kann sich {slide:der} {head} nicht bewegen, also liegt "
        "{meeting} darauf."
    ),
    "along velocity slot": (
        "∥ {line} durch {point}: {line:im} kann {slide:der} {head} nur so gleiten, also "
        "liegt {meeting} darauf."
    ),
    "along velocity link": (
        "∥ {line} durch {point}: auf {line:dem} kann {slide:der} {head} nur so gleiten, also liegt "
        "{meeting} darauf."
    ),
    "along acceleration": (
        "∥ {line} durch {point}, Richtung der Gleitbeschleunigung: {meeting} liegt darauf."
    ),
    "without normal": "Wegen {zero} = 0 gibt es keine Normalkomponente. {said}",
    "without coriolis": "Wegen {zero} = 0 gibt es keine Coriolisbeschleunigung. {said}",
    "crossing": "{letter} ist der Schnittpunkt der Geraden.",
    "crossing zero": "{letter} ist der Schnittpunkt der Geraden: {found}.",
    "lines and crossing": "{one}; {other}. {crossing}",
    "lines that cross": "{one}; {other}. Sie schneiden sich in {crossing}.",
    "line and crossing": "{one}. {crossing}",
    "line alone": "{one}.",
    "zero": "bei {point}, also ist {symbol} null",
    "zeros": "{one}; {other}",
    "pole crossing": "Der Pol {letter} ist der Schnittpunkt der Geraden: {point} steht still.",
    "measured omega": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense}: von {tail} aus "
        "gesehen läuft {head} {way}."
    ),
    "measured omega absolute": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense}: {head} läuft {way}."
    ),
    "measured omega strut": (
        "{omega} = {label}/{bar} = {value}/{size} = {rate} {rad/s}, {sense}: quer zu {bar} läuft "
        "{head} {way}."
    ),
    "measured alpha": "{alpha} = {label}/{bar} = {value}/{size} = {rate} {rad/s²}, {sense}.",
    "measured sliding velocity": (
        "{label} = {value} {unit}: {slide:der} {head} gleitet längs {line:des} {way}, {symbol} = "
        "{rate} {unit}."
    ),
    "measured sliding acceleration": (
        "{label} = {value} {unit}, {way}: {slide:der} {head} hat längs {line:des} {symbol} = "
        "{rate} {unit}."
    ),
    "whole": "{label} = {value} {unit}, {whose}.",
    "too small": "{said} Dieser Vektor ist in diesem Maßstab zu kurz, um sichtbar zu sein.",
    "image velocity": "dem Geschwindigkeitsbild",
    "image acceleration": "dem Beschleunigungsbild",
    "image": (
        "{letter} aus {image} {link:des}: {part} = {whole}·{bar}/{base} = {known} × "
        "{size}/{length} = {own} {unit}{also}."
    ),
    "image against": (
        "{letter} aus {image} {link:des}, jenseits von {tail}: {part} = {whole}·{bar}/{base} = "
        "{known} × {size}/{length} = {own} {unit}{also}."
    ),
    "image similar": (
        "{letter} aus {image} {link:des}, {triangle} gleichsinnig ähnlich zu {corners}: "
        "{part} = {whole}·{bar}/{base} = {known} × {size}/{length} = {own} {unit}."
    ),
    "image line": (
        "Durch {point} unter ∠{corner} = {angle}°, {sense} ab {side}, wie {link:am}: "
        "{meeting} liegt darauf."
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
    # die Antwort
    "answer": "Antwort",
    "answer at angle": "Bei {value}°",
    "answer at place": "Bei {symbol} = {value} {unit}",
    "answer here": "In dieser Lage",
    "answer turns": "{place} dreht sich {name:der} {of} {way} mit {rate} {unit}{trend}.",
    "answer moves": "{place} bewegt sich {name:der} {of} {way} mit {rate} {unit}{trend}.",
    "answer measures": "{place} hat {name:der} {of} {symbol} = {rate} {unit}{trend}.",
    "answer rests": "{place} steht {name:der} {of} für einen Augenblick still.",
    "answer point": "{place} gilt für {of}: {rates} von *x* aus.",
    "answer point rate": "{symbol} = {rate} {unit} bei {way}°",
    "answer shifts": (
        "{place} bewegt sich {name:der} {of} {way} mit {rate} {unit}, ohne sich zu drehen."
    ),
    "answer pushes": (
        "{place} muss der Antrieb die Enden von {of} mit {symbol} = {value} {unit} "
        "auseinanderdrücken."
    ),
    "answer pulls": (
        "{place} muss der Antrieb die Enden von {of} mit {symbol} = {value} {unit} zusammenziehen."
    ),
    "answer torque": (
        "{place} muss das Drehmoment *{symbol}* = {value} {unit} {way} {name:am} {of} wirken."
    ),
    "answer force": (
        "{place} muss die Kraft {symbol} = {value} {unit} {name:den} {of} {way} antreiben."
    ),
    "answer undriven": "{place} braucht {name:der} {of} keinen Antrieb.",
    "answer gains": " und wird schneller",
    "answer loses": " und wird langsamer",
    "answer steady": "",
    "answer next": "; ",
    "page stepped": (
        "Diese Seite wird Strich für Strich abgespielt. "
        "Die Zeichnung lässt sich nicht von Hand drehen."
    ),
    "answer balances": "Die Welle ist ausgeglichen durch {masses}.",
    "answer mass": "{letter} mit {symbol} = {size} {unit} unter {angle}°",
    "answer over a turn": "Im Umlauf: {results}.",
    "answer reaches": "{what} erreicht {largest} {unit} bei {where}°",
    "answer steadily": "{what} beträgt immer {largest} {unit}",
    "answer balanced": "{what} ist ausgeglichen",
    "answer primary force": "die Kraft 1. Ordnung",
    "answer secondary force": "die Kraft 2. Ordnung",
    "answer primary couple": "das Moment 1. Ordnung",
    "answer secondary couple": "das Moment 2. Ordnung",
    "answer tractive force": "die Schwankung der Zugkraft",
    "answer swaying couple": "das Drehmoment um die Hochachse",
    "answer hammer blow": "der Hammerschlag von {letter}",
    "loop": "{panel}, Masche {number}",
    # Wörter
    "and": "{first} und {last}",
    "the pole": "den Pol",
    "of point": "von {head}",
    "parallel": "∥ {line}",
    "square": "⟂ {line}",
    "degrees": "{angle}°",
    "counter-clockwise": "gegen den Uhrzeigersinn",
    "clockwise": "im Uhrzeigersinn",
    "extending": "von {tail} nach {head} (ausfahrend)",
    "retracting": "von {head} nach {tail} (einfahrend)",
    "outwards": "von {tail} nach {head}",
    "inwards": "von {head} nach {tail}",
    "right": "nach rechts",
    "left": "nach links",
    "up": "nach oben",
    "down": "nach unten",
    # --- das sphärische Gelenkviereck und Pläne von Körpern
    # Lageplan
    "spherical along": "längs {axis}",
    "spherical frame": (
        "Die festen Achsen durchstoßen die Kugel um *O* in *A* und *D*, {size}° auseinander; "
        "*OA* und *OD* liegen im Blatt."
    ),
    "spherical crank angle": (
        "Längs *AO* gesehen steht die Kurbel bei {angle}°, vom Bogen *AD* gegen den Uhrzeigersinn."
    ),
    "spherical crank": (
        "*B* läuft um *OA* auf einem Kreis, der als Strecke erscheint: die Kurbel ist *AB* = "
        "{size}°."
    ),
    "spherical C": (
        "In *C* schneiden sich zwei Kreise: um *B* mit *BC* = {coupler}° und um *D* mit *DC* = "
        "{rocker}°, als Strecke zu sehen."
    ),
    "spherical bars": (
        "Die Koppel *BC* steht bei *θ_B* = {b}° zum verlängerten Bogen *AB*; von *CD* nach *CB* "
        "ist *θ_C* = {c}°."
    ),
    "spherical rocker angle": (
        "Längs *DO* gesehen steht die Schwinge bei {symbol} = {angle}°, vom verlängerten Bogen "
        "*AD* aus."
    ),
    "spherical I": (
        "Die Großkreise von *BC* und *AD* schneiden sich in *I* im Winkel *δ* = {delta}°; *AI* = "
        "{ai}°, *DI* = {di}°. Um *OI* dreht sich die Schwinge relativ zur Kurbel."
    ),
    "spherical laid": "Um *OI* ins Blatt umgeklappt liegt *OB* {b}° und *OC* {c}° von *OI*.",
    # Pläne von Körpern
    "bodies remark": (
        "Dreieck 1 2 4 in der Gestellebene; 2 3 4 in der Koppelebene, ins Blatt umgeklappt"
    ),
    "bodies pole": "Pol ist das Gestell, {frame}; {symbol} = {value} {unit}, längs {axis}.",
    "bodies pole steady": ("Der Pol: das Gestell, 1′, und 2′, denn *α₂* = {value} ist gegeben."),
    "bodies measured": "{symbol} = {value} {unit}.",
    "bodies whole": "|{symbol}| = {value} {unit}, von {tail} nach {head}.",
    "bodies whole steady": (
        "|{symbol}| = {value} {unit}, von {tail} nach {head}: wegen *α₂* = 0 der Vektor *α₄*."
    ),
    "bodies turned frame": (
        "|{symbol}·*τ̇*| = {omega} × ({apart}·cos *δ*)/sin({delta}°) = {value} {unit}, ⟂ *OI*. "
        "Klammer: Teil von *ω₃* in *BOC* ⟂ *OI*, mit den Abständen von 3 und 1 zu 2 4."
    ),
    "bodies turned coupler": (
        "|{symbol}·*τ̇₃*| = {omega} × ({apart}·cos *δ*)/sin({delta}°) = {value} {unit}, ⟂ *OI*. "
        "Klammer: Teil in *AOD*."
    ),
    "bodies turned paced": (
        "|{symbol}·*τ̇*| = {omega} × {pace} = {value} {unit}, ⟂ *OI*, mit *τ̇* = (*ω₄₂*·sin "
        "*IB*·sin *IC*/sin {bc}° − *ω₂*·sin *τ*·cos *δ*)/sin *δ* = {signed} {rad/s}."
    ),
    "bodies line 24 velocity": "∥ *OI* durch {point}, Achse der Schwinge relativ zur Kurbel",
    "bodies line 14 velocity": "∥ *OD* durch {point}, ihre Achse im Gestell",
    "bodies line 23 velocity": (
        "∥ *OB* durch {point}, {arc}° von *OI*, Achse der Koppel an der Kurbel"
    ),
    "bodies line 43 velocity": (
        "∥ *OC* durch {point}, {arc}° von *OI*, ihre Achse an der Schwinge"
    ),
    "bodies line 24 acceleration": "∥ *OI* durch {point}, längs *α₄₂ₜ*",
    "bodies line 14 acceleration": "∥ *OD* durch {point}, längs *α₄*",
    "bodies line 23 acceleration": "∥ *OB* durch {point}, {arc}° von *OI*, längs *α₃₂*",
    "bodies line 43 acceleration": "∥ *OC* durch {point}, {arc}° von *OI*, längs *α₃₄*",
    "bodies fold": (
        "Die Koppelebene wird um *OI* ins Blatt umgeklappt: dort sind *OB* und *OC* unverzerrt."
    ),
    "bodies fold again": "Wieder wird diese Ebene um *OI* umgeklappt.",
    "bodies sines": (
        "{symbol} = *ω₂*·sin *AI* / sin *DI* = {crank} × sin({ai}°) / sin({di}°) = {value} {unit}."
    ),
    # --- Wellen und Motoren
    "balance axis": "{axis} ist die Achse der Welle, von ihrem Ende gesehen.",
    "balance reference": "Von dieser Geraden an werden Winkel gemessen.",
    "balance mass": "Masse {letter}: {mass} kg bei {radius} {unit} unter {angle}°.",
    "balance open": "Masse {letter} bei {radius} {unit} ist gesucht.",
    "balance side": "Von der Seite gesehen: die Ebenen längs der Welle.",
    "balance plane": "Die Ebene von {letter}.",
    "balance forces": "Die Vektoren *m·r* ergeben zusammen null.",
    "balance couples": "Die Vektoren *m·r·l* um die Ebene von {reference} ergeben zusammen null.",
    "balance known force": "{letter}: *m·r* = {mass} × {radius} = {value} {unit}, nach außen.",
    "balance known couple": (
        "{letter}: *m·r·l* = {mass} × {radius} × {arm} = {value} {unit}, nach außen."
    ),
    "balance known couple inward": (
        "{letter}: *m·r·l* = {mass} × {radius} × {arm} = {value} {unit}, nach innen: "
        "die Ebene liegt auf der anderen Seite."
    ),
    "balance from couples force": (
        "{letter} ist aus den Momenten bekannt: *m·r* = {value} {unit}."
    ),
    "balance from couples couple": "{letter}: *m·r·l* = {value} {unit}.",
    "balance closes": "Die Schlusslinie ist {letter}: {value} {unit} unter {angle}°.",
    "balance line": "{letter} liegt auf dieser Geraden.",
    "balance arc": "{letter} ist {value} {unit} lang: ein Bogen mit diesem Halbmesser.",
    "balance meet": "Sie treffen sich: das Polygon schließt sich.",
    "balance meet twice": (
        "Sie treffen sich: das Polygon schließt sich. Sie treffen sich ein zweites Mal, in der "
        "gespiegelten Lösung: choice {choice}."
    ),
    "balance other": "auch eine gespiegelte Lösung gleicht aus: choice {choice}",
    "balance about other": (
        "um die Ebene von {reference}; auch eine gespiegelte Lösung gleicht aus: choice {choice}"
    ),
    "balance about": "um die Ebene von {reference}",
    "engine zero": (
        "Hier schließt es sich; im Umlauf ist die Resultierende höchstens {largest} {unit}, "
        "bei {where}°."
    ),
    "engine rod": "Pleuel und Kolben von {letter}.",
    "engine stroke": "Die Hubrichtung von {letter}.",
    "engine crank": "Die Kurbel von {letter} steht unter {angle}°.",
    "engine forces": "Die Kräfte werden aneinandergereiht.",
    "engine couples": "Die Momente um die Bezugsebene werden aneinandergereiht.",
    "engine primary": "{letter}: {value} {unit} unter dem Winkel seiner Kurbel, {angle}°.",
    "engine secondary": (
        "{letter}: {value} {unit} unter dem doppelten Winkel seiner Kurbel, {angle}°."
    ),
    "engine direct": (
        "Gleichlaufende Kurbel von {letter}: die Hälfte, {value} {unit} unter {angle}°."
    ),
    "engine reverse": (
        "Gegenlaufende Kurbel von {letter}: die Hälfte, {value} {unit} unter {angle}°."
    ),
    "engine turning": "Masse {letter} dreht sich mit der Welle: {value} {unit} unter {angle}°.",
    "engine resultant": "Die Resultierende {letter} ist {value} {unit} unter {angle}°.",
    "engine ellipse": (
        "Im Umlauf läuft ihr Ende auf dieser Ellipse: {letter} ist höchstens {largest} {unit}, "
        "bei {where}°, und mindestens {least} {unit}."
    ),
    "engine circle": "Ihr Ende läuft auf diesem Kreis: {letter} ist immer {largest} {unit}.",
    "engine straight": (
        "Ihr Ende läuft auf dieser Strecke hin und her: "
        "{letter} ist höchstens {largest} {unit}, bei {where}°."
    ),
    "engine turned": "Die Welle hat sich um {angle}° gedreht.",
    "engine closing primary": (
        "Der Schlussvektor {letter} ist {value} {unit} unter {angle}°. Er dreht sich mit der "
        "Kurbel."
    ),
    "engine closing secondary": (
        "Der Schlussvektor {letter} ist {value} {unit} unter {angle}°. Er dreht sich doppelt so "
        "schnell wie die Kurbel."
    ),
    "engine across": "Nur sein Anteil in der Hubrichtung wirkt.",
    "engine nothing": (
        "Hier wirkt kein Teil von ihm; im Umlauf erreicht {letter} {largest} {unit}, bei {where}°."
    ),
    "engine resultant in line": (
        "{letter} = {value} {unit} in der Hubrichtung; im Umlauf höchstens {largest} {unit}, bei "
        "{where}°."
    ),
    "engine left out": (
        "Beide Glieder lassen höchstens {value} {unit} der genauen Kraft aus, bei {angle}°."
    ),
    "engine balanced": "Das Polygon schließt sich: ausgeglichen.",
    "traction forces": (
        "Was hin und her geht und nicht ausgeglichen ist, zieht längs des Gleises: die "
        "Zugkraft schwankt."
    ),
    "traction couples": (
        "Es dreht die Lokomotive um ihre Mitte: die Drehmomente werden aneinandergereiht. "
    ),
    "hammer blows": (
        "Was die Räder längs des Gleises ausgleichen, fügen sie quer dazu hinzu: den Hammerschlag."
    ),
    "hammer vector": (
        "{mass} kg von {letter} gleichen aus, was hin und her geht; sie ziehen mit {value} "
        "{unit} unter {angle}°."
    ),
    "hammer across": "Nur der Anteil quer zum Gleis wirkt auf die Schiene.",
    "hammer nothing": (
        "Rad {letter} wird hier weder gehoben noch gedrückt; es drückt mit {largest} {unit} "
        "bei {pressing}°."
    ),
    "hammer lifts": (
        "Rad {letter} wird mit {value} {unit} gehoben; es drückt mit {largest} {unit} bei "
        "{pressing}°."
    ),
    "hammer presses": (
        "Rad {letter} drückt mit {value} {unit} auf die Schiene; höchstens mit {largest} "
        "{unit}, bei {pressing}°."
    ),
    "balance found": "{letter} = {value} {unit} unter {angle}°.",
    # --- das Kreuzgelenk
    # Lageplan
    "hooke along": "längs Welle 2 gesehen",
    "hooke plan": "Ebene der Wellen",
    "hooke shafts": (
        "Die Wellen 2 und 4 schneiden sich in *O* unter *β* = {angle}°: unten in wahrer Größe, "
        "oben längs Welle 2 gesehen."
    ),
    "hooke P": (
        "*P*, der Zapfen von Gabel 2, läuft auf diesem Kreis und steht bei {angle}°; *OP* ist "
        "ein Arm des Kreuzes, 3."
    ),
    "hooke ellipse": (
        "*Q*, der Zapfen von Gabel 4, läuft um Welle 4: sein Kreis erscheint als Ellipse, schmaler "
        "um den Faktor cos {angle}°."
    ),
    "hooke Q": (
        "*OP* liegt im Blatt, also erscheint sein rechter Winkel mit *OQ* unverzerrt: diese "
        "Gerade trifft die Ellipse in *Q*."
    ),
    "hooke theta 4": (
        "Parallel zur Ebene der Wellen kommt *Q* auf den Kreis: dort ist {theta} = {value}° in "
        "wahrer Größe, tan {theta} = {ratio}."
    ),
    "hooke ratio": "tan {theta} / cos {shafts}",
    "hooke speed range": "*ω₄*/*ω₂* = {low} … {high}",
    "hooke tangent": "tan {theta}",
    "hooke plan view": (
        "Unten, mit *OP* = *OQ* = 1, steht *Q* sin *ψ_P* = sin *β*·sin *θ₄* vor der Ebene ⟂ "
        "Welle 2, *P* sin *ψ_Q* = sin *β*·cos *θ₂* vor der ⟂ 4: das Kreuz hat *ψ_P* = {at_p}°, "
        "*ψ_Q* = {at_q}°."
    ),
    "hooke T": "Die Gerade durch {one} und {other} trifft die Ebene der Wellen in *T*.",
    "hooke other end": "das andere Ende von *O*{pin}",
    "hooke OT": (
        "*T*, heruntergelotet, ergibt *OT*, den Schnitt der Ebenen von Kreuz und Wellen: nach dem "
        "Strahlensatz tan *τ* = tan {shafts}°·sin² {theta}°, *τ* = {tau}°."
    ),
    "hooke tau": "*τ*",
    "hooke laid": (
        "Um *OT* in die Ebene der Wellen umgeklappt, liegt *OP* {at_p}° von *OT*, mit dem "
        "Kosinus cos *τ*·cos *θ₂*, und *OQ*, ⟂ *OP*, {at_q}°."
    ),
    # Polygone
    "hooke speeds": "*ω₂*, *ω₄*, bei jedem *θ₂* abgetragen",
    "hooke shaft": "Welle {shaft}",
    "hooke line 24 velocity": (
        "∥ *OT* durch {point}, denn *ω₄₂* von Welle 4 relativ zu 2 liegt in beiden Ebenen"
    ),
    "hooke line 14 velocity": "∥ Welle 4 durch {point}, die Achse der Gabel 4",
    "hooke line 23 velocity": (
        "∥ *OP* durch {point}, denn um *OP* dreht sich das Kreuz in Gabel 2"
    ),
    "hooke line 43 velocity": "∥ *OQ* durch {point}, denn um *OQ* dreht es sich in Gabel 4",
    "hooke line 24 acceleration": "∥ *OT* durch {point}, längs *α₄₂ₜ*",
    "hooke line 14 acceleration": "∥ Welle 4 durch {point}, längs *α₄*",
    "hooke cross": (
        "{symbol} = {value} {unit}; *OP* ist ⟂ Welle 2, also *ω₃* = √({crank}² + {size}²) = "
        "{whole} {unit}; 1 3 verbindet zwei Ebenen und ist nicht *ω₃*."
    ),
    "hooke driven": "{symbol} = {value} {unit}; im Umlauf ist es {low} bis {high} mal *ω₂*.",
    "hooke fold": "*OP* und *OQ* bleiben so umgeklappt.",
    "hooke turned paced": (
        "|{symbol}·*τ̇*| = {omega} × {pace} = {value} {unit}, ⟂ *OT*, das sich mit *τ̇* = *ω₂*·tan "
        "*β*·sin 2*θ₂*·cos² *τ* dreht (tan *τ* abgeleitet)."
    ),
    # Kleins Konstruktion
    "klein rod": "Die Gerade der Stange {b}{c}, verlängert.",
    "klein square": "Durch {a}, senkrecht zur Führung.",
    "klein M": (
        "*M* ist der Schnittpunkt beider Geraden: {a}{b}*M* ist der Geschwindigkeitsplan, um "
        "90° gedreht."
    ),
    "klein rod 1": (
        "{side} = {size}: {c} hat gegen {b} *v* = {omega}·{side} = {rate} × {size} = {value} "
        "{unit}."
    ),
    "klein slider 1": (
        "{side} = {size}: der Schieber hat *v* = {omega}·{side} = {rate} × {size} = {value} {unit}."
    ),
    "klein circle M": "Ein Kreis um {b} durch *M*.",
    "klein circle rod": "Ein Kreis mit der Stange {b}{c} als Durchmesser.",
    "klein K": "*K* ist der Schnittpunkt der beiden Kreise.",
    "klein L": "*L* ist ihr zweiter Schnittpunkt.",
    "klein chord": "Die Sehne *KL* steht senkrecht zur Stange.",
    "klein Q": (
        "*Q* ist der Schnittpunkt von *KL* mit der Stange: {b}*Q* ist ihre Normalbeschleunigung, "
        "durch ω²."
    ),
    "klein guide": "Durch {a}, längs der Führung.",
    "klein N": (
        "*N* ist der Schnittpunkt von *KL* mit dieser Geraden: {a}{b}*QN* ist der "
        "Beschleunigungsplan, um 180° gedreht."
    ),
    "klein rod 2": (
        "{side} = {size}: {c} hat gegen {b} *a*ₜ = {omega}²·{side} = {rate} × {size} = {value} "
        "{unit}."
    ),
    "klein slider 2": (
        "{side} = {size}: der Schieber hat *a* = {omega}²·{side} = {rate} × {size} = {value} "
        "{unit}."
    ),
    "klein remark": "{a}{b} : {b}*M* : {a}*M*   und   {a}{b} : {b}*Q* : *QN* : {a}*N*",
    # Momentanpole
    "centre bodies": "{count} Körper haben {all} Momentanpole: einen für je zwei.",
    "centre in": "{letter} in {point}",
    "centre pins": "Die Drehgelenke sind Pole: {centres}.",
    "centre all pins": "Jedes Drehgelenk ist der Pol der Körper, die es verbindet.",
    "centre slide": "{letter} liegt im Unendlichen, senkrecht zu {line:dem}: ein Körper gleitet.",
    "centre line": "Drei Körper haben ihre Pole auf einer Geraden: {letter} mit {one} und {other}.",
    "centre line far": (
        "{letter} liegt auf einer Geraden mit {one} und {other}, der im Unendlichen liegt und die "
        "Richtung gibt."
    ),
    "centre found": "{letter} ist der Schnittpunkt beider Geraden.",
    "centre away": "{letter} ist der Schnittpunkt beider Geraden, {size} {unit} von {other}.",
    "centre away label": "{letter}: {size} {unit} von {other}",
    "centre far": "Beide Geraden sind parallel: {letter} liegt im Unendlichen.",
    "centre far label": "{letter} im Unendlichen",
    "centre alike": "Beide Körper drehen gleich: {letter} liegt auf dieser Geraden im Unendlichen.",
    "centre ratio": (
        "{symbol} = {omega}·{first}/{second} = {rate} × {one}/{other} = {value} {unit}, {sense}."
    ),
    "centre speed": (
        "{both} ist ein Punkt beider Körper: *v* = {omega}·{first} = {rate} × {one} = {value} "
        "{unit}."
    ),
    "centre turning": (
        "{both} ist ein Punkt beider Körper: {symbol} = *v*/{second} = {rate}/{other} = {value} "
        "{unit}, {sense}."
    ),
    "centre cylinder": (
        "Stange und Rohr drehen gleich: {symbol} = *v*/{second} = {rate}/{other} = {value} {unit}, "
        "{sense}."
    ),
    "centre still": "{letter} liegt im Unendlichen: {link:der} dreht in dieser Lage nicht.",
    "centre same": "{both} liegt im Unendlichen: beide Körper bewegen sich in dieser Lage gleich.",
    "centrode fixed": "In allen Lagen liegt {letter} auf dieser Kurve: der Rastpolbahn.",
    "centrode under": "Auf {link:dem} liegt {letter} in allen Lagen auf dieser Kurve.",
    "centrode moving": (
        "Auf {link:dem} liegt {letter} auf dieser Kurve: der Gangpolbahn, die auf der anderen "
        "abrollt."
    ),
    # der gedrehte Geschwindigkeitsplan
    "turned pole": (
        "Der Pol liegt in {pivot}: Geschwindigkeiten sind um 90° gedreht und durch {omega} geteilt."
    ),
    "turned crank": "So ist {label} {crank:der} {bar} selbst.",
    "turned along": "Eine Geschwindigkeit senkrecht zu {bar} liegt gedreht längs {bar}.",
    "turned square": "Eine Geschwindigkeit längs {line:des} steht gedreht senkrecht dazu.",
    "turned crossing": "{letter} ist der Schnittpunkt beider Geraden.",
    "turned omega": (
        "{label} = {size}, also {symbol} = {omega}·{label}/{bar} = {rate} × {size}/{length} = "
        "{turning} {rad/s}, {sense}."
    ),
    "turned speed": "{label} = {size}: *v* = {omega}·{label} = {rate} × {size} = {value} {unit}.",
    # Kräfte
    "force nothing": "Kein Gelenk trägt eine Kraft: nur der Antrieb ist belastet.",
    "force force": "{label} = {value} {unit}, die Last {link:am} in {point}.",
    "force weight": "{label} = {value} {unit}, das Gewicht {link:des} in {point}.",
    "force inertia": (
        "{label} = *m*·*a* = {mass} {heavy} × {size} {fast} = {value} {unit}, die Trägheitskraft "
        "{link:des}, gegen die Beschleunigung von {point}."
    ),
    "force couple": "{label} = {value} {unit}, {sense}, das Moment {link:am}.",
    "force spin": (
        "{label} = *I*·{symbol} = {inertia} {heavy} × {alpha} {turning} = {value} {unit}, {sense}, "
        "das Moment der Trägheitskräfte {link:des}, gegen {symbol}."
    ),
    "force moved": (
        "Um *h* = {couple}/{label} = {moment} {turning}/({value} {unit}) = {arm} {length} "
        "verschoben, hat {label} allein auch das Moment {couple}."
    ),
    "force friction": "{label} = {value} {unit}, die Reibung {link:am} in {point}.",
    "force joint": (
        "{label} = {value} {unit}: die Gegenkraft {other:des} {link:am}, entgegengesetzt zu "
        "{opposite}."
    ),
    "force along": "{label} = {value} {unit} hält, was längs seiner Geraden {link:am} wirkt.",
    "force moments": (
        "Momente um {point}: {label} = {moment} {turning}/({size} {length}) = {value} {unit}, "
        "⟂ {bar}."
    ),
    "force square": "{label} steht senkrecht zur Geraden, auf der {link:der} gleitet.",
    "force two": "An {link:dem} {bar} wirken nur zwei Kräfte: beide liegen längs {bar}.",
    "force line": "Die Wirkungslinie von {label}.",
    "force meeting": (
        "Drei Kräfte im Gleichgewicht gehen durch einen Punkt: {link:am} schneiden sich "
        "{label} und {force} in {letter}."
    ),
    "force three": "Also geht auch {label} durch {point} und {meeting}.",
    "force rest": "Der Rest der Kraft, {label}, liegt längs {bar}.",
    "drive along": "{label} liegt längs der Geraden, auf der {link:der} gleitet.",
    "drive force": "{label} = {value} {unit}: so viel muss der Antrieb {link:am} aufbringen.",
    "force closes": "Die beiden Geraden schneiden sich: das Polygon schließt sich.",
    "force part": "{label} = {value} {unit}, gemessen.",
    "force pushes": "{label} = {value} {unit}: {one:der} drückt {other:am}.",
    "force pulls": "{label} = {value} {unit}: {one:der} zieht {other:am}.",
    "force on": "{label} = {value} {unit}: die Kraft {one:des} {other:am}.",
    "force arm": "*h* = {arm} {length} ist der Abstand des Punktes {point} von dieser Geraden.",
    "torque none": "Die Momente um {point} heben sich auf: es braucht kein Drehmoment.",
    "torque": "Momente um {point}: *T* = {torque} {turning}, {sense}, muss {link:am} wirken.",
    "torque sum": (
        "Momente um {point}: *T* = {terms} = {torque} {turning}, {sense}, muss {link:am} wirken."
    ),
    "superposed part": "{label} = {value} {unit} gehört zu {loads} allein.",
    "superposed alone": "{loads} allein: {said}",
    "drive superposed": (
        "{label} = {symbols} = {terms} = {value} {unit}: so viel muss der Antrieb {link:am} "
        "aufbringen."
    ),
    "superposed sum": (
        "{label} = {terms} = {value} {unit} als Vektoren: die Kraft {one:des} {other:am}."
    ),
    "torque superposed": (
        "*T* = {symbols} = {terms} = {torque} {turning}, {sense}, muss {link:am} wirken."
    ),
    "power one": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt}; {symbols} = {taken} "
        "{watt}: zusammen null."
    ),
    "power": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt}; {symbols} = {terms} = "
        "{taken} {watt}: zusammen null."
    ),
    "power all": (
        "{drive}·{symbol} = {value} {unit} × {rate} {fast} = {power} {watt}; die Leistung aller "
        "Lasten ist {taken} {watt}: zusammen null."
    ),
    "force torque": (
        "*T* = {label}·*h* = {value} {unit} × {arm} {length} = {torque} {turning}, {sense}, muss "
        "{link:am} wirken."
    ),
    "force whole": (
        "{label} = √({known}² + {found}²) = {value} {unit}: die Kraft {one:des} {other:am}."
    ),
    "turning measured": "{label} = {symbol} = {value} {unit}.",
    # --- das räumliche Gelenkviereck
    # Lage
    "spatial star": "längs *DA*",
    "spatial rose": "längs *A*",
    "spatial rose D": "längs *D*",
    "spatial frame": (
        "*AD* = {size} {unit} ist die gemeinsame Normale der Achsen in *A* und *D* ({twist}°); in "
        "*D* gleitet die Schwinge auch."
    ),
    "spatial crank": (
        "Die Kurbel *AB* = {size} {unit} steht bei {angle}° von *AD*, längs *A* gesehen."
    ),
    "spatial b": (
        "Die Achse in *B* ist ⟂ *AB*, {twist}° von der in *A*; die Koppel dreht sich und gleitet "
        "auf ihr."
    ),
    "spatial directions": (
        "*OA* bis *OD* sind ∥ den Achsen: die Ebenen *AOD*, *BOC* schneiden sich in *OI* unter "
        "*δ* = {delta}°, *τ* = {tau}° von *OA*; *IB* = {ib}°, *IC* = {ic}°."
    ),
    "spatial slides": (
        "Drei Längen schließen die Kette: *s_B* = {b}, *s_C* = {c}, *s_D* = {d} {unit}."
    ),
    "spatial bars": (
        "Die Koppel *BC* = {coupler} {unit}, die Schwinge *DC* = {rocker} {unit} bei *θ₄* = "
        "{theta}°."
    ),
    "spatial H": (
        "Gegen die Kurbel dreht sich die Schwinge um *I* ∥ *OI* und gleitet längs *I*, ⟂ *BC* und "
        "in *H* ⟂ *AD*: *AH* = {height} {unit}."
    ),
    # die unteren Polygone
    "spatial pole velocity": (
        "Unten, längs *DA* gesehen: *A* als Punkt der Schwinge, Geschwindigkeit *aa₄*."
    ),
    "spatial pole acceleration": ("*ay* und *ya₄* drehen sich mit *OI* und ändern sich."),
    "spatial about I velocity": (
        "{label} = |*ω₄₂*·*AH*| = {turn} × {lever} = {value} {unit}, ⟂ *OI*: *A* dreht sich um *I*."
    ),
    "spatial turned": "{label} = *aa₄*·|*τ̇*| = {speed} × {pace} = {value} {unit}, ⟂ *aa₄*.",
    "spatial about I acceleration": (
        "{label} = |*α₄₂ₜ*·*AH* + *ω₄₂*·*ḣ*| = {sum} = {value} {unit}, ⟂ *OI*; *AH* wächst mit "
        "*ḣ* = {rising} {pace}, Dualteil von *τ̇*."
    ),
    "spatial about D velocity": (
        "{label} = |{symbol}|·*AD* = {turn} × {lever} = {value} {unit}, ⟂ *OD*: auch um *D*."
    ),
    "spatial about D acceleration": (
        "{label} = |{symbol}|·*AD* = {turn} × {lever} = {value} {unit}, ⟂ *OD*."
    ),
    "spatial along I": "∥ *OI* durch {point}",
    "spatial along D velocity": "∥ *OD* durch {point}, *A* gleitet längs beider",
    "spatial along D acceleration": "∥ *OD* durch {point}",
    # --- das Gelenkviereck mit Kugelgelenken
    # Lageplan
    "balls ahead": "vor",
    "balls behind": "hinter",
    "balls crank": (
        "Unten, längs der Achse von *A* gesehen: die Kurbel *AB* = {size} {unit} steht bei "
        "{angle}° vom gemeinsamen Lot."
    ),
    "balls path of C": (
        "Oben, längs der Achse von *D* gesehen: *C* läuft auf diesem Kreis, *DC* = {size} {unit}; "
        "*A* und *B* stehen senkrecht darüber."
    ),
    "balls compass": (
        "*B* steht {height} {unit} {side} der Ebene dieses Kreises: hier ist *BC* = √({size}² − "
        "{height}²) = {reach} {unit}."
    ),
    "balls compass square": (
        "*B* steht {offset} + {crank}·sin {angle}° = {height} {unit} hinter der Ebene dieses "
        "Kreises: hier ist *BC* = √({size}² − {height}²) = {reach} {unit}."
    ),
    "balls offset": "{size}",
    "balls C": (
        "In *C* schneiden sich beide Kreise; die Schwinge *DC* steht bei {theta} = {angle}°."
    ),
    "balls top": "Senkrecht darunter ergänzt *C* die untere Ansicht.",
    "balls third": (
        "Um die Tangente an die Bahn von *C* umgeklappt, erscheint die Ebene durch sie und *BC* "
        "in wahrer Größe, die Ebene ⟂ *BC* als Gerade."
    ),
    "balls askew": (
        "Projektionen: *p_AB* = {seen_AB}, *p_DC* = {seen_DC}, *p_BT* = {seen_BT} (*BT*: *AB*, "
        "um 90° gedreht); nach hinten positiv *h_AB* = {off_AB}, *h_DC* = {off_DC}, *h_BT* = "
        "{off_BT} {unit}."
    ),
    "balls along D": "längs *D* gesehen",
    "balls along A": "längs *A* gesehen",
    "balls along both": "Ebene von *BC* und Bahn von *C* in wahrer Größe",
    # Pläne
    "balls path": "Bahn von *C*",
    "balls remark": "in der Ebene von *BC* und Bahn von *C*; die Koppel dreht sich nicht um *BC*",
    "balls tangential": "{label} = {symbol}·*p_BT* = {rate} × {size} = {value} {unit}, ∥ *BT*.",
    "balls normal": (
        "{label} = {symbol}²·{length} = {rate} × {size} = {value} {unit}, von {head} nach {tail}."
    ),
    "balls line BC velocity": "⟂ *BC* durch {point}, denn *BC* behält seine Länge",
    "balls line DC velocity": "∥ Bahn von *C* durch {point}",
    "balls line BC acceleration": "⟂ *BC* durch {point}, längs {symbol}·*BC*",
    "balls line DC acceleration": "∥ Bahn von *C* durch {point}, längs {symbol}·*DC*",
    "balls coupler velocity": "{symbol} = {label}/*BC* = {value}/{size} = {rate} {rad/s}.",
    "balls coupler velocity askew": (
        "{label} = {value} {unit} im Bild, nach hinten {sum} = {off} {unit}: zusammen "
        "{symbol} = {whole}/{size} = {rate} {rad/s}."
    ),
    "balls coupler acceleration": "{symbol} = {label}/*BC* = {value}/{size} = {rate} {rad/s²}.",
    "balls coupler acceleration askew": (
        "{label} = {value} {unit} im Bild, nach hinten {sum} = {off} {unit}: zusammen "
        "{symbol} = {whole}/{size} = {rate} {rad/s²}."
    ),
    "balls rocker velocity": "{symbol} = {label}/*DC* = {value}/{size} = {rate} {rad/s}, {sense}.",
    "balls rocker acceleration": (
        "{symbol} = {label}/*DC* = {value}/{size} = {rate} {rad/s²}, {sense}."
    ),
    "balls whole": "{label} = {value} {unit} im Bild.",
    # Bilder und Tabellen von Läufen, und Kennwerte
    "angle of the driver": "Winkel {link:des}",
    "position of the driver": "Lage {link:des}",
    "force of one on another": "{one} auf {other}",
    "transmission angle": "Übertragungswinkel",
    "time ratio": "Zeitverhältnis",
    "forward angle": "Winkel des Hinlaufs",
    "return angle": "Winkel des Rücklaufs",
    "mechanical advantage": "Kraftübersetzung",
    "does not close": "schließt nicht",
    "merit output": "Abtrieb",
    "merit grashof": "Grashof",
    "merit ranges": "schließt für",
    "merit dead": "Totlagen",
    "merit least": "kleinster Übertragungswinkel",
    "merit largest": "größter Übertragungswinkel",
    "merit none": "keine",
    "merit every angle": "jeden Winkel",
    "merit and": "{first} und {last}",
    "merit at": "{value} bei {place}",
    "grashof crank-rocker": "Kurbelschwinge",
    "grashof double-crank": "Doppelkurbel",
    "grashof double-rocker": "Doppelschwinge mit umlaufender Koppel",
    "grashof rocker-crank": "Kurbelschwinge, von der Schwinge getrieben",
    "grashof triple-rocker": "Totalschwinge",
    "grashof change point": "durchschlagend",
    "merit rubbing": "Gleiten am Bolzen",
    "merit pair": "{pin}: {one} auf {other}",
    "merit diameter": "Durchmesser",
    "merit velocity": "Geschwindigkeit",
    "merit slowest": "langsamster Punkt",
    "merit distance": "vom ersten Ende",
    "merit speed": "Betrag",
    "merit on link": "auf dem Glied",
    "merit yes": "ja",
    "merit no": "nein",
    "merit extremes": "Extremwerte",
    "merit minimum": "kleinster",
    "merit maximum": "größter",
    "merit place": "bei",
}

#: Namen von Getrieben, Diagrammen, Gliedern, Schiebern und Maßen.
NAMES = {
    "drive": "Antrieb",
    "joint": "Gelenk",
    "Shaft": "Welle",
    "Couples": "Momente",
    "Engine": "Motor",
    "Tractive force": "Zugkraft",
    "Hammer blow": "Hammerschlag",
    "Primary forces": "1. Ordnung",
    "Secondary forces": "2. Ordnung",
    "engine_cylinder": "Zylinder",
    "largest": "größte",
    "resultant": "Resultierende",
    "Position": "Lage",
    "Velocity": "Geschwindigkeit",
    "Acceleration": "Beschleunigung",
    "Drive": "Antrieb",
    "Instantaneous centres": "Momentanpole",
    "Klein’s construction": "Konstruktion nach Klein",
    "Turned velocities": "Gedrehte Geschwindigkeiten",
    "Forces": "Kräfte",
    "loads": "Lasten",
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
    "actuator_rod": "Kolbenstange",
    "cylinder_rod": "Kolbenstange",
    "frame": "Gestell",
    "mass": "Masse",
    "inertia": "Trägheitsmoment",
    "friction": "Reibung",
    "angle": "Winkel",
    "radius": "Trägheitsradius",
    "piston": "Kolben",
    "pin": "Bolzen",
    "ground": "Gestell",
    "slider": "Schieber",
    "block": "Stein",
    "ram": "Stößel",
    "yoke": "Kreuzschieber",
    "length": "Länge",
    "guide": "Führung",
    "slot": "Schlitz",
    "offset": "Versatz",
    "tracer": "Zeichenpunkt",
    "ram_height": "Stößelhöhe",
    "ground_angle": "Gestellwinkel gegen x",
    "guide_a": "Führung A",
    "guide_b": "Führung B",
    "Spherical four-bar": "Sphärisches Viergelenk",
    "Hooke’s joint": "Kreuzgelenk",
    "driving": "Antriebswelle",
    "driven": "Abtriebswelle",
    "cross": "Kreuz",
    "shaft_angle": "Beugewinkel β",
    "Spatial four-bar": "Räumliches Viergelenk",
    "axis": "Achse",
    "Spatial four-bar with ball joints": "Räumliches Viergelenk mit Kugelgelenken",
    "ground_twist": "Kreuzungswinkel",
    "crank_offset": "Kurbelversatz",
    "rocker_offset": "Schwingenversatz",
    "ratio": "Verhältnis",
    "coupled": "gekuppelte Achsen",
    "reference": "Bezugsebene",
    "rotating": "umlaufende Masse",
    "balance_radius": "Ausgleichsradius",
    "wheel_diameter": "Raddurchmesser",
    "wheel_load": "Radlast",
    "coupling": "Kuppelmasse",
    "coupling_radius": "Radius der Kuppelzapfen",
    "coupling_angle": "Winkel der Kuppelzapfen",
    "{}_angle": "Winkel {}",
    "{}_offset": "Versatz {}",
    "{}_mass": "Masse {}",
    "{}_radius": "Radius {}",
    "{}_crank": "Kurbelwinkel {}",
    "{}_plane": "Ebene {}",
    "{}_line": "Zylinderwinkel {}",
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
    "actuator_rod": "f",
    "cylinder_rod": "f",
    "frame": "n",
    "piston": "m",
    "pin": "m",
    "slider": "m",
    "block": "m",
    "ram": "m",
    "yoke": "m",
    "guide": "f",
    "slot": "m-es",
    "driving": "f",
    "driven": "f",
    "cross": "n-es",
    "axis": "f",
}

#: Der männliche Artikel, nach dem ein Satz fragt, und was daraus je nach Geschlecht wird.
_M = {
    "der": "der {}",
    "des": "des {}s",
    "dem": "dem {}",
    "den": "den {}",
    "zum": "zum {}",
    "im": "im {}",
    "am": "am {}",
}
_F = {
    "der": "die {}",
    "des": "der {}",
    "dem": "der {}",
    "den": "die {}",
    "zum": "zur {}",
    "im": "in der {}",
    "am": "an der {}",
}
ARTICLES = {
    "m": _M,
    "m-es": _M | {"des": "des {}es"},
    "f": _F,
    "n": _M | {"der": "das {}", "den": "das {}"},
}

#: Das Dezimalzeichen.
POINT = ","

#: Knöpfe und Texte der Seite einer Lektion.
PLAYER = {
    "play": "Abspielen",
    "pause": "Anhalten",
    "first": "Zum Anfang",
    "back": "Einen Strich zurück",
    "forward": "Einen Strich weiter",
    "last": "Zum Ende",
    "speed": "Tempo",
    "strokes": "Alle Striche",
    "theme": "Tafel oder Papier",
    "full-screen": "Vollbild",
    "large": "Ein Bild vergrößern",
    "keys": "Tasten",
    "letters": "Tasten aus einem Zeichen",
    "travels": "Vektoren wandern",
    "close": "Schließen",
    "scrub": "Gezeichnete Striche",
    "drawn": "{panel}: {done} von {count} Strichen gezeichnet",
    "begin": "Abspielen oder Strich für Strich weitergehen.",
    "controls": "Abspieler",
    "parts": "Diagramme",
    "key-space": "Leertaste",
    "key-home": "Pos1",
    "key-end": "Ende",
    "key-up": "Bild↑",
    "key-down": "Bild↓",
}

#: Worte einer Seite, auf der ein Getriebe von Hand gedreht wird.
HAND = {
    "lesson": "Lektion",
    "hand": "Hand",
    "mode": "Lektion oder Hand",
    "undo": "Rückgängig",
    "redo": "Wiederholen",
    "turn-crank": "Die Kurbel ist in der Hand.",
    "turn-link": "Das antreibende Glied ist in der Hand.",
    "move-slide": "Der Antrieb ist in der Hand.",
    "runs": "Der Mechanismus läuft von selbst.",
    "shown": "Zu sehen ist, was bis {panel} {step} gezeichnet ist.",
    "return": "Zurück zu {panel} {step}",
    "return-short": "Zurück",
    "return-lesson": "Zurück zur Lektion",
    "show-all": "Alles zeigen",
    "limit": "Grenzlage bei {place}: {why}.",
    "parted": "jenseits davon trennen sich die Glieder",
    "parting-bars": "{one} und {other} liegen auf einer Geraden",
    "parting-guide": "{one} steht senkrecht auf der Führung",
    "parting-slot": "{one} steht senkrecht auf der Schleife",
    "parting-spherical-four-bar": "B, C und D liegen auf einem Großkreis",
    "parting-rssr": "die Koppel BC steht senkrecht auf der Bahn von C",
    "other-assembly": "In der anderen Einbaulage weiter",
    "dead": "Totlage bei {place}: Geschwindigkeiten haben hier keinen Wert.",
    "unclosed": "{name} {place}: die Glieder schließen nicht; sie schließen für {ranges}",
    "unclosed-nowhere": "{name} {place}: mit diesen Maßen schließen die Glieder nirgends",
    "guarded": "Jenseits von {name} {value} gilt das Bild nicht: der Regler hält hier.",
    "try": "versuche {name} {value}",
    "unknown": "{name}: diese Eingabe hat die Seite nicht",
    "known": "sie hat {names}",
    "no-number": "{name}: muss eine endliche Zahl sein, nicht {value}",
    "positive": "{name}: muss positiv sein, nicht {value}",
    "beyond": "{name}: muss von {low} bis {high} {unit} gehen, wo Zahlen stimmen, nicht {value}",
    "assembly": "assembly: muss auf dieser Seite {names} sein, nicht {value}",
    "other-page": "sie hat eine eigene Seite: vad draw --assembly {value}",
    "or": " oder ",
    "assemblies": "Einbaulage",
    "request": "muss ein Objekt aus Namen und Zahlen sein",
    "crank": "Kurbelwinkel",
    "link": "Winkel des antreibenden Glieds",
    "slide": "Ort des Antriebs",
    "far-back": "Eine Vierteldrehung zurück",
    "far-on": "Eine Vierteldrehung weiter",
    "little-back": "1° zurück",
    "little-on": "1° weiter",
    "more-back": "Ein Viertel des Wegs zurück",
    "more-on": "Ein Viertel des Wegs weiter",
    "step-back": "Einen Schritt zurück",
    "step-on": "Einen Schritt weiter",
    "degrees": "{value} Grad",
    "motion": "Bewegung",
    "dimensions": "Maße",
    "more": "{count} weitere Maße",
    "show": "Zeigen",
    "curves": "Kurven",
    "hodographs": "Hodographen",
    "paths": "Bahnen",
    "names": "Buchstaben",
    "step": "step: muss ein Schritt der Lektion sein, nicht {value}",
    "unheld": "mit diesen Maßen würde diese Seite Falsches zeichnen",
    "steps-are": "eine Zahl von 0 bis {count}, oder wie velocity:4",
    "pole": "{name} ist der Pol",
    "vertex": "{name} {size} bei {angle}",
    "hide-row": "{name} zeigen oder verbergen",
    "settings": "Einstellungen",
    "no-polygon": "kein Plan in dieser Lage",
    "key-escape": "Esc",
    "page-keys": "15° zurück / weiter",
    "fine": "je 0,1°",
    "ring": "Am Ring ziehen",
    "and": " und ",
}

#: Zeichen, wie sie vorgelesen werden; „^“ ist eine Potenz.
SPOKEN = {
    "√": "Wurzel aus ",
    "∠": "Winkel",
    "⟂": "senkrecht zu",
    "∥": "parallel zu",
    "′": " Strich",
    "̇": " Punkt",
    "̈": " zwei Punkte",
    "″": " zwei Strich",
    "·": " mal ",
    "×": " mal ",
    "+": " plus ",
    "−": "minus ",
    "=": "gleich",
    "|": " ",
    "/": " durch ",
    "/s": " pro Sekunde",
    "°": " Grad",
    "^": "hoch {}",
    "^2": "Quadrat",
    "α": "Alpha",
    "β": "Beta",
    "θ": "Theta",
    "δ": "Delta",
    "τ": "tau",
    "ψ": "psi",
    "ω": "Omega",
    "φ": "Phi",
}

#: Was das Fenster von ``vad gui`` sagt.
WINDOW = {
    "title": "vad: Geschwindigkeits- und Beschleunigungspläne",
    "language": "Sprache",
    "mechanism": "Mechanismus",
    "dimensions": "Abmessungen",
    "assembly": "Einbaulage",
    "motion": "Antrieb",
    "angle": "Winkel θ",
    "position": "Lage",
    "open": "offen",
    "crossed": "gekreuzt",
    "upper": "oben",
    "lower": "unten",
    "left": "links",
    "right": "rechts",
    "parallel": "parallel",
    "draw": "Zeichnen",
    "reset": "Zurücksetzen",
    "link": "Link kopieren",
    "linked": "Der Link ist kopiert.",
    "save": "Speichern als",
    "saving": "Wird gespeichert …",
    "saved": "Gespeichert: {name}",
    "command": "Befehl kopieren",
    "copied": "Kopiert: {line}",
    "retry": "Noch einmal",
    "try": "nimm {values}",
    "stopped": "vad gui ist beendet. Starte es im Terminal neu.",
    "large": "{name} ist zu groß: Das Fenster öffnet Dateien von weniger als {most} kB.",
    "examples": "Beispiele",
    "turn": "Umlauf",
    "problem": "Aufgabenblatt",
    "file": "Öffnen …",
    "controls": "Was eingestellt ist",
    "slider": "{name}, Schieber",
}

# Was das Fenster anstelle der englischen Sätze sagt.
ERRORS = {
    "'{text}' is not a number": "„{text}“ ist keine Zahl",
    "'{text}' is not {what}": "„{text}“ ist keine Einheit, die hier passt",
    "try {input} {value}": "versuche {input} {value}",
    "try {units}": "versuche {units}",
    "with a point, as in 1.5": "mit einem Komma wie in 1,5",
    "write 60 or '60 {unit}'": "schreibe 60 oder 60 {unit}",
    "must be a finite number, got {value}": "muss eine endliche Zahl sein, nicht {value}",
    "must be positive, got {value}": "muss positiv sein, nicht {value}",
    "must be within ±{most}, got {value}": "muss zwischen −{most} und {most} liegen, nicht {value}",
    "must be between {low} and {high}, got {value}": (
        "muss zwischen {low} und {high} liegen, nicht {value}"
    ),
    "must be at least {low}, got {value}": "muss mindestens {low} sein, nicht {value}",
    "at {places} both axes are one": "bei {places} sind beide Achsen eine",
    "at {place} it locks": "bei {place} klemmt es",
    "parallel axes make a four-bar in the plane": (
        "parallele Achsen ergeben ein ebenes Gelenkviereck"
    ),
    "must differ from {other}, got {value}, which is the same line": (
        "muss sich von {other} unterscheiden: {value} ist dieselbe Gerade"
    ),
    "{input} {place}: the links miss by {miss}; they close for {input} {ranges}": (
        "Bei {place} fehlen den Gliedern {miss}; sie schließen für {input} {ranges}"
    ),
    "{input} {place}: the links miss by {miss}; with these lengths they close at no {input}": (
        "Bei {place} fehlen den Gliedern {miss}; mit diesen Maßen schließen sie nirgends"
    ),
    "with these lengths the links close nowhere": "mit diesen Maßen schließen die Glieder nirgends",
    "dead centre: the construction lines of {lines} are parallel and do not cross": (
        "Totlage: die Konstruktionslinien von {lines} sind parallel und schneiden sich nicht"
    ),
    "the result is undetermined at this dead centre": "in dieser Totlage ist das unbestimmt",
    "the result leaves the range of double precision": "das Ergebnis ist für den Rechner zu groß",
    "cannot be drawn, for its longest vector has {length}": (
        "lässt sich nicht zeichnen, weil der längste Vektor {length} hat"
    ),
    "draw other panels, or with other rates": "zeichne anderes oder mit anderem Antrieb",
    "parallel needs the coupler as long as the ground and the rocker as the crank": (
        "parallel geht nur mit einer Koppel so lang wie das Gestell "
        "und einer Schwinge so lang wie die Kurbel"
    ),
    "try coupler {coupler} and rocker {rocker}": "versuche Koppel {coupler} und Schwinge {rocker}",
    "the answer takes longer than {seconds} s": "die Antwort dauert länger als {seconds} s",
    "try fewer points, or a file": "versuche weniger Punkte oder eine Datei",
    "another film is being made": "es entsteht schon ein anderer Film",
    "too much is being worked out already": "es wird schon zu viel anderes berechnet",
    "try again in a while": "versuche es später noch einmal",
    "the film takes more than {size}": "der Film braucht mehr als {size}",
    "try a smaller size, or vad animate": "versuche es kleiner oder mit vad animate",
    "open the address that vad gui has printed": (
        "vad gui ist neu gestartet. Öffne die Adresse, die es ausgegeben hat"
    ),
    "a fault of the program; the terminal shows where": (
        "ein Fehler im Programm; das Terminal zeigt, wo"
    ),
    "{file}, line {line}": "{file}, Zeile {line}",
    "is no TOML from column {column} on: {detail}": "ist ab Spalte {column} kein TOML: {detail}",
    "is no TOML at its end: {detail}": "ist am Ende kein TOML: {detail}",
    "is nested too deep": "ist zu tief verschachtelt",
    "has a number of more than {count} digits": "hat eine Zahl mit mehr als {count} Ziffern",
    "write it as {number}": "schreibe sie wie {number}",
    'text stands in quotes: "{text}"': 'Text steht in Anführungszeichen: "{text}"',
    "a name is one word, as in {name}": "ein Name ist ein einziges Wort wie {name}",
    "did you mean {names}?": "ist {names} gemeint?",
    "known: {names}": "bekannt: {names}",
    "as in {example}": "wie in {example}",
    "must be a number, got {value}": "muss eine Zahl sein, nicht {value}",
    "must be one number to be opened here, got {value}": (
        "muss hier eine einzige Zahl sein, nicht {value}"
    ),
    "must be one word": "muss ein einziges Wort sein",
    "must be a line of text, got {value}": "muss eine Zeile Text sein, nicht {value}",
    "must be one word, got {value}": "muss ein einziges Wort sein, nicht {value}",
    "must be one point": "muss ein einziger Punkt sein",
    "must name two points or more, got {value}": (
        "muss zwei Punkte oder mehr nennen, nicht {value}"
    ),
    "is empty": "ist leer",
    "{point} is no point": "{point} ist kein Punkt",
    "{point} is fixed twice": "{point} ist zweimal festgelegt",
    "{tail} and {head} are at the same place": "{tail} und {head} sind am selben Ort",
    "the triangle {points} with sides {sides} does not close": (
        "das Dreieck {points} mit den Seiten {sides} schließt sich nicht"
    ),
    "no distance leads to {point}": "keine Entfernung führt zu {point}",
    "{pair} does not lead to another point of the link": (
        "{pair} führt zu keinem anderen Punkt des Glieds"
    ),
    "the distance of {point} from {other} is missing": (
        "die Entfernung von {point} nach {other} fehlt"
    ),
    "a cylinder has two points": "ein Zylinder hat zwei Punkte",
    "no link has both {one} and {other}": "kein Glied hat {one} und {other}",
    "is longer than {count} bytes": "ist länger als {count} Bytes",
    "is no text in UTF-8": "ist kein Text in UTF-8",
    "must be a table": "muss eine Tabelle sein",
    "must be a line, got {value}": "muss eine Gerade sein, nicht {value}",
    "must say how it moves": "muss sagen, wie es sich bewegt",
    "must be distances of its points, got {value}": (
        "muss Abstände seiner Punkte haben, nicht {value}"
    ),
    "there is no link": "es gibt kein Glied",
    "there is no fixed point": "es gibt keinen festen Punkt",
    "there are two numbers of this name": "zwei Zahlen haben diesen Namen",
    "has no {word}": "hat kein {word}",
    "has no line": "hat keine Gerade",
    "has one place only": "hat nur eine Lage",
    "needs a distance": "braucht einen Abstand",
    "cannot read {text}": "{text} ist nicht zu lesen",
    "is a fixed point already": "ist schon ein fester Punkt",
    "is pinned to the frame at {points}, so it cannot move": (
        "ist bei {points} am Gestell befestigt und kann sich nicht bewegen"
    ),
    "slides, but no link has this point": "gleitet, aber kein Glied hat diesen Punkt",
    "drives nothing else": "treibt nichts anderes an",
    "hangs on points that stand still": "hängt an Punkten, die stillstehen",
    "loads: are not kept in the file of a sheet": "Lasten stehen nicht in der Datei eines Blatts",
    "name them on the command line, as in --load": "nenne sie auf der Befehlszeile wie mit --load",
    "unknown {what} {name}": "{name} ist unbekannt",
    "{verb} no point with the rest": "kein Punkt ist mit den anderen gemeinsam",
    "with these lengths {point} cannot be reached at the driver's place: it misses by {miss}": (
        "mit diesen Längen ist {point} bei dieser Lage des Antriebs nicht zu erreichen: "
        "es fehlen {miss}"
    ),
    "dead centre: B, C and D lie on one great circle": (
        "Totlage: B, C und D liegen auf einem Großkreis"
    ),
    "dead centre: the coupler BC is square to the path of C": (
        "Totlage: die Koppel BC steht senkrecht auf der Bahn von C"
    ),
    "dead centre: the axes at B, C and D are parallel to one plane": (
        "Totlage: die Achsen in B, C und D sind zu einer Ebene parallel"
    ),
    "{angle} of arc": "{angle} im Bogen",
    "{text} is no number and no expression": "{text} ist weder Zahl noch Ausdruck",
    "write 60, '6 cm', or 'a/2' with a in [dimensions]": (
        "schreibe 60, '6 cm' oder 'a/2' mit a in [dimensions]"
    ),
    "{text} has no value": "{text} hat keinen Wert",
    "write {name} = 100 under [dimensions]": "schreibe {name} = 100 unter [dimensions]",
    "write the expression where it is used": "schreibe den Ausdruck dort, wo er gebraucht wird",
    "{text} must be positive, got {value}": "{text} muss positiv sein, nicht {value}",
    "{text} must be between {low} and {high}, got {value}": (
        "{text} muss zwischen {low} und {high} liegen, nicht {value}"
    ),
    "must be one number here, got an array": "muss hier eine einzige Zahl sein",
    "must be the name of a unit, got {value}": "muss der Name einer Einheit sein, nicht {value}",
    "must not be negative, got {value}": "darf nicht negativ sein, also nicht {value}",
    "must be a line of text, without {signs}": "muss eine Zeile Text sein, ohne {signs}",
    "has {count} letters, and may have {most}": "hat {count} Buchstaben und darf {most} haben",
    "has {sign}, as no name may have": "enthält {sign}, was in keinem Namen stehen darf",
    "write {name} ({signs})": "schreibe {name} ({signs})",
    "is a word of the program's own": "ist ein Wort des Programms",
    "call it {name}": "nenne es {name}",
    "[{table}] has more than {most} entries": "[{table}] hat mehr als {most} Einträge",
    "has more than {most} entries": "hat mehr als {most} Einträge",
    "must be a table, got {value}": "muss eine Tabelle sein, nicht {value}",
    "write [{table}]": "schreibe [{table}]",
    "write [{table}] and below it {example}": "schreibe [{table}] und darunter {example}",
    "{code} is no language": "{code} ist keine Sprache",
    "the two letters of a language, as in [names.de]": (
        "die zwei Buchstaben einer Sprache wie in [names.de]"
    ),
    "write a name, or leave it out": "schreibe einen Namen oder lass es weg",
    "must be two coordinates, got {value}": "muss zwei Koordinaten haben, nicht {value}",
    "write {point} = [0, 0]": "schreibe {point} = [0, 0]",
    "write {point} = [0, 0] or {example}": "schreibe {point} = [0, 0] oder {example}",
    "is no place": "ist kein Ort",
    "{value} is no place": "{value} ist kein Ort",
    "upper, lower, left, right, parallel, or coordinates near it": (
        "upper (oben), lower (unten), left (links), right (rechts), parallel, oder Koordinaten "
        "in der Nähe"
    ),
    "from {point}, which is no fixed point above it": (
        "von {point} aus, was kein fester Punkt darüber ist"
    ),
    "a capital letter, or a letter with a number: O2": (
        "ein Großbuchstabe oder ein Buchstabe mit einer Ziffer: O2"
    ),
    "the pose does not say where {point} is": "die Lage sagt nicht, wo {point} ist",
    "add {point} = [0, 0] to [pose], or write its distances": (
        "füge {point} = [0, 0] in [pose] hinzu oder schreibe seine Abstände"
    ),
    "is no line": "ist keine Gerade",
    "a line is {examples} or {last}": "eine Gerade ist {examples} oder {last}",
    "{point} is neither a fixed point nor one that slides": (
        "{point} ist weder ein fester noch ein gleitender Punkt"
    ),
    "along = 'DC' is the slot of a link that turns": (
        "along = 'DC' ist der Schlitz eines Glieds, das sich dreht"
    ),
    "must be two points of a link, got {value}": (
        "muss zwei Punkte eines Glieds nennen, nicht {value}"
    ),
    "{links} have both": "{links} haben beide Punkte",
    "{link} is a cylinder, which has no slot": "{link} ist ein Zylinder und hat keinen Schlitz",
    "{point} is a point of {link} itself": "{point} ist selbst ein Punkt von {link}",
    "only a link has a point under the block": "nur ein Glied hat einen Punkt unter dem Gleitstein",
    "must be one point, got {value}": "muss ein einziger Punkt sein, nicht {value}",
    "there is a point {point} already": "es gibt schon einen Punkt {point}",
    "give it a name": "gib ihm einen Namen",
    "{pair} is {other}, which is given already": "{pair} ist {other}, was schon gegeben ist",
    "two letters are a distance, three an angle": (
        "zwei Buchstaben sind ein Abstand, drei ein Winkel"
    ),
    "write 'clockwise' or 'counter-clockwise'": (
        "schreibe 'clockwise' (im Uhrzeigersinn) oder 'counter-clockwise'"
    ),
    "fix the others to its neighbours": "befestige die anderen an seinen Nachbarn",
    "only a cylinder has one": "nur ein Zylinder hat eine",
    "only a cylinder's one length varies": "nur die eine Länge eines Zylinders ändert sich",
    "{pair} is fixed already by the other distances": (
        "{pair} ist durch die anderen Abstände schon festgelegt"
    ),
    "give {pair}": "gib {pair} an",
    "add {pair} = 100": "füge {pair} = 100 hinzu",
    "the longest side must be less than {length}": (
        "die längste Seite muss kürzer als {length} sein"
    ),
    "join {link} to another link": "verbinde {link} mit einem anderen Glied",
    "has {points} in common with {link}, so both are one link": (
        "hat {points} mit {link} gemeinsam: beide sind ein einziges Glied"
    ),
    "{one} and {other} both have {points}: one link": (
        "{one} und {other} haben beide {points}: ein einziges Glied"
    ),
    "is held at one point, {point}, only": "hängt nur an einem Punkt, {point}",
    "a link that only repeats a parallelogram can be left out": (
        "ein Glied, das nur ein Parallelogramm wiederholt, kann wegbleiben"
    ),
    (
        "{links} can only be found together: a triad (Assur group of class III) or more, not "
        "a pair that two arcs or lines locate"
    ): (
        "{links} sind nur zusammen zu finden: ein Dreischlag (Assur-Gruppe III. Klasse) oder "
        "mehr, kein Zweischlag, den zwei Bögen oder Geraden festlegen"
    ),
    "driven at the {links} it is dyads alone": "angetrieben an {links} sind es lauter Zweischläge",
    "no other driver makes it dyads": "mit keinem anderen Antrieb werden es Zweischläge",
    "add the links that it moves, as in {example}": (
        "füge die Glieder hinzu, die es bewegt, wie in {example}"
    ),
    "one of its points must be on the {driver}, or on what the {driver} moves": (
        "einer seiner Punkte muss auf {driver} liegen oder auf etwas, das {driver} bewegt"
    ),
    "one link or slide drives, not {count}": "ein Glied oder Gleitstück treibt an, nicht {count}",
    "one link or slide drives, and none does": (
        "ein Glied oder Gleitstück treibt an, hier aber keines"
    ),
    "neither of its two places is {place}, at {places}": (
        "keiner seiner beiden Orte ist {place}: {places}"
    ),
    "nearer to {place}": "näher an {place}",
    "say {words}": "schreibe {words}",
    "begin with the driver elsewhere, where they lie apart": (
        "beginne mit einer anderen Lage des Antriebs, bei der sie auseinander liegen"
    ),
    "cannot be so while {point} is {place}": "kann nicht so liegen, solange {point} „{place}“ ist",
    "one of them is enough": "eines davon genügt",
    "with {point} at its other place it would close": (
        "mit {point} am anderen Ort würde es schließen"
    ),
    "two places have {points}": "zwei Orte haben {points}",
    "must be places by point, got {value}": "muss Orte von Punkten nennen, nicht {value}",
    "the links miss by {miss}": "den Gliedern fehlen {miss}",
    "{pair} and the side opposite it differ by {length}": (
        "{pair} und die Seite gegenüber unterscheiden sich um {length}"
    ),
    "a parallelogram has equal opposite sides": (
        "im Parallelogramm sind gegenüberliegende Seiten gleich"
    ),
    "a parallelogram has two known sides and two unknown ones": (
        "ein Parallelogramm hat zwei bekannte und zwei unbekannte Seiten"
    ),
    "{point} stands on the pivot {pivot}, where the {link} may point anywhere": (
        "{point} steht auf dem Lager {pivot}, wo {link} beliebig stehen kann"
    ),
    "loop {number}": "Masche {number}",
    "give the lines different directions": "gib den Geraden verschiedene Richtungen",
    "stands still, for {driver} does not move it": "steht still, denn {driver} bewegt sie nicht",
    "the angle of {link}": "der Winkel von {link}",
    "the length of {link}": "die Länge von {link}",
    "slides along two lines": "gleitet auf zwei Geraden",
    "point {point}": "Punkt {point}",
    "its distance": "sein Abstand",
    "its angle": "sein Winkel",
    "its distance must not be 0": "sein Abstand darf nicht 0 sein",
    "there is the first end of the link": "dort ist das erste Ende des Glieds",
    "the mechanism has a point {point} already": "das Getriebe hat schon einen Punkt {point}",
    "free are {points} …": "frei sind {points} …",
    "points are marked on links in the plane alone": (
        "nur auf ebenen Gliedern lassen sich Punkte bezeichnen"
    ),
    "is missing; a ram needs a rod and a ram_height": (
        "fehlt; ein Stößel braucht rod und ram_height"
    ),
    "must have a force, a couple or a table": (
        "muss eine Kraft (force), ein Moment (couple) oder eine Tabelle (table) haben"
    ),
    "must be places and loads, or a file beside this": (
        "muss Orte und Lasten enthalten oder eine Datei daneben nennen"
    ),
    "must be words and numbers, got {value}": "muss Wörter und Zahlen haben, nicht {value}",
    "must be one number or two, got {value}": "muss eine oder zwei Zahlen sein, nicht {value}",
    "mass of {body}": "Masse von {body}",
    "load {number}": "Last {number}",
    "{point} is no point of {link}": "{point} ist kein Punkt von {link}",
    "{point} is a point of {links}": "{point} ist ein Punkt von {links}",
    "{point} is on {links}": "{point} ist auf {links}",
    "say on which it acts: {examples}": "sage, auf welches sie wirkt: {examples}",
    "{body} does not turn: its guide takes the couple": (
        "{body} dreht sich nicht: die Führung nimmt das Moment auf"
    ),
    "{body} does not turn, so it has no moment of inertia": (
        "{body} dreht sich nicht und hat darum kein Trägheitsmoment"
    ),
    "a couple needs a body": "ein Moment braucht einen Körper",
    "a couple acts on {bodies}": "ein Moment wirkt auf {bodies}",
    "reaches from {low} to {high}, and the driver is at {place}": (
        "reicht von {low} bis {high}, und der Antrieb steht bei {place}"
    ),
    "a table needs two rows or more": "eine Tabelle braucht zwei Zeilen oder mehr",
    "has {count} columns, not two": "hat {count} Spalten statt zwei",
    "has more than {count} rows": "hat mehr als {count} Zeilen",
    "two columns: the driver's place, and the load there": (
        "zwei Spalten: die Lage des Antriebs und die Last dort"
    ),
    "{text} is no pair of numbers": "{text} ist kein Zahlenpaar",
    "its places must ascend, but {place} follows {other}": (
        "seine Lagen müssen steigen, aber {place} folgt auf {other}"
    ),
    "must be at most {most}, got {value}": "darf höchstens {most} sein, nicht {value}",
    "a window takes at most {most}, got {count}": (
        "ein Fenster nimmt höchstens {most}, nicht {count}"
    ),
    "a window takes at most {most} loads, got {count}": (
        "ein Fenster nimmt höchstens {most} Lasten, nicht {count}"
    ),
    (
        "the page has no room for {panels} panels with {rows} rows of results and captions "
        "of {lines} lines"
    ): (
        "die Seite hat keinen Platz für {panels} Bilder mit {rows} Zeilen Ergebnissen und "
        "{lines} Zeilen Text"
    ),
    "draw fewer panels": "zeichne weniger Bilder",
    "a drawing has room for {most} on links, got {count}": (
        "eine Zeichnung hat Platz für {most} auf Gliedern, nicht {count}"
    ),
    "the program is ending": "das Programm wird beendet",
    "the planes of the shafts and of the cross are one": (
        "Totlage: die Wellen und das Kreuz liegen in einer Ebene"
    ),
    "{owner} is called {name} already": "{owner} heißt schon {name}",
    "a rod": "eine Kolbenstange",
    "a slide": "ein Gleitstück",
    "a link": "ein Glied",
    "is held at no point": "hängt an keinem Punkt",
    "{count}, not 1": "{count} statt 1",
    "{links} links and {joints} joints give {sum} degrees of freedom": (
        "{links} Glieder und {joints} Gelenke ergeben {sum} Freiheitsgrade"
    ),
    "the {side} one": "„{side}“",
    "{line} under [assembly]": "{line} unter [assembly]",
    "the lines of {slides} are parallel": "die Geraden von {slides} sind parallel",
    "{lines}, so that all between them slides along without a limit": (
        "{lines}, sodass alles dazwischen ohne Ende gleitet"
    ),
    "{lines} and never cross": "{lines} und schneiden sich nie",
    "must be one number, got {value}": "muss eine einzige Zahl sein, nicht {value}",
    "a window turns a mechanism by hand, which a shaft or an engine is not": (
        "in einem Fenster wird ein Getriebe von Hand gedreht, Wellen und Motoren nicht"
    ),
    "vad draw {example} shows it": "vad draw {example} zeigt es",
    "vad example {name} makes a file to begin with": (
        "vad example {name} macht eine Datei für den Anfang"
    ),
    "on {bodies}": "auf {bodies}",
    "unknown {what} in {table} {name}": "{name} ist in {table} unbekannt",
    "unknown {what} of {owner} {name}": "{name} ist bei {owner} unbekannt",
    "unknown {what} with two places {name}": "{name} hat keine zwei Orte",
    "as in {example}, where {name} is its name": "wie in {example}, wobei {name} sein Name ist",
    "{point} is no point of a link": "{point} ist kein Punkt eines Glieds",
}

#: Womit die Lösungen eines Entwurfs beschrieben werden.
DESIGN = {
    "slider-crank": "Schubkurbel aus Hub und Zeitverhältnis",
    "quick-return": "Kurbelschleife mit schnellem Rücklauf aus Hub und Zeitverhältnis",
    "crank-rocker": "Kurbelschwinge aus Schwingwinkel und Zeitverhältnis",
    "three-positions": "Gelenkviereck durch drei Lagen seiner Koppel",
    "function": "Gelenkviereck für drei Winkelpaare von Kurbel und Schwinge",
    "solution": "Lösung",
    "mechanism": "Getriebe",
    "assembly": "Einbaulage",
    "origin": "A bei x, y",
    "position": "Lage",
    "dead centre": "Totlage",
    "sense": "Drehsinn der Kurbel",
    "forwards": "gegen den Uhrzeigersinn",
    "backwards": "im Uhrzeigersinn",
    "slow": "langsamer Hub",
    "slow out": "von der Kurbel weg",
    "slow in": "zur Kurbel hin",
    "slow right": "nach rechts",
    "slow left": "nach links",
    "slow with": "gleichsinnig mit der Kurbel",
    "slow against": "gegensinnig zur Kurbel",
    "driven": "angetrieben am",
    "driven first": "ersten Gelenk",
    "driven second": "zweiten Gelenk",
    "back": "zeigt rückwärts",
    "back crank": "die Kurbel",
    "back rocker": "die Schwinge",
    "back both": "Kurbel und Schwinge",
    "faults": "Mängel",
    "none": "keine",
    "fault assembly": "wechselt die Einbaulage",
    "fault range": "kommt nicht von einer Lage in die andere",
    "fault order": "andere Reihenfolge der Lagen",
    "grashof": "Grashof",
    "stroke": "Hub oder Schwingwinkel",
    "time ratio": "Zeitverhältnis",
    "least transmission": "kleinster Übertragungswinkel (bei)",
    "largest transmission": "größter Übertragungswinkel (bei)",
    "kind crank-rocker": "Kurbelschwinge",
    "kind double-crank": "Doppelkurbel",
    "kind double-rocker": "Doppelschwinge",
    "kind rocker-crank": "Kurbelschwinge, an der Schwinge angetrieben",
    "kind triple-rocker": "Totalschwinge",
    "kind change point": "durchschlagend",
}

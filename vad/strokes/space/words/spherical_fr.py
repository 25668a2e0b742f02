"""Ce que dit le professeur du quadrilatère sphérique et des polygones de corps, en français."""

PHRASES = {
    # position
    "spherical along": "suivant {axis}",
    "spherical outline": (
        "La sphère, vue perpendiculairement au plan du bâti : son contour est le grand cercle du "
        "bâti."
    ),
    "spherical axes": "Les axes OA et OD sont dans la feuille : leurs directions sont vraies.",
    "spherical O": "Tous les axes se coupent en O, le centre de la sphère.",
    "spherical shaft": "Un élément tourne autour de O{letter}.",
    "spherical bearing": "Son arbre est porté par le bâti.",
    "spherical fixed": "En {letter}, un axe fixe perce la sphère.",
    "spherical ground": "A et D sont les axes fixes, à {size}° l’un de l’autre.",
    "spherical circle": "B tourne autour de OA : son cercle est vu par la tranche.",
    "spherical rose": "Vu suivant {axis}, l’angle est en vraie grandeur.",
    "spherical reference A": "Il se mesure à partir de l’arc AD.",
    "spherical reference D": "Il se mesure à partir de l’arc AD, prolongé au-delà de D.",
    "spherical true A": "La manivelle est à {angle}°.",
    "spherical angle A": "Son angle se compte dans le sens direct, vu de l’extérieur.",
    "spherical true D": "Le balancier est à {symbol} = {angle}°.",
    "spherical angle D": "C’est {symbol}.",
    "spherical crank": "La manivelle AB = {size}° est à {angle}°.",
    "spherical B": "B est à son extrémité.",
    "spherical about B": "C est sur le cercle de centre B et de rayon BC = {size}°.",
    "spherical about D": (
        "C est sur le cercle de centre D et de rayon DC = {size}°, vu par la tranche."
    ),
    "spherical C": "C est à l’intersection des deux cercles.",
    "spherical coupler": "La bielle BC : elle est à {b}° en B et à {c}° en C.",
    "spherical rocker": "Le balancier DC.",
    "spherical great circle": "On suit le grand cercle de la bielle jusqu’au contour.",
    "spherical I": "Là, en I, il rencontre le grand cercle du bâti.",
    "spherical OI": (
        "Les plans de la bielle et du bâti se coupent suivant OI : c’est autour de cet axe que le "
        "balancier tourne par rapport à la manivelle."
    ),
    # polygones de corps
    "bodies remark": "1 2 4 dans le plan du bâti, 2 3 4 dans celui de la bielle, rabattu",
    "bodies pole velocity": "Le pôle : le bâti, 1, ne tourne pas.",
    "bodies pole acceleration": "Le pôle : le bâti, 1′, n’a pas d’accélération angulaire.",
    "bodies given": "{label} = {symbol} = {value} {unit}, suivant {axis}.",
    "bodies turned frame": (
        "{label} = {symbol}·τ̇ = {omega} × {tau} = {value} {unit}, ⟂ OI : {symbol} tourne avec OI "
        "dans le plan du bâti."
    ),
    "bodies turned coupler": (
        "{label} = {symbol}·τ̇₃ = {omega} × {tau} = {value} {unit}, "
        "⟂ OI : dans le plan de la bielle aussi, {symbol} tourne avec OI."
    ),
    "bodies line 24 velocity": (
        "Par {point}, parallèlement à OI : seul OI est à la fois dans le plan du bâti et dans "
        "celui de la bielle, donc le corps 4 tourne autour de OI par rapport au corps 2, et "
        "{meeting} est sur cette droite."
    ),
    "bodies line 24 acceleration": (
        "Par {point}, parallèlement à OI : on ne sait pas encore de combien la rotation croît "
        "suivant OI, donc {meeting} est sur cette droite."
    ),
    "bodies line 14": (
        "Par {point}, parallèlement à OD : le balancier ne tourne autour d’aucune autre droite, "
        "donc {meeting} est sur cette droite."
    ),
    "bodies fold": (
        "Le plan de la bielle est rabattu sur la feuille autour de OI : OB et OC y sont en vraie "
        "direction."
    ),
    "bodies line 23": (
        "Par {point}, parallèlement à OB rabattu, à {arc}° de OI : la bielle tourne autour de OB "
        "par rapport à la manivelle, donc {meeting} est sur cette droite."
    ),
    "bodies line 43": (
        "Par {point}, parallèlement à OC, à {arc}° de OI : la bielle tourne autour de OC par "
        "rapport au balancier, donc {meeting} est sur cette droite."
    ),
    "bodies sines": (
        "{label} = {symbol} = {value} {unit} : ω₄/ω₂ = sin AI / sin DI = sin {ai}° / sin {di}°."
    ),
}

NAMES = {"Spherical four-bar": "Quadrilatère sphérique"}

GENDERS: dict[str, str] = {}

"""Ce que l'enseignant dit du quadrilatère spatial, en français."""

PHRASES = {
    # position
    "spatial star": "suivant DA",
    "spatial rose": "suivant OA",
    "spatial a": "L’axe a de la manivelle est fixe.",
    "spatial d": "De même l’axe d du balancier.",
    "spatial AD": (
        "AD = {size} {unit} est leur normale commune ; d est tourné de {twist}° par rapport à a."
    ),
    "spatial shaft": "La manivelle tourne autour de a.",
    "spatial bearing": "Un palier la tient : elle ne glisse pas.",
    "spatial A": "A est le pied de la normale commune sur a.",
    "spatial D sleeve": (
        "Dans son fourreau du bâti, le balancier tourne autour de d et glisse suivant d."
    ),
    "spatial D": "D est le pied de la normale commune sur d.",
    "spatial crank": "La manivelle AB = {size} {unit} est à {angle}°.",
    "spatial circle": "Vu suivant a, B décrit un cercle.",
    "spatial reference": "L’angle se compte à partir de AD.",
    "spatial true": "Ici, la manivelle est vue dans sa vraie direction.",
    "spatial angle": "Son angle est {angle}°.",
    "spatial b": "Son axe en B est perpendiculaire à AB, et tourné de {twist}° par rapport à a.",
    "spatial B sleeve": "Dans son fourreau en B, la bielle tourne et glisse.",
    "spatial directions": (
        "Les directions sont celles du quadrilatère sphérique d’arcs {ground}°, {crank}°, "
        "{coupler}°, {rocker}° : les longueurs ne font rien tourner."
    ),
    "spatial true directions": "Vus suivant DA, OA et OD sont dans le plan du dessin.",
    "spatial I": (
        "Les plans du bâti et de la bielle s’y coupent suivant OI, τ = {tau}° de OA : autour de OI "
        "le balancier tourne par rapport à la manivelle."
    ),
    "spatial c": "De là, l’axe en C a sa direction.",
    "spatial slides B": (
        "Trois longueurs ferment la chaîne : s_B = {b}, s_C = {c}, s_D = {d} {unit}."
    ),
    "spatial slides C": "s_C = {c} {unit}, du balancier jusqu’au pied de BC.",
    "spatial slides D": "s_D = {d} {unit}, de D jusqu’au pied du balancier.",
    "spatial coupler": (
        "La bielle : de son arbre en B, le long de la normale commune BC = {size} {unit}."
    ),
    "spatial C sleeve": "En C, elle guide le balancier dans un fourreau.",
    "spatial rocker": (
        "Le balancier DC = {size} {unit} avec ses arbres en C et en D : θ₄ = {theta}°."
    ),
    "spatial C": "C est le pied de BC sur son axe.",
    "spatial screw": (
        "Autour de I, le balancier tourne par rapport à la manivelle, et il glisse suivant I."
    ),
    "spatial H": "I coupe AD en H, à angle droit : AH = {height} {unit}.",
    # les polygones du bas
    "spatial pole velocity": (
        "Dessous, A comme point du balancier ; au pôle, A et D du bâti, qui sont immobiles."
    ),
    "spatial pole acceleration": (
        "Dessous, A comme point du balancier ; au pôle, A et D du bâti, qui sont immobiles."
    ),
    "spatial about I velocity": (
        "{label} = ω₄₂·AH = {turn} × {lever} = {value} {unit}, ⟂ OI : comme point du balancier, A "
        "tourne par rapport à la manivelle autour de I."
    ),
    "spatial about I acceleration": (
        "{label} = α₄₂ₜ·AH + ω₄₂·ḣ + v₄₂·τ̇ = {sum} = {value} {unit}, ⟂ OI : A tourne plus vite "
        "autour de I, et I se déplace."
    ),
    "spatial about D": (
        "{label} = {symbol}·AD = {turn} × {lever} = {value} {unit}, ⟂ OD : avec le balancier, A "
        "tourne autour de D."
    ),
    "spatial along I velocity": (
        "Par {point}, parallèlement à OI : on ne sait pas encore à quelle vitesse A glisse suivant "
        "I, donc {meeting} est sur cette droite."
    ),
    "spatial along I acceleration": (
        "Par {point}, parallèlement à OI : la part suivant I n’est pas encore connue, donc "
        "{meeting} est sur cette droite."
    ),
    "spatial along D velocity": (
        "Par {point}, parallèlement à OD : on ne sait pas encore à quelle vitesse A glisse suivant "
        "d, donc {meeting} est sur cette droite."
    ),
    "spatial along D acceleration": (
        "Par {point}, parallèlement à OD : la part suivant d n’est pas encore connue, donc "
        "{meeting} est sur cette droite."
    ),
}

NAMES = {"Spatial four-bar": "Quadrilatère spatial", "axis": "axe"}

GENDERS = {"axis": "m"}

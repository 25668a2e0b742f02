"""The words of the window: one table a language, of which another takes English for what it lacks."""

from __future__ import annotations

from collections.abc import Mapping

_ENGLISH = {
    "language": "Language",
    "mechanism": "Mechanism",
    "dimensions": "Dimensions",
    "assembly": "Assembly",
    "motion": "Input motion",
    "angle": "angle θ",
    "omega": "ω",
    "alpha": "α",
    "position": "position",
    "velocity": "v",
    "acceleration": "a",
    "open": "open",
    "crossed": "crossed",
    "parallel": "parallel",
    "draw": "Draw it",
    "reset": "Reset",
    "lock": "Keep the scales",
    "link": "Copy link",
    "linked": "The link is copied.",
    "save": "Save as",
    "saving": "Saving …",
    "saved": "Saved: {name}",
    "retry": "Try again",
    "try": "try {values}",
    "stopped": "vad gui has stopped. Start it again in the terminal.",
    "handle": "Turn by hand: {name}",
    "controls": "What is set",
    "slider": "{name}, slider",
}
_GERMAN = {
    "language": "Sprache",
    "mechanism": "Mechanismus",
    "dimensions": "Abmessungen",
    "assembly": "Einbaulage",
    "motion": "Antrieb",
    "angle": "Winkel θ",
    "position": "Lage",
    "open": "offen",
    "crossed": "gekreuzt",
    "parallel": "parallel",
    "draw": "Zeichnen",
    "reset": "Zurücksetzen",
    "lock": "Maßstäbe behalten",
    "link": "Link kopieren",
    "linked": "Der Link ist kopiert.",
    "save": "Speichern als",
    "saving": "Wird gespeichert …",
    "saved": "Gespeichert: {name}",
    "retry": "Noch einmal",
    "try": "nimm {values}",
    "stopped": "vad gui ist beendet. Starte es im Terminal neu.",
    "handle": "Von Hand bewegen: {name}",
    "controls": "Was eingestellt ist",
    "slider": "{name}, Schieber",
}
_FRENCH = {
    "language": "Langue",
    "mechanism": "Mécanisme",
    "dimensions": "Dimensions",
    "assembly": "Montage",
    "motion": "Mouvement d’entrée",
    "angle": "angle θ",
    "position": "position",
    "open": "ouvert",
    "crossed": "croisé",
    "parallel": "parallèle",
    "draw": "Tracer",
    "reset": "Réinitialiser",
    "lock": "Garder les échelles",
    "link": "Copier le lien",
    "linked": "Le lien est copié.",
    "save": "Enregistrer en",
    "saving": "Enregistrement …",
    "saved": "Enregistré : {name}",
    "retry": "Réessayer",
    "try": "essayer {values}",
    "stopped": "vad gui est arrêté. Relancez-le dans le terminal.",
    "handle": "Déplacer à la main : {name}",
    "controls": "Ce qui est réglé",
    "slider": "{name}, curseur",
}
_TABLES: Mapping[str, Mapping[str, str]] = {"en": {}, "de": _GERMAN, "fr": _FRENCH}


def words(language: str) -> dict[str, str]:
    """Return the words of the window in a language."""
    return {**_ENGLISH, **_TABLES.get(language, {})}

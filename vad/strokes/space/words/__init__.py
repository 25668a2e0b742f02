"""What the teacher says of a mechanism in space: one file for each mechanism and language.

Each adds its ``PHRASES``, ``NAMES`` and ``GENDERS`` to those of `vad.strokes.language`.
"""

"""What the teacher draws: strokes, polygons and captions; no colour, no time, no pixels."""

"""When each stroke is drawn: timing, easing and the state at a moment."""

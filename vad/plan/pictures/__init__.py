"""The pictures in the panels: the mechanism, and vectors laid tip to tail."""

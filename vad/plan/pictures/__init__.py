"""The pictures in the panels: the skeleton of the mechanism, and vectors laid tip to tail."""

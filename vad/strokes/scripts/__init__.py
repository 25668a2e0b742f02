"""What is drawn of mechanisms in space: one script for each, named by its mechanism."""

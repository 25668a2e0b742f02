"""How a plan becomes pixels and files: painters, and the frames of films."""

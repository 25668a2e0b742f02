"""The drawings of shafts and engines: views of the machine, and polygons of forces and couples."""

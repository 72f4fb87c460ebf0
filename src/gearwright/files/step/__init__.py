"""STEP files in, through Open CASCADE: smooth solids, placed, as polyhedra and with properties of the smooth shape."""

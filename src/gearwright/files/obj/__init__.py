"""OBJ files: text in."""

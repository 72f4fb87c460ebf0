"""STL files: binary and text in, binary out."""

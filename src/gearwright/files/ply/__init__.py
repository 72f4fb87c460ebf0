"""PLY files, version 1.0: text, binary little-endian and binary big-endian."""

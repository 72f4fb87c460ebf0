"""Bodies as objects of other libraries, in memory. Knows arrays, not solids; a library loads when asked for."""

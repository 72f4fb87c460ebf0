"""Bodies looked at in a notebook or browser: a page that turns them, or a still picture. Knows arrays, not solids."""

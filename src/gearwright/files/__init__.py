"""Files: arrays and boundaries out, arrays in."""

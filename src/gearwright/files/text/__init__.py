"""What readers of text share: numbers and rows in compiled loops, and refusals that name the line."""

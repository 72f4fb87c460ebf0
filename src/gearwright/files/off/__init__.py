"""OFF files: text and binary in."""

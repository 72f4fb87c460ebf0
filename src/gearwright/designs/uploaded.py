"""Values that stand for files which a page has given its server: "upload:ID/name"."""

UPLOADED = "upload:"
"""How they begin."""

"""Bodies of gears inside their teeth: bore, keyway, hub, web with holes."""

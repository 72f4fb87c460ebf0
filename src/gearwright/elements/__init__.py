"""Elements: frozen parameters that yield sections, motions and solids; one file a kind."""

"""Curves: lines, arcs, involutes and their spherical counterparts, each analytic in its own parameter."""

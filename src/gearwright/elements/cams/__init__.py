"""Plane disk cams: motion laws and programmes, followers, profiles, and the synthesis of least area."""

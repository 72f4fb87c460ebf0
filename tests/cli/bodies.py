"""Files of several bodies: what a reader would find in them, without a format that holds them."""

import numpy as np

from gearwright.files import reading
from gearwright.files.contents import Body, Contents
from gearwright.moments.faces import corner_lists

CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def box(name, size, at=(0, 0, 0), faces=FACES):
    """A box with its lowest corner somewhere."""
    indices, offsets = corner_lists(faces)
    return Body(name=name, vertices=CORNERS * size + np.array(at, float), indices=indices, offsets=offsets)


def put(monkeypatch, **files):
    """Lets names without a suffix be read as these bodies; (unit, bodies) for files that state a unit."""
    own = reading.read

    def read(path):
        if str(path) not in files:
            return own(path)
        found = files[str(path)]
        unit, bodies = found if isinstance(found, tuple) else (None, found)
        return Contents(bodies=tuple(bodies), length_unit=unit)

    monkeypatch.setattr(reading, "read", read)

"""Pages for the tests of the viewer, into a folder: python pages.py FOLDER."""

import sys
from pathlib import Path

import gearwright as gw

FOLDER = Path(sys.argv[1])

PAIR = gw.GearPair(teeth=(20, 30), module=2, face_width=10)
VIEWS = {
    "pair": PAIR.show(),
    "rack": gw.GearPair(teeth=(24, 6), module=2, face_width=10, kind="rack").show(),
    "rod": gw.extrude(gw.Section.circle(10), 20).show(title="rod"),
    "tube": gw.revolve(gw.Section.rectangle(4, 20, centre=(8, 10))).show(title="tube"),
    "far": gw.extrude(gw.Section.circle(10, centre=(1e6, 1e6)), 20).show(title="far rod"),
}

if __name__ == "__main__":
    for name, view in VIEWS.items():
        view.save(FOLDER / f"{name}.html")
    notebook = f"<!doctype html><title>a notebook</title>{PAIR.show()._repr_html_()}"
    (FOLDER / "notebook.html").write_text(notebook, encoding="utf-8")

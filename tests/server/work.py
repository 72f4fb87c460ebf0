"""Jobs for workers: generators that the server's functions are stood in for by."""

import errno
import json
import os
import re
import signal
import time
import warnings
from pathlib import Path

import numpy as np

from gearwright.errors import FileError, MachineError, ParameterError, Problem


def count(request):
    """So many answers, one after another."""
    for k in range(request["to"]):
        time.sleep(request.get("pause", 0.0))
        yield {"k": k, "pid": os.getpid()}


def multiply(request):
    """How many threads the process has after a product that linear algebra would rather share out."""
    np.ones((800, 800)) @ np.ones((800, 800))
    yield {"threads": len(list(Path("/proc/self/task").iterdir()))}


def sleep(request):
    """Comes to no second answer for a minute."""
    yield {"pid": os.getpid()}
    time.sleep(60)
    yield {}


def hold(request):
    """Lets no other thread run for hours, as some compiled code does."""
    yield {"pid": os.getpid()}
    re.match(r"(a+)+$", "a" * 60 + "b")
    yield {}


def die(request):
    """Is ended by the system after its first answer."""
    yield {"pid": os.getpid()}
    os.kill(os.getpid(), request.get("signal", signal.SIGKILL))
    yield {}


def hog(request):
    """Takes more memory than there may be."""
    yield {"taken": len(bytearray(request["bytes"]))}


def refuse(request):
    yield {}
    raise ParameterError("Gear", [Problem("gear face_width = 3 mm", "too thin"), Problem("turn", "of nothing")])


def refuse_file(request):
    raise FileError("section.dxf: broken")
    yield {}


def warn(request):
    warnings.warn("of a division", RuntimeWarning, stacklevel=1)
    yield {"warned": True}


def fault(request):
    raise KeyError("lost")
    yield {}


def frame(header, buffer):
    text = json.dumps(header).encode()
    text += b" " * (-(4 + len(text)) % 8)
    return len(text).to_bytes(4, "little") + text + buffer


def live(request):
    """Answers as a design's name says."""
    design = request["design"]
    match design.get("do"):
        case "slow":
            for k in range(100):
                time.sleep(0.05)
                yield {"answer": "values", "k": k}
        case "large":
            yield frame({"answer": "mesh", "id": request["id"]}, bytes(design["bytes"]))
        case "sleep" | "die" | "refuse" | "fault" as word:
            yield from globals()[word](request)
        case "note the time":
            if request.get("part") != "rest":
                yield frame({"answer": "mesh", "id": request["id"], "at": time.monotonic()}, b"")
            if request.get("part") != "shape":
                yield {"answer": "values", "at": time.monotonic()}
        case _:
            yield frame({"answer": "mesh", "id": request["id"], "title": design.get("title")}, b"\1\2\3\4")
            yield {"answer": "values", "have": request.get("have")}


def plot(request):
    """No chart, in the form of one."""
    axis = {"label": "x", "unit": "mm"}
    line = {"name": "a", "x": [0, 1], "y": [0, None], "style": "solid"}
    yield {"title": "t", "x": axis, "y": axis, "equal": False, "lines": [line], "log": "none", "notes": []}


def texts(request):
    yield dict.fromkeys(("toml", "python", "command"), request["design"].get("element", ""))


def full_disk(request):
    """Fails as a writer does on a full disk, in the words or the error that a design names."""
    path = f"{request['folder']}/files/spur.stl"
    match request["design"]["element"]:
        case "told":
            raise MachineError(f"{path}: cannot be written (No space left on device)")
        case "folder":
            raise MachineError(f"{request['folder']}/files: cannot be written to (No space left on device)")
        case "system":
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), path)
        case _:
            raise ValueError(f"{path} has no end")
    yield {}


def write(request):
    """A file of so many bytes as the design says."""
    path = Path(request["folder"]) / "a.stl"
    path.write_bytes(bytes(request["design"]["bytes"]))
    yield {"file": str(path), "name": path.name}

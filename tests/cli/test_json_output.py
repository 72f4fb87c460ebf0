import json

import numpy as np

from gearwright.cli.json_output import json_line


def test_what_is_not_finite_is_null_and_arrays_are_lists():
    document = {"a": np.array([1.0, np.nan]), "b": float("inf"), "c": (np.float64(0.1), np.int64(3)), "δ": "δ"}
    assert json.loads(json_line(document)) == {"a": [1.0, None], "b": None, "c": [0.1, 3], "δ": "δ"}


def test_numbers_survive():
    values = [0.1 + 0.2, 1e-300, 113.00419879299999]
    assert json.loads(json_line({"values": values}))["values"] == values

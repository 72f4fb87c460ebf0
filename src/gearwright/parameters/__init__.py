"""Parameters of elements: declared once, checked here; options, schema and forms are derived from them.

An element is a frozen keyword-only dataclass whose fields are made by `declared`. Nothing here
imports numpy, so that an edge can list every option without loading a kernel.
"""

from .declaration import Declaration, declarations, declared, entry, member_value
from .forms import FileName, Numbers, Points, Several, Table, Text
from .parameter import Form, Parameter, did_you_mean
from .problems import Problems, from_mapping
from .spelling import call, spelled
from .units import LEAST, LENGTH_UNITS, MILLIMETRES, MOST, Size, Unit, in_words, rounded_down, rounded_up, unit_text

__all__ = [
    "LEAST",
    "LENGTH_UNITS",
    "MILLIMETRES",
    "MOST",
    "Declaration",
    "FileName",
    "Form",
    "Numbers",
    "Parameter",
    "Points",
    "Problems",
    "Several",
    "Size",
    "Table",
    "Text",
    "Unit",
    "call",
    "declarations",
    "declared",
    "did_you_mean",
    "entry",
    "from_mapping",
    "in_words",
    "member_value",
    "rounded_down",
    "rounded_up",
    "spelled",
    "unit_text",
]

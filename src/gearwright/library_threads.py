"""Threads of the linear algebra under numpy: one, to be said before numpy is loaded.

Products of matrices here are small. Handing them to threads takes longer than they do, many times longer where every
processor has work, as beside other processes of ours; and sums then depend on how many processors there are.
"""

import os

_NAMES = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


def one_thread() -> None:
    """For this process, if it has not loaded numpy, and those that it begins; what is set already stays."""
    for name in _NAMES:
        os.environ.setdefault(name, "1")

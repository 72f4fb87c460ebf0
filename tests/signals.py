"""What processes do with signals from the moment they begin."""

import signal
from contextlib import contextmanager


@contextmanager
def begun_with(number, what):
    """Has processes that are begun in the block do that at a signal.

    They take it over from those that begin them: under nohup a closed terminal is ignored, in the background of a
    script Ctrl-C is.
    """
    before = signal.signal(number, what)
    try:
        yield
    finally:
        signal.signal(number, before)

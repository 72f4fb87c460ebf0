"""Limits of how often: token buckets, by name."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Callable
from typing import final

_MOST_NAMES = 4096


@final
class Bucket:
    """So many at once, and so many a second after that."""

    def __init__(self, rate: float, burst: float, clock: Callable[[], float] = time.monotonic):
        self._rate, self._burst, self._clock = rate, burst, clock
        self._left, self._at = burst, clock()

    def take(self) -> bool:
        """Takes one; False where none is left."""
        now = self._clock()
        self._left = min(self._burst, self._left + (now - self._at) * self._rate)
        self._at = now
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True


@final
class Buckets:
    """A bucket for each name; those not used for longest are forgotten."""

    def __init__(self, rate: float, burst: float, clock: Callable[[], float] = time.monotonic):
        self._of = (rate, burst, clock)
        self._buckets: OrderedDict[str, Bucket] = OrderedDict()

    def take(self, name: str) -> bool:
        """Takes one of a name's; False where none is left."""
        bucket = self._buckets.pop(name, None) or Bucket(*self._of)
        self._buckets[name] = bucket
        while len(self._buckets) > _MOST_NAMES:
            self._buckets.popitem(last=False)
        return bucket.take()

"""Finds the range of times with most of a file's records."""

from __future__ import annotations

import math
from dataclasses import dataclass

_MAX_BUCKETS = 64

WIDTH = 68719476736.0
"""The width of a bucket: 2^36 µs, 19 hours."""

NEVER = 9007199254740992.0
"""2^53 µs, 285 years: beyond that, µs are not exact, and no robot runs for so long."""


@dataclass(frozen=True)
class Cluster:
    """Times that belong together, in µs."""

    start: float
    until: float
    records: int
    """The number of records at these times."""


class TimeHistogram:
    """Counts records in buckets of 19 hours.

    Records a whole bucket away from the others do not belong to the same run of a robot.
    """

    def __init__(self) -> None:
        self._counts: dict[float, int] = {}
        self._first: dict[float, float] = {}

    def add(self, micros: float) -> bool:
        """Counts a record at `micros`, from 0 on. Returns False if it must be dropped: its time is impossible, or too many times are far apart."""
        if micros >= NEVER:
            return False
        return self.add_many(math.floor(micros / WIDTH) * WIDTH, micros, 1)

    def add_many(self, bucket: float, first: float, count: int) -> bool:
        """Counts `count` records in one bucket, the first of them at `first`."""
        counts = self._counts
        if bucket not in counts:
            if len(counts) == _MAX_BUCKETS:
                return False
            counts[bucket] = 0
            self._first[bucket] = first
        counts[bucket] += count
        if first < self._first[bucket]:
            self._first[bucket] = first
        return True

    def largest_cluster(self) -> Cluster | None:
        """The times of most records; None if there are none."""
        best: Cluster | None = None
        start = 0.0
        records = 0
        order = sorted(self._counts)
        for i, bucket in enumerate(order):
            if records == 0:
                start = self._first[bucket]
            records += self._counts[bucket]
            if i + 1 < len(order) and order[i + 1] <= bucket + WIDTH:
                continue
            if best is None or records > best.records:
                best = Cluster(start, bucket + WIDTH, records)
            records = 0
        return best

    @property
    def total(self) -> int:
        """The number of counted records."""
        return sum(self._counts.values())

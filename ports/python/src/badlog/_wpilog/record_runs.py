"""Reads records that all fit, many at a time: nearly all records of a log."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from badlog._wpilog.entry import Entry
from badlog._wpilog.record_head import MAX_PAYLOAD_BYTES
from badlog._wpilog.record_search import NEAR_MICROS
from badlog._wpilog.record_table import RecordTable
from badlog._wpilog.time_histogram import NEVER, WIDTH, TimeHistogram

MAX_HEAD = 17
"""The size of the longest head of a record."""

HEADS = [4 + (bits & 3) + (bits >> 2 & 3) + (bits >> 4 & 7) for bits in range(256)]
"""For the first byte of a record, the size of its head."""


@dataclass(frozen=True)
class Run:
    """The result of reading a run of records."""

    end: int
    """The end of the last record, at which a fitting one begins."""
    micros: float
    """The time of the last record."""
    count: int
    """The number of records."""


class RecordRuns(Protocol):
    """Reads runs of fitting records into a table."""

    def start(self, id: int, entry: Entry | None) -> None:
        """Called when `id` begins to stand for `entry`, or for nothing."""

    def read(self, at: int, most: int, most_bytes: int) -> Run:
        """Reads records by the rules of `RecordSink.records`. Stops before one that is odd in any way, or is followed by an odd one."""


class PlainRuns:
    """Reads runs of records one after another."""

    def __init__(self, data: bytes, by_id: dict[int, Entry], table: RecordTable, histogram: TimeHistogram) -> None:
        self._data = data
        self._by_id = by_id
        self._table = table
        self._histogram = histogram

    def start(self, id: int, entry: Entry | None) -> None:
        """Does nothing: `by_id` is enough."""

    def read(self, at: int, most: int, most_bytes: int) -> Run:
        # A function for each record would take twice the time.
        data = self._data
        by_id = self._by_id
        heads = HEADS
        from_bytes = int.from_bytes
        add_number, add_micros, add_start, add_size = self._table.adders
        histogram = self._histogram
        limit = len(data) - MAX_HEAD
        entry: Entry | None = None
        first = last = micros = bucket = end_of_bucket = 0.0
        start = size = count = 0
        place = at
        while place <= limit:
            bits = data[place]
            size_at = place + 2 + (bits & 3)
            following = by_id.get(data[place + 1] if bits & 3 == 0 else from_bytes(data[place + 1 : size_at], "little"))
            # Control records have no entry.
            if following is None or bits & 0x80:
                break
            if bits & 0x0C:
                time_at = size_at + 1 + (bits >> 2 & 3)
                next_size = from_bytes(data[size_at:time_at], "little")
                if next_size > MAX_PAYLOAD_BYTES:
                    break
            else:
                time_at = size_at + 1
                next_size = data[size_at]
            next_start = place + heads[bits]
            next_micros = float(from_bytes(data[time_at:next_start], "little"))
            width = following.width
            if width and (next_size % width if following.is_array else next_size != width):
                break
            if entry is not None:
                if abs(next_micros - micros) > NEAR_MICROS:
                    break
                add_number(entry.number)
                add_micros(micros)
                add_start(start)
                add_size(size)
                count += 1
                at = place
                last = micros
                if micros < first:
                    first = micros
            else:
                bucket = next_micros // WIDTH * WIDTH
                end_of_bucket = bucket + WIDTH
                first = next_micros
                # Times below 0 have the highest bit of 8 bytes.
                if next_micros >= NEVER or not histogram.add_many(bucket, next_micros, 0):
                    break
            if count >= most or next_size > most_bytes or not bucket <= next_micros < end_of_bucket:
                break
            entry, micros, start, size = following, next_micros, next_start, next_size
            place = next_start + next_size
        if count > 0:
            histogram.add_many(bucket, first, count)
        return Run(at, last, count)

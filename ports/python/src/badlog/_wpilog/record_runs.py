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
    """What was read."""

    end: int
    """The end of the last record, where one that fits begins."""
    micros: float
    """The time of the last record."""
    count: int
    """The number of records."""


class RecordRuns(Protocol):
    """Reads runs of fitting records into a table."""

    def start(self, id: int, entry: Entry | None) -> None:
        """Called when `id` begins to mean `entry`, or nothing."""

    def read(self, at: int, most: int, most_bytes: int) -> Run:
        """Reads records as `RecordSink.records` says: none that is odd in any way, or followed by one that is."""


class PlainRuns:
    """Reads runs of records one after another."""

    def __init__(self, data: bytes, by_id: dict[int, Entry], table: RecordTable, histogram: TimeHistogram) -> None:
        self._data = data
        self._by_id = by_id
        self._table = table
        self._histogram = histogram

    def start(self, id: int, entry: Entry | None) -> None:
        """Does nothing: `by_id` says it."""

    def read(self, at: int, most: int, most_bytes: int) -> Run:
        one = self._head_at(at)
        if one is None:
            return Run(at, 0.0, 0)
        entry, micros, start, size = one
        bucket = micros // WIDTH * WIDTH
        if not self._histogram.add_many(bucket, micros, 0):
            return Run(at, 0.0, 0)
        add = self._table.add
        end_of_bucket = bucket + WIDTH
        first = micros
        last = 0.0
        count = 0
        while count < most and size <= most_bytes:
            end = start + size
            following = self._head_at(end)
            if following is None:
                break
            next_entry, next_micros, next_start, next_size = following
            width = next_entry.width
            if width and (next_size % width if next_entry.is_array else next_size != width):
                break
            if abs(next_micros - micros) > NEAR_MICROS or not bucket <= micros < end_of_bucket:
                break
            add(entry.number, micros, start, size)
            count += 1
            at = end
            last = micros
            if micros < first:
                first = micros
            entry, micros, start, size = next_entry, next_micros, next_start, next_size
        if count > 0:
            self._histogram.add_many(bucket, first, count)
        return Run(at, last, count)

    def _head_at(self, at: int) -> tuple[Entry, float, int, int] | None:
        """Entry, time, and place and size of the payload of the record at `at`; None if anything about it needs a closer look."""
        data = self._data
        if at > len(data) - MAX_HEAD:
            return None
        bits = data[at]
        if bits & 0x80:
            return None
        id_end = at + 2 + (bits & 3)
        entry = self._by_id.get(data[at + 1] if bits & 3 == 0 else int.from_bytes(data[at + 1 : id_end], "little"))
        if entry is None:
            return None
        size_end = id_end + 1 + (bits >> 2 & 3)
        size = data[id_end] if size_end == id_end + 1 else int.from_bytes(data[id_end:size_end], "little")
        start = at + HEADS[bits]
        micros = int.from_bytes(data[size_end:start], "little")
        # Times below 0 have the highest bit of 8 bytes.
        if micros >= NEVER or size > MAX_PAYLOAD_BYTES or start + size > len(data):
            return None
        return entry, float(micros), start, size

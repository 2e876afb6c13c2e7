"""Reads records that all fit, with NumPy: Python finds where they begin, and NumPy checks thousands of heads together."""

from __future__ import annotations

from typing import Any

import numpy

from badlog._wpilog.entry import Entry
from badlog._wpilog.record_head import MAX_PAYLOAD_BYTES
from badlog._wpilog.record_runs import HEADS, MAX_HEAD, Run
from badlog._wpilog.record_search import NEAR_MICROS
from badlog._wpilog.record_table import RecordTable
from badlog._wpilog.time_histogram import NEVER, WIDTH, TimeHistogram

# The number of records that are checked together grows while they fit.
_MIN_RUN = 64
_MAX_RUN = 1 << 16
# Entries with larger ids are checked one by one.
_MAX_ID = 1 << 16

_BITS = numpy.arange(256)
_ID_SIZES = 1 + (_BITS & 3)
_SIZE_SIZES = 1 + (_BITS >> 2 & 3)
_TIME_SIZES = 1 + (_BITS >> 4 & 7)
_HEAD_SIZES = numpy.array(HEADS)
_MASKS = numpy.array([(1 << 8 * size) - 1 for size in range(5)], dtype=numpy.uint32)
_LONG_MASKS = numpy.array([(1 << 8 * size) - 1 for size in range(9)], dtype=numpy.uint64)


class NumpyRuns:
    """Reads runs of records, thousands at a time."""

    def __init__(self, data: bytes, table: RecordTable, histogram: TimeHistogram) -> None:
        self._data = data
        self._table = table
        self._histogram = histogram
        self._most = _MIN_RUN
        # For each id, the number of its entry, or -1; the last element stands for all larger ids. Then the width of its values, and whether
        # it has any number of them.
        self._numbers = numpy.full(_MAX_ID + 1, -1, numpy.int32)
        self._widths = numpy.ones(_MAX_ID + 1, numpy.uint32)
        self._are_arrays = numpy.zeros(_MAX_ID + 1, bool)
        self._bytes = numpy.frombuffer(data, numpy.uint8)
        self._words = self._view("<u4")
        self._long_words = self._view("<u8")

    def _view(self, code: str) -> Any:
        width = numpy.dtype(code).itemsize
        return numpy.ndarray((max(0, len(self._data) - width + 1),), code, self._data, strides=(1,))

    def start(self, id: int, entry: Entry | None) -> None:
        if id >= _MAX_ID:
            return
        self._numbers[id] = -1 if entry is None else entry.number
        if entry is not None:
            # Any size is a multiple of 1.
            self._widths[id] = entry.width or 1
            self._are_arrays[id] = entry.is_array or entry.width == 0

    def read(self, at: int, most: int, most_bytes: int) -> Run:
        count = 0
        micros = 0.0
        while count < most:
            wanted = min(self._most, most - count) + 1
            run = self._read_some(at, wanted, most_bytes)
            count += run.count
            if run.count > 0:
                at, micros = run.end, run.micros
            if run.count < wanted - 1:
                self._most = max(_MIN_RUN, min(self._most, run.count * 2))
                break
            self._most = min(_MAX_RUN, self._most * 8)
        return Run(at, micros, count)

    def _read_some(self, at: int, most: int, most_bytes: int) -> Run:
        places = _chain(self._data, at, most)
        if len(places) < 2:
            return Run(at, 0.0, 0)
        begin = numpy.array(places)
        bits = self._bytes[begin]
        size_at = begin + 1 + _ID_SIZES[bits]
        ids = self._words[begin + 1] & _MASKS[_ID_SIZES[bits]]
        sizes = self._words[size_at] & _MASKS[_SIZE_SIZES[bits]]
        times = self._long_words[size_at + _SIZE_SIZES[bits]] & _LONG_MASKS[_TIME_SIZES[bits]]
        micros = times.astype(numpy.float64)
        numbers, fits = self._known(ids, sizes)
        # Times below 0 have the highest bit of 8 bytes.
        bucket = float(micros[0]) // WIDTH * WIDTH
        is_in_bucket = (micros >= bucket) & (micros < bucket + WIDTH) & (micros < NEVER)
        fits[1:] &= numpy.abs(micros[1:] - micros[:-1]) <= NEAR_MICROS
        # Each is read if the one after it fits.
        is_read = is_in_bucket[:-1] & (sizes[:-1] <= most_bytes) & fits[1:] & (numbers[:-1] >= 0)
        count = len(is_read) if bool(is_read.all()) else int(numpy.argmin(is_read))
        if count == 0 or not self._histogram.add_many(bucket, float(micros[:count].min()), count):
            return Run(at, 0.0, 0)
        starts = begin + _HEAD_SIZES[bits]
        self._table.add_all(numbers[:count], micros[:count], starts[:count], sizes[:count].astype(numpy.int64))
        return Run(places[count], float(micros[count - 1]), count)

    def _known(self, ids: Any, sizes: Any) -> tuple[Any, Any]:
        """The numbers of the entries with these ids, -1 for others, and whether their payloads may have these sizes."""
        known = numpy.minimum(ids, _MAX_ID)
        numbers = self._numbers[known]
        widths = self._widths[known]
        fits = sizes == widths
        others = numpy.flatnonzero(self._are_arrays[known])
        fits[others] = sizes[others] % widths[others] == 0
        return numbers, fits & (numbers >= 0)


def _chain(data: bytes, at: int, most: int) -> list[int]:
    """The starts of up to `most` records from `at` on. They end at a control record, bytes that are not a record, or the last record."""
    limit = len(data) - MAX_HEAD
    places: list[int] = []
    add = places.append
    heads = HEADS
    for _ in range(most):
        if at > limit:
            break
        bits = data[at]
        # Most ids have one or two bytes, and most sizes have one.
        shape = bits & 0x8F
        if shape == 0:
            if data[at + 1] == 0:
                break
            add(at)
            at += data[at + 2] + heads[bits]
        elif shape == 1:
            add(at)
            at += data[at + 3] + heads[bits]
        elif bits & 0x80:
            break
        else:
            size_at = at + 2 + (bits & 3)
            size = int.from_bytes(data[size_at : size_at + 1 + (bits >> 2 & 3)], "little")
            if size > MAX_PAYLOAD_BYTES:
                break
            add(at)
            at += size + heads[bits]
    return places

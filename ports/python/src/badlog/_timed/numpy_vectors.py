"""Reads many numbers from bytes at a time, with NumPy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy

from badlog._timed.vectors import Numbers, Places


class NumpyVectors:
    """The operations, by NumPy."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._views: dict[str, Any] = {}

    def _view(self, code: str) -> Any:
        """The number that would be read at each byte of the file."""
        view = self._views.get(code)
        if view is None:
            width = numpy.dtype(code).itemsize
            view = numpy.ndarray((max(0, len(self._data) - width + 1),), code, self._data, strides=(1,))
            self._views[code] = view
        return view

    def floats(self, code: str, places: Places) -> Numbers:
        return self._view(code)[places].astype(numpy.float64)

    def integers(self, places: Places, width: int) -> Any:
        if width in (1, 2, 4, 8):
            return self._view(f"<u{width}")[places].astype(numpy.uint64)
        numbers = numpy.zeros(len(places), numpy.uint64)
        for i in range(width):
            numbers |= self._view("u1")[places + i].astype(numpy.uint64) << numpy.uint64(8 * i)
        return numbers

    def signed(self, integers: Any, bits: int) -> Any:
        unused = numpy.int64(64 - bits)
        return (integers << unused.astype(numpy.uint64)).view(numpy.int64) >> unused

    def shifted(self, integers: Any, shift: int, bits: int) -> Any:
        return integers >> numpy.uint64(shift) & numpy.uint64((1 << bits) - 1)

    def doubles(self, integers: Any) -> tuple[Numbers, int]:
        limit = 1 << 53
        is_beyond = integers > limit
        if integers.dtype == numpy.int64:
            is_beyond |= integers < -limit
        return integers.astype(numpy.float64), int(numpy.count_nonzero(is_beyond))

    def truths(self, integers: Any) -> Numbers:
        return (integers != 0).astype(numpy.float64)

    def whole(self, numbers: Sequence[int]) -> Places:
        return numpy.array(numbers, dtype=numpy.int64)

    def numbers(self, numbers: Sequence[float]) -> Numbers:
        return numpy.array(numbers, dtype=numpy.float64)

    def plus(self, places: Places, offset: int) -> Places:
        return places + offset

    def times_of(self, micros: Numbers) -> Numbers:
        return micros / 1e6

    def take(self, values: Any, indices: Places) -> Any:
        return values[indices]

    def where_equal(self, sizes: Any, size: int) -> Places | None:
        is_equal = sizes == size
        return None if bool(is_equal.all()) else numpy.flatnonzero(is_equal)

    def where_multiple(self, sizes: Any, width: int) -> Places | None:
        is_multiple = sizes % width == 0
        return None if bool(is_multiple.all()) else numpy.flatnonzero(is_multiple)

    def quotients(self, sizes: Any, width: int) -> Any:
        return sizes // width

    def where_above(self, counts: Any, least: int, among: Places | None) -> Places:
        return numpy.flatnonzero(counts > least) if among is None else among[counts[among] > least]

    def with_followers(self, indices: Places, size: int) -> tuple[Places, Places]:
        followers = indices + 1
        ends_run = numpy.append(followers[:-1] != indices[1:], True) if len(indices) else numpy.zeros(0, bool)
        ends_run &= followers < size
        rows = numpy.sort(numpy.concatenate([indices, followers[ends_run]]))
        return rows, numpy.searchsorted(rows, indices)

    def spread(self, numbers: Numbers, size: int, positions: Places) -> Numbers:
        all_numbers = numpy.full(size, numpy.nan)
        all_numbers[positions] = numbers
        return all_numbers

    def gaps_outside(self, size: int, positions: Places) -> Any:
        is_gap = numpy.ones(size, bool)
        is_gap[positions] = False
        return is_gap

    def count(self, truths: Any) -> int:
        return int(numpy.count_nonzero(truths))

    def nans(self, size: int) -> Numbers:
        return numpy.full(size, numpy.nan)

    def last_before(self, times: Numbers, rows: Sequence[float]) -> Any:
        return numpy.searchsorted(times, numpy.array(rows, dtype=numpy.float64), side="right") - 1

    def held(self, numbers: Numbers, indices: Any) -> Numbers:
        if len(numbers) == 0:
            return numpy.full(len(indices), numpy.nan)
        return numpy.where(indices < 0, numpy.nan, numbers[numpy.maximum(indices, 0)])

    def infinite(self, numbers: Numbers) -> Any:
        return numpy.isinf(numbers)

    def not_finite(self, numbers: Numbers) -> int:
        return len(numbers) - int(numpy.count_nonzero(numpy.isfinite(numbers)))

    def written_nans(self, numbers: Numbers, is_gap: Any | None) -> list[int]:
        is_nan = numpy.isnan(numbers)
        found: list[int] = numpy.flatnonzero(is_nan if is_gap is None else is_nan & ~is_gap).tolist()
        return found

    def order(self, times: Numbers, first: float, last: float) -> tuple[Numbers, Places | None, int]:
        is_early = times < 0
        is_kept = is_early | ((times >= first) & (times <= last))
        is_ordered = not bool((times[1:] < times[:-1]).any())
        if is_ordered and bool(is_kept.all()):
            return (numpy.where(is_early, first, times) if bool(is_early[:1].any()) else times), None, 0
        kept = numpy.flatnonzero(is_kept)
        own = times[kept]
        disorder = int(numpy.count_nonzero(own[1:] < own[:-1]))
        if disorder > 0:
            kept = kept[numpy.argsort(own, kind="stable")]
            own = times[kept]
        return numpy.where(own < 0, first, own), kept, disorder

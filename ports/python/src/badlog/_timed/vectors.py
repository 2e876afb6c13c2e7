"""Reads many numbers from bytes at a time, with NumPy or with Python alone."""

from __future__ import annotations

import math
from array import array
from bisect import bisect_right
from collections.abc import Sequence
from importlib.util import find_spec
from itertools import compress
from struct import Struct
from typing import Any, Protocol

Numbers = Any
"""A sequence of numbers: a NumPy array from `NumpyVectors`, otherwise an `array`."""

Places = Any
"""Ascending whole numbers: positions in the bytes, or indices."""


class Vectors(Protocol):
    """The operations on the bytes of one file."""

    def floats(self, code: str, places: Places) -> Numbers:
        """The numbers at `places`, encoded as `struct` calls it: `<d`, `>H`."""

    def integers(self, places: Places, width: int) -> Any:
        """The unsigned integers of `width` bytes, up to 8, at `places`, lowest byte first."""

    def signed(self, integers: Any, bits: int) -> Any:
        """Unsigned integers of `bits` bits as signed ones."""

    def shifted(self, integers: Any, shift: int, bits: int) -> Any:
        """The `bits` bits of each that are `shift` above the lowest."""

    def doubles(self, integers: Any) -> tuple[Numbers, int]:
        """The numbers as doubles, and how many of them are beyond 2^53."""

    def truths(self, integers: Any) -> Numbers:
        """0 for 0, otherwise 1."""

    def whole(self, numbers: Sequence[int]) -> Places:
        """Whole numbers as a list of this kind."""

    def numbers(self, numbers: Sequence[float]) -> Numbers:
        """Numbers as a list of this kind."""

    def plus(self, places: Places, offset: int) -> Places:
        """Each of `places` moved by `offset`."""

    def times_of(self, micros: Numbers) -> Numbers:
        """Times in µs as times in s."""

    def since(self, times: Numbers, origin: float) -> Numbers:
        """Times in s from `origin` on, which is in µs."""

    def take(self, values: Any, indices: Places) -> Any:
        """The values at `indices`."""

    def where_equal(self, sizes: Any, size: int) -> Places | None:
        """The indices at which `sizes` is `size`; None if it is everywhere."""

    def where_multiple(self, sizes: Any, width: int) -> Places | None:
        """The indices at which `sizes` is a multiple of `width`; None if it is everywhere."""

    def quotients(self, sizes: Any, width: int) -> Any:
        """Each of `sizes` divided by `width`, rounded down."""

    def where_above(self, counts: Any, least: int, among: Places | None) -> Places:
        """The indices, all or those `among`, at which `counts` is above `least`."""

    def with_followers(self, indices: Places, size: int) -> tuple[Places, Places]:
        """`indices` with the index after each run of them, if that is below `size`. The second array has the places of the original ones
        among these."""

    def spread(self, numbers: Numbers, size: int, positions: Places) -> Numbers:
        """`size` numbers, those at `positions` from `numbers`, NaN elsewhere."""

    def gaps_outside(self, size: int, positions: Places) -> Any:
        """For each of `size` samples, whether it is not at one of `positions`."""

    def count(self, truths: Any) -> int:
        """How many of them are true."""

    def nans(self, size: int) -> Numbers:
        """`size` times NaN."""

    def last_before(self, times: Numbers, rows: Sequence[float]) -> Any:
        """For each of `rows`, the index of the last of `times` that is not after it; -1 if all are."""

    def held(self, numbers: Numbers, indices: Any) -> Numbers:
        """The number at each of `indices`, NaN for -1."""

    def infinite(self, numbers: Numbers) -> Any:
        """For each, whether it is infinite."""

    def not_finite(self, numbers: Numbers) -> int:
        """How many are NaN or infinite."""

    def written_nans(self, numbers: Numbers, is_gap: Any | None) -> list[int]:
        """The indices of the NaNs that are not gaps."""

    def order(self, times: Numbers, first: float, last: float) -> tuple[Numbers, Places | None, int]:
        """The times from `first` to `last` and those below 0, ascending. Also their former indices, or None if none moved; and the
        number that followed a later one. Those below 0 become `first`.
        """


def uses_numpy() -> bool:
    """Whether NumPy is installed."""
    return find_spec("numpy") is not None


def vectors_of(data: bytes, with_numpy: bool) -> Vectors:
    """The operations on `data`."""
    if with_numpy:
        from badlog._timed.numpy_vectors import NumpyVectors

        return NumpyVectors(data)
    return PlainVectors(data)


class PlainVectors:
    """The operations, with Python alone."""

    def __init__(self, data: bytes) -> None:
        self._data = data

    def floats(self, code: str, places: Places) -> Numbers:
        unpack = Struct(code).unpack_from
        data = self._data
        return array("d", [unpack(data, at)[0] for at in places])

    def integers(self, places: Places, width: int) -> Any:
        data = self._data
        if width == 1:
            return [data[at] for at in places]
        read = int.from_bytes
        return [read(data[at : at + width], "little") for at in places]

    def signed(self, integers: Any, bits: int) -> Any:
        sign = 1 << (bits - 1)
        return [(number ^ sign) - sign for number in integers]

    def shifted(self, integers: Any, shift: int, bits: int) -> Any:
        mask = (1 << bits) - 1
        return [number >> shift & mask for number in integers]

    def doubles(self, integers: Any) -> tuple[Numbers, int]:
        limit = 1 << 53
        rounded = sum(not -limit <= number <= limit for number in integers)
        return array("d", integers), rounded

    def truths(self, integers: Any) -> Numbers:
        return array("d", [float(number != 0) for number in integers])

    def whole(self, numbers: Sequence[int]) -> Places:
        return array("q", numbers)

    def numbers(self, numbers: Sequence[float]) -> Numbers:
        return array("d", numbers)

    def plus(self, places: Places, offset: int) -> Places:
        return places if offset == 0 else array("q", [at + offset for at in places])

    def times_of(self, micros: Numbers) -> Numbers:
        return array("d", [time / 1e6 for time in micros])

    def since(self, times: Numbers, origin: float) -> Numbers:
        return array("d", [round(time * 1e6 - origin) / 1e6 for time in times])

    def take(self, values: Any, indices: Places) -> Any:
        return array(values.typecode, [values[index] for index in indices])

    def where_equal(self, sizes: Any, size: int) -> Places | None:
        found = [index for index, other in enumerate(sizes) if other == size]
        return None if len(found) == len(sizes) else array("q", found)

    def where_multiple(self, sizes: Any, width: int) -> Places | None:
        found = [index for index, size in enumerate(sizes) if size % width == 0]
        return None if len(found) == len(sizes) else array("q", found)

    def quotients(self, sizes: Any, width: int) -> Any:
        return array("q", [size // width for size in sizes])

    def where_above(self, counts: Any, least: int, among: Places | None) -> Places:
        if among is None:
            return array("q", [index for index, count in enumerate(counts) if count > least])
        return array("q", [index for index in among if counts[index] > least])

    def with_followers(self, indices: Places, size: int) -> tuple[Places, Places]:
        rows = array("q")
        positions = array("q")
        for i, index in enumerate(indices):
            positions.append(len(rows))
            rows.append(index)
            follower = index + 1
            if follower < size and (i + 1 == len(indices) or indices[i + 1] != follower):
                rows.append(follower)
        return rows, positions

    def spread(self, numbers: Numbers, size: int, positions: Places) -> Numbers:
        all_numbers = self.nans(size)
        for position, number in zip(positions, numbers):
            all_numbers[position] = number
        return all_numbers

    def gaps_outside(self, size: int, positions: Places) -> Any:
        is_gap = bytearray(b"\1") * size
        for position in positions:
            is_gap[position] = 0
        return array("B", bytes(is_gap))

    def count(self, truths: Any) -> int:
        return sum(truths)

    def nans(self, size: int) -> Numbers:
        return array("d", [math.nan]) * size

    def last_before(self, times: Numbers, rows: Sequence[float]) -> Any:
        return [bisect_right(times, row) - 1 for row in rows]

    def held(self, numbers: Numbers, indices: Any) -> Numbers:
        return array("d", [math.nan if index < 0 else numbers[index] for index in indices])

    def infinite(self, numbers: Numbers) -> Any:
        return [math.isinf(number) for number in numbers]

    def not_finite(self, numbers: Numbers) -> int:
        # A finite sum means that all are finite, but the sum may overflow although all are.
        return 0 if math.isfinite(sum(numbers)) else sum(not math.isfinite(number) for number in numbers)

    def written_nans(self, numbers: Numbers, is_gap: Any | None) -> list[int]:
        return [i for i, number in enumerate(numbers) if number != number and (is_gap is None or not is_gap[i])]

    def order(self, times: Numbers, first: float, last: float) -> tuple[Numbers, Places | None, int]:
        is_kept = [time < 0 or first <= time <= last for time in times]
        is_ordered = all(one <= other for one, other in zip(times, times[1:]))
        if is_ordered and all(is_kept):
            early = next((i for i, time in enumerate(times) if time >= 0), len(times))
            return (times if early == 0 else array("d", [first]) * early + times[early:]), None, 0
        kept = list(compress(range(len(times)), is_kept))
        disorder = sum(times[kept[i]] < times[kept[i - 1]] for i in range(1, len(kept)))
        if disorder > 0:
            kept.sort(key=times.__getitem__)
        return array("d", [first if times[i] < 0 else times[i] for i in kept]), array("q", kept), disorder

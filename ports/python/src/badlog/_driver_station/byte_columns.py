"""Turns columns of bytes into numbers, with NumPy or with Python alone."""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from typing import Any


class ByteColumns:
    """The operations on columns; a column has one byte of every record."""

    def __init__(self, with_numpy: bool) -> None:
        self._numpy: Any = None
        if with_numpy:
            import numpy

            self._numpy = numpy

    def looked_up(self, column: bytes, table: Sequence[float]) -> Any:
        """The entry in `table` for each byte."""
        if self._numpy is not None:
            return self._numpy.array(table)[self._numpy.frombuffer(column, self._numpy.uint8)]
        return array("d", map(table.__getitem__, column))

    def scaled(self, high: bytes, low: bytes, shift: int, mask: int, divisor: float) -> Any:
        """The bits `mask` that are `shift` above the lowest of each two bytes, divided by `divisor`."""
        numpy = self._numpy
        if numpy is not None:
            words = numpy.frombuffer(high, numpy.uint8).astype(numpy.uint16) << 8 | numpy.frombuffer(low, numpy.uint8)
            return (words >> shift & mask) / divisor
        return array("d", [((one << 8 | other) >> shift & mask) / divisor for one, other in zip(high, low)])

    def total(self, columns: Sequence[Any]) -> Any:
        """The sums of several columns of numbers."""
        return sum(columns[1:], start=columns[0]) if self._numpy is not None else array("d", map(sum, zip(*columns)))

    def times(self, indices: Sequence[range], seconds: float) -> Any:
        """Each of `indices` in `seconds`."""
        numpy = self._numpy
        if numpy is not None:
            return numpy.concatenate([numpy.zeros(0), *(numpy.arange(one.start, one.stop) * seconds for one in indices)])
        return array("d", [index * seconds for one in indices for index in one])

    def with_gaps(self, numbers: Any, places: Sequence[int]) -> Any:
        """The numbers with NaN at `places`."""
        for place in places:
            numbers[place] = float("nan")
        return numbers

    def places(self, column: bytes, byte: int) -> list[int]:
        """Where a byte occurs."""
        if self._numpy is not None:
            found: list[int] = self._numpy.flatnonzero(self._numpy.frombuffer(column, self._numpy.uint8) == byte).tolist()
            return found
        return [place for place, other in enumerate(column) if other == byte]

    def above(self, numbers: Any, most: float) -> list[int]:
        """Where a number is above `most`."""
        if self._numpy is not None:
            found: list[int] = self._numpy.flatnonzero(numbers > most).tolist()
            return found
        return [place for place, number in enumerate(numbers) if number > most]

"""The numbers of a topic, in the pieces in which they were read; the pieces are joined on first use."""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy
    import numpy.typing
    import pyarrow

    Numbers = numpy.typing.NDArray[numpy.float64]
else:
    Numbers = Any


class Samples:
    """One number for each row; NaN where there is none."""

    def __init__(self) -> None:
        # Arrays of Arrow, in which null is a gap, arrays of NumPy, or plain ones.
        self._parts: list[Any] = []
        self._whole: Any = None

    @staticmethod
    def of(numbers: Any) -> Samples:
        """Samples from a double array, NumPy's or a plain one, which must not change afterwards."""
        samples = Samples()
        samples._parts.append(numbers)
        return samples

    @staticmethod
    def of_indices(count: int) -> Samples:
        """The numbers from 0 on."""
        return Samples.of(array("d", range(count)))

    def add(self, number: float) -> None:
        self._last_plain().append(number)

    def extend(self, numbers: Iterable[float]) -> None:
        self._last_plain().extend(numbers)

    def add_part(self, part: Any) -> None:
        """Adds a double array of Arrow or of NumPy as it is."""
        self._parts.append(part)

    def _last_plain(self) -> array[float]:
        if not self._parts or not isinstance(self._parts[-1], array):
            self._parts.append(array("d"))
        last: array[float] = self._parts[-1]
        return last

    def whole(self) -> Numbers:
        """All numbers in one array: NumPy's if that is installed, otherwise a plain one."""
        if self._whole is None:
            self._whole = self._joined()
        whole: Numbers = self._whole
        return whole

    def _joined(self) -> Any:
        try:
            import numpy
        except ImportError:
            return self._parts[0] if self._parts else array("d")
        parts = [_numbers_of(part) for part in self._parts]
        whole = parts[0] if len(parts) == 1 else numpy.concatenate([numpy.empty(0), *parts])
        whole.flags.writeable = False
        return whole

    def to_arrow(self, written_nans: list[int]) -> pyarrow.Array | pyarrow.ChunkedArray:
        """All numbers with null for a gap, except in the rows `written_nans`, in which a NaN was written."""
        import numpy
        import pyarrow

        if self._parts and all(isinstance(part, pyarrow.Array) for part in self._parts):
            return pyarrow.chunked_array(self._parts)
        numbers = self.whole()
        is_gap = numpy.isnan(numbers)
        is_gap[written_nans] = False
        return pyarrow.array(numbers, mask=is_gap)


def _numbers_of(part: Any) -> Any:
    import numpy

    if isinstance(part, array):
        # A copy, because an array cannot grow while its memory is shared.
        return numpy.array(part, dtype=numpy.float64)
    if isinstance(part, numpy.ndarray):
        return part
    return part.to_numpy(zero_copy_only=False) if part.null_count else numpy.array(part.to_numpy())


def no_samples(rows: int) -> Samples:
    """Samples with nothing but gaps."""
    samples = Samples()
    samples.extend([math.nan] * rows)
    return samples

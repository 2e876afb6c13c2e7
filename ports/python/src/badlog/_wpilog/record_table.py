"""A table of a file's records, with one line of numbers for each."""

from __future__ import annotations

from array import array
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from badlog._timed.vectors import Places, Vectors


@dataclass(frozen=True)
class EntryRecords:
    """The records of one entry, in the order of the file."""

    indices: Places
    """Their numbers among all records."""
    micros: Any
    """Their times in µs."""
    starts: Places
    """Where their payloads begin."""
    sizes: Any
    """The sizes of their payloads in bytes."""

    def __len__(self) -> int:
        return len(self.starts)

    def taken(self, indices: Places | None, vectors: Vectors) -> EntryRecords:
        """The records at `indices`, or all of them if that is None."""
        if indices is None:
            return self
        take = vectors.take
        return EntryRecords(take(self.indices, indices), take(self.micros, indices), take(self.starts, indices), take(self.sizes, indices))


class RecordTable:
    """A growing table of records."""

    def __init__(self) -> None:
        self._entries = array("i")
        self._micros = array("d")
        self._starts = array("q")
        self._sizes = array("q")

    def add(self, entry: int, micros: float, start: int, size: int) -> None:
        """Adds a record of the entry number `entry`."""
        self._entries.append(entry)
        self._micros.append(micros)
        self._starts.append(start)
        self._sizes.append(size)

    @property
    def adders(self) -> tuple[Callable[[int], None], Callable[[float], None], Callable[[int], None], Callable[[int], None]]:
        """The functions that add the parts of a record; call all four."""
        return self._entries.append, self._micros.append, self._starts.append, self._sizes.append

    def add_all(self, entries: Any, micros: Any, starts: Any, sizes: Any) -> None:
        """Adds many records from NumPy arrays with the same types."""
        self._entries.frombytes(entries.tobytes())
        self._micros.frombytes(micros.tobytes())
        self._starts.frombytes(starts.tobytes())
        self._sizes.frombytes(sizes.tobytes())

    def by_entry(self, count: int, with_numpy: bool) -> list[EntryRecords]:
        """The records of each of `count` entries."""
        return self._by_numpy(count) if with_numpy else self._by_python(count)

    def _by_python(self, count: int) -> list[EntryRecords]:
        groups = [array("q") for _ in range(count)]
        for i, entry in enumerate(self._entries):
            groups[entry].append(i)
        return [
            EntryRecords(
                group,
                array("d", map(self._micros.__getitem__, group)),
                array("q", map(self._starts.__getitem__, group)),
                array("q", map(self._sizes.__getitem__, group)),
            )
            for group in groups
        ]

    def _by_numpy(self, count: int) -> list[EntryRecords]:
        import numpy

        entries = numpy.array(self._entries)
        order = numpy.argsort(entries.astype(numpy.uint16) if count < 1 << 16 else entries, kind="stable")
        ends = numpy.cumsum(numpy.bincount(entries, minlength=count)).tolist()
        micros, starts, sizes = numpy.array(self._micros)[order], numpy.array(self._starts)[order], numpy.array(self._sizes)[order]
        groups = []
        for i in range(count):
            own = slice(ends[i - 1] if i > 0 else 0, ends[i])
            groups.append(EntryRecords(order[own], micros[own], starts[own], sizes[own]))
        return groups

"""The columns made of one entry's payloads, in blocks that share their times."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from badlog._timed.column import Column, Timestamps
from badlog._timed.vectors import Places, Vectors

MAX_ELEMENTS = 256
"""The number of array elements that are shown: each is a topic and a graph."""

# No program shows more topics, and a damaged file could produce millions.
_MAX_COLUMNS = 1 << 16


@dataclass(frozen=True)
class Block:
    """Columns with the same times."""

    columns: list[Column]
    timestamps: Timestamps


@dataclass
class Decoded:
    """The decoded payloads of one entry."""

    timestamps: Timestamps
    """The times of all good records."""
    blocks: list[Block] = field(default_factory=list)
    bad_count: int = 0
    """The number of payloads without the size that the type requires."""
    dropped_values: int = 0
    """The number of values for which there was no topic left."""
    is_undecoded: bool = False
    """Whether only the sizes of the payloads are shown."""


# A message of a few bytes may have a thousand values by default, so their number needs its own bound.
_MIN_MESSAGE_VALUES = 1 << 25


class ColumnRoom:
    """Counts the columns of a file of `size` bytes, and the values of its messages, up to the maximum."""

    def __init__(self, size: int) -> None:
        self._made = 0
        self._values_left = max(_MIN_MESSAGE_VALUES, size)

    def has(self, count: int) -> bool:
        """Whether `count` more columns are allowed."""
        return self._made + count <= _MAX_COLUMNS

    def take(self, count: int) -> None:
        """Counts `count` columns."""
        self._made += count

    def spend(self, values: int) -> bool:
        """Counts more values of messages. Returns False, and counts nothing, if they are too many."""
        if values > self._values_left:
            return False
        self._values_left -= values
        return True


def decode_elements(
    decoded: Decoded,
    counts: Sequence[int],
    leaves: int,
    room: ColumnRoom,
    vectors: Vectors,
    columns_of: Callable[[int, Places], list[Column]],
) -> None:
    """Adds a block for each element of arrays, which are the good records of `decoded` and have `counts` elements.

    Elements in every record share their timestamps; one that appears later or disappears has its own, so that an array that was once long costs
    nothing afterwards. `columns_of` makes the `leaves` columns of an element, from its index and the records that have it.
    """
    size = len(counts)
    index = 0
    present = vectors.where_above(counts, 0, None)
    while len(present) > 0:
        if index == MAX_ELEMENTS or not room.has(leaves):
            decoded.dropped_values += sum(int(counts[row]) - index for row in present)
            return
        room.take(leaves)
        columns = columns_of(index, present)
        timestamps = decoded.timestamps
        if len(present) < size:
            rows, positions = vectors.with_followers(present, size)
            timestamps = timestamps.taken(rows)
            if len(rows) > len(present):
                columns = [column.spread(len(rows), positions, vectors) for column in columns]
        decoded.blocks.append(Block(columns, timestamps))
        index += 1
        present = vectors.where_above(counts, index, present)

"""Decodes payloads that are messages of Protocol Buffers."""

from __future__ import annotations

from array import array
from dataclasses import dataclass, field

from badlog._timed.column import NUMBERS, TRUTHS, Column, Timestamps
from badlog._timed.vectors import Vectors
from badlog._wpilog.blocks import MAX_ELEMENTS, Block, ColumnRoom, Decoded
from badlog._wpilog.message_layout import MessageLayout, MessageList, MessageValue
from badlog._wpilog.message_reader import ReadMessage
from badlog._wpilog.record_table import EntryRecords


def decode_messages(layout: MessageLayout, data: bytes, records: EntryRecords, room: ColumnRoom, vectors: Vectors) -> Decoded:
    """The decoded payloads of an entry with messages of `layout`."""
    good = array("q", (i for i, (start, size) in enumerate(zip(records.starts, records.sizes)) if layout.fits(data, int(start), int(start + size))))
    fitting = records if len(good) == len(records) else records.taken(vectors.whole(good), vectors)
    times = [micros / 1e6 for micros in map(float, fitting.micros)]
    room.take(len(layout.values))
    block = _GrowingBlock([_GrowingColumn(value, value.path) for value in layout.values], times)
    lists = [_ListTopics(one, one.path, data, room) for one in layout.lists]
    dropped = 0
    for time, start, size in zip(times, map(int, fitting.starts), map(int, fitting.sizes)):
        message = ReadMessage.of(layout, data, start, start + size)
        block.add(message, data)
        for one in lists:
            dropped += one.add(time, message)
    blocks = [block, *(inner for one in lists for inner in one.blocks)]
    timestamps = Timestamps(vectors.times_of(fitting.micros), vectors)
    return Decoded(
        timestamps,
        [one.block(timestamps if one is block else Timestamps(vectors.numbers(one.times), vectors), vectors) for one in blocks],
        bad_count=len(records) - len(fitting),
        dropped_values=dropped,
    )


@dataclass
class _GrowingColumn:
    value: MessageValue
    path: str
    numbers: array[float] = field(default_factory=lambda: array("d"))
    texts: list[bytes] = field(default_factory=list)
    rows: array[int] = field(default_factory=lambda: array("q"))
    size: int = 0
    rounded: int = 0

    def add(self, message: ReadMessage, data: bytes) -> None:
        value = self.value
        found = message.field_of(value)
        if found is None:
            self.add_gap()
            return
        type = value.type
        self.rows.append(self.size)
        self.size += 1
        if type.name == "string":
            self.texts.append(data[found.start : found.end])
        elif type.name == "enum":
            number = type.integer(found.bits)
            self.texts.append(value.names.get(number) or str(number).encode())
        elif type.name == "bytes":
            self.numbers.append(float(found.end - found.start))
        else:
            self.numbers.append(type.number(found.bits))
            self.rounded += type.is_rounded(found.bits)

    def add_gap(self) -> None:
        self.size += 1

    def column(self, vectors: Vectors) -> Column:
        if self.value.type.is_text:
            return Column.of_texts(self.path, self.size, self.rows, self.texts, vectors)
        sort = TRUTHS if self.value.type.name == "bool" else NUMBERS
        positions = vectors.whole(self.rows)
        numbers = vectors.spread(self.numbers, self.size, positions)
        is_gap = vectors.gaps_outside(self.size, positions) if len(self.rows) < self.size else None
        return Column(self.path, sort, self.size, numbers, is_gap, rounded=self.rounded)


class _GrowingBlock:
    """The columns of one message, or of one element of a list, all at the same times."""

    def __init__(self, columns: list[_GrowingColumn], times: list[float]) -> None:
        self.columns = columns
        self.times = times
        self._is_in_gap = False

    def add(self, message: ReadMessage, data: bytes) -> None:
        self._is_in_gap = False
        for column in self.columns:
            column.add(message, data)

    def add_at(self, time: float, message: ReadMessage, data: bytes) -> None:
        self.times.append(time)
        self.add(message, data)

    def miss(self, time: float) -> None:
        """Records that the list no longer has this element at `time`: a gap."""
        if self._is_in_gap:
            return
        self._is_in_gap = True
        self.times.append(time)
        for column in self.columns:
            column.add_gap()

    def block(self, timestamps: Timestamps, vectors: Vectors) -> Block:
        return Block([column.column(vectors) for column in self.columns], timestamps)


class _ListTopics:
    """The topics of a list; their names consist of the entry's name and `path`."""

    def __init__(self, layout: MessageList, path: str, data: bytes, room: ColumnRoom) -> None:
        self._list = layout
        self._path = path
        self._data = data
        self._room = room
        self._blocks: list[_GrowingBlock] = []
        # The lists in each element.
        self._inner: list[list[_ListTopics]] = []
        self._present = 0

    @property
    def blocks(self) -> list[_GrowingBlock]:
        return self._blocks + [block for lists in self._inner for one in lists for block in one.blocks]

    def add(self, time: float, outer: ReadMessage) -> int:
        """Adds this list of the message `outer`. Returns the number of values for which no topic was left."""
        found = outer.lists[self._list.index]
        count = outer.counts[self._list.index]
        element = self._list.element
        dropped = count - len(found)
        inner_dropped = 0
        for index, place in enumerate(found):
            if (index == len(self._blocks) and not self._grow(index)) or not self._room.spend(len(element.values)):
                dropped = count - index
                break
            if self._list.type is None:
                message = ReadMessage.of(element, self._data, place.start, place.end)
            else:
                message = ReadMessage.of_single(element, place)
            self._blocks[index].add_at(time, message, self._data)
            for one in self._inner[index]:
                inner_dropped += one.add(time, message)
        for index in range(len(found), len(self._inner)):
            for one in self._inner[index]:
                one.end(time)
        self._end(len(found), time)
        return dropped + inner_dropped

    def end(self, time: float) -> None:
        """Records that the list is missing at `time`."""
        for lists in self._inner:
            for one in lists:
                one.end(time)
        self._end(0, time)

    def _end(self, count: int, time: float) -> None:
        for index in range(count, self._present):
            self._blocks[index].miss(time)
        self._present = min(count, len(self._blocks))

    def _grow(self, index: int) -> bool:
        """Adds the topics of one more element; returns False if there are too many."""
        element = self._list.element
        if index >= MAX_ELEMENTS or not self._room.has(len(element.values)):
            return False
        self._room.take(len(element.values))
        path = f"{self._path}[{index}]"
        self._inner.append([_ListTopics(one, path + one.path, self._data, self._room) for one in element.lists])
        self._blocks.append(_GrowingBlock([_GrowingColumn(value, path + value.path) for value in element.values], []))
        return True

"""Turns the payloads of an entry into columns, by its type."""

from __future__ import annotations

from badlog._timed.column import NUMBERS, Column, Timestamps
from badlog._timed.vectors import Places, Vectors
from badlog._wpilog.blocks import MAX_ELEMENTS, Block, ColumnRoom, Decoded, decode_elements
from badlog._wpilog.entry import MESSAGE_SCHEMA, Entry
from badlog._wpilog.layout import ValueLayout
from badlog._wpilog.message_decoding import decode_messages
from badlog._wpilog.message_types import MessageTypes
from badlog._wpilog.record_table import EntryRecords
from badlog._wpilog.struct_schemas import StructSchemas

_TEXT_TYPES = ("string", "json", "structschema")
_STRUCT = "struct:"
_PROTO = "proto:"
# The maximum number of payload bytes that wait for their schema, and the additional bytes counted for each payload.
_MAX_HELD = 1 << 20
_OVERHEAD = 64


class Decoding:
    """Decodes the entries of one file, one after another."""

    def __init__(self, data: bytes, vectors: Vectors, structs: StructSchemas, messages: MessageTypes) -> None:
        self._data = data
        self._vectors = vectors
        self._structs = structs
        self._messages = messages
        self._room = ColumnRoom(len(data))

    def decode(self, entry: Entry, records: EntryRecords) -> Decoded:
        """The decoded payloads of `entry`."""
        type = entry.type
        single = type.removesuffix("[]")
        layout = ValueLayout.of(single)
        if not self._room.has(1):
            return Decoded(self._timestamps(records.taken(self._vectors.whole([]), self._vectors)), dropped_values=len(records))
        if layout is not None:
            return self._of_layout(layout, entry.is_array, records)
        if single.startswith(_STRUCT):
            known = self._structs.layout_of(single.removeprefix(_STRUCT))
            if known is not None and self._room.has(len(known[0].leaves)) and not _waits_too_long(records, known[1]):
                return self._of_layout(known[0], entry.is_array, records)
        elif type == "string[]":
            return self._of_text_arrays(records)
        elif type in _TEXT_TYPES:
            return self._of_texts(records)
        elif type.startswith(_PROTO) and type != MESSAGE_SCHEMA:
            message = self._messages.layout_of(type.removeprefix(_PROTO))
            if message is None or not self._room.has(len(message[0].values)) or _waits_too_long(records, message[1]):
                return self._of_sizes(records)
            if self._room.spend(len(message[0].values) * len(records)):
                return decode_messages(message[0], self._data, records, self._room, self._vectors)
        return self._of_sizes(records)

    def _timestamps(self, records: EntryRecords) -> Timestamps:
        return Timestamps(self._vectors.times_of(records.micros), self._vectors)

    def _of_layout(self, layout: ValueLayout, is_array: bool, records: EntryRecords) -> Decoded:
        vectors = self._vectors
        if not is_array:
            good = vectors.where_equal(records.sizes, layout.width)
        elif layout.width > 0:
            good = vectors.where_multiple(records.sizes, layout.width)
        else:
            good = vectors.whole([])
        fitting = records.taken(good, vectors)
        decoded = Decoded(self._timestamps(fitting), bad_count=len(records) - len(fitting))
        starts = fitting.starts
        if not is_array:
            self._room.take(len(layout.leaves))
            columns = [leaf.column(leaf.path, self._data, starts, vectors) for leaf in layout.leaves]
            decoded.blocks.append(Block(columns, decoded.timestamps))
            return decoded

        def columns_of(index: int, present: Places) -> list[Column]:
            places = starts if len(present) == len(starts) else vectors.take(starts, present)
            places = vectors.plus(places, index * layout.width)
            return [leaf.column(f"[{index}]{leaf.path}", self._data, places, vectors) for leaf in layout.leaves]

        if layout.width > 0:
            counts = vectors.quotients(fitting.sizes, layout.width)
            decode_elements(decoded, counts, len(layout.leaves), self._room, vectors, columns_of)
        return decoded

    def _of_texts(self, records: EntryRecords) -> Decoded:
        self._room.take(1)
        data = self._data
        decoded = Decoded(self._timestamps(records))
        texts = [data[start : start + size] for start, size in zip(_ints(records.starts), _ints(records.sizes))]
        column = Column.of_texts("", len(texts), range(len(texts)), texts, self._vectors)
        decoded.blocks.append(Block([column], decoded.timestamps))
        return decoded

    def _of_text_arrays(self, records: EntryRecords) -> Decoded:
        vectors = self._vectors
        found = [self._texts_in(start, start + size) for start, size in zip(_ints(records.starts), _ints(records.sizes))]
        good = [i for i, one in enumerate(found) if one is not None]
        fitting = records if len(good) == len(found) else records.taken(vectors.whole(good), vectors)
        arrays = [one for one in found if one is not None]
        decoded = Decoded(self._timestamps(fitting), bad_count=len(found) - len(arrays))

        def columns_of(index: int, present: Places) -> list[Column]:
            texts = [arrays[row][1][index] for row in _ints(present)]
            return [Column.of_texts(f"[{index}]", len(texts), range(len(texts)), texts, vectors)]

        decode_elements(decoded, vectors.whole([count for count, _ in arrays]), 1, self._room, vectors, columns_of)
        return decoded

    def _texts_in(self, start: int, until: int) -> tuple[int, list[bytes]] | None:
        """The number of texts in a payload, and the first of them; None unless they fill it exactly."""
        data = self._data
        if until - start < 4:
            return None
        count = int.from_bytes(data[start : start + 4], "little")
        if count > (until - start) // 4 - 1:
            return None
        at = start + 4
        texts = []
        for index in range(count):
            if until - at < 4:
                return None
            size = int.from_bytes(data[at : at + 4], "little")
            at += 4
            if size > until - at:
                return None
            if index < MAX_ELEMENTS:
                texts.append(data[at : at + size])
            at += size
        return (count, texts) if at == until else None

    def _of_sizes(self, records: EntryRecords) -> Decoded:
        self._room.take(1)
        decoded = Decoded(self._timestamps(records), is_undecoded=True)
        sizes, _ = self._vectors.doubles(records.sizes)
        decoded.blocks.append(Block([Column("", NUMBERS, len(records), sizes)], decoded.timestamps))
        return decoded


def _ints(numbers: Places) -> list[int]:
    ints: list[int] = numbers.tolist()
    return ints


def _waits_too_long(records: EntryRecords, since: int) -> bool:
    """Whether too many bytes came before the record number `since`, from which on their schema is known."""
    held = 0
    for index, size in zip(_ints(records.indices), _ints(records.sizes)):
        if index >= since:
            return False
        held += size + _OVERHEAD
        if held > _MAX_HELD:
            return True
    return False

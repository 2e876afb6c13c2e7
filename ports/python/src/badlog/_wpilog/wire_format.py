"""The encoding of Protocol Buffers, see https://protobuf.dev/programming-guides/encoding."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

VARINT, FIXED_64, SIZED, FIXED_32 = 0, 1, 2, 5
"""The encodings of a field."""

_MASK_64 = (1 << 64) - 1
_MAX_VARINT_SIZE = 10


class WireField(NamedTuple):
    """One field of a message."""

    number: int
    wire: int
    bits: int
    """Its 64 bits, unless it is SIZED."""
    start: int
    """Where the bytes of a SIZED field begin."""
    end: int
    """Where they end."""


def fields_in(data: bytes, start: int, until: int) -> Iterator[WireField | None]:
    """The fields of one message; the last one is None if the bytes are not a message to their end."""
    at = start
    while at < until:
        tag, at = _varint(data, at, until)
        # 32 bits with a sign; field numbers use 29 of them.
        number = tag >> 3 & 0xFFFFFFFF
        field = _value(data, number, tag & 7, at, until) if at >= 0 and 0 < number < 1 << 31 else None
        yield field
        if field is None:
            return
        at = field.end


def packed_in(data: bytes, wire: int, start: int, until: int) -> Iterator[WireField | None]:
    """The numbers of a packed list with the encoding `wire`. The last one is None if the bytes are not such
    a list.
    """
    at = start
    while at < until:
        field = _value(data, 0, wire, at, until)
        yield field
        if field is None:
            return
        at = field.end


def _value(data: bytes, number: int, wire: int, at: int, until: int) -> WireField | None:
    if wire == VARINT:
        bits, end = _varint(data, at, until)
        return None if end < 0 else WireField(number, wire, bits, end, end)
    if wire == SIZED:
        size, start = _varint(data, at, until)
        return None if start < 0 or size > until - start else WireField(number, wire, 0, start, start + size)
    if wire not in (FIXED_64, FIXED_32):
        return None
    end = at + (8 if wire == FIXED_64 else 4)
    return None if end > until else WireField(number, wire, int.from_bytes(data[at:end], "little"), end, end)


def _varint(data: bytes, at: int, until: int) -> tuple[int, int]:
    """A number of up to 64 bits, and its end: -1 if it has none."""
    number = 0
    shift = 0
    for place in range(at, min(until, at + _MAX_VARINT_SIZE)):
        byte = data[place]
        number |= (byte & 0x7F) << shift
        if byte < 0x80:
            return number & _MASK_64, place + 1
        shift += 7
    return 0, -1

"""The part of a record before its payload, and the payloads of control records."""

from __future__ import annotations

from badlog._wpilog.entry import Entry

FITTING, ODD, NONE, MORE = range(4)
"""The look of bytes where a record is expected.

FITTING: a record that belongs to the log, for its entry was started, its size fits the type, and its time is near the others. ODD: possibly a
record; its head is valid, but something in it is odd. NONE: not a record. MORE: it would continue after the end of the file.
"""

MAX_PAYLOAD_BYTES = 1 << 24
"""No logger writes a larger payload; a larger size is damage."""

CONTROL_HEAD = 5
"""The bytes of a control record's payload that all kinds have: the kind, and the entry that it is about."""

START, FINISH, SET_METADATA = range(3)
"""The kinds of control records."""

TEXTS_OF = {START: 3, FINISH: 0, SET_METADATA: 1}
"""The number of texts after the head of a control record, for each kind."""


class RecordHead:
    """The head of one record at a time."""

    __slots__ = ("entry", "id", "length", "micros", "size")

    def __init__(self) -> None:
        self.id = 0
        """The record's entry; 0 for a control record."""
        self.micros = 0.0
        """Its time, in µs."""
        self.size = 0
        """The size of the payload in bytes."""
        self.length = 0
        """The size of the whole record in bytes."""
        self.entry: Entry | None = None
        """The record's entry, if it was looked up; None for a control record and for an unknown entry."""

    @property
    def has_one_size(self) -> bool:
        """Whether all records of its entry have the same size, so that the size of a fitting one is certain."""
        return self.entry is not None and self.entry.has_one_size

    def read(self, data: bytes, at: int, end: int) -> int:
        """Reads the head at `at`; returns FITTING if it is valid."""
        if at >= end:
            return MORE
        bits = data[at]
        if bits & 0x80:
            return NONE
        size_at = at + 2 + (bits & 3)
        time_at = size_at + 1 + (bits >> 2 & 3)
        head_end = time_at + 1 + (bits >> 4)
        if head_end > end:
            return MORE
        size = int.from_bytes(data[size_at:time_at], "little")
        if size > MAX_PAYLOAD_BYTES:
            return NONE
        self.size = size
        self.id = int.from_bytes(data[at + 1 : size_at], "little")
        self.micros = float(int.from_bytes(data[time_at:head_end], "little", signed=head_end - time_at == 8))
        self.length = head_end - at + size
        return FITTING


def control_texts(data: bytes, start: int, until: int) -> list[tuple[int, int]] | None:
    """The start and the end of each text in the control record's payload. None unless the bytes are exactly one such payload, without a NUL
    in its texts.
    """
    if until - start < CONTROL_HEAD:
        return None
    count = TEXTS_OF.get(data[start])
    if count is None or not any(data[start + 1 : start + CONTROL_HEAD]):
        return None
    at = start + CONTROL_HEAD
    texts = []
    for _ in range(count):
        if until - at < 4:
            return None
        size = int.from_bytes(data[at : at + 4], "little")
        at += 4
        if size > until - at or data.find(b"\0", at, at + size) >= 0:
            return None
        texts.append((at, at + size))
        at += size
    return texts if at == until else None

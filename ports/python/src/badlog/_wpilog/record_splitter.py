"""Splits the bytes of a WPILOG into records, and finds records again after damage."""

from __future__ import annotations

import math
from typing import Protocol

from badlog._wpilog.record_head import FITTING, MAX_PAYLOAD_BYTES, MORE, NONE, ODD, RecordHead
from badlog._wpilog.record_search import NOWHERE, RecordSearch, StartedEntries

MAGIC = b"WPILOG"
"""The start of every WPILOG."""

HEADER = 12
"""The size of the header without its text."""

# An odd record up to this size may cost a few others.
_SMALL = 1000


class RecordSink(StartedEntries, Protocol):
    """Receives the records and gaps that a `RecordSplitter` finds."""

    record_count: int
    """The number of records received."""

    def record(self, head: RecordHead, start: int, until: int) -> None:
        """Receives the record that begins at `start` and ends at `until`."""

    def records(self, at: int, most: int, most_bytes: int) -> tuple[int, float]:
        """Receives fitting records of up to `most_bytes` payload each, from `at` on, at most `most`, and without control records. The one at `at`
        is known to fit; the record after the last received one fits, too. Returns the end of the last one and its time in µs; may receive none."""

    def skipped(self, start: int, until: int) -> None:
        """Called if the bytes from `start` until `until` are not records, but those after them are."""


class RecordSplitter:
    """Reads the records of `data` after a header that ends at `start`, at most `most`.

    A record is passed on when the next one also looks like a record: a wrong size is discovered where the record ends.
    """

    def __init__(self, data: bytes, start: int, sink: RecordSink, most: int) -> None:
        self._data = data
        self._end = len(data)
        self._sink = sink
        self._most = most
        self._search = RecordSearch(data, sink)
        self._head = RecordHead()
        self._next_head = RecordHead()
        self._last_micros = math.nan
        # The last time that was near its predecessor: damage may contain any time.
        self._steady_micros = math.nan
        # The size of an unsuspicious payload.
        self._usual_size = _SMALL
        self._gap_from = -1
        self.is_cut = False
        """Whether the file ends inside a record."""
        self.is_full = False
        """Whether there are more records than the maximum."""
        self._read(start)

    @property
    def readable_end(self) -> int:
        """The byte from which on nothing can be read; -1 if everything could be."""
        return self._gap_from

    def _read(self, at: int) -> None:
        end = self._end
        search = self._search
        # Whether the head is known to fit.
        is_known = False
        while at < end:
            if self._sink.record_count >= self._most:
                self.is_full = True
                return
            if is_known:
                at = self._pass_fitting(at)
                if at == end:
                    return
            if self._gap_from >= 0:
                found = search.find(at, end, self._steady_micros, is_inside=False)
                if found == NOWHERE:
                    return
                at = self._end_gap(found)
            look = FITTING if is_known else search.look(self._head, at, self._last_micros)
            is_known = False
            head = self._head
            if look == MORE or (look == FITTING and head.length > end - at):
                following = self._read_cut(at)
            elif look != FITTING:
                following = self._read_odd(at, look)
            elif head.id == 0 or head.length == end - at:
                # The content of a control record is needed to recognize the next record.
                following = self._pass(at)
            else:
                next_look = search.look(self._next_head, at + head.length, head.micros)
                is_known = next_look == FITTING
                if is_known and head.size <= self._usual_size:
                    following = self._pass(at)
                else:
                    end_of_record = at + head.length
                    following = self._read_doubtful(at, next_look)
                    is_known = is_known and following == end_of_record
            if is_known:
                self._head, self._next_head = self._next_head, self._head
            at = following

    def _pass_fitting(self, at: int) -> int:
        """Passes on the record at `at`, which has a fitting head, and those after it, up to an odd one.

        Returns where the odd one begins; `_head` is then its head. Nearly all records of a log are handled here.
        """
        most = self._most - self._sink.record_count
        following, micros = self._sink.records(at, most, self._usual_size)
        if following > at:
            self._steady_micros = self._last_micros = micros
            self._search.look(self._head, following, micros)
        return following

    def _pass(self, at: int, is_steady: bool = True) -> int:
        head = self._head
        end = at + head.length
        self._sink.record(head, at, end)
        if head.id != 0:
            if is_steady:
                self._steady_micros = head.micros
            self._last_micros = head.micros
        return end

    def _read_doubtful(self, at: int, next_look: int) -> int:
        """Reads a record that fits, but is larger than usual, or followed by something that does not fit. Its own size may be wrong."""
        data = self._data
        head = self._head
        end = at + head.length
        if not head.has_one_size:
            following = self._next_head
            if next_look == ODD and following.length <= min(_SMALL, self._end - end) and self._search.all_fit(end + following.length):
                return self._pass(at)
            found = self._search.find(at + 1, end, self._steady_micros, is_inside=True)
            if found != NOWHERE:
                return self._skip(at, found)
        self._usual_size = max(self._usual_size, head.size * 2)
        # A hole of zeros that begins inside a record leaves its head intact.
        is_torn = next_look == NONE and data[end] == 0 and data[end - 1] == 0
        if not is_torn:
            return self._pass(at)
        self._gap_from = at
        return end

    def _read_odd(self, at: int, look: int) -> int:
        """Reads bytes that are not a fitting record."""
        if look == ODD:
            search = self._search
            end = at + self._head.length
            if self._head.length <= _SMALL and end <= self._end and search.all_fit(end):
                return self._pass(at, is_steady=False)
            found = search.find(at + 1, end, self._steady_micros, is_inside=True)
            if found != NOWHERE:
                return self._skip(at, found)
            if end > self._end:
                return self._cut()
            if search.goes_on(end):
                return self._pass(at, is_steady=False)
        self._gap_from = at
        return at + 1

    def _read_cut(self, at: int) -> int:
        """Reads a record that contains the end of the file, or that has a damaged size."""
        found = self._search.find(at + 1, self._end, self._steady_micros, is_inside=True)
        return self._skip(at, found) if found != NOWHERE else self._cut()

    def _cut(self) -> int:
        self.is_cut = True
        return self._end

    def _skip(self, at: int, found: int) -> int:
        self._gap_from = at
        return self._end_gap(found)

    def _end_gap(self, found: int) -> int:
        self._sink.skipped(self._gap_from, found)
        self._gap_from = -1
        self._last_micros = math.nan
        return found


def header_end(data: bytes) -> int | None:
    """Where the records begin; None if the header is cut, or its size is impossible."""
    if len(data) < HEADER:
        return None
    size = int.from_bytes(data[HEADER - 4 : HEADER], "little")
    return None if size > min(MAX_PAYLOAD_BYTES, len(data) - HEADER) else HEADER + size

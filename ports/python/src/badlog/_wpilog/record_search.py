"""Distinguishes records from bytes that only look like them.

A WPILOG has neither checksums nor marks between its records. But each record names a started entry, has a size that fits its type, and a time near
the previous record's.
"""

from __future__ import annotations

import math
import re
from typing import Protocol

from badlog._wpilog.entry import Entry
from badlog._wpilog.record_head import CONTROL_HEAD, FITTING, MORE, NONE, ODD, RecordHead, control_texts

NOWHERE = -1
"""The result of `find` if records continue nowhere."""

# This many fitting records in a row are not a coincidence. Fewer are enough at the end of the file, or if they are very large.
_MIN_FITTING = 10
_MIN_AT_END = 3
_MIN_FAR = 5
# The number of them that must have types of a fixed size if the place may be inside a record.
_MIN_FIXED_SIZE = 2
# The number of odd ones that may be among them, in addition to one for each fitting one.
_MAX_ODD = 2
_GOES_ON = 4
_PATIENCE = 100
# The maximum number of bytes to look ahead.
_MAX_LOOKAHEAD = 1 << 20
# One minute: the maximum distance between the times of consecutive records.
NEAR_MICROS = 6e7
_TIGHT_MICROS = 1e5
# Two hours.
_FAR_MICROS = 7.2e9
_ZEROS = re.compile(rb"\0{3,}")


class StartedEntries(Protocol):
    """The known entries so far."""

    by_id: dict[int, Entry]
    """The entries that are started and not finished, by their ids."""

    def is_stranger(self, id: int) -> bool:
        """Whether more records of `id`, which is not an entry's id, are to be expected, because there were so many."""


class RecordSearch:
    """Recognizes the records of one file."""

    def __init__(self, data: bytes, entries: StartedEntries) -> None:
        self._data = data
        self._end = len(data)
        self._entries = entries
        self._head = RecordHead()

    def look(self, head: RecordHead, at: int, near: float) -> int:
        """Reads the bytes at `at` into `head`, and returns their look after a record at `near` µs. `near` is NaN if there was none."""
        possible = head.read(self._data, at, self._end)
        if possible != FITTING:
            return possible
        if head.id != 0:
            entry = head.entry = self._entries.by_id.get(head.id)
            is_expected = entry.fits(head.size) if entry is not None else self._entries.is_stranger(head.id)
            return FITTING if is_expected and not abs(head.micros - near) > NEAR_MICROS else ODD
        head.entry = None
        if head.size < CONTROL_HEAD:
            return NONE
        if head.length > self._end - at:
            return MORE
        end = at + head.length
        return FITTING if control_texts(self._data, end - head.size, end) is not None else ODD

    def find(self, start: int, end: int, near: float, is_inside: bool) -> int:
        """The first place from `start` and before `end` at which several fitting records in a row continue after damage. NOWHERE if
        there is none.

        `is_inside` says whether the place is inside bytes that may themselves be a record; the first records there must be of types with a fixed
        size.
        """
        data = self._data
        at = start
        end = min(end, self._end)
        while at < end:
            if data[at] == 0 and (zeros := _ZEROS.match(data, at)) is not None:
                # A control record without a payload does not exist.
                at = zeros.end() - 2
            elif self._may_begin(at) and self._row_at(at, near, is_inside):
                return at
            else:
                at += 1
        return NOWHERE

    def _may_begin(self, at: int) -> bool:
        """A quick check whether the record at `at` may fit."""
        bits = self._data[at]
        if bits & 0x80:
            return False
        id = int.from_bytes(self._data[at + 1 : at + 2 + (bits & 3)], "little")
        return id == 0 or id in self._entries.by_id or self._entries.is_stranger(id)

    def _row_at(self, start: int, near: float, is_inside: bool) -> bool:
        """Whether fitting records in a row begin at `start`, the first of them at a time consistent with the others."""
        head = self._head
        at = start
        fitting = 0
        odd = 0
        last = math.nan
        first_step = math.nan
        longest_step = _TIGHT_MICROS
        least = _MIN_FITTING
        while fitting < _MIN_FITTING:
            if at == self._end:
                least = _MIN_AT_END
                break
            if at - start > _MAX_LOOKAHEAD:
                least = _MIN_FAR
                break
            look = self.look(head, at, last)
            if look == NONE:
                return False
            if is_inside and fitting < _MIN_FIXED_SIZE and (look == ODD or (look == FITTING and not (head.id == 0 or head.has_one_size))):
                return False
            if look == MORE or head.length > _MAX_LOOKAHEAD or head.length > self._end - at:
                least = _MIN_FAR
                break
            if look == ODD:
                odd += 1
                if fitting == 0 or odd > _MAX_ODD + fitting:
                    return False
            else:
                # The lost part may have been minutes long, but no log continues hours later.
                if fitting == 0 and head.id != 0 and abs(head.micros - near) > _FAR_MICROS:
                    return False
                fitting += 1
            if head.id != 0:
                step = abs(head.micros - last)
                if math.isnan(first_step):
                    first_step = step
                elif step > longest_step:
                    longest_step = step
                last = head.micros
            at += head.length
        # Damage may look like a record and end where a real one begins, but hardly with its time.
        return fitting >= least and not first_step > longest_step

    def all_fit(self, start: int) -> bool:
        """Whether the next records from `start` on fit, so that the previous one certainly ends there."""
        head = self._head
        at = start
        last = math.nan
        for _ in range(_GOES_ON):
            if at == self._end:
                return True
            if self.look(head, at, last) != FITTING or head.length > _MAX_LOOKAHEAD or head.length > self._end - at:
                return False
            if head.id != 0:
                last = head.micros
            at += head.length
        return True

    def goes_on(self, start: int) -> bool:
        """Whether records continue at `start`, some of them odd, so that the odd one before them has its correct size."""
        head = self._head
        at = start
        fitting = 0
        odd = 0
        last = math.nan
        while fitting + odd < _PATIENCE:
            if at == self._end:
                return True
            if at - start > _MAX_LOOKAHEAD:
                break
            look = self.look(head, at, last)
            if look == NONE:
                return False
            if look == MORE:
                return True
            if look == FITTING:
                fitting += 1
            else:
                odd += 1
            if fitting >= _GOES_ON and fitting >= odd:
                break
            if head.length > self._end - at:
                return True
            if head.id != 0:
                last = head.micros
            at += head.length
        return fitting > 0 or odd == _PATIENCE

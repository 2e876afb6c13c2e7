"""Finds the cells of a row that is not plain, under several readings of its quotes."""

from __future__ import annotations

from enum import Enum

_QUOTE = 0x22
_COMMA = 0x2C


class Quotes(Enum):
    """The readings of quotes."""

    STRICT = 0
    """RFC 4180: a quote opens at a cell's start, closes at the next single quote; doubled ones stand for one."""
    LENIENT = 1
    """A quote opens at a cell's start and closes only before a comma or the end. The original never doubled quotes."""
    LITERAL = 2
    """A quote is a character like any other."""


class RowSplitter:
    """The cells that `split` found last: where they begin and end, without their quotes, and whether they had some."""

    def __init__(self) -> None:
        self.starts: list[int] = []
        self.ends: list[int] = []
        self.quoted: list[bool] = []
        self.is_open = False
        """Whether the bytes ended inside quotes."""
        self.is_malformed = False
        """Whether there was a quote where RFC 4180 allows none."""
        self._quotes = Quotes.STRICT

    @property
    def is_proper(self) -> bool:
        """Whether all quotes are as RFC 4180 has them."""
        return not self.is_open and not self.is_malformed

    def split(self, data: bytes, start: int, until: int, quotes: Quotes) -> int:
        """Splits the bytes, which have no line end outside quotes. Returns the number of cells."""
        self.starts = []
        self.ends = []
        self.quoted = []
        self.is_open = False
        self.is_malformed = False
        self._quotes = quotes
        return self._split_on(data, start, until)

    def extend(self, data: bytes, until: int) -> int:
        """Continues a row that ended in an open quote, as if `split` had read all of it. Returns the number of cells."""
        self.is_open = False
        self.quoted.pop()
        end = self._close_cell(data, self.starts.pop(), self.ends.pop(), until)
        return self._split_after(data, end, until)

    def _split_on(self, data: bytes, at: int, until: int) -> int:
        while True:
            if self._quotes is not Quotes.LITERAL and at < until and data[at] == _QUOTE:
                at = self._close_cell(data, at + 1, at + 1, until)
            else:
                at = self._plain_cell(data, at, until)
            if at >= until:
                return len(self.starts)
            at += 1
            if at == until:
                # A comma at the end: a cell follows it.
                self._add(at, at, False)
                return len(self.starts)

    def _split_after(self, data: bytes, end: int, until: int) -> int:
        """Splits the bytes after a cell that ends at `end`."""
        if end + 1 < until:
            return self._split_on(data, end + 1, until)
        if end + 1 == until:
            self._add(until, until, False)
        return len(self.starts)

    def _plain_cell(self, data: bytes, start: int, until: int) -> int:
        end = data.find(b",", start, until)
        if end < 0:
            end = until
        if data.find(b'"', start, end) >= 0:
            self.is_malformed = True
        self._add(start, end, False)
        return end

    def _close_cell(self, data: bytes, start: int, at: int, until: int) -> int:
        """Searches from `at` on for the end of the quoted cell that begins at `start`. Returns where its quotes end."""
        at = data.find(b'"', at, until)
        while at >= 0:
            following = data[at + 1] if at + 1 < until else _COMMA
            if following == _COMMA:
                self._add(start, at, True)
                return at + 1
            if following == _QUOTE and self._quotes is Quotes.STRICT:
                at += 1
            else:
                self.is_malformed = True
            at = data.find(b'"', at + 1, until)
        self.is_open = True
        self._add(start, until, True)
        return until

    def merge_torn_quotes(self, data: bytes, wanted: int) -> int:
        """Joins cells that were split at a quote and a comma inside one text, as in `"he said "a", ok"`.

        A cell that ends in a quote without having begun with one belongs to the quoted cell before it. Stops at `wanted` cells; returns the number of
        cells.
        """
        i = 1
        while i < len(self.starts) > wanted:
            is_torn_off = not self.quoted[i] and self.ends[i] > self.starts[i] and data[self.ends[i] - 1] == _QUOTE
            opening = self._quoted_before(i) if is_torn_off else -1
            if opening >= 0 and len(self.starts) - (i - opening) >= wanted:
                self.ends[opening] = self.ends[i] - 1
                gone = slice(opening + 1, i + 1)
                del self.starts[gone], self.ends[gone], self.quoted[gone]
                i = opening + 1
            else:
                i += 1
        return len(self.starts)

    def _quoted_before(self, cell: int) -> int:
        i = cell - 1
        while i >= 0 and not self.quoted[i]:
            i -= 1
        return i

    def _add(self, start: int, end: int, is_quoted: bool) -> None:
        self.starts.append(start)
        self.ends.append(end)
        self.quoted.append(is_quoted)

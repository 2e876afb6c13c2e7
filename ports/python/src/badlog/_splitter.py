"""Finds the cells of a row that is not plain, under several readings of its quotes."""

from __future__ import annotations

from enum import Enum

_QUOTE = 0x22
_COMMA = 0x2C


class Quotes(Enum):
    """How to read quotes."""

    STRICT = 0
    """RFC 4180: a quote opens at a cell's start, closes at the next single quote; doubled ones stand for one."""
    LENIENT = 1
    """A quote opens at a cell's start and closes only before a comma or the end: the original never doubled them."""
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
        """Whether a quote stood where RFC 4180 has none."""

    @property
    def is_proper(self) -> bool:
        """Whether all quotes are as RFC 4180 has them."""
        return not self.is_open and not self.is_malformed

    def split(self, data: bytes, start: int, until: int, quotes: Quotes) -> int:
        """Splits the bytes, which hold no line end outside quotes; returns how many cells."""
        self.starts = []
        self.ends = []
        self.quoted = []
        self.is_open = False
        self.is_malformed = False
        at = start
        while True:
            if quotes is not Quotes.LITERAL and at < until and data[at] == _QUOTE:
                at = self._quoted_cell(data, at, until, quotes)
            else:
                at = self._plain_cell(data, at, until)
            if at >= until:
                break
            at += 1
            if at == until:
                self._add(at, at, False)
                break
        return len(self.starts)

    def _plain_cell(self, data: bytes, start: int, until: int) -> int:
        end = data.find(b",", start, until)
        if end < 0:
            end = until
        if data.find(b'"', start, end) >= 0:
            self.is_malformed = True
        self._add(start, end, False)
        return end

    def _quoted_cell(self, data: bytes, start: int, until: int, quotes: Quotes) -> int:
        at = data.find(b'"', start + 1, until)
        while at >= 0:
            following = data[at + 1] if at + 1 < until else _COMMA
            if following == _COMMA:
                self._add(start + 1, at, True)
                return at + 1
            if following == _QUOTE and quotes is Quotes.STRICT:
                at += 1
            else:
                self.is_malformed = True
            at = data.find(b'"', at + 1, until)
        self.is_open = True
        self._add(start + 1, until, True)
        return until

    def merge_torn_quotes(self, data: bytes, wanted: int) -> int:
        """Joins cells that a quote and a comma inside one text took apart, as in `"he said "a", ok"`.

        A cell that ends in a quote without having begun with one belongs to the quoted cell before it. Stops at `wanted` cells;
        returns how many there are now.
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

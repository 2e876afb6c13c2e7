"""The first lines from the titles on: the rows show whether a line of titles is damaged or merely unusual."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass

from badlog import _cell
from badlog._cursor import Cursor, after_line_end, line_end_in
from badlog._splitter import Quotes, RowSplitter

_ROWS = 20  # the number of rows that are examined
_MAX_BYTES = 1 << 20
_CLEARLY = 3

# Among random bytes, every ninth is a control character. In a text with a few damaged places, fewer than one in this many.
_MIN_TEXT = 20
_MIN_CONTROLS = 16

_CONTROLS = bytes(byte for byte in range(1, 32) if byte not in b"\t\n\r")
_CONTROL = re.compile(rb"[\x01-\x08\x0a-\x1f]")


def has_controls(line: bytes) -> bool:
    """Whether there are bytes that do not occur in text."""
    return _CONTROL.search(line) is not None


@dataclass(frozen=True)
class FirstLine:
    """A line without its end."""

    start: int
    end: int
    following: int
    """Where the next line begins."""
    cells: int
    """The number of its cells; 0 if its quotes or bytes cannot be in a row."""
    numbers: int
    """The number of cells with a number, `true` or `false`."""
    texts: int

    @property
    def is_titles(self) -> bool:
        """Whether it is a line of titles rather than a row: all of its cells are texts."""
        return self.texts == self.cells


class FirstLines:
    """The titles, which are at the cursor, and the examined lines after them."""

    def __init__(self, cursor: Cursor) -> None:
        self.lines: list[FirstLine] = []
        self._splitter = RowSplitter()
        data = cursor.data
        limit = min(cursor.end, cursor.start + _MAX_BYTES)
        at = cursor.start
        rows = 0
        while rows <= _ROWS:
            end = line_end_in(data, at, limit)
            if end == limit:
                # The end of the file ends a line; a line that is too long to examine does not count.
                break
            following = after_line_end(data, end)
            if end > at:
                line = self._line_of(data, at, end, following)
                self.lines.append(line)
                if line.cells > 0:
                    rows += 1
            # After a line that ends at a NUL, go on from that NUL.
            at = end + 1 if following == end else following
        looked_at = data[cursor.start : at]
        controls = len(looked_at) - len(looked_at.translate(None, _CONTROLS))
        self.is_binary = controls >= _MIN_CONTROLS and controls * _MIN_TEXT > len(looked_at)
        """Whether the bytes are a picture, an archive or a program: even a damaged log has more text than those."""
        self.width = 0
        """The number of cells that most of the lines after the titles have; 0 if that is not clear."""
        self.has_rows = False
        """Whether there are rows with numbers among them."""
        self._find_width()

    def rows_of(self, width: int) -> int:
        """The number of lines after the first that have that many cells."""
        return sum(line.cells == width for line in self.lines[1:])

    def _line_of(self, data: bytes, start: int, end: int, following: int) -> FirstLine:
        splitter = self._splitter
        count = splitter.split(data, start, end, Quotes.STRICT)
        is_row = splitter.is_proper and not has_controls(data[start:end])
        kinds = Counter(_cell.read_cell(data[splitter.starts[i] : splitter.ends[i]])[0] for i in range(count))
        texts = kinds[_cell.TEXT]
        return FirstLine(start, end, following, count if is_row else 0, count - kinds[_cell.EMPTY] - texts, texts)

    def _find_width(self) -> None:
        full = [line for line in self.lines[1:] if line.cells > 0]
        # A piece of the titles, split off by damage, has no numbers.
        rows = [line for line in full if line.numbers > 0] or full
        counts = Counter(line.cells for line in rows)
        if counts:
            best = max(counts, key=lambda cells: (counts[cells], cells))
            own = counts[self.lines[0].cells]
            self.width = self.lines[0].cells if own * _CLEARLY >= counts[best] else best
        numeric = sum(line.cells == self.width and line.numbers > 0 for line in rows)
        enough = min(2, len(self.lines) - 1)
        self.has_rows = self.width > 0 and numeric >= enough and (self.width > 1 or numeric * 2 >= len(self.lines))

"""Reads the rows that are not plain: quoted, cut, split, too short or too long ones.

A line that is a complete row by itself is never merged into a damaged one before it.
"""

from __future__ import annotations

import re

from badlog import _cell
from badlog._cell import Cell, read_cell, read_decimal_comma
from badlog._column import Column
from badlog._cursor import Cursor, after_line_end, line_end_in
from badlog._splitter import Quotes, RowSplitter
from badlog._text import excerpt, is_letter_or_digit
from badlog.problem import ProblemKind, ProblemList

# For a damaged row the reader may look ahead, but never further than this.
_MAX_LINES = 100
_MAX_BYTES = 1 << 16
_QUOTED_BYTES = 200
_NUMBER_WITH_POINT = re.compile(rb"[0-9]+\.[0-9]*")


class RowRepair:
    """Reads one row after another from the cursor.

    `ends_in_newline` says that every whole row of this file ends in a newline, as a bag's does, so that a last row without one is cut.
    """

    def __init__(self, cursor: Cursor, columns: list[Column], problems: ProblemList, ends_in_newline: bool) -> None:
        self._cursor = cursor
        self._columns = columns
        self._wanted = len(columns)
        self._problems = problems
        self._ends_in_newline = ends_in_newline
        self._splitter = RowSplitter()
        self._numbers_before: list[bool] = []
        self._end_in_sight = _end_in_sight(cursor.data)
        self.row: list[Cell] | None = None
        """The row that the last call of `repair` found, or None."""
        self.lines_passed = 0
        """The number of physical lines that this call read."""

    def repair(self, row: int) -> int:
        """Reads from the cursor, the start of a line, on, after `row` rows; returns where the next row begins."""
        cursor = self._cursor
        data = cursor.data
        start = cursor.start
        self.row = None
        self.lines_passed = 1
        end = line_end_in(data, start, cursor.end)
        if end == cursor.end:
            return self._tail(start, cursor.end, self._ends_in_newline)
        if data[end] == 0:
            if end > start:
                self._tail(start, end, True)
            self.lines_passed = 0
            return end
        following = after_line_end(data, end)
        if end == start:
            self.lines_passed = 0
            return cursor.pass_blank_lines(end, following, self._problems)
        splitter = self._splitter
        count = splitter.split(data, start, end, Quotes.STRICT)
        if splitter.is_proper and count == self._wanted:
            return self._take(True, following)
        if splitter.is_open and not splitter.is_malformed:
            before = min(count - 1, self._wanted)
            self._numbers_before = [self._kind_of(i) == _cell.NUMBER for i in range(before)]
            after = self._quoted_lines(start, following)
            if after is not None:
                return after
        if self._read_with_odd_quotes(start, end, may_be_open=True):
            return self._take(False, following)
        if cursor.is_after_hole:
            # The bytes between a hole and the next newline would be a whole row only by chance.
            message = f"The end of a row whose beginning is lost was dropped; it held {self._quotation(start, end)}."
            self._problems.add(ProblemKind.ROW_CUT, message, cursor.line)
            return following
        after = self._joined_lines(start, end, following)
        if after is not None:
            return after
        if self._continues_text(start, end, row - 1):
            return following
        return self._take_uneven(start, end, following)

    def _quoted_lines(self, start: int, second_line: int) -> int | None:
        """Reads a row with newlines inside a quoted cell, as RFC 4180 allows; returns None if it is not one."""
        cursor = self._cursor
        data = cursor.data
        at = second_line
        holds_rows = False
        # The row, which grows by a line at a time; the other splitter looks at each line by itself.
        whole = RowSplitter()
        whole.split(data, start, line_end_in(data, start, second_line), Quotes.STRICT)
        for lines in range(2, _MAX_LINES + 1):
            end = line_end_in(data, at, cursor.end)
            if end - start > _MAX_BYTES:
                return None
            # With one topic, every line is a row.
            if at < end and (self._wanted == 1 or self._is_complete_row(at, end)):
                if self._wanted > 1 and self._has_same_numbers():
                    return None
                holds_rows = True
            if end == cursor.end:
                return None if holds_rows else self._tail(start, end, self._ends_in_newline)
            if data[end] == 0:
                return None
            count = whole.extend(data, end)
            following = after_line_end(data, end)
            if not whole.is_open:
                if whole.is_malformed or count != self._wanted:
                    return None
                self.lines_passed = lines
                self._splitter = whole
                return self._take(True, following)
            if whole.is_malformed and start < self._end_in_sight:
                # It stays open, and the end of the file is too far away to have cut it.
                return None
            at = following
        return None

    def _has_same_numbers(self) -> bool:
        # A line of a quoted text may have as many cells as a row. It seldom has a number wherever the row has one.
        return not any(is_number and self._kind_of(i) == _cell.TEXT for i, is_number in enumerate(self._numbers_before))

    def _kind_of(self, i: int) -> int:
        return read_cell(self._cursor.data[self._splitter.starts[i] : self._splitter.ends[i]])[0]

    def _read_with_odd_quotes(self, start: int, end: int, may_be_open: bool) -> bool:
        """Tries readings of quotes that were never escaped, until one gives the row its right number of cells.

        `may_be_open` says whether a quote that nothing closes may be a character like any other.
        """
        splitter = self._splitter
        data = self._cursor.data
        wanted = self._wanted
        fits = (
            (splitter.split(data, start, end, Quotes.LENIENT) == wanted and not splitter.is_open)
            or (splitter.merge_torn_quotes(data, wanted) == wanted and not splitter.is_open)
            or (may_be_open and splitter.split(data, start, end, Quotes.LITERAL) == wanted)
            or (may_be_open and splitter.split(data, start, end, Quotes.LENIENT) == wanted)
        )
        if fits:
            message = "A cell has unescaped quotes; the row was split to match the number of titles."
            self._problems.add(ProblemKind.QUOTES_REPAIRED, message, self._cursor.line)
        return fits

    def _joined_lines(self, start: int, newline: int, second_line: int) -> int | None:
        """Joins a text cell that a raw newline has split. The pieces belong together if they then have the right number of cells."""
        cursor = self._cursor
        data = cursor.data
        splitter = self._splitter
        at = second_line
        # Without quotes, counting commas gives the number of cells, so nothing has to be split repeatedly.
        commas = data.count(b",", start, newline)
        quotes = data.count(b'"', start, newline)
        for lines in range(2, _MAX_LINES + 1):
            end = line_end_in(data, at, cursor.end)
            if end - start > _MAX_BYTES or at == cursor.end or (end < cursor.end and data[end] == 0):
                return None
            if self._is_complete_row(at, end):
                return None
            commas += data.count(b",", at, end)
            quotes += data.count(b'"', at, end)
            count = commas + 1
            if quotes > 0 or count >= self._wanted:
                count = splitter.split(data, start, end, Quotes.LENIENT)
                if count > self._wanted or splitter.is_open:
                    return None
            after = after_line_end(data, end)
            if count == self._wanted:
                if not self._is_text_torn_at(newline, second_line):
                    return None
                self.lines_passed = lines
                message = f"A newline in a text split the row into {lines} lines; they were joined."
                self._problems.add(ProblemKind.LINES_JOINED, message, cursor.line)
                self._take(False, after)
                if end == cursor.end and self._ends_in_newline:
                    self._drop_last_cell()
                return after
            at = after
        return None

    def _continues_text(self, start: int, end: int, row: int) -> bool:
        """Handles a piece of the last topic's text that a raw newline split off. It is a line of one text, where a number should be."""
        piece = self._cursor.data[start:end]
        is_piece = (
            self._wanted > 1
            and self._columns[0].first_text is None
            and b"," not in piece
            and not _is_end_of_row(piece)
            and read_cell(piece)[0] == _cell.TEXT
            and self._columns[-1].extend_text(row, piece, _MAX_BYTES)
        )
        if is_piece:
            self._problems.add(ProblemKind.LINES_JOINED, "A line of text was joined to the text in the row above it.", self._cursor.line)
        return is_piece

    def _is_text_torn_at(self, newline: int, following: int) -> bool:
        # Two short rows of numbers could also be joined, but a newline is never inside a number.
        data = self._cursor.data
        for start, end in zip(self._splitter.starts, self._splitter.ends):
            if start <= newline <= end:
                rest = min(following, end)
                pieces = (data[start:newline], data[rest : line_end_in(data, rest, end)])
                return any(read_cell(piece)[0] == _cell.TEXT for piece in pieces)
        return False

    def _is_complete_row(self, start: int, until: int) -> bool:
        return (
            self._wanted > 1
            and self._splitter.split(self._cursor.data, start, until, Quotes.STRICT) == self._wanted
            and self._splitter.is_proper
        )

    def _take_uneven(self, start: int, end: int, following: int) -> int:
        """Takes a row with too few or too many cells in every reading."""
        data = self._cursor.data
        splitter = self._splitter
        count = splitter.split(data, start, end, Quotes.STRICT)
        is_strict = splitter.is_proper
        if not is_strict:
            count = splitter.split(data, start, end, Quotes.LENIENT)
        wanted = self._wanted
        if count < wanted:
            message = f"A row has {count} of {wanted} cells; the missing ones were left empty."
            self._problems.add(ProblemKind.ROW_SHORT, message, self._cursor.line)
        else:
            extra = self._quotation(splitter.starts[wanted] if count > wanted else end, end)
            message = f"A row has {count} cells instead of {wanted}; the extra ones were dropped: {extra}."
            self._problems.add(ProblemKind.ROW_LONG, message, self._cursor.line)
        return self._take(is_strict, following, count)

    def _tail(self, start: int, until: int, is_cut: bool) -> int:
        """Reads a row without a newline, at the end of the file or before a hole.

        `is_cut` says whether a missing newline means that bytes are missing.
        """
        self.lines_passed = 1
        splitter = self._splitter
        count = splitter.split(self._cursor.data, start, until, Quotes.STRICT)
        is_open = splitter.is_open
        is_strict = not splitter.is_malformed
        if not is_strict:
            if self._read_with_odd_quotes(start, until, may_be_open=False):
                self._take(False, until)
                if is_cut:
                    self._drop_last_cell()
                return until
            # As in core, the last reading decides.
            is_open = splitter.is_open
        if is_open or count < self._wanted:
            message = f"A row is cut off after {count} of {self._wanted} cells and was dropped; it held {self._quotation(start, until)}."
            self._problems.add(ProblemKind.ROW_CUT, message, self._cursor.line)
            return until
        if not is_strict or count > self._wanted:
            return self._take_uneven(start, until, until)
        self._take(True, until)
        if is_cut:
            self._drop_last_cell()
        return until

    def _drop_last_cell(self) -> None:
        assert self.row is not None
        self.row[-1] = _cell.NO_CELL
        held = self._quotation(self._splitter.starts[self._wanted - 1], self._splitter.ends[self._wanted - 1])
        message = f"The last row lacks its newline, so its last cell may be cut and was left empty; it held {held}."
        self._problems.add(ProblemKind.LAST_CELL_CUT, message, self._cursor.line, self._columns[-1].name)

    def _take(self, undouble: bool, following: int, count: int | None = None) -> int:
        """Makes a row of the cells that the splitter found. Missing cells are empty, and extra ones are dropped."""
        found = self._wanted if count is None else min(count, self._wanted)
        self.row = [self._cell(i, undouble) for i in range(found)] + [_cell.NO_CELL] * (self._wanted - found)
        return following

    def _cell(self, i: int, undouble: bool) -> Cell:
        held = self._cursor.data[self._splitter.starts[i] : self._splitter.ends[i]]
        is_quoted = self._splitter.quoted[i]
        if is_quoted and self._columns[i].reads_decimal_comma:
            with_comma = read_decimal_comma(held)
            if with_comma is not None:
                return _cell.DECIMAL_COMMA, with_comma, b""
        kind, number = read_cell(held)
        if kind != _cell.TEXT:
            return kind, number, b""
        return kind, number, held.replace(b'""', b'"') if undouble and is_quoted else held

    def _quotation(self, start: int, until: int) -> str:
        return f"“{excerpt(self._cursor.data[start:until], _QUOTED_BYTES)}”"


def _end_in_sight(data: bytes) -> int:
    """The place from which looking ahead may reach the end of the file."""
    at = len(data)
    for _ in range(_MAX_LINES + 2):
        at = data.rfind(b"\n", 0, at)
        if at < 0:
            return 0
    return max(at, len(data) - _MAX_BYTES)


def _is_end_of_row(piece: bytes) -> bool:
    """Whether it is a number directly followed by letters: damage left only the x and the end of this row."""
    number = _NUMBER_WITH_POINT.match(piece)
    if number is None or number.end() == len(piece):
        return False
    byte = piece[number.end()]
    # Like core, which reads bytes beyond ASCII as signed ones.
    return is_letter_or_digit(chr(byte if byte < 0x80 else 0xFF00 | byte))

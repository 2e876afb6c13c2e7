"""Reads the rows into columns: many plain ones at a time, all others one by one."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from badlog._column import Column
from badlog._cursor import Cursor, line_end_in
from badlog._repair import RowRepair
from badlog.problem import ProblemKind, ProblemList

if TYPE_CHECKING:
    from badlog._arrow_rows import ArrowRows

_MAX_ROW_BYTES = 1 << 24
_PLAIN_BYTES = 1 << 18
_ARROW_BYTES = 1 << 25

# Below this size, Arrow takes longer to start than to read.
_MIN_ARROW_BYTES = 1 << 16

_LONE_CR = re.compile(rb"\r(?!\n)")
# A quoted cell of one line after its first quote, by RFC 4180.
_QUOTED_REST = re.compile(rb'[^"\n\r\x00]*(?:""[^"\n\r\x00]*)*"(?=[,\r\n])')


class RowReader:
    """Reads rows from the cursor; the caller skips NULs between them."""

    def __init__(
        self,
        cursor: Cursor,
        columns: list[Column],
        problems: ProblemList,
        ends_in_newline: bool,
        max_rows: int,
        arrow: ArrowRows | None,
    ) -> None:
        self._cursor = cursor
        self._columns = columns
        self._problems = problems
        self._max_rows = max_rows
        self._arrow = arrow if len(columns) > 1 else None
        self._repair = RowRepair(cursor, columns, problems, ends_in_newline)
        # The next place of each kind of byte that no plain row has; searched again when it is passed.
        self._next_odd = {"nul": -1, "cr": -1, "quote": -1}
        # The lines with a wrong number of commas in the searched part, the next one last.
        self._uneven: list[int] = []
        # Before this place, Arrow has failed although every line seems plain.
        self._arrow_from = 0
        self.row_count = 0
        self.gave_up = False
        """Whether reading stopped because the bytes that follow are not rows at all."""

    def read(self) -> int:
        """Reads the next rows. Returns where the rows after them begin."""
        cursor = self._cursor
        if self.row_count >= self._max_rows:
            message = f"The log has more than {self._max_rows} rows; the rest was not read. Pass max_rows to read more."
            return self._give_up(ProblemKind.TOO_MANY_ROWS, message)
        start = cursor.start
        if start + _MAX_ROW_BYTES < cursor.end and line_end_in(cursor.data, start, start + _MAX_ROW_BYTES) == start + _MAX_ROW_BYTES:
            message = f"A line of more than {_MAX_ROW_BYTES} bytes is not a row of samples; the rest of the file was not read."
            return self._give_up(ProblemKind.ROW_CUT, message)
        following = self._read_plain(start, self._plain_until(start))
        if following > start:
            return following
        following = self._repair.repair(self.row_count)
        if self._repair.row is not None:
            for column, cell in zip(self._columns, self._repair.row):
                column.add_cell(self.row_count, cell, cursor.line)
            self.row_count += 1
        cursor.line += self._repair.lines_passed
        return following

    def _give_up(self, kind: ProblemKind, message: str) -> int:
        self.gave_up = True
        self._problems.add(kind, message, self._cursor.line)
        return self._cursor.end

    def _plain_until(self, start: int) -> int:
        """The end of the last line from `start` on before a byte that no plain row has, or `start`."""
        data = self._cursor.data
        odd = self._next_odd
        if odd["nul"] < start:
            odd["nul"] = _or_end(data.find(b"\0", start), data)
        if odd["cr"] < start:
            first = data.find(b"\r", start)
            lone = _LONE_CR.search(data, first) if first >= 0 else None
            odd["cr"] = len(data) if lone is None else lone.start()
        if odd["quote"] < start:
            odd["quote"] = self._next_odd_quote(start)
        while self._uneven and self._uneven[-1] < start:
            self._uneven.pop()
        until = min(*odd.values(), self._uneven[-1] if self._uneven else len(data))
        return data.rfind(b"\n", start, until) + 1 or start

    def _next_odd_quote(self, start: int) -> int:
        """The next quote; where Arrow reads, the next one that is not part of a properly quoted cell."""
        data = self._cursor.data
        at = data.find(b'"', start)
        while at >= 0 and self._arrow is not None and (at == start or data[at - 1] in b",\n"):
            cell = _QUOTED_REST.match(data, at + 1)
            if cell is None:
                break
            at = data.find(b'"', cell.end())
        return _or_end(at, data)

    def _read_plain(self, start: int, until: int) -> int:
        """Reads lines that are rows unless they have too few or too many commas; returns where it stopped."""
        data = self._cursor.data
        at = start
        while at < until and self.row_count < self._max_rows:
            arrow = self._arrow
            if arrow is not None and at >= self._arrow_from and until - at >= _MIN_ARROW_BYTES:
                end = _whole_lines(data, at, until, _ARROW_BYTES)
                rows = data.count(b"\n", at, end)
                if self.row_count + rows <= self._max_rows:
                    if arrow.read(data, at, end, rows, self.row_count, self._cursor.line):
                        self._pass(at, end, rows)
                        at = end
                        continue
                    self._find_uneven(at, end)
                    self._arrow_from = end
                    if self._uneven:
                        # Arrow reads the lines between such lines.
                        self._arrow_from = at
                        until = min(until, self._uneven[-1])
                        continue
            end = _whole_lines(data, at, until, _PLAIN_BYTES)
            following = self._read_block(at, end)
            if following == at:
                break
            at = following
            if at < end:
                break
        return at

    def _find_uneven(self, start: int, until: int) -> None:
        wanted = len(self._columns) - 1
        found = []
        at = start
        for line in self._cursor.data[start:until].split(b"\n")[:-1]:
            if line.count(b",") != wanted or line in (b"", b"\r"):
                found.append(at)
            at += len(line) + 1
        self._uneven = found[::-1]

    def _read_block(self, start: int, until: int) -> int:
        """Reads the lines without Arrow."""
        block = self._cursor.data[start:until]
        quote = block.find(b'"')
        if quote >= 0:
            block = block[: block.rfind(b"\n", 0, quote) + 1]
        width = len(self._columns)
        lines = block.split(b"\n")[: self._max_rows - self.row_count]
        if not lines[-1]:
            lines.pop()
        rows = 0
        for line in lines:
            if line.count(b",") != width - 1 or line in (b"", b"\r") or len(line) > _MAX_ROW_BYTES:
                break
            rows += 1
        end = start + sum(map(len, lines[:rows])) + rows
        if rows < len(lines) and not self._uneven:
            # There may be more, and the whole block must not be searched for each of them.
            self._find_uneven(end, start + len(block))
        if rows == 0:
            return start
        cells = b",".join([line[:-1] if line.endswith(b"\r") else line for line in lines[:rows]]).split(b",")
        for i, column in enumerate(self._columns):
            column.add_cells(self.row_count, cells[i::width], self._cursor.line)
        self._pass(start, end, rows)
        return end

    def _pass(self, start: int, until: int, rows: int) -> None:
        cursor = self._cursor
        self.row_count += rows
        cursor.line += rows
        if cursor.data.find(b"\r", start, until) >= 0:
            cursor.saw_carriage_return = True


def _or_end(place: int, data: bytes) -> int:
    return len(data) if place < 0 else place


def _whole_lines(data: bytes, start: int, until: int, most: int) -> int:
    """The end of the last line that is within `most` bytes, or of the first line if that is longer."""
    if until - start <= most:
        return until
    end = data.rfind(b"\n", start, start + most) + 1
    return end if end > start else data.index(b"\n", start, until) + 1

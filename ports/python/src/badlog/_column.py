"""One column while its file is read: its numbers, its texts, and counts of oddities."""

from __future__ import annotations

import math
from array import array

from badlog import _cell
from badlog._cell import Cell, read_cell
from badlog._samples import Samples, no_samples
from badlog._text import decode, excerpt
from badlog.problem import ProblemKind, ProblemList
from badlog.recording import CellCounts, Topic, TopicKind

_NUMERIC = b"0123456789.+-eE"
_QUOTED_BYTES = 60


class Column:
    """A column that takes cells row by row, or many at a time."""

    def __init__(self, name: str, unit: str, attributes: tuple[str, ...]) -> None:
        self.name = name
        self._unit = unit
        self._attributes = attributes
        self.reads_decimal_comma = "log" not in attributes
        """False for a topic of texts, in which `1,5` may be meant literally."""
        self.samples = Samples()
        self.text_rows = array("q")
        self.text_ids = array("q")
        self.dictionary: list[str] = []
        self._encoded: list[bytes] = []
        self._ids: dict[bytes, int] = {}
        self._written_nans: list[int] = []
        self.first_text: str | None = None
        """The first text, in the form for a message."""
        self._first_text_line = 0
        self._last_text_size = 0
        self._is_last_text_new = False
        self._not_utf8_line = 0
        self._first_decimal_comma_line = 0
        self._decimal_commas = 0
        self._not_finite = 0
        self._truth_values = 0
        self._empty = 0
        self._gaps = 0
        self._last_gap_row = -2

    def add_cell(self, row: int, cell: Cell, line: int) -> None:
        """Adds the cell in `row`, which is on `line`."""
        kind, number, text = cell
        if kind == _cell.TEXT:
            self.samples.add(math.nan)
            self.add_gaps(row, row, 1)
            self.add_text(row, text, line)
            return
        self.samples.add(number)
        if kind == _cell.EMPTY:
            self._empty += 1
            self.add_gaps(row, row, 1)
        elif kind != _cell.NUMBER:
            self.add_odd_number(row, kind, number, line)

    def add_cells(self, row: int, cells: list[bytes], line: int) -> None:
        """Adds the cells of neighboring rows, one per line; none of them was in quotes."""
        if not b"".join(cells).translate(None, _NUMERIC):
            try:
                numbers = array("d", map(float, cells))
            except ValueError:
                numbers = array("d")
            if numbers and math.isfinite(sum(numbers)):
                self.samples.extend(numbers)
                return
        for i, cell in enumerate(cells):
            kind, number = read_cell(cell)
            self.add_cell(row + i, (kind, number, cell), line + i)

    def add_empty(self, count: int) -> None:
        """Counts empty cells; their numbers and gaps are added separately."""
        self._empty += count

    def add_gaps(self, first_row: int, last_row: int, runs: int) -> None:
        """Counts `runs` runs of neighboring rows without a number; the first one begins in `first_row`."""
        self._gaps += runs - (first_row == self._last_gap_row + 1)
        self._last_gap_row = last_row

    def add_odd_number(self, row: int, kind: int, number: float, line: int) -> None:
        """Counts a cell with a number in an unusual form; the number itself is added separately."""
        if kind == _cell.NOT_FINITE:
            self._not_finite += 1
            if math.isnan(number):
                self._written_nans.append(row)
        elif kind == _cell.TRUTH_VALUE:
            self._truth_values += 1
        elif kind == _cell.DECIMAL_COMMA:
            if self._decimal_commas == 0:
                self._first_decimal_comma_line = line
            self._decimal_commas += 1

    def add_truth_values(self, count: int) -> None:
        """Counts cells that are true or false."""
        self._truth_values += count

    def id_of(self, text: bytes, line: int) -> int:
        """The id of that text, which is on `line`."""
        known = self._ids.get(text)
        self._is_last_text_new = known is None
        if known is not None:
            return known
        decoded, was_not_utf8 = decode(text)
        if was_not_utf8 and self._not_utf8_line == 0:
            self._not_utf8_line = line
        return self._new_id(text, decoded)

    def _new_id(self, text: bytes, decoded: str) -> int:
        self._ids[text] = len(self.dictionary)
        self.dictionary.append(decoded)
        self._encoded.append(text)
        return len(self.dictionary) - 1

    def add_text(self, row: int, text: bytes, line: int) -> None:
        """Adds the text in `row`; its gap is added separately."""
        self.text_ids.append(self.id_of(text, line))
        self.text_rows.append(row)
        self.mark_text(text, text, line)

    def mark_text(self, first: bytes, last: bytes, line: int) -> None:
        """Remembers the last text, and the first one if there was none before."""
        self._last_text_size = len(last)
        if self.first_text is None:
            self.first_text = excerpt(first, _QUOTED_BYTES)
            self._first_text_line = line

    def extend_text(self, row: int, more: bytes, longest: int) -> bool:
        """Adds a line to the text in `row`, the last one.

        Returns False if that cell is not text, or would become longer than `longest` bytes.
        """
        size = self._last_text_size + 1 + len(more)
        if not self.text_rows or self.text_rows[-1] != row or size > longest:
            return False
        self._last_text_size = size
        id = self.text_ids[-1]
        text = self._encoded[id] + b"\n" + more
        if self._is_last_text_new:
            self.dictionary.pop()
            del self._ids[self._encoded.pop()]
        known = self._ids.get(text)
        self._is_last_text_new = known is None
        self.text_ids[-1] = self._new_id(text, decode(text)[0]) if known is None else known
        return True

    def topic(self, rows: int, problems: ProblemList) -> Topic:
        """Returns the topic made of all rows, and reports the column's oddities. Call it once, last."""
        texts = len(self.text_rows)
        numeric = rows - texts - self._empty
        counts = CellCounts(
            numbers=numeric - self._not_finite - self._truth_values,
            not_finite=self._not_finite,
            truth_values=self._truth_values,
            texts=texts,
            empty=self._empty,
            gaps=self._gaps,
        )
        samples = self.samples if rows > 0 else no_samples(0)
        topic = Topic(
            self.name, self._unit, self._attributes, counts, samples, self.text_rows, self.text_ids, self.dictionary, self._written_nans
        )
        self._report(topic, problems)
        return topic

    def _report(self, topic: Topic, problems: ProblemList) -> None:
        name = self.name
        counts = topic.counts
        if self._not_utf8_line > 0:
            message = f"Texts in “{name}” are not UTF-8; they were read as Windows-1252."
            problems.add(ProblemKind.NOT_UTF8, message, self._not_utf8_line, name)
        if self._decimal_commas > 0:
            message = f"Numbers in “{name}” have a decimal comma; it was read as a point."
            problems.add(ProblemKind.DECIMAL_COMMA, message, self._first_decimal_comma_line, name, self._decimal_commas)
        if counts.not_finite > 0:
            message = f"“{name}” is NaN or infinite in {counts.not_finite} of {counts.total} cells; these are kept, and drawn as gaps."
            problems.add(ProblemKind.NOT_FINITE, message, None, name, counts.not_finite)
        if counts.truth_values > 0:
            message = f"“{name}” holds true and false; they were read as 1 and 0."
            problems.add(ProblemKind.TRUTH_VALUES, message, None, name, counts.truth_values)
        if topic.kind not in (TopicKind.NUMERIC, TopicKind.BOOLEAN):
            return
        if counts.texts > 0 and self.reads_decimal_comma:
            message = f"“{name}” has text, such as “{self.first_text}”, in {counts.texts} of {counts.total} cells; these are gaps."
            problems.add(ProblemKind.TEXT_IN_NUMBERS, message, self._first_text_line, name, counts.texts)
        if counts.empty > 0 and not topic.is_sparse:
            message = f"“{name}” is empty in {counts.empty} of {counts.total} cells."
            problems.add(ProblemKind.EMPTY_CELLS, message, None, name, counts.empty)

"""Makes a recording from the bytes of a bag or a CSV file, by the rules of `docs/bag-format.md`. Never raises because of the bytes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from badlog._column import Column
from badlog._cursor import Cursor
from badlog._header_reader import NOT_A_LOG, HeaderReader
from badlog._rows import RowReader
from badlog._titles import HeaderColumns
from badlog.problem import ProblemKind, ProblemList
from badlog.recording import UNITLESS, Recording, RecordingFormat, Topic, TopicKind

if TYPE_CHECKING:
    from badlog._arrow_rows import ArrowRows


def parse(data: bytes, max_rows: int, uses_arrow: bool) -> Recording:
    """The recording of a file that holds `data`, inflated."""
    return _BagParser(data, max_rows, uses_arrow).recording()


class _BagParser:
    def __init__(self, data: bytes, max_rows: int, uses_arrow: bool) -> None:
        self._cursor = Cursor(data)
        self._problems = ProblemList()
        self._header = HeaderReader(self._cursor, self._problems)
        self._max_rows = max_rows
        self._uses_arrow = uses_arrow
        self._columns: list[Column] = []
        self._rows: RowReader | None = None

    def recording(self) -> Recording:
        cursor = self._cursor
        header = self._header
        while self._pass_hole():
            if not header.is_done:
                following = header.read()
            elif header.columns is None or (self._rows is not None and self._rows.gave_up):
                following = cursor.end
            else:
                rows = self._rows or self._begin_rows(header.columns)
                following = rows.read()
            cursor.advance_to(following)
        return self._finish()

    def _pass_hole(self) -> bool:
        """Skips NULs; returns whether anything is left."""
        cursor = self._cursor
        if cursor.start < cursor.end and cursor.data[cursor.start] == 0:
            at = cursor.start
            step = 1 << 16
            while cursor.data[at : at + step].count(b"\0") == step:
                at += step
            while at < cursor.end and cursor.data[at] == 0:
                at += 1
            message = f"NUL bytes ({at - cursor.start}) have replaced data, probably after a power loss; that data is lost."
            self._problems.add(ProblemKind.NUL_HOLE, message, cursor.line)
            cursor.advance_to(at)
            cursor.hole_line = cursor.line
        return cursor.start < cursor.end

    def _begin_rows(self, layout: HeaderColumns) -> RowReader:
        self._columns = _columns_of(layout)
        is_bag = self._header.line is not None
        arrow = self._arrow() if self._uses_arrow and self._columns else None
        self._rows = RowReader(self._cursor, self._columns, self._problems, is_bag, self._max_rows, arrow)
        return self._rows

    def _arrow(self) -> ArrowRows:
        from badlog._arrow_rows import ArrowRows

        return ArrowRows(self._columns)

    def _finish(self) -> Recording:
        header = self._header
        layout = header.columns
        if layout is None:
            # Without a line of titles there are no rows, but the line of JSON may still list the topics.
            names = [topic.name for topic in header.header.topics] if header.header is not None else []
            layout = HeaderColumns.match(header.header, names, self._cursor.line, self._problems)
        rows = self._rows
        row_count = 0 if rows is None else rows.row_count
        columns = self._columns if rows is not None else _columns_of(layout)
        topics = [columns[i].topic(row_count, self._problems) for i in layout.order]
        ignores_the_rest = header.is_not_log or (rows is not None and rows.gave_up)
        if self._cursor.saw_carriage_return and not ignores_the_rest:
            self._problems.add(ProblemKind.CARRIAGE_RETURNS, "Lines end in a carriage return, as on Windows; that is fine.")
        if header.header is None and len(topics) == 1 and row_count > 0 and _is_prose(topics[0]):
            self._problems.add(ProblemKind.NOT_A_RECORDING, f"{NOT_A_LOG}: it is text without columns of numbers.", 1)
            return Recording(RecordingFormat.CSV, None, [], [], 0, self._problems.to_list())
        if not ignores_the_rest:
            self._report_emptiness(topics, row_count)
        return Recording(
            format=RecordingFormat.CSV if header.line is None else RecordingFormat.BAG,
            header_line=header.line,
            values=[] if header.header is None else header.header.values,
            topics=topics,
            row_count=row_count,
            problems=self._problems.to_list(),
        )

    def _report_emptiness(self, topics: list[Topic], row_count: int) -> None:
        if self._header.line is None and not topics:
            message = "The file is empty; the robot may have been switched off too early."
            self._problems.add(ProblemKind.EMPTY_FILE, message)
        elif row_count == 0:
            message = "There is a header but no row of samples; the robot may have been switched off too early."
            self._problems.add(ProblemKind.NO_ROWS, message)


def _columns_of(layout: HeaderColumns) -> list[Column]:
    return [
        Column(name, UNITLESS if topic is None else topic.unit, () if topic is None else topic.attributes)
        for name, topic in zip(layout.names, layout.topics)
    ]


def _is_prose(topic: Topic) -> bool:
    return topic.kind is TopicKind.EMPTY or topic.counts.texts + topic.counts.empty == topic.counts.total

"""Reads the lines before the rows: the line of JSON, if there is one, and the line of column titles."""

from __future__ import annotations

import re
from collections import Counter

from badlog._cursor import Cursor, after_line_end, line_end_in
from badlog._first_lines import FirstLine, FirstLines, has_controls
from badlog._header import BagHeader, read_header
from badlog._splitter import Quotes, RowSplitter
from badlog._text import BLANKS, decode
from badlog._titles import ColumnTitles, HeaderColumns
from badlog.problem import ProblemKind, ProblemList

NOT_A_LOG = "This file is neither a bag, nor a CSV file, nor a WPILOG, nor a .dslog or .dsevents of the Driver Station"

_BINARY = f"{NOT_A_LOG}: it has bytes that never occur in text."
_UTF_16 = "The file is UTF-16, like Excel's “Unicode text”; save it again as CSV UTF-8."
_GZIP = "The file is compressed with gzip twice; inflate it once."
_BYTE_ORDER_MARK = b"\xef\xbb\xbf"

_MAX_LINE_BYTES = 1 << 24  # a file without a newline before that is not a bag
_MAX_COLUMNS = 1 << 16  # each column costs memory before it has a row
_MIN_ROWS = 3  # this many rows of one width count more than the titles

# The characters between a key of JSON and its value, which no title has.
_JSON_MARK = re.compile(rb'":["\[]')
_TITLE_CONTROL = re.compile("[\x00-\x08\x0a-\x1f]")


class HeaderReader:
    """Reads the header at the cursor, and moves the cursor on to the first row."""

    def __init__(self, cursor: Cursor, problems: ProblemList) -> None:
        self._cursor = cursor
        self._problems = problems
        self._saw_other_text = False
        self._may_be_utf16 = False
        self._is_at_signature = True
        self._is_at_first_line = True
        self.line: str | None = None
        """The line of JSON as it is written, or None if there is none."""
        self.header: BagHeader | None = None
        """The content of that line; None if it is missing or cannot be read."""
        self.columns: HeaderColumns | None = None
        """The columns; None if the line of titles is missing."""
        self.is_done = False
        self.is_not_log = False
        """Whether the bytes turned out not to be a log."""

    def read(self) -> int:
        """Reads one line of the header. Returns where the next begins."""
        if self._is_at_signature:
            self._is_at_signature = False
            return self._read_signature()
        cursor = self._cursor
        line_end = line_end_in(cursor.data, cursor.start, cursor.end)
        if line_end - cursor.start > _MAX_LINE_BYTES:
            return self._refuse(_BINARY)
        following = after_line_end(cursor.data, line_end)
        if line_end == cursor.start:
            return cursor.pass_blank_lines(line_end, following, self._problems)
        if self._is_at_first_line:
            self._is_at_first_line = False
            return self._take_first_line(line_end, following)
        return self._take_titles(line_end, following)

    def _read_signature(self) -> int:
        start = self._cursor.start
        seen = self._cursor.data[start : start + 6]
        if seen.startswith(b"\x1f\x8b"):
            return self._refuse(_GZIP)
        self._may_be_utf16 = seen.startswith((b"\xff\xfe", b"\xfe\xff"))
        if self._may_be_utf16 and b"\0" in seen:
            return self._refuse(_UTF_16)
        if not seen.startswith(_BYTE_ORDER_MARK):
            return start
        self._problems.add(ProblemKind.BYTE_ORDER_MARK, "The file begins with a byte order mark, which was skipped.", 1)
        return start + len(_BYTE_ORDER_MARK)

    def _take_first_line(self, line_end: int, following: int) -> int:
        cursor = self._cursor
        if cursor.data[cursor.start] != 0x7B:
            return cursor.start
        text = self._decode(cursor.start, line_end)
        self._report_encoding()
        self.line = text
        self.header = read_header(text)
        if self.header is None:
            self._report_unreadable(
                f"Line {cursor.line} is cut or is not JSON, so units, attributes and values are lost; the rest was read as CSV."
            )
        if following > line_end:
            cursor.line += 1
        return following

    def _take_titles(self, line_end: int, following: int) -> int:
        cursor = self._cursor
        is_cut = following == line_end
        if self.line is not None and self.header is None:
            # The rest of a line of JSON after a hole is not the line of titles.
            is_rest = not cursor.is_after_hole and _JSON_MARK.search(cursor.data, cursor.start, line_end) is not None
            if is_rest:
                self._report_unreadable(f"Line {cursor.line} is part of the JSON line before it; it was skipped.")
            if is_rest or cursor.is_after_hole:
                cursor.line += not is_cut
                return following
        columns = cursor.data.count(b",", cursor.start, line_end) + 1
        if columns > _MAX_COLUMNS:
            return self._refuse(f"Line {cursor.line} has {columns} titles; a log has at most {_MAX_COLUMNS} topics.")
        names = [topic.name for topic in self.header.topics] if self.header is not None else []
        titles = self._titles(line_end, names)
        self.is_done = True
        if self.header is None:
            return self._take_without_header(titles, line_end, following)
        return self._take_with_header(names, titles, following, is_cut)

    def _take_with_header(self, names: list[str], titles: list[str], following: int, is_cut: bool) -> int:
        cursor = self._cursor
        self._report_encoding()
        is_sure = Counter(titles) == Counter(names)
        first_lines = None if is_sure else FirstLines(cursor)
        width = 0 if first_lines is None else _clear_width(first_lines, len(names))
        known_names = set(names)
        is_none = bool(names) and not any(title in known_names for title in titles)
        # Line 2 may be lost, to a hole or to damage: then this is a row.
        is_row = is_none and (
            cursor.hole_line > 0
            or (first_lines is not None and len(names) == width == len(titles) and first_lines.lines[0].numbers > 0)
        )
        # The line of JSON is more reliable than a line of titles that is cut.
        is_only_names = is_row or (is_cut and bool(names) and width == 0)
        known = ColumnTitles.certain(names) if is_only_names else ColumnTitles.of(names, titles, width)
        self.columns = self._columns_of(known, titles)
        is_uneven = first_lines is not None and width > 0 and len(titles) != width
        end = following
        if first_lines is not None and is_uneven and not is_cut and not is_row:
            end = _rest_of_titles(first_lines, following, width)
        if cursor.hole_line == 0 and not is_cut and (is_row or (is_uneven and len(names) == width)):
            self._problems.add(
                ProblemKind.TITLES_DAMAGED,
                f"Line {cursor.line} does not have a title for each of the {width} cells of a row; the names of line 1 were used.",
                cursor.line,
            )
        if is_row:
            return cursor.start
        cursor.line += (not is_cut) + self._lines_in(following, end)
        return end

    def _take_without_header(self, titles: list[str], line_end: int, following: int) -> int:
        """Handles a plain CSV file, or the rest of a bag if its first line cannot be read."""
        cursor = self._cursor
        first_lines = FirstLines(cursor)
        width = _clear_width(first_lines, 0)
        is_damaged = width > 1 and len(titles) != width
        may_be_binary = self._may_be_utf16 or has_controls(cursor.data[cursor.start : line_end])
        if first_lines.is_binary or (may_be_binary and not first_lines.has_rows):
            return self._refuse(_UTF_16 if self._may_be_utf16 else _BINARY)
        self._report_encoding()
        if len(titles) == 1:
            message = self._other_separator(titles[0], first_lines, width)
            if message is not None:
                return self._refuse(message)
        lines = first_lines.lines
        if is_damaged and first_lines.has_rows:
            # Damage, or remarks of the file's author, may come before the titles.
            begin = next((line for line in lines if line.cells == width), None)
            if begin is not None and begin.is_titles:
                return self._skip_to(begin, lines[0].end)
        if lines and len(titles) == width and (lines[0].texts == 0 or (self.line is not None and lines[0].numbers > 0)):
            return self._take_untitled(width)
        known = ColumnTitles.of([], titles, width) if is_damaged else ColumnTitles.certain(list(titles))
        # A hole destroyed the rest of the line, which may have had more titles.
        if following == line_end and first_lines.has_rows:
            known.is_doubtful = [True] * len(known.titles)
        for i, title in enumerate(known.titles):
            if _TITLE_CONTROL.search(title):
                known.is_doubtful[i] = True
                known.titles[i] = _TITLE_CONTROL.sub(" ", title)
        self.columns = self._columns_of(known, titles)
        cursor.line += following > line_end
        end = _rest_of_titles(first_lines, following, width) if is_damaged and following > line_end else following
        cursor.line += self._lines_in(following, end)
        return end

    def _take_untitled(self, width: int) -> int:
        """Reads the line as a row, because the line of titles is missing."""
        line = self._cursor.line
        message = f"Line {line} has values in place of titles; the columns are named by number."
        self._problems.add(ProblemKind.TITLES_DAMAGED, message, line)
        self.columns = HeaderColumns.match(self.header, [""] * width, line, self._problems)
        return self._cursor.start

    def _skip_to(self, titles: FirstLine, first_end: int) -> int:
        """Continues at the line `titles`; all earlier bytes are lost."""
        cursor = self._cursor
        text = decode(cursor.data[cursor.start : first_end])[0]
        if self.line is None and '"name":' in text:
            self.line = text
        self._report_unreadable(f"Line {cursor.line} is not the start of a bag or CSV file; it was skipped.")
        cursor.line += self._lines_in(cursor.start, titles.start)
        self.is_done = False
        return titles.start

    def _lines_in(self, start: int, until: int) -> int:
        data = self._cursor.data
        feeds = data.count(b"\n", start, until)
        return feeds + sum(data[at + 1 : at + 2] != b"\n" for at in _places(data, b"\r", start, until))

    def _report_unreadable(self, message: str) -> None:
        self._problems.add(ProblemKind.HEADER_UNREADABLE, message, self._cursor.line)

    def _columns_of(self, known: ColumnTitles, titles: list[str]) -> HeaderColumns:
        line = self._cursor.line
        matched = HeaderColumns.match(self.header, known.titles, line, self._problems)
        for i, name in enumerate(matched.names):
            if not known.is_doubtful[i]:
                continue
            is_other = i < len(titles) and titles[i] != name
            reason = f"line {line} has “{titles[i]}” there" if is_other else "the title line is damaged"
            message = f"Column {i + 1} is shown as “{name}”, which may be wrong: {reason}."
            self._problems.add(ProblemKind.NAME_IN_DOUBT, message, line, name)
        return matched

    def _other_separator(self, title: str, first_lines: FirstLines, width: int) -> str | None:
        for char, name in ((";", "semicolons"), ("\t", "tabs")):
            if char not in title:
                continue
            rows = [self._cursor.data[line.start : line.end].count(char.encode()) for line in first_lines.lines[1:]]
            # Decimal commas split the cells of such rows.
            is_other = all(count == title.count(char) for count in rows) if width > 1 else not rows or rows[0] > 0
            if is_other:
                return f"The columns are separated by {name}; save the file again as CSV with commas."
        return None

    def _titles(self, line_end: int, names: list[str]) -> list[str]:
        self._saw_other_text = False
        cursor = self._cursor
        # The original does not quote names, so only the line of JSON shows that a name has a comma.
        if len(names) > 1 and self._decode(cursor.start, line_end) == ",".join(names):
            return names
        splitter = RowSplitter()
        count = splitter.split(cursor.data, cursor.start, line_end, Quotes.STRICT)
        titles = []
        for i in range(count):
            title = self._decode(splitter.starts[i], splitter.ends[i])
            titles.append(title.replace('""', '"') if splitter.quoted[i] else title.strip(BLANKS))
        return titles

    def _decode(self, start: int, until: int) -> str:
        text, was_not_utf8 = decode(self._cursor.data[start:until])
        self._saw_other_text |= was_not_utf8
        return text

    def _report_encoding(self) -> None:
        if self._saw_other_text:
            message = "The header is not UTF-8; it was read as Windows-1252."
            self._problems.add(ProblemKind.NOT_UTF8, message, self._cursor.line)

    def _refuse(self, message: str) -> int:
        self._problems.add(ProblemKind.NOT_A_RECORDING, message, self._cursor.line)
        self.is_done = True
        self.is_not_log = True
        return self._cursor.end


def _clear_width(first_lines: FirstLines, names: int) -> int:
    """The number of cells of a row; 0 if that is not clear."""
    width = first_lines.width
    return width if width == names or first_lines.rows_of(width) >= _MIN_ROWS else 0


def _rest_of_titles(first_lines: FirstLines, following: int, width: int) -> int:
    """The end of the lines that damage split off the line of titles: they are not rows."""
    end = following
    for line in first_lines.lines[1:]:
        if line.cells == width or line.numbers > 0 or line.following <= line.end:
            break
        end = line.following
    return end


def _places(data: bytes, byte: bytes, start: int, until: int) -> list[int]:
    places = []
    at = data.find(byte, start, until)
    while at >= 0:
        places.append(at)
        at = data.find(byte, at + 1, until)
    return places

"""The position in a file up to which it is read, and the ends of its lines."""

from __future__ import annotations

import re

from badlog.problem import ProblemKind, ProblemList

_LINE_END = re.compile(rb"[\n\r\x00]")
_LINE_FEEDS = re.compile(rb"\n*")
_CRLFS = re.compile(rb"(?:\r\n)*")
_LF = 10
_CR = 13
_MAX_LISTED = 10


def line_end_in(data: bytes, start: int, until: int) -> int:
    """The end of the line: its LF or CR, or a NUL, where the original bytes are lost. It is `until` if there is none."""
    end = _LINE_END.search(data, start, until)
    return until if end is None else end.start()


def after_line_end(data: bytes, end: int) -> int:
    """Where the line after the one that ends at `end` begins; after a NUL, that is the NUL itself."""
    if end == len(data) or data[end] == 0:
        return end
    if data[end] == _CR and end + 1 < len(data) and data[end + 1] == _LF:
        return end + 2
    return end + 1


class Cursor:
    """The bytes of a file, inflated, and the position up to which they are read."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.start = 0
        self.end = len(data)
        self.line = 1
        """The physical line, from 1, that `start` is in."""
        self.hole_line = 0
        """The line on which a run of NULs was skipped last; 0 before any."""
        self.saw_carriage_return = False
        """Whether a line that was read ended in a carriage return."""

    @property
    def is_after_hole(self) -> bool:
        """Whether the beginning of the line that `start` is in was lost in a run of NULs."""
        return self.line == self.hole_line

    def advance_to(self, following: int) -> None:
        """Records that everything before `following` is read."""
        last = self.data[max(self.start, following - 2) : following]
        if last.endswith(b"\r") or last == b"\r\n":
            self.saw_carriage_return = True
        self.start = following

    def pass_blank_lines(self, end: int, following: int, problems: ProblemList) -> int:
        """Skips the blank line that ends at `end`, before `following`, and all blank lines after it. Returns where they
        end.
        """
        size = following - end
        at = following
        more = _CRLFS if size == 2 else _LINE_FEEDS if self.data[end] == _LF else None
        if more is not None:
            match = more.match(self.data, at)
            assert match is not None
            at = match.end()
        count = (at - end) // size
        blank = "A blank line was skipped."
        for i in range(1 if self.is_after_hole else 0, min(count, _MAX_LISTED)):
            problems.add(ProblemKind.BLANK_LINE, blank, self.line + i)
        if count > _MAX_LISTED:
            problems.add(ProblemKind.BLANK_LINE, blank, self.line + _MAX_LISTED, count=count - _MAX_LISTED)
        self.line += count
        return at

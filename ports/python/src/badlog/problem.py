"""The problems of a log, as data: a damaged file opens, and its problems describe the loss."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum, IntEnum

__all__ = ["Problem", "ProblemKind", "Severity"]


class Severity(IntEnum):
    """The importance of a problem to someone who reads the recording."""

    NOTE = 0
    """Nothing is lost or doubtful: for information only."""
    WARNING = 1
    """Everything was kept, but some of it may have been read differently than intended."""
    ERROR = 2
    """Part of the file's data is lost."""


_ERRORS = frozenset(
    "NOT_A_RECORDING EMPTY_FILE GZIP_CUT HEADER_UNREADABLE TITLES_DAMAGED ROW_CUT LAST_CELL_CUT NUL_HOLE TOO_MANY_ROWS ROW_LONG "
    "RECORD_CUT RECORDS_SKIPPED RECORDS_LOST BAD_RECORD UNKNOWN_ENTRY WILD_TIMES TOO_MANY_TOPICS".split()
)
_NOTES = frozenset(
    "BLANK_LINE BYTE_ORDER_MARK CARRIAGE_RETURNS EMPTY_CELLS TRUTH_VALUES NOT_FINITE UNUSUAL_NAME UNKNOWN_ATTRIBUTE "
    "DUPLICATE_ATTRIBUTE X_REPEATS UNUSUAL_JOIN INTEGRAL_OVER_GAPS TIMES_SORTED NOT_DECODED NUMBERS_ROUNDED CSV_DIALECT LONG_PATH".split()
)


def times_text(count: int) -> str:
    """` (3×)` to add to a sentence about something that happened `count` times; nothing for once."""
    return "" if count == 1 else f" ({count}×)"


class ProblemKind(str, Enum):
    """The kinds of problems of a log. `docs/bag-format.md`, `docs/wpilog.md` and `docs/driver-station.md` have the rule behind each kind."""

    NOT_A_RECORDING = "NOT_A_RECORDING"
    EMPTY_FILE = "EMPTY_FILE"
    GZIP_CUT = "GZIP_CUT"
    HEADER_UNREADABLE = "HEADER_UNREADABLE"
    TITLES_DAMAGED = "TITLES_DAMAGED"
    NAME_IN_DOUBT = "NAME_IN_DOUBT"
    NO_ROWS = "NO_ROWS"
    ROW_CUT = "ROW_CUT"
    LAST_CELL_CUT = "LAST_CELL_CUT"
    NUL_HOLE = "NUL_HOLE"
    LINES_JOINED = "LINES_JOINED"
    QUOTES_REPAIRED = "QUOTES_REPAIRED"
    TOO_MANY_ROWS = "TOO_MANY_ROWS"
    ROW_SHORT = "ROW_SHORT"
    ROW_LONG = "ROW_LONG"
    BLANK_LINE = "BLANK_LINE"
    BYTE_ORDER_MARK = "BYTE_ORDER_MARK"
    CARRIAGE_RETURNS = "CARRIAGE_RETURNS"
    NOT_UTF8 = "NOT_UTF8"
    DECIMAL_COMMA = "DECIMAL_COMMA"
    EMPTY_CELLS = "EMPTY_CELLS"
    TEXT_IN_NUMBERS = "TEXT_IN_NUMBERS"
    TRUTH_VALUES = "TRUTH_VALUES"
    NOT_FINITE = "NOT_FINITE"
    TOPIC_WITHOUT_COLUMN = "TOPIC_WITHOUT_COLUMN"
    COLUMN_WITHOUT_TOPIC = "COLUMN_WITHOUT_TOPIC"
    DUPLICATE_TOPIC = "DUPLICATE_TOPIC"
    UNUSUAL_NAME = "UNUSUAL_NAME"
    UNKNOWN_ATTRIBUTE = "UNKNOWN_ATTRIBUTE"
    DUPLICATE_ATTRIBUTE = "DUPLICATE_ATTRIBUTE"
    UNFIT_ATTRIBUTE = "UNFIT_ATTRIBUTE"
    SECOND_X_AXIS = "SECOND_X_AXIS"
    X_BACKWARDS = "X_BACKWARDS"
    X_REPEATS = "X_REPEATS"
    X_GAPS = "X_GAPS"
    X_WILD = "X_WILD"
    UNUSUAL_JOIN = "UNUSUAL_JOIN"
    INTEGRAL_OVER_GAPS = "INTEGRAL_OVER_GAPS"
    RECORD_CUT = "RECORD_CUT"
    RECORDS_SKIPPED = "RECORDS_SKIPPED"
    RECORDS_LOST = "RECORDS_LOST"
    BAD_RECORD = "BAD_RECORD"
    UNKNOWN_ENTRY = "UNKNOWN_ENTRY"
    EARLY_TIMES = "EARLY_TIMES"
    WILD_TIMES = "WILD_TIMES"
    TOO_MANY_TOPICS = "TOO_MANY_TOPICS"
    TIMES_SORTED = "TIMES_SORTED"
    NOT_DECODED = "NOT_DECODED"
    NUMBERS_ROUNDED = "NUMBERS_ROUNDED"
    CSV_DIALECT = "CSV_DIALECT"
    LONG_PATH = "LONG_PATH"

    @property
    def severity(self) -> Severity:
        """The importance of a problem of this kind."""
        if self.value in _ERRORS:
            return Severity.ERROR
        return Severity.NOTE if self.value in _NOTES else Severity.WARNING

    def __str__(self) -> str:
        return self.value


@dataclass(frozen=True)
class Problem:
    """A problem in a file: its kind, its place, and how it was handled."""

    kind: ProblemKind
    message: str
    """One sentence."""
    line: int | None = None
    """The physical line of the file, from 1, or None if the problem has no line."""
    topic: str | None = None
    """The name of the topic concerned, or None."""
    count: int = 1
    """How often it occurred; `line` and `message` describe the first occurrence."""

    @property
    def severity(self) -> Severity:
        """The importance of the problem, from its `kind`."""
        return self.kind.severity

    def __str__(self) -> str:
        place = "" if self.line is None else f"line {self.line}: "
        return f"{self.severity.name.lower()}: {place}{self.message}"


class ProblemList:
    """Collects problems in bounded memory: of each kind and topic the first ten are kept, the others counted."""

    _MAX_LISTED = 10

    def __init__(self) -> None:
        self._problems: list[Problem] = []
        self._seen: dict[tuple[ProblemKind, str | None], int] = {}
        self._overflow: dict[tuple[ProblemKind, str | None], Problem] = {}

    def add(self, kind: ProblemKind, message: str, line: int | None = None, topic: str | None = None, count: int = 1) -> None:
        key = (kind, topic)
        times = self._seen.get(key, 0) + 1
        self._seen[key] = times
        if times <= self._MAX_LISTED:
            self._problems.append(Problem(kind, message, line, topic, count))
        else:
            first = self._overflow.get(key) or Problem(kind, message, line, topic, 0)
            self._overflow[key] = replace(first, count=first.count + count)

    def to_list(self) -> list[Problem]:
        """The problems in the order in which they were added, then one for each kind that occurred more often."""
        return self._problems + list(self._overflow.values())

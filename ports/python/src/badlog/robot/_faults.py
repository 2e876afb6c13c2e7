"""Handles the faults in a robot's loop. Each is counted every time, reported once, and noted as an event in the log."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from badlog.robot import _standard_error

if TYPE_CHECKING:
    from badlog.robot._events import EventTexts

# A program that invents names must not fill the memory with them.
_MAX_MESSAGES = 100
_SLOW_NANOS = 5_000_000


@dataclass(frozen=True)
class LogCounters:
    """The numbers of rows, cells and calls that a log has written, lost or ignored since `BadLog.init`, at one moment."""

    rows_written: int
    """Rows that were passed to the operating system, except those written to a file known to be deleted."""
    rows_missed: int
    """Rows that were lost because they could not be written, or because the file is known to be deleted."""
    bytes_written: int
    """The length of the file in bytes."""
    slowest_row_nanos: int
    """The longest time that one call of `BadLog.log` took, in nanoseconds."""
    slow_writes: int
    """Writes that took more than 5 ms, including those that failed."""
    failed_syncs: int
    """How often the operating system could not sync the file to the disk."""
    cells_missed: int
    """Cells left empty because a callable raised or gave None."""
    calls_ignored: int
    """Calls that were ignored, such as publishing to a name that was never created."""
    events_dropped: int
    """Events that are in no row: they came faster than rows, or the log ended before one could be written."""


class Faults:
    """Counts and reports faults. Thread-safe; never raises."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._counts = dict.fromkeys(LogCounters.__dataclass_fields__, 0)
        self._reported: set[str] = set()
        # Separate, because a program's names must not clash with the log's own subjects.
        self._ignored: dict[str, set[str]] = {"call": set(), "name": set()}
        self.room: EventTexts | None = None
        """The column that takes events, if there is one."""

    def count(self, counter: str, more: int = 1) -> None:
        with self._lock:
            self._counts[counter] += more

    def row_took(self, nanos: int) -> None:
        with self._lock:
            self._counts["slowest_row_nanos"] = max(nanos, self._counts["slowest_row_nanos"])

    def write_took(self, nanos: int) -> None:
        if nanos > _SLOW_NANOS:
            self.count("slow_writes")

    def grew_to(self, length: int) -> None:
        with self._lock:
            self._counts["bytes_written"] = length

    def counters(self) -> LogCounters:
        with self._lock:
            return LogCounters(**self._counts)

    def cell_missed(self, topic: str, what: str) -> None:
        """Handles a fault of that topic: its cell stays empty in this row."""
        self.count("cells_missed")
        if self._is_new(f"topic {topic}"):
            self.report(f'The topic "{topic}" {what}, so its cell is empty. Further gaps of this topic are only counted.')

    def call_ignored(self, call: str, why: str) -> None:
        self._count_ignored("call", call, why)

    def publish_ignored(self, name: str, why: str) -> None:
        self._count_ignored("name", name, why)

    def _count_ignored(self, what: str, about: str, why: str) -> None:
        with self._lock:
            self._counts["calls_ignored"] += 1
            before = self._ignored[what]
            is_new = about not in before and len(before) < _MAX_MESSAGES
            if is_new:
                before.add(about)
        if is_new:
            self.report(why)

    def report_once(self, about: str, message: Callable[[], str]) -> None:
        """Reports the message, unless its subject was reported before."""
        if self._is_new(about):
            self.report(message())

    def report(self, message: str) -> None:
        _standard_error.print_soon(message)
        self.note(message)

    def note(self, text: str) -> None:
        """Keeps the text for the next row that has room."""
        if self.room is not None:
            self.room.add(text)

    def _is_new(self, about: str) -> bool:
        with self._lock:
            if about in self._reported:
                return False
            self._reported.add(about)
            return True


def describe(cause: BaseException) -> str:
    """The exception in one line. Its own text may raise, too."""
    name = type(cause).__name__
    try:
        text = str(cause)
    except Exception:
        return name
    return f"{name}: {text}" if text else name

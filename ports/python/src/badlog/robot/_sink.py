"""Writes rows: each at once, or several together at most a quarter of a second after the previous write."""

from __future__ import annotations

import time
from pathlib import Path

from badlog.robot._events import EventTexts
from badlog.robot._faults import Faults, describe
from badlog.robot._output import AppendFile, GzipFile

_BATCH_BYTES = 6 * 1024
_MAX_WAIT_NANOS = 250_000_000
_RETRY_NANOS = 250_000_000


class LogFile:
    """The file of a log."""

    def __init__(self, path: Path, output: AppendFile) -> None:
        self.path = path
        self.output = output
        self.is_missing = False
        """Whether it was deleted; it can still be written to."""

    @classmethod
    def open(cls, path: Path, is_compressed: bool, faults: Faults) -> LogFile | None:
        """Creates or empties the file; None, which is reported once, if that is impossible."""
        try:
            return cls(path, GzipFile(path) if is_compressed else AppendFile(path))
        except (OSError, ValueError) as failure:
            reason = describe(failure)
            faults.report_once(
                "open",
                lambda: f"The log {path} cannot be created: {reason}. Nothing is logged; use a folder that exists and can be written "
                "to, such as /home/lvuser/logs.",
            )
            return None

    def close(self, faults: Faults) -> None:
        """Closes it; a failure is reported, because the disk may be gone by then."""
        try:
            self.output.close()
        except OSError as failure:
            reason = describe(failure)
            faults.report_once("close", lambda: f"The log {self.path} could not be closed: {reason}. Its end may be missing.")


class RowSink:
    """Writes rows. Rows that cannot be written are lost and counted. After a failure it waits before the next attempt, because a full or
    missing disk may be slow to report it. Guarded by the log's lock.
    """

    def __init__(self, file: LogFile, flushes_each_row: bool, faults: Faults) -> None:
        self._file = file
        self._flushes_each_row = flushes_each_row
        self._faults = faults
        self._events: list[EventTexts] = []
        self._header: bytes | None = None
        self._rows: list[bytes] = []
        self._size = 0
        self._last_write = time.monotonic_ns()
        self._rows_lost = 0
        self.is_failing = False
        """Whether the last attempt to write failed."""
        self.is_dirty = False
        """Whether something was written since this was last set to False."""

    def begin(self, lines: bytes, events: list[EventTexts]) -> None:
        """Writes the header before any row. Rows will take events from `events`."""
        self._events = events
        self._header = lines
        self._write(time.monotonic_ns())

    def is_refusing(self, now: int) -> bool:
        """Whether a row begun now would be lost. Do not begin it then, so that no events are lost with it."""
        return self._is_waiting_to_retry(now) and (self._flushes_each_row or self._size >= _BATCH_BYTES)

    def miss_row(self) -> None:
        """Counts a row that was not begun."""
        self._lose(1)

    def add_row(self, row: bytes, began: int) -> None:
        """Takes a row that was begun at `began`, a time of `time.monotonic_ns`."""
        self._rows.append(row)
        self._size += len(row)
        is_due = self._flushes_each_row or self._size >= _BATCH_BYTES or began - self._last_write >= _MAX_WAIT_NANOS
        if is_due and not self._is_waiting_to_retry(began):
            self._write(began)
        self._faults.row_took(time.monotonic_ns() - began)

    def drop_row(self) -> None:
        """Counts a row that could not be made."""
        self._faults.count("rows_missed")
        # This includes the events of buffered rows: an event in two rows is better than in none.
        for texts in self._events:
            texts.restore()

    def flush(self) -> None:
        """Writes all rows that wait."""
        if self._rows or self._header is not None:
            self._write(time.monotonic_ns())

    def flush_waiting(self) -> None:
        """Does the same as `flush`, unless a write has just failed."""
        if not self._is_waiting_to_retry(time.monotonic_ns()):
            self.flush()

    def finish(self) -> None:
        """Writes the waiting rows and the end of the file."""
        self.flush()
        try:
            self._file.output.finish()
            self.is_dirty = True
        except OSError as failure:
            self._report_failed(failure)
        for texts in self._events:
            texts.end()

    def _is_waiting_to_retry(self, now: int) -> bool:
        return self.is_failing and now - self._last_write < _RETRY_NANOS

    def _write(self, now: int) -> None:
        self._last_write = now
        rows = len(self._rows)
        try:
            if self._header is not None:
                self._append(self._header)
                self._header = None
            if rows > 0:
                self._append(b"".join(self._rows))
        except OSError as failure:
            self._lose(rows)
            self._forget_rows()
            for texts in self._events:
                texts.restore()
            self.is_failing = True
            self._report_failed(failure)
            return
        # Writing to a deleted file succeeds silently; a file that was only moved may come back.
        self._faults.count("rows_missed" if self._file.is_missing else "rows_written", rows)
        self._faults.grew_to(self._file.output.length)
        self.is_dirty = True
        self._forget_rows()
        for texts in self._events:
            texts.written()
        if self.is_failing:
            self.is_failing = False
            self._faults.note(f"{self._rows_lost} rows before this one could not be written")
            self._rows_lost = 0

    def _append(self, data: bytes) -> None:
        began = time.monotonic_ns()
        try:
            self._file.output.append(data)
        finally:
            # Even if it fails, because a failing disk is often slow.
            self._faults.write_took(time.monotonic_ns() - began)

    def _report_failed(self, failure: OSError) -> None:
        reason = describe(failure)
        self._faults.report_once(
            "write",
            lambda: f"The log {self._file.path} cannot be written: {reason}. Rows are lost until it can; check whether the disk is full "
            "or was removed.",
        )

    def _lose(self, rows: int) -> None:
        self._rows_lost += rows
        self._faults.count("rows_missed", rows)

    def _forget_rows(self) -> None:
        self._rows = []
        self._size = 0

"""Syncs the file to the disk, four times a second. So a loss of power costs no more than that time."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from pathlib import Path

from badlog.robot._faults import Faults, describe
from badlog.robot._sink import LogFile, RowSink

_INTERVAL_SECONDS = 0.25


class SyncThread(threading.Thread):
    """Writes the waiting rows, syncs, and notices if the file was deleted. At the end, it closes the file.

    It holds no lock while it waits for a sync.
    """

    def __init__(self, file: LogFile, sink: RowSink, faults: Faults, syncs: bool, flush: Callable[[], None]) -> None:
        super().__init__(name="badlog sync", daemon=True)
        self._file = file
        self._sink = sink
        self._faults = faults
        self._flush = flush
        self._times_missing = 0
        self._stopped = threading.Event()
        self.syncs = syncs
        """Whether to sync rows to the disk; the rest is always done."""

    def run(self) -> None:
        if self.syncs:
            _sync_folder(self._file.path.absolute().parent)
        self._sync()
        self._look_for_file()
        while not self._stopped.wait(_INTERVAL_SECONDS):
            self._flush()
            self._sync()
            self._look_for_file()
        self._sync()
        self._file.close(self._faults)

    def finish(self) -> None:
        """Ends the thread soon, without waiting for it."""
        self._stopped.set()

    def _sync(self) -> None:
        if not self.syncs or not self._sink.is_dirty:
            return
        # Before the sync, so that rows written meanwhile are not missed.
        self._sink.is_dirty = False
        try:
            self._file.output.sync()
        except OSError as failure:
            reason = describe(failure)
            self._faults.count("failed_syncs")
            self._faults.report_once(
                "sync",
                lambda: f"The log {self._file.path} could not be synced to the disk: {reason}. A power cut may cost more than the last "
                "quarter of a second.",
            )

    def _look_for_file(self) -> None:
        # Checks twice, because the file may be in the middle of being renamed.
        self._times_missing = 0 if self._file.path.exists() else self._times_missing + 1
        is_missing = self._times_missing > 1
        if is_missing:
            self._faults.report_once(
                "missing",
                lambda: f"The log {self._file.path} was deleted, or its disk was removed, while it was being written. From now on, "
                "data is lost; restart the robot program to start a new log.",
            )
        # Reported before the state changes, so that code that sees the log fail can read why.
        self._file.is_missing = is_missing


def _sync_folder(folder: Path) -> None:
    """Syncs the names of the folder's files to the disk. Otherwise, a loss of power could remove even the name of a new file."""
    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:
        # Some systems do not open folders; those write names to the disk by themselves.
        return
    try:
        os.fsync(handle)
    except OSError:
        pass
    finally:
        os.close(handle)

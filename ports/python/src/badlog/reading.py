"""Reads logs from files and folders."""

from __future__ import annotations

import os
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import IO, Union

from badlog import _bag_parser
from badlog._driver_station import parser as _driver_station_parser
from badlog._driver_station.station_times import is_driver_station
from badlog._inflate import inflated
from badlog._log_names import is_of_binary_log, is_only_of_logs, is_second_file, may_be_log, second_file_of
from badlog._timed.vectors import uses_numpy
from badlog._wpilog import parser as _wpilog_parser
from badlog.problem import Problem, ProblemKind
from badlog.recording import Recording, RecordingFormat

__all__ = ["MAX_ROWS", "read", "read_folder"]

MAX_ROWS = 50_000_000
"""The default for the maximum number of rows, or records, that are read from one log."""

# In smaller files of records, NumPy costs more than it saves.
_MIN_NUMPY_BYTES = 1 << 20

Source = Union[str, "os.PathLike[str]", bytes, bytearray, memoryview, IO[bytes]]


def read(source: Source, max_rows: int = MAX_ROWS) -> Recording:
    """Reads a bag, a CSV file, a WPILOG or a log of the Driver Station. It may be compressed with gzip, or with xz as a `.wpilogxz`.

    The content decides the format, never the name. A `.dslog` is read together with the `.dsevents` of its name beside it.

    Damage never raises: anything wrong in the file becomes a problem of the recording.

    Args:
        source: The path of a file, its bytes, or a file that is open for reading bytes.
        max_rows: The maximum number of rows, or of records of a log without rows, to read.

    Raises:
        OSError: The file is missing or cannot be read.
    """
    if isinstance(source, (bytes, bytearray, memoryview)):
        return _recording_of(bytes(source), None, max_rows)
    if isinstance(source, (str, os.PathLike)):
        return _recording_of(Path(source).read_bytes(), Path(source), max_rows)
    return _recording_of(source.read(), None, max_rows)


def read_folder(folder: str | os.PathLike[str], max_rows: int = MAX_ROWS) -> Iterator[Recording]:
    """Reads the logs in a folder and the folders below it, one after another, in the order of their paths.

    A log is a file with a name that ends in `.bag`, `.badbag`, `.csv`, `.wpilog`, `.wpilogxz`, `.dslog` or `.dsevents`, perhaps followed by `.gz`; a
    `.dslog` and the `.dsevents` of its name are one log. Files that cannot be opened, CSV files that are not logs, and hidden folders are skipped.
    Only one recording is in memory at a time, unless you keep more.

    Raises:
        NotADirectoryError: There is no such folder.
    """
    root = Path(folder)
    if not root.is_dir():
        raise NotADirectoryError(f"“{root}” is not a folder; pass a folder of logs, or read one log by badlog.read().")
    return _logs_in(root, max_rows)


def _logs_in(root: Path, max_rows: int) -> Iterator[Recording]:
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in sorted(files):
            path = Path(folder, name)
            if not may_be_log(name) or is_second_file(path):
                continue
            try:
                recording = read(path, max_rows)
            except OSError:
                continue
            if recording.is_readable or is_only_of_logs(name):
                yield recording


def _recording_of(file: bytes, path: Path | None, max_rows: int) -> Recording:
    content = inflated(file)
    data = content.data
    missing = [] if content.problem is None else [content.problem]
    if _wpilog_parser.is_wpilog(data):
        recording = _wpilog_parser.parse(data, max_rows, len(data) >= _MIN_NUMPY_BYTES and uses_numpy())
    elif is_driver_station(data):
        second = None if path is None else second_file_of(path)
        if second is not None:
            other = inflated(second.read_bytes())
            data += other.data
            missing += [] if other.problem is None else [other.problem]
        recording = _driver_station_parser.parse(data, max_rows, uses_numpy())
    elif path is not None and is_of_binary_log(path.name) and b"\0" in data:
        recording = _without_beginning(path)
    else:
        recording = _bag_parser.parse(data, max_rows, _has_arrow())
        if not recording.is_readable:
            # Other problems of such bytes would only distract.
            recording.problems = [problem for problem in recording.problems if problem.kind is ProblemKind.NOT_A_RECORDING]
    recording.path = None if path is None else os.fspath(path)
    if all(problem.kind is not ProblemKind.TOO_MANY_ROWS for problem in recording.problems):
        recording.problems[:0] = missing
    return recording


def _without_beginning(path: Path) -> Recording:
    message = (
        f"“{path.name}” is named like a WPILOG or a Driver Station log, but does not begin like one: its beginning is lost, so nothing can be read; "
        "badlog reads bags, CSV files, WPILOGs, and .dslog and .dsevents of the Driver Station."
    )
    return Recording(RecordingFormat.CSV, None, [], [], 0, [Problem(ProblemKind.NOT_A_RECORDING, message)])


def _has_arrow() -> bool:
    return find_spec("pyarrow") is not None and find_spec("numpy") is not None

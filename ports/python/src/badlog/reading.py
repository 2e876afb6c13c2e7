"""Reads logs from files and folders."""

from __future__ import annotations

import os
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import IO, Union

from badlog._bag_parser import parse as parse
from badlog._gzip import inflate, is_gzip
from badlog.problem import Problem, ProblemKind
from badlog.recording import Recording

__all__ = ["MAX_ROWS", "read", "read_folder"]

MAX_ROWS = 50_000_000
"""The largest number of rows that are read from one log, by default."""

# A small compressed file may hold more than the memory.
_MAX_BYTES = 1 << 33
_ENDINGS = (".bag", ".badbag", ".csv")

Source = Union[str, "os.PathLike[str]", bytes, bytearray, memoryview, IO[bytes]]


def read(source: Source, max_rows: int = MAX_ROWS) -> Recording:
    """Reads a bag or a CSV file, which may be compressed with gzip. The content decides the format, never the name.

    Damage never raises: whatever is wrong in the file becomes a problem of the recording.

    Args:
        source: The path of a file, its bytes, or a file that is open for reading bytes.
        max_rows: How many rows are read at most.

    Raises:
        OSError: The file is missing or cannot be read.
    """
    if isinstance(source, (bytes, bytearray, memoryview)):
        return _recording_of(bytes(source), None, max_rows)
    if isinstance(source, (str, os.PathLike)):
        return _recording_of(Path(source).read_bytes(), os.fspath(source), max_rows)
    return _recording_of(source.read(), None, max_rows)


def read_folder(folder: str | os.PathLike[str], max_rows: int = MAX_ROWS) -> Iterator[Recording]:
    """Reads the logs in a folder and in those below it, one after another, in the order of their paths.

    A log is a file whose name ends in `.bag`, `.badbag` or `.csv`, perhaps followed by `.gz`. Files that cannot be opened, and CSV files that are
    not logs, are left out; hidden folders are skipped. Only one recording is in memory at a time, unless you keep more.

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
            if not _may_be_log(name):
                continue
            try:
                recording = read(Path(folder, name), max_rows)
            except OSError:
                continue
            if recording.is_readable or not name.lower().endswith((".csv", ".csv.gz")):
                yield recording


def _may_be_log(name: str) -> bool:
    lower = name.lower()
    return lower.removesuffix(".gz").endswith(_ENDINGS) and not name.startswith(".")


def _recording_of(data: bytes, path: str | None, max_rows: int) -> Recording:
    is_cut = False
    is_compressed = is_gzip(data)
    if is_compressed:
        data, is_cut = inflate(data, _MAX_BYTES)
    recording = parse(data, max_rows, _has_arrow())
    recording.path = path
    gave_up = any(problem.kind is ProblemKind.TOO_MANY_ROWS for problem in recording.problems)
    if is_cut and not gave_up:
        message = f"The compressed file is cut off or damaged; the {len(data)} bytes before that were read."
        recording.problems.insert(0, Problem(ProblemKind.GZIP_CUT, message))
    elif is_compressed and len(data) >= _MAX_BYTES and not gave_up:
        message = f"The compressed file holds more than {_MAX_BYTES >> 30} GiB; the rest was not read. Inflate it, and cut it into parts."
        recording.problems.insert(0, Problem(ProblemKind.TOO_MANY_ROWS, message))
    return recording


def _has_arrow() -> bool:
    return find_spec("pyarrow") is not None and find_spec("numpy") is not None

"""The problems that a file of records may have."""

from __future__ import annotations

from badlog.problem import ProblemKind, ProblemList


def add_skipped(problems: ProblemList, start: int, until: int) -> None:
    """Reports that the bytes from `start` until `until` were skipped."""
    message = f"Bytes {start} to {until - 1} are not records and were skipped; the rest was read."
    problems.add(ProblemKind.RECORDS_SKIPPED, message)


def add_lost(problems: ProblemList, start: int, total: int) -> None:
    """Reports that nothing could be read from byte `start` to the end, `total`."""
    message = f"Bytes {start} to {total - 1}, the last of the file, cannot be read: they are not records."
    problems.add(ProblemKind.RECORDS_LOST, message)


def add_cut(problems: ProblemList) -> None:
    """Reports that the file ends in an incomplete record."""
    problems.add(ProblemKind.RECORD_CUT, "The file ends inside a record, which was dropped.")


def add_too_many(problems: ProblemList, most: int) -> None:
    """Reports that there are more records than `most`."""
    message = f"The log has more than {most} records; the rest was not read. Pass a larger max_rows to read more."
    problems.add(ProblemKind.TOO_MANY_ROWS, message)

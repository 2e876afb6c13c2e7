"""The records read from a `.dslog`, in runs of equal size, and the gaps between them."""

from __future__ import annotations

from dataclasses import dataclass

SECONDS = 0.02
"""The time from record to record."""


@dataclass(frozen=True)
class SampledRun:
    """Several records of one size, one after another, or a gap."""

    first: int
    """The index of the first record, which was written at this many times `SECONDS`."""
    start: int
    """Where it begins in the file."""
    size: int
    """The size of each in bytes; 0 for a gap."""
    count: int
    """The number of records; 1 for a gap."""


def column_of(data: bytes, runs: list[SampledRun], offset: int) -> bytes:
    """The byte at `offset` of each record, and 0 for a gap."""
    parts = [data[run.start + offset : run.start + run.size * run.count : run.size] if run.size > 0 else b"\0" for run in runs]
    return parts[0] if len(parts) == 1 else b"".join(parts)


def gaps_of(runs: list[SampledRun]) -> list[int]:
    """Which of the samples are gaps."""
    gaps = []
    place = 0
    for run in runs:
        if run.size == 0:
            gaps.append(place)
        place += run.count
    return gaps

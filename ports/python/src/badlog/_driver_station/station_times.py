"""The times in the files of the Driver Station, and their headers."""

from __future__ import annotations

SECONDS_TO_1970 = 2082844800.0
"""The seconds from the start of 1904, from which Driver Stations count, to the start of 1970."""

HEADER_SIZE = 20
"""Version, the seconds since 1904 and their fraction."""

NEAR = 2.7e6
"""A month, in s: no Driver Station runs for longer."""

_SIGNATURE_SIZE = 9
_MAX_VERSION = 9


def is_driver_station(data: bytes) -> bool:
    """Whether a file with `data` is a log of the Driver Station. It begins with a version, and a time from 2006 until 2040."""
    return len(data) >= _SIGNATURE_SIZE and word_at(data, 0) <= _MAX_VERSION and word_at(data, 4) == 0 and data[8] >= 0xC0


def word_at(data: bytes, at: int) -> int:
    """The 32 bits at `at`, the highest first."""
    return int.from_bytes(data[at : at + 4], "big")


def seconds_at(data: bytes, at: int) -> float:
    """The whole seconds since 1904 of the time at `at`."""
    return float(word_at(data, at + 4))


def fraction_at(data: bytes, at: int) -> float:
    """The fraction of a second of the time at `at`, which follows its whole seconds."""
    return (word_at(data, at + 8) + word_at(data, at + 12) / 2**32) / 2**32


def is_near(one: float, other: float) -> bool:
    """Whether times of `one` and `other` seconds may belong to the same run of the Driver Station."""
    return abs(one - other) < NEAR

"""The time of day as text."""

from __future__ import annotations

import math
from datetime import datetime, timedelta

_END_OF_9999 = 2.534023008e17
# September 2001 and the end of 2096, in µs since 1970.
_FIRST = 1e15
_LAST = 4e15


def origin_of(first_micros: float) -> float:
    """The moment that is time 0 of a log with this earliest time. It is that time if it counts from 1970, as a laptop's clock does,
    otherwise 0."""
    return first_micros if _FIRST <= first_micros <= _LAST else 0.0


def wall_time_text(micros: float) -> str | None:
    """The moment `micros` µs after the start of 1970, in UTC: `2024-03-09 14:02:31 UTC`. None outside the years 1970 to 9999."""
    if not 0 <= micros < _END_OF_9999:
        return None
    moment = datetime(1970, 1, 1) + timedelta(seconds=math.floor(micros / 1e6))
    return f"{moment:%Y-%m-%d %H:%M:%S} UTC"

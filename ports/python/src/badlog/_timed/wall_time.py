"""The time of day as text."""

from __future__ import annotations

import math
from datetime import datetime, timedelta

_END_OF_9999 = 2.534023008e17


def wall_time_text(micros: float) -> str | None:
    """The moment `micros` µs after the start of 1970, in UTC: `2024-03-09 14:02:31 UTC`; None outside the years 1970 to 9999."""
    if not 0 <= micros < _END_OF_9999:
        return None
    moment = datetime(1970, 1, 1) + timedelta(seconds=math.floor(micros / 1e6))
    return f"{moment:%Y-%m-%d %H:%M:%S} UTC"

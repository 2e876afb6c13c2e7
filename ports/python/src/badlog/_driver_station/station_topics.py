"""The parts of a Driver Station log that become topics."""

from __future__ import annotations

from typing import NamedTuple

from badlog._timed.column import Column, Timestamps


class StationTopic(NamedTuple):
    """A column with the topic's name as its path, and the topic's other properties."""

    column: Column
    unit: str
    attributes: tuple[str, ...]
    timestamps: Timestamps

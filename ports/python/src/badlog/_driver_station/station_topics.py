"""What becomes a topic of a Driver Station log."""

from __future__ import annotations

from typing import NamedTuple

from badlog._timed.column import Column, Timestamps


class StationTopic(NamedTuple):
    """A column, whose path is the topic's name, and what else the topic has."""

    column: Column
    unit: str
    attributes: tuple[str, ...]
    timestamps: Timestamps

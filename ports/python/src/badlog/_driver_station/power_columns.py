"""The currents of a power distribution, a PDP or a PDH, in the blocks of a `.dslog`."""

from __future__ import annotations

from typing import Any, NamedTuple

from badlog._driver_station.byte_columns import ByteColumns
from badlog._driver_station.sampled_runs import SECONDS, SampledRun, column_of, gaps_of
from badlog._driver_station.station_topics import StationTopic
from badlog._timed.column import NUMBERS, Column, Timestamps
from badlog._timed.vectors import Vectors


class PowerBlock(NamedTuple):
    """The block of one kind of power distribution."""

    name: str
    size: int
    """In bytes."""
    channels: int


PDP = PowerBlock("PDP", 25, 16)
PDH = PowerBlock("PDH", 33, 24)

_TEN_BITS = 0x3FF
# The channels of a PDH that have 10 bits; the others have a byte each.
_WIDE_CHANNELS = 20
_FIRST_NARROW = 28
_VOLTAGE, _TEMPERATURE = 23, 24
_VOLTS = [byte * 0.05 + 4.0 for byte in range(256)]
_DEGREES = [byte * 1.03250836957542 - 67.8564500484966 for byte in range(256)]
_SIXTEENTHS = [byte / 16.0 for byte in range(256)]


def power_columns(block: PowerBlock, data: bytes, runs: list[SampledRun], at: int, columns: ByteColumns, vectors: Vectors) -> list[StationTopic]:
    """The topics of the blocks that begin at the offset `at` of each record of `runs`. There are none without runs."""
    if not runs:
        return []
    timestamps = Timestamps(columns.times([range(run.first, run.first + run.count) for run in runs], SECONDS), vectors)
    size = len(timestamps)
    gaps = gaps_of(runs)
    is_gap = None
    if gaps:
        gap_set = set(gaps)
        is_gap = vectors.gaps_outside(size, vectors.whole([place for place in range(size) if place not in gap_set]))

    def byte(offset: int) -> bytes:
        return column_of(data, runs, at + offset)

    def topic(name: str, unit: str, attributes: tuple[str, ...], numbers: Any) -> StationTopic:
        column = Column(f"{block.name}/{name}", NUMBERS, size, columns.with_gaps(numbers, gaps), is_gap)
        return StationTopic(column, unit, attributes, timestamps)

    amps = []
    for channel in range(block.channels):
        if block is PDP:
            # 10 bits per channel, the highest bit first, six channels in 8 bytes.
            bit = channel // 6 * 64 + channel % 6 * 10
            first = 1 + bit // 8
            amps.append(columns.scaled(byte(first), byte(first + 1), 6 - bit % 8, _TEN_BITS, 8.0))
        elif channel < _WIDE_CHANNELS:
            # 10 bits per channel, the lowest bit first, three channels in 4 bytes.
            bit = channel // 3 * 32 + channel % 3 * 10
            first = 1 + bit // 8
            amps.append(columns.scaled(byte(first + 1), byte(first), bit % 8, _TEN_BITS, 8.0))
        else:
            amps.append(columns.looked_up(byte(_FIRST_NARROW + channel - _WIDE_CHANNELS), _SIXTEENTHS))
    total = columns.total(amps)
    attributes = ("hide", f"join:{block.name}/Channel Currents")
    topics = [topic(f"Channel {channel}", "A", attributes, numbers) for channel, numbers in enumerate(amps)]
    topics.append(topic("Total Current", "A", (), total))
    if block is PDP:
        topics.append(topic("Bus Voltage", "V", (), columns.looked_up(byte(_VOLTAGE), _VOLTS)))
        topics.append(topic("Temperature", "°C", (), columns.looked_up(byte(_TEMPERATURE), _DEGREES)))
    return topics

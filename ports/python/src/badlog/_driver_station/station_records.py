"""The records of a `.dslog` of version 3 or 4: one every 20 ms, without a time."""

from __future__ import annotations

from dataclasses import replace

from badlog._driver_station.byte_columns import ByteColumns
from badlog._driver_station.frames import MORE, NONE
from badlog._driver_station.power_columns import PDH, PDP, PowerBlock, power_columns
from badlog._driver_station.sampled_runs import SECONDS, SampledRun, column_of, gaps_of
from badlog._driver_station.station_times import word_at
from badlog._driver_station.station_topics import StationTopic
from badlog._timed.column import NUMBERS, TRUTHS, Column, Timestamps
from badlog._timed.vectors import Vectors

FOLDER = "Driver Station/"
"""The folder of the topics that every Driver Station has."""

_HEAD_3, _HEAD, _SIZE_3 = 10, 14, 35
_TRIP, _LOSS, _VOLTS, _CPU, _STATUS, _CAN, _POWER_SIZE = 0, 1, 2, 4, 5, 6, 10
_MAX_POWER = 4096
_NO_TRIP = 255
# 20 V: no robot has a battery of more. Without the robot's answer, the Driver Station writes 255.996 V or another large number.
_MAX_VOLTS = 20 * 256
_MAX_IN_RUN = 1 << 14

# The bits of the status, which are inverted.
_MODES = 7
_DS_MODE = 3
_DS_DISABLED, _DS_ENABLED, _WATCHDOG, _BROWNOUT = 0x08, 0x30, 0x40, 0x80

_HALVES = [byte / 2 for byte in range(256)]
# A few percent below 0 mean 0.
_LOSSES = [min(max((byte - 256 if byte > 127 else byte) * 4.0, 0.0), 100.0) for byte in range(256)]
_IS_ENABLED = [float(~status & _DS_DISABLED == 0 and ~status & _DS_ENABLED != 0) for status in range(256)]
_IS_BROWNOUT = [float(~status & _BROWNOUT != 0) for status in range(256)]
_IS_WATCHDOG = [float(~status & _WATCHDOG != 0) for status in range(256)]


def _mode(bits: int) -> bytes | None:
    return b"Disabled" if bits & 1 else b"Autonomous" if bits & 2 else b"Teleop" if bits & 4 else None


_DS_MODES = [_mode(~status >> _DS_MODE) or b"Other" for status in range(256)]
_ROBOT_MODES = [_mode(~status) for status in range(256)]


def _is_one_mode(bits: int) -> bool:
    return (bits & _MODES) in (0, 1, 2, 4)


class StationRecords:
    """Receives the records of one file: `Frames`."""

    may_end = True

    def __init__(self, data: bytes, version: int) -> None:
        self._data = data
        self._end = len(data)
        self._version = version
        self._head = _HEAD_3 if version == 3 else _HEAD
        self._runs: list[SampledRun] = []
        self._index = 0
        self._last_size = _SIZE_3 if version == 3 else _HEAD
        self.bad_count = 0
        """The number of records that were dropped because they are impossible."""

    def size_at(self, at: int) -> int:
        """The size of the record at `at`."""
        if self._version == 3:
            return MORE if self._end - at < _SIZE_3 else _SIZE_3
        if self._end - at < _HEAD:
            return MORE
        if not self._is_possible(at):
            return NONE
        power = word_at(self._data, at + _POWER_SIZE)
        end = at + _HEAD + power
        if end > self._end:
            return MORE
        # The bytes after an unknown block show whether it is one.
        if _is_known(power) or self._end - end < _HEAD or self._is_possible(end):
            return _HEAD + power
        return NONE

    def is_sure(self, at: int) -> bool:
        """Whether the record at `at` is certainly one."""
        status = ~self._data[at + _STATUS]
        power = word_at(self._data, at + _POWER_SIZE)
        return (_is_known(power) or _HEAD + power == self._last_size) and _is_one_mode(status) and _is_one_mode(status >> _DS_MODE)

    def _is_possible(self, at: int) -> bool:
        # All modes at once mean a hole of zeros.
        return self._data[at + _STATUS] != 0 and word_at(self._data, at + _POWER_SIZE) <= _MAX_POWER

    def take(self, at: int, size: int, until: int, most: int) -> tuple[int, int]:
        """Reads the record at `at`, and the records of the same size after it."""
        self._last_size = size
        if self._data[at + _STATUS] == 0:
            self.bad_count += 1
            self._runs.append(SampledRun(self._index, at, 0, 1))
            self._index += 1
            return at + size, 1
        count = 1
        wanted = 1
        while wanted > 0:
            # The number read at a time grows while the records are alike.
            wanted = min(wanted * 2, (until - at) // size - count, most - count, _MAX_IN_RUN)
            alike = self._alike(at + count * size, at, size, wanted)
            count += alike
            if alike < wanted:
                break
        self._add_run(SampledRun(self._index, at, size, count))
        self._index += count
        return at + count * size, count

    def _alike(self, start: int, like: int, size: int, count: int) -> int:
        """The number of records from `start` on, up to `count`. They have the size of the one at `like` and a possible status."""
        if count <= 0:
            return 0
        data = self._data
        end = start + count * size
        status = data[start + _STATUS : end : size].find(0)
        fewest = count if status < 0 else status
        if self._version == 3:
            return fewest
        if not _is_known(size - _HEAD):
            # The following bytes show whether it is a record.
            return 0
        for offset in range(_POWER_SIZE, _HEAD):
            column = data[start + offset : end : size]
            others = len(column) - len(column.lstrip(data[like + offset : like + offset + 1]))
            fewest = min(fewest, others)
        return fewest

    def _add_run(self, run: SampledRun) -> None:
        last = self._runs[-1] if self._runs else None
        if last is not None and last.size == run.size and last.start + last.size * last.count == run.start:
            self._runs[-1] = replace(last, count=last.count + run.count)
        else:
            self._runs.append(run)

    def skip(self, count: int) -> None:
        """Records that `count` bytes were lost: time continues as if they were records."""
        records = (count + self._last_size // 2) // self._last_size
        if records > 0:
            self._runs.append(SampledRun(self._index, 0, 0, 1))
            self._index += records

    def topics(self, columns: ByteColumns, vectors: Vectors) -> list[StationTopic]:
        """The topics made of the records."""
        data = self._data
        runs = self._runs
        indices = [range(run.first, run.first + run.count) for run in runs]
        timestamps = Timestamps(columns.times(indices, SECONDS), vectors)
        gaps = gaps_of(runs)
        size = len(timestamps)
        status = column_of(data, runs, _STATUS)
        trips = column_of(data, runs, _TRIP)
        high, low = column_of(data, runs, _VOLTS), column_of(data, runs, _VOLTS + 1)
        gap_set = set(gaps)
        there = [place for place in range(size) if place not in gap_set] if gaps else range(size)
        volts = columns.scaled(high, low, 0, 0xFFFF, 256.0)
        without_volts = columns.above(volts, _MAX_VOLTS / 256)
        without_trip = columns.places(trips, _NO_TRIP)
        without_link = {*without_volts, *without_trip}

        def numbers(name: str, unit: str, values: object, missing: list[int]) -> StationTopic:
            places = sorted({*gaps, *missing})
            is_gap = None
            if places:
                place_set = set(places)
                is_gap = vectors.gaps_outside(size, vectors.whole([place for place in range(size) if place not in place_set]))
            column = Column(FOLDER + name, NUMBERS, size, columns.with_gaps(values, places), is_gap)
            return StationTopic(column, unit, (), timestamps)

        def truths(name: str, values: object) -> StationTopic:
            topic = numbers(name, "", values, [])
            topic.column.sort = TRUTHS
            return topic

        def texts(name: str, values: list[bytes]) -> StationTopic:
            return StationTopic(Column.of_texts(FOLDER + name, size, there, values, vectors), "", (), timestamps)

        links = columns.looked_up(bytes(size), [1.0])
        for place in without_link:
            links[place] = 0.0
        robot_modes = [
            _ROBOT_MODES[status[place]] or (b"No Robot Communication" if place in without_link else b"No Robot Code") for place in there
        ]
        topics = [
            numbers("Battery Voltage", "V", volts, without_volts),
            numbers("CPU Utilization", "%", columns.looked_up(column_of(data, runs, _CPU), _HALVES), without_volts),
            numbers("CAN Utilization", "%", columns.looked_up(column_of(data, runs, _CAN), _HALVES), without_volts),
            numbers("Trip Time", "ms", columns.looked_up(trips, _HALVES), without_trip),
            numbers("Packet Loss", "%", columns.looked_up(column_of(data, runs, _LOSS), _LOSSES), []),
            truths("Comms Connected", links),
            truths("Enabled", columns.looked_up(status, _IS_ENABLED)),
            texts("DS Mode", [_DS_MODES[status[place]] for place in there]),
            texts("Robot Mode", robot_modes),
            truths("Brownout", columns.looked_up(status, _IS_BROWNOUT)),
            truths("Watchdog", columns.looked_up(status, _IS_WATCHDOG)),
        ]
        for block in (PDP, PDH):
            topics += power_columns(block, data, self._power_runs(block), self._head, columns, vectors)
        return topics

    def _power_runs(self, block: PowerBlock) -> list[SampledRun]:
        """The records with such a block, and a gap where they end."""
        found: list[SampledRun] = []
        is_missing = True
        for run in self._runs:
            if run.size == self._head + block.size:
                is_missing = False
                found.append(run)
            elif not is_missing:
                is_missing = True
                found.append(SampledRun(run.first, 0, 0, 1))
        return found


def _is_known(power: int) -> bool:
    return power in (0, PDP.size, PDH.size)

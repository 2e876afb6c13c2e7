"""Makes a recording from a `.dslog`, a `.dsevents`, or both in this order, by the rules of `docs/driver-station.md`.

Never raises because of the bytes.
"""

from __future__ import annotations

import sys

from badlog._driver_station.byte_columns import ByteColumns
from badlog._driver_station.frames import Frames, FrameSplitter
from badlog._driver_station.station_events import StationEvents
from badlog._driver_station.station_records import StationRecords
from badlog._driver_station.station_times import HEADER_SIZE, SECONDS_TO_1970, fraction_at, is_near, seconds_at, word_at
from badlog._timed.record_problems import add_cut, add_lost, add_skipped, add_too_many
from badlog._timed.vectors import vectors_of
from badlog._timed.wall_time import wall_time_text
from badlog.problem import ProblemKind, ProblemList, times_text
from badlog.recording import Recording, RecordingFormat, Topic, Value

_VERSIONS = (3, 4)
# A record has a dozen samples, and more if there is a power distribution.
_SAMPLES = 12


def parse(data: bytes, max_rows: int, with_numpy: bool) -> Recording:
    """The recording of one or two files with `data`, inflated. At most `max_rows` rows of a dozen samples are read."""
    return _StationParser(data, max_rows // _SAMPLES, with_numpy).recording()


class _StationParser:
    def __init__(self, data: bytes, most: int, with_numpy: bool) -> None:
        self._data = data
        self._most = most
        self._with_numpy = with_numpy
        self._problems = ProblemList()
        self._records: StationRecords | None = None
        self._events: StationEvents | None = None
        self._refusal: str | None = None
        # The time of day at which x is 0, in whole seconds since 1904 and their fraction. None if no header was read.
        self._origin: tuple[float, float] | None = None

    def recording(self) -> Recording:
        problems = self._problems
        splitter = FrameSplitter(self._data, self._most, self._begin, lambda start, until: add_skipped(problems, start, until))
        if self._refusal is None:
            self._report_end(splitter)
        else:
            problems.add(ProblemKind.NOT_A_RECORDING, self._refusal)
        vectors = vectors_of(self._data, self._with_numpy)
        found = [] if self._records is None else self._records.topics(ByteColumns(self._with_numpy), vectors)
        found += [] if self._events is None else self._events.topics(vectors)
        topics: list[Topic] = []
        for column, unit, attributes, timestamps in found:
            timestamps.finish(0.0, sys.float_info.max)
            topics.append(column.topic(column.path, unit, attributes, timestamps, vectors, problems))
        if self._refusal is None and splitter.count == 0:
            problems.add(ProblemKind.NO_ROWS, "There are no samples; the Driver Station may have been closed too early.")
        return Recording(RecordingFormat.DRIVER_STATION, None, self._values(), topics, 0, problems.to_list())

    def _begin(self, at: int) -> Frames | None:
        """The frames that follow the header at `at`; None if they are not to be read."""
        data = self._data
        version = word_at(data, at)
        if version not in _VERSIONS:
            self._refusal = f"This Driver Station log has version {version}; badlog reads versions 3 and 4 (2016 to 2026)."
            return None
        seconds = seconds_at(data, at + 4)
        if self._origin is None:
            self._origin = (seconds, fraction_at(data, at + 4))
        first = at + HEADER_SIZE
        is_entry = len(data) - first >= 8 and word_at(data, first) == 0 and is_near(seconds_at(data, first), seconds)
        if self._records is None and not is_entry:
            self._records = StationRecords(data, version)
            return self._records
        self._events = StationEvents(data, seconds, self._origin)
        return self._events

    def _values(self) -> list[Value]:
        values = [] if self._events is None else self._events.values()
        if self._origin is not None:
            seconds, fraction = self._origin
            start = wall_time_text((seconds + fraction - SECONDS_TO_1970) * 1e6)
            values += [] if start is None else [Value("Start Time", start)]
        return values

    def _report_end(self, splitter: FrameSplitter) -> None:
        problems = self._problems
        bad = 0 if self._records is None else self._records.bad_count
        if bad > 0:
            problems.add(ProblemKind.BAD_RECORD, f"Records with all modes of the robot at once were dropped{times_text(bad)}.", count=bad)
        if splitter.is_full:
            add_too_many(problems, self._most)
        elif splitter.lost_from >= 0:
            add_lost(problems, splitter.lost_from, len(self._data))
        elif splitter.pending_bytes > 0:
            add_cut(problems)

"""The content of one log."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING

from badlog._samples import Numbers, Samples
from badlog.problem import Problem, ProblemKind, Severity

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

__all__ = ["CellCounts", "Event", "Recording", "RecordingFormat", "Topic", "TopicKind", "Value"]

UNITLESS = "ul"

# Up to this many different texts are states, however often each occurs.
_MAX_RARE_STATES = 8


class RecordingFormat(str, Enum):
    """The format that a recording was read from."""

    BAG = "bag"
    """A line of JSON, then CSV."""
    CSV = "csv"
    """CSV alone: a bag without units, attributes and values."""
    WPILOG = "wpilog"
    """The log of WPILib's DataLog."""
    DRIVER_STATION = "driver_station"
    """A log of the FRC Driver Station: its records, its events, or both."""

    @property
    def has_rows(self) -> bool:
        """Whether all topics share rows; otherwise each has times of its own."""
        return self in (RecordingFormat.BAG, RecordingFormat.CSV)


class TopicKind(str, Enum):
    """The kinds of topics, by the content of their cells."""

    EMPTY = "empty"
    """No cell holds anything."""
    NUMERIC = "numeric"
    """Numbers."""
    BOOLEAN = "boolean"
    """Only `true` and `false`, kept as 1 and 0."""
    STATE = "state"
    """The states of something: mostly texts, in at least half of the rows. With times of its own, few different texts."""
    EVENT = "event"
    """Mostly texts, in fewer than half of the rows, or with times of its own and many different texts: events."""


@dataclass(frozen=True)
class Value:
    """A name and a text that were known when the log began, such as the match number."""

    name: str
    text: str


@dataclass(frozen=True)
class Event:
    """A text with a time."""

    x: float
    """The x of its row: the value of the topic with the attribute `xaxis`, otherwise the row's index. In a log without rows, its time in s."""
    topic: str
    text: str


@dataclass(frozen=True)
class CellCounts:
    """The number of a topic's cells for each kind of content. All but `gaps` add up to the number of its rows, or of its times."""

    numbers: int
    """Finite numbers."""
    not_finite: int
    """`NaN` and infinities that were written as such."""
    truth_values: int
    """`true` and `false`."""
    texts: int
    """Any other text."""
    empty: int
    """Empty cells, `null`, and cells that their row lacks."""
    gaps: int
    """The number of runs of neighboring rows without a number."""

    @property
    def total(self) -> int:
        """The number of cells."""
        return self.numbers + self.not_finite + self.truth_values + self.texts + self.empty

    @property
    def kind(self) -> TopicKind:
        """The kind of a topic with such cells."""
        numeric = self.numbers + self.not_finite + self.truth_values
        if numeric == 0 and self.texts == 0:
            return TopicKind.EMPTY
        if self.texts > numeric:
            return TopicKind.STATE if self.texts * 2 >= self.total else TopicKind.EVENT
        return TopicKind.BOOLEAN if self.truth_values == numeric else TopicKind.NUMERIC


@dataclass(frozen=True)
class Topic:
    """A named, united, attributed stream of samples: one for each row of its recording, or at times of its own."""

    name: str
    """The full name, unique in its recording; `/` makes folders."""
    unit: str
    """The unit as the file gives it; `ul` and the empty text mean none."""
    attributes: tuple[str, ...]
    """The attributes as the file gives them, in its order."""
    counts: CellCounts
    """The number of cells of each kind."""
    _samples: Samples = field(repr=False, compare=False)
    _text_rows: Sequence[int] = field(repr=False, compare=False)
    _text_ids: Sequence[int] = field(repr=False, compare=False)
    _dictionary: Sequence[str] = field(repr=False, compare=False)
    _written_nans: list[int] = field(repr=False, compare=False)
    _times: Samples | None = field(default=None, repr=False, compare=False)
    type: str = ""
    """The type of the samples as the file names it, such as `double` or `struct:Pose2d`; empty if it names none."""
    metadata: str = field(default="", repr=False)
    """Further text about the topic in the file, often JSON; may be empty."""

    @property
    def times(self) -> Numbers | None:
        """The time of each sample, in s, ascending, perhaps repeating. None if sample `i` belongs to row `i` of the recording.

        Like `samples`, an array of NumPy or an `array('d')`; topics that were logged together share it. See `Recording.x_of`.
        """
        return None if self._times is None else self._times.whole()

    @property
    def samples(self) -> Numbers:
        """One number for each row or time, NaN where there is none. A read-only array of NumPy, or an `array('d')` without NumPy."""
        return self._samples.whole()

    @property
    def texts(self) -> list[tuple[int, str]]:
        """The cells that hold a text: the row, or the index of the time, from 0, and the text."""
        return [(int(row), self._dictionary[id]) for row, id in zip(self._text_rows, self._text_ids)]

    @property
    def kind(self) -> TopicKind:
        """The kind of the topic, determined by its cells."""
        kind = self.counts.kind
        if kind is TopicKind.STATE and self._times is not None and _tells_events(len(self._dictionary), len(self._text_rows)):
            return TopicKind.EVENT
        return kind

    @property
    def is_sparse(self) -> bool:
        """Whether fewer than half of the rows have a number, mostly isolated ones.

        Such a topic is sampled at its own times: its empty cells are not gaps, but rows without a sample.
        """
        if self._times is not None:
            return False
        without_number = self.counts.empty + self.counts.texts
        with_number = self.counts.total - without_number
        return without_number > with_number and with_number < 2 * self.counts.gaps

    def __len__(self) -> int:
        return self.counts.total

    def to_arrow(self) -> pyarrow.Array | pyarrow.ChunkedArray:
        """The cells as an array of Arrow: doubles, booleans, or a dictionary of texts, with null for a gap."""
        from badlog import _tables

        return _tables.column_of(self)


def _tells_events(different: int, texts: int) -> bool:
    return different > _MAX_RARE_STATES and different * 2 > texts


class Recording:
    """The content of one log: everything that could be kept, and the problems found.

    `recording["Arm/Angle"]` is a topic; iterating gives the topics' names, as with a `dict`.
    """

    def __init__(
        self,
        format: RecordingFormat,
        header_line: str | None,
        values: list[Value],
        topics: list[Topic],
        row_count: int,
        problems: list[Problem],
        path: str | None = None,
    ) -> None:
        self.format = format
        self.header_line = header_line
        """The JSON of the file's first line, exactly as in the file, or None if it has none."""
        self.values = values
        """The values, in the order of the file."""
        self.topics = topics
        """The topics, in the order in which they are shown."""
        self.row_count = row_count
        """The number of samples of each topic. It is 0 in a log without rows, in which each topic has `times` of its own."""
        self.problems = problems
        """The problems of the file."""
        self.path = path
        """The file it was read from; None if it was read from bytes."""
        self._by_name = {topic.name: topic for topic in topics}

    def __getitem__(self, name: str) -> Topic:
        try:
            return self._by_name[name]
        except KeyError:
            raise KeyError(f"The log has no topic “{name}”; it has {len(self.topics)}, see recording.topics.") from None

    def __contains__(self, name: object) -> bool:
        return name in self._by_name

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    def __len__(self) -> int:
        return len(self.topics)

    def __repr__(self) -> str:
        name = "" if self.path is None else f"{os.path.basename(self.path)}: "
        size = f"{self.row_count} rows" if self.format.has_rows else f"{self.sample_count} samples"
        return f"<badlog.Recording {name}{len(self.topics)} topics, {size}, {len(self.problems)} problems>"

    def value(self, name: str, default: str = "") -> str:
        """The text of the first value of that name, or `default` if there is none."""
        return next((value.text for value in self.values if value.name == name), default)

    @property
    def units(self) -> dict[str, str]:
        """The unit of each topic that has one, by name."""
        return {topic.name: topic.unit for topic in self.topics if topic.unit not in ("", UNITLESS)}

    @property
    def sample_count(self) -> int:
        """The number of samples of all topics together, gaps included."""
        return sum(len(topic) for topic in self.topics)

    @property
    def is_readable(self) -> bool:
        """False for bytes that are not a log at all, so that there is nothing but `problems`."""
        return all(problem.kind is not ProblemKind.NOT_A_RECORDING for problem in self.problems)

    @property
    def is_salvaged(self) -> bool:
        """True if part of the file's data is lost: one of `problems` is an error."""
        return any(problem.severity is Severity.ERROR for problem in self.problems)

    @property
    def x_axis(self) -> Topic | None:
        """The first topic with the attribute `xaxis`, if it has numbers."""
        axis = next((topic for topic in self.topics if "xaxis" in topic.attributes), None)
        has_numbers = axis is not None and axis.kind in (TopicKind.NUMERIC, TopicKind.BOOLEAN, TopicKind.STATE)
        return axis if has_numbers and axis is not None and axis.counts.total > axis.counts.texts + axis.counts.empty else None

    def x_of(self, name: str) -> Numbers:
        """The x of each sample of the topic `name`. It is its own times in s, or the rows' times, otherwise the rows' indices.

        Raises:
            KeyError: There is no such topic.
        """
        topic = self[name]
        if topic.times is not None:
            return topic.times
        axis = self.x_axis
        return Samples.of_indices(len(topic)).whole() if axis is None else axis.samples

    @property
    def events(self) -> list[Event]:
        """The texts of all topics that are events or have the attribute `log`. They are in the order of the rows, or of their times."""
        axis = self.x_axis
        x = None if axis is None else axis.samples
        found: list[tuple[float, Event]] = []
        for topic in self.topics:
            if topic.kind is not TopicKind.EVENT and "log" not in topic.attributes:
                continue
            times = topic.times
            for row, text in topic.texts:
                place = float(row if x is None else x[row]) if times is None else float(times[row])
                found.append((float(row) if times is None else place, Event(place, topic.name, text)))
        found.sort(key=lambda ranked: ranked[0])
        return [event for _, event in found]

    def resampled(self, period: float | None = None, rows_at: str | None = None) -> Recording:
        """This log with rows: every `period` s, or at each time of the topic `rows_at`.

        In each row, a topic has its last value at or before that time, and nothing before its first sample. An event is in the first row that is not
        before it; several in one row are joined by `; `. The first topic, `Time`, has the times of the rows.

        Raises:
            ValueError: The log has rows already, both or neither are given, or the period gives no rows or more than 100 million.
            KeyError: There is no such topic.
        """
        from badlog._timed import resampling

        if self.format.has_rows:
            raise ValueError("The log has rows already.")
        if (period is None) == (rows_at is None):
            raise ValueError("Pass either a period in s or the name of a topic that gives the times of the rows.")
        rows = resampling.times_of(self[rows_at]) if rows_at is not None else resampling.periodic_times(self, period or 0.0)
        return resampling.resampled(self, rows)

    @property
    def attribute_problems(self) -> list[Problem]:
        """The problems of the topics' attributes: found when they are applied, not when the file is read."""
        from badlog._attributes import attribute_problems

        return attribute_problems(self)

    def to_arrow(self) -> pyarrow.Table:
        """A table of Arrow, a column for each topic; units, attributes and values are in its metadata. See `docs/python.md`.

        Raises:
            ValueError: The log has no rows; see `resampled`.
        """
        from badlog import _tables

        return _tables.table_of(self)

    def to_pandas(self, index: str | None = None) -> pandas.DataFrame:
        """A data frame, a column for each topic; units and values are in its `attrs`. `index` names the topic that is the index.

        Raises:
            ValueError: The log has no rows; see `resampled`.
        """
        from badlog import _tables

        return _tables.pandas_of(self, index)

    def to_polars(self) -> polars.DataFrame:
        """A data frame of Polars, a column for each topic. Polars keeps no metadata: see `units`.

        Raises:
            ValueError: The log has no rows; see `resampled`.
        """
        from badlog import _tables

        return _tables.polars_of(self)

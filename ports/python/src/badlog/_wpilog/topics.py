"""Creates the topics of the entries, each with a unique name."""

from __future__ import annotations

from collections.abc import Iterator

from badlog._timed.column import NUMBERS, Column
from badlog._timed.vectors import Vectors
from badlog._wpilog.blocks import Decoded
from badlog._wpilog.entry import MESSAGE_SCHEMA, Entry
from badlog.problem import ProblemKind, ProblemList, times_text
from badlog.recording import Topic

_BYTE = "B"


class TopicMaker:
    """Keeps samples from `first` to `last`, in s, and counts their times from `origin`, in µs."""

    def __init__(self, first: float, last: float, origin: float, vectors: Vectors, problems: ProblemList) -> None:
        self._first = first
        self._last = last
        self._origin = origin
        self._vectors = vectors
        self._problems = problems
        self._given: set[str] = set()
        self._copies: dict[str, int] = {}

    def topics_of(self, entry: Entry, decoded: Decoded) -> Iterator[Topic]:
        """The topics of `entry`, made of its `decoded` payloads."""
        decoded.timestamps.finish(self._first, self._last, self._origin)
        vectors = self._vectors
        unit = _BYTE if decoded.is_undecoded else entry.unit
        attributes = entry.attributes
        type = entry.topic_type
        if not any(block.columns for block in decoded.blocks):
            # An entry without records, or with only empty arrays, is still a topic.
            size = len(decoded.timestamps)
            gaps = Column("", NUMBERS, size, vectors.nans(size), vectors.gaps_outside(size, vectors.whole([])))
            name = self._unique(entry.name)
            yield gaps.topic(name, unit, attributes, decoded.timestamps, vectors, self._problems, type, entry.metadata)
        for block in decoded.blocks:
            block.timestamps.finish(self._first, self._last, self._origin)
            for column in block.columns:
                name = self._unique(entry.name + column.path)
                # In an event message, only texts are events; times and counts beside them are numbers.
                is_number = len(column.text_rows) == 0 and type.startswith("proto:")
                own = tuple(text for text in attributes if text != "log") if is_number else attributes
                yield column.topic(name, unit, own, block.timestamps, vectors, self._problems, type, entry.metadata)

    def _unique(self, wanted: str) -> str:
        name = wanted
        copy = self._copies.get(wanted, 2)
        while name in self._given:
            name = f"{wanted} ({copy})"
            copy += 1
        self._given.add(name)
        self._copies[wanted] = copy
        if name != wanted:
            self._problems.add(ProblemKind.DUPLICATE_TOPIC, f"Two topics are named “{wanted}”; the second is shown as “{name}”.", topic=name)
        return name


def report_entry(entry: Entry, decoded: Decoded, problems: ProblemList) -> None:
    """Reports the oddities of one entry's records."""
    name = entry.name
    if decoded.bad_count > 0:
        message = f"Records of “{name}” are not of its type, {entry.type}, and were dropped{times_text(decoded.bad_count)}."
        problems.add(ProblemKind.BAD_RECORD, message, topic=name, count=decoded.bad_count)
    if decoded.dropped_values > 0:
        message = f"Values of “{name}” were dropped{times_text(decoded.dropped_values)}: there are more than can be shown."
        problems.add(ProblemKind.TOO_MANY_TOPICS, message, topic=name, count=decoded.dropped_values)
    if decoded.is_undecoded and len(decoded.timestamps) > 0 and entry.type != MESSAGE_SCHEMA:
        message = f"“{name}” has the type {entry.type}, which badlog cannot decode; the size of each record is shown instead, in bytes."
        problems.add(ProblemKind.NOT_DECODED, message, topic=name)

"""The entries of a `.dsevents`, each with its time of day and often several messages."""

from __future__ import annotations

import re

from badlog._driver_station.frames import MORE, NONE
from badlog._driver_station.station_times import fraction_at, is_near, seconds_at, word_at
from badlog._driver_station.station_topics import StationTopic
from badlog._text import BLANKS
from badlog._timed.column import NUMBERS, Column, Timestamps
from badlog._timed.vectors import Vectors
from badlog.recording import Value

_TIME_SIZE = 16
_HEADER_SIZE = 20
# The longest entry seen has 22 kB.
_MAX_TEXT = 1 << 20
_FOLDER = "Driver Station/"
# The beginnings of untagged messages.
_SPEAKERS = ("Info ", "Warning ", "ERROR ")
# The names and units, in the order of the line.
_SYSTEM = (("roboRIO Disk Free", "MB"), ("roboRIO Memory Free", "MB"), ("Laptop CPU", "%"), ("Laptop Battery", "%"))
_SYSTEM_LINE = re.compile(r"Disk Free (\d+) MB, Memory Free (\d+) MB\. DS Laptop: CPU (\d+)% Batt (\d+)%", re.ASCII)
_EVENT_NAME = re.compile(r"FMS Event Name: *([^\s<]+)", re.ASCII)
_MATCH = re.compile(r"FMS Connected: +(\w+) - (\d+):(\d+)", re.ASCII)
_FLAGS = re.compile(r"[+-]?[0-9]{1,10}")


class StationEvents:
    """Receives the entries of one file: `Frames`. Times count from `origin`, whole seconds and their fraction."""

    may_end = False

    def __init__(self, data: bytes, header_seconds: float, origin: tuple[float, float]) -> None:
        self._data = data
        self._end = len(data)
        self._header_seconds = header_seconds
        self._origin = origin
        self._events: list[tuple[float, bytes]] = []
        self._console: list[tuple[float, bytes]] = []
        self._system: list[tuple[float, list[float]]] = []
        self._event_name = ""
        self._match: re.Match[str] | None = None

    def size_at(self, at: int) -> int:
        """The size of the entry at `at`."""
        data = self._data
        if self._end - at < _HEADER_SIZE:
            return MORE
        size = word_at(data, at + _TIME_SIZE)
        if word_at(data, at) != 0 or size > _MAX_TEXT or not is_near(seconds_at(data, at), self._header_seconds):
            return NONE
        return MORE if self._end - at < _HEADER_SIZE + size else _HEADER_SIZE + size

    def is_sure(self, at: int) -> bool:
        """Whether the entry at `at` is certainly one, according to its time."""
        return True

    def take(self, at: int, size: int, until: int, most: int) -> tuple[int, int]:
        """Reads the entry at `at`."""
        seconds, fraction = self._origin
        time = seconds_at(self._data, at) - seconds + (fraction_at(self._data, at) - fraction)
        text = self._data[at + _HEADER_SIZE : at + size].decode("utf-8", "replace")
        name = _EVENT_NAME.search(text)
        self._event_name = self._event_name if name is None else name.group(1)
        self._match = _MATCH.search(text) or self._match
        # The newest comes first.
        for message in reversed(text.split("<TagVersion>")):
            self._hear(time, message)
        return at + size, 1

    def skip(self, count: int) -> None:
        """Does nothing: each entry has its own time."""

    def _hear(self, time: float, message: str) -> None:
        if "<time>" not in message:
            for speaker in _SPEAKERS:
                message = message.replace(f" {speaker}", f"\0{speaker}")
            for line in message.split("\0"):
                self._hear_untagged(time, line)
        elif "<details>" in message:
            flags = _between(message, "<flags>", "<Code>")
            is_error = _FLAGS.fullmatch(flags) is not None and int(flags) % 2 == 1 and abs(int(flags)) < 1 << 31
            location = _between(message, "<location>", "<stack>")
            stack = message.partition("<stack>")[2].rstrip(BLANKS)
            what = f"{'ERROR' if is_error else 'Warning'} {_between(message, '<Code>', '<details>')} {_between(message, '<details>', '<location>')}"
            what += f" at {location}" if location else ""
            _add(self._events, time, what + (f"\n{stack}" if stack else ""))
        else:
            _, tag, told = message.partition("<message>")
            told = told if tag else message
            _, blank, rest = told.partition(" ")
            _add(self._console, time, (rest if blank else told).rstrip(BLANKS))

    def _hear_untagged(self, time: float, message: str) -> None:
        found = _SYSTEM_LINE.search(message)
        if found is None:
            _add(self._events, time, message.strip(BLANKS))
        else:
            self._system.append((time, [float(digits) for digits in found.groups()]))

    def values(self) -> list[Value]:
        """The match, as reported by the field."""
        values = [Value("Event Name", self._event_name)] if self._event_name else []
        if self._match is not None:
            names = ("Match Type", "Match Number", "Replay Number")
            values += [Value(name, text) for name, text in zip(names, self._match.groups())]
        return values

    def topics(self, vectors: Vectors) -> list[StationTopic]:
        """The topics made of the entries."""
        topics = []
        for name, lane in (("Events", self._events), ("Console", self._console)):
            column = Column.of_texts(_FOLDER + name, len(lane), range(len(lane)), [text for _, text in lane], vectors)
            topics.append(StationTopic(column, "", ("log",), _timestamps([time for time, _ in lane], vectors)))
        timestamps = _timestamps([time for time, _ in self._system], vectors)
        for i, (name, unit) in enumerate(_SYSTEM):
            numbers = vectors.numbers([found[i] for _, found in self._system])
            topics.append(StationTopic(Column(_FOLDER + name, NUMBERS, len(self._system), numbers), unit, (), timestamps))
        return topics


def _timestamps(times: list[float], vectors: Vectors) -> Timestamps:
    return Timestamps(vectors.numbers(times), vectors)


def _add(lane: list[tuple[float, bytes]], time: float, text: str) -> None:
    if text.strip(BLANKS):
        lane.append((time, text.encode()))


def _between(text: str, start: str, end: str) -> str:
    return text.partition(start)[2].partition(end)[0].strip(BLANKS)

"""The columns of a log.

A row is made in three steps: `sample` calls the robot's code, without holding any lock, because that code may do anything; `commit` makes all
samples current at once; `cell` returns their text. The last two run under the log's lock.
"""

from __future__ import annotations

import threading
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from enum import Enum
from typing import Any

from badlog.recording import UNITLESS
from badlog.robot._bag_text import text_cell
from badlog.robot._events import EventTexts
from badlog.robot._faults import Faults, describe
from badlog.robot._numbers import five_digits, microseconds

DEFAULT_DATA = "-1.0"

NumberFormatter = Callable[[float], str]


class DataInferMode(Enum):
    """The content of a subscriber topic's cell if nothing was published since the last `update_topics`."""

    DEFAULT = "default"
    """The default, `BadLog.DEFAULT_DATA`."""
    LAST = "last"
    """The last published value; the default until there is one."""


class NumberText:
    """Converts a log's numbers to text: by the format's own rules, or by the program's `function` once it is set.

    The function that was set when a number was supplied or published converts it.
    """

    def __init__(self, faults: Faults) -> None:
        self._faults = faults
        self.function: NumberFormatter | None = None
        self.current: NumberFormatter | None = None
        """The value of `function` when the current values were supplied."""

    def cell(self, value: float, function: NumberFormatter | None, topic: Topic) -> bytes:
        if function is None:
            return (microseconds(value) if topic.is_x_axis else five_digits(value)).encode("ascii")
        try:
            text = function(value)
        except Exception as failure:
            self._faults.cell_missed(topic.name, f"could not be formatted: the double-to-string function raised {describe(failure)}")
            return b""
        if not isinstance(text, str):
            self._faults.cell_missed(topic.name, "could not be formatted: the double-to-string function gave no text")
            return b""
        return text_cell(text)


class Topic(ABC):
    """One column."""

    def __init__(self, name: str, unit: str, attributes: Sequence[str]) -> None:
        self.name = name
        self.unit = unit
        self.attributes = tuple(attributes)
        self.is_x_axis = "xaxis" in self.attributes
        """Whether it is the x axis of all other topics, which needs more digits than they do."""

    def sample(self) -> None:
        """Calls the robot's code, if the topic has a callable."""

    def commit(self) -> None:
        """Makes the sample the current one, if there is one."""

    @abstractmethod
    def cell(self) -> bytes:
        """The current sample as it is written in the row."""


class QueriedTopic(Topic):
    """A topic with values from a supplier in the robot's code. A failed call leaves a gap."""

    def __init__(
        self,
        name: str,
        unit: str,
        attributes: Sequence[str],
        supplier: Callable[[], Any],
        convert: Callable[[Any], Any],
        write: Callable[[Any, QueriedTopic], bytes],
        faults: Faults,
    ) -> None:
        super().__init__(name, unit, attributes)
        self._supplier = supplier
        self._convert = convert
        self._write = write
        self._faults = faults
        self._sample: Any = None
        self._current: Any = None

    def sample(self) -> None:
        self._sample = None
        try:
            value = self._supplier()
            if value is None:
                self._faults.cell_missed(self.name, "gave None")
            else:
                self._sample = self._convert(value)
        except Exception as failure:
            self._faults.cell_missed(self.name, f"raised {describe(failure)}")

    def commit(self) -> None:
        self._current = self._sample

    def cell(self) -> bytes:
        return b"" if self._current is None else self._write(self._current, self)


class SubscribedTopic(Topic):
    """A topic with values that the robot's code publishes, from any thread, at any time.

    It has its own lock, so publishers never wait for a write. An event log also takes the log's own events, in rows without a new text.
    """

    def __init__(self, name: str, unit: str, attributes: Sequence[str], mode: DataInferMode, text: NumberText, texts: EventTexts) -> None:
        super().__init__(name, unit, attributes)
        self._mode = mode
        self._number_text = text
        self.texts = texts
        self._lock = threading.Lock()
        self._published: tuple[float | str, NumberFormatter | None] | None = None
        self._current: tuple[float | str, NumberFormatter | None] = (DEFAULT_DATA, None)
        self._is_new = False

    @property
    def is_event_log(self) -> bool:
        """Whether it can take the log's own events."""
        return "log" in self.attributes

    def publish(self, value: float | str) -> None:
        with self._lock:
            self._published = (value, self._number_text.function)

    def commit(self) -> None:
        with self._lock:
            published = self._published
            self._published = None
        self._is_new = published is not None
        if published is not None:
            self._current = published
        elif self._mode is DataInferMode.DEFAULT:
            self._current = (DEFAULT_DATA, None)

    def cell(self) -> bytes:
        events = None if self._is_new else self.texts.take()
        if events is not None:
            return text_cell(events)
        value, function = self._current
        return text_cell(value) if isinstance(value, str) else self._number_text.cell(value, function, self)


class EventTopic(Topic):
    """A topic of events: each row has all events since the previous row, however often the topics were updated."""

    def __init__(self, name: str, texts: EventTexts) -> None:
        super().__init__(name, UNITLESS, ("log",))
        self.texts = texts

    def cell(self) -> bytes:
        text = self.texts.take()
        return b"" if text is None else text_cell(text)

"""Logs a robot's data into a bag, with the original's functions under Python's usual names."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import ClassVar

from badlog.recording import UNITLESS
from badlog.robot import _standard_error
from badlog.robot._bag_text import text_cell
from badlog.robot._events import EventTexts
from badlog.robot._faults import Faults, LogCounters
from badlog.robot._session import InvalidModeError, LogSession, LogState
from badlog.robot._topics import DEFAULT_DATA, DataInferMode, EventTopic, QueriedTopic, SubscribedTopic

__all__ = ["BadLog", "Events", "Publisher"]


class Publisher:
    """Publishes to one subscriber topic without looking up its name. Created by `BadLog.create_publisher`.

    Thread-safe; never raises, and never waits for a file.
    """

    def __init__(self, topic: SubscribedTopic, session: LogSession) -> None:
        self._topic = topic
        self._session = session

    def publish(self, value: float | str) -> None:
        """Publishes a number or a text for the next `update_topics`; the last one counts. Anything else is ignored."""
        self._session.publish_to(self._topic, value)


class Events:
    """An event log, created by `BadLog.create_events`. Thread-safe."""

    def __init__(self, topic: EventTopic, faults: Faults) -> None:
        self._topic = topic
        self._faults = faults

    def event(self, text: str) -> None:
        """Logs that something happened. The event is in the next row; several events of one row are joined in order by `; `.

        Never raises; blank texts, and anything but a text, are ignored.
        """
        if isinstance(text, str) and text.strip():
            self._topic.texts.add(text)
        else:
            self._faults.call_ignored(self._topic.name, f'The event log "{self._topic.name}" was given an event without a text.')


class BadLog:
    """A log. There is one at a time: `init` starts it, the class's functions create topics and values, `finish_initialization`
    writes the header, and then each loop calls `update_topics` and `log`.

    While a log is set up, mistakes raise. The functions that a robot calls in its loop, `update_topics`, `log`, `flush` and those that
    publish, never raise. A failure leaves a gap, or the call is ignored; it is counted (see `counters`), reported once on standard error, and
    noted in the log's first event log, if there is one. All functions may be called from any thread.
    """

    UNITLESS: ClassVar[str] = UNITLESS
    """The unit of data without a unit."""
    DEFAULT_DATA: ClassVar[str] = DEFAULT_DATA
    """The content of a subscriber topic's cell without a value."""

    _current: ClassVar[BadLog | None] = None
    _starting: ClassVar[threading.Lock] = threading.Lock()

    def __init__(self, session: LogSession) -> None:
        self._session = session

    @classmethod
    def init(cls, path: str | os.PathLike[str], compress: bool = False, flush: bool = True) -> BadLog:
        """Starts a log. Missing folders are created; an existing file of that name is replaced. If there already is a log, it is closed first.

        If the file cannot be created, this is reported on standard error, and nothing is logged.

        Args:
            path: The path of the file, such as `/home/lvuser/logs/match.bag`.
            compress: True to write a gzip file; then `.gz` is added to the path.
            flush: True to write each row at once, False to write the rows of about a quarter of a second together.
        """
        session = LogSession(flushes_each_row=flush)
        log = cls(session)
        with cls._starting:
            before = BadLog._current
            if before is not None and before.state is not LogState.CLOSED:
                _standard_error.print_soon("A new log was started while another was open; the other one was closed.")
                before.close()
            BadLog._current = log
        session.open(Path(f"{os.fspath(path)}.gz" if compress else path), compress)
        return log

    @classmethod
    def create_topic(cls, name: str, unit: str, supplier: Callable[[], float | None], *attrs: str) -> None:
        """Creates a topic of numbers.

        Args:
            name: Letters, digits, spaces, `_`, and `/` for folders.
            unit: Such as `V`, or `BadLog.UNITLESS`.
            supplier: Called in each `update_topics`; None leaves a gap.
            attrs: How to show it, such as `hide` or `join:Drivetrain`.

        Raises:
            DuplicateNameError: A topic or value of that name exists.
            InvalidModeError: Before `init` or after `finish_initialization`.
        """
        session = cls._setting_up(name)
        text = session.text
        faults = session.faults
        session.add(QueriedTopic(name, unit, attrs, supplier, float, lambda value, topic: text.cell(value, text.current, topic), faults))

    @classmethod
    def create_topic_str(cls, name: str, unit: str, supplier: Callable[[], str | None], *attrs: str) -> None:
        """Creates a topic of texts, otherwise like `create_topic`."""
        session = cls._setting_up(name)
        session.add(QueriedTopic(name, unit, attrs, supplier, str, lambda value, _: text_cell(value), session.faults))

    @classmethod
    def create_topic_int(cls, name: str, unit: str, supplier: Callable[[], int | None], *attrs: str) -> None:
        """Creates a topic of whole numbers, written with all their digits; otherwise like `create_topic`."""
        session = cls._setting_up(name)
        session.add(QueriedTopic(name, unit, attrs, supplier, int, lambda value, _: b"%d" % value, session.faults))

    @classmethod
    def create_topic_bool(cls, name: str, unit: str, supplier: Callable[[], bool | None], *attrs: str) -> None:
        """Creates a topic that is true or false, otherwise like `create_topic`."""
        session = cls._setting_up(name)
        session.add(QueriedTopic(name, unit, attrs, supplier, bool, lambda value, _: b"true" if value else b"false", session.faults))

    @classmethod
    def create_topic_subscriber(cls, name: str, unit: str, mode: DataInferMode, *attrs: str) -> None:
        """Creates a topic for published values. `mode` decides its value if nothing was published. Otherwise like `create_topic`."""
        cls.create_publisher(name, unit, mode, *attrs)

    @classmethod
    def create_publisher(cls, name: str, unit: str, mode: DataInferMode, *attrs: str) -> Publisher:
        """Creates a topic like `create_topic_subscriber`, and returns a faster way to publish to it."""
        session = cls._setting_up(name)
        topic = SubscribedTopic(name, unit, attrs, mode, session.text, EventTexts(session.faults))
        return Publisher(session.add(topic), session)

    @classmethod
    def create_events(cls, name: str) -> Events:
        """Creates an event log: a topic with the attribute `log`. Raises the same exceptions as `create_topic`."""
        session = cls._setting_up(name)
        return Events(session.add(EventTopic(name, EventTexts(session.faults))), session.faults)

    @classmethod
    def create_value(cls, name: str, value: str) -> None:
        """Creates a value: a text that is already known, such as the match number. Raises the same exceptions as `create_topic`."""
        cls._setting_up(name).add_value(name, str(value))

    @classmethod
    def publish(cls, name: str, value: float | str) -> None:
        """Publishes a number or a text to a subscriber topic. Never raises."""
        current = BadLog._current
        if current is not None:
            current._session.publish(name, value)

    def finish_initialization(self) -> None:
        """Ends the setup and writes the header.

        Raises:
            InvalidModeError: That was done before.
        """
        self._session.finish_setup()

    def update_topics(self) -> None:
        """Calls all suppliers, and takes over the published values. All rows until the next call have these values."""
        self._session.update()

    def log(self) -> None:
        """Writes a row with the values from the last `update_topics`."""
        self._session.log()

    def flush(self) -> None:
        """Writes the rows that are still buffered, if the log was started without writing each row at once."""
        self._session.flush()

    def set_double_to_string_function(self, function: Callable[[float], str] | None) -> None:
        """Sets how numbers are converted to text, for all topics, including those already created. Default, and None: `%.5g`.

        The function is called while a row is built, with the log's lock held: it must be quick, and must not wait for other threads.
        """
        self._session.text.function = function

    def set_syncing(self, enabled: bool) -> None:
        """Sets whether rows are synced to the disk four times a second. Default: on."""
        self._session.set_syncing(enabled)

    def close(self) -> None:
        """Writes the buffered rows, and closes the file. Later calls are ignored."""
        self._session.close()

    @property
    def state(self) -> LogState:
        """The current state of the log."""
        return self._session.state

    def counters(self) -> LogCounters:
        """The numbers of rows, cells and calls that were written, lost or ignored so far."""
        return self._session.faults.counters()

    def __enter__(self) -> BadLog:
        return self

    def __exit__(self, kind: type[BaseException] | None, cause: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    @classmethod
    def _setting_up(cls, name: str) -> LogSession:
        if BadLog._current is None:
            raise InvalidModeError(f'"{name}" was created too early: call BadLog.init(path) first.')
        return BadLog._current._session

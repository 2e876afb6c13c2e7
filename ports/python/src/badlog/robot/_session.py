"""One log from its setup to its end. Mistakes during setup raise; the functions that a robot calls in its loop never do."""

from __future__ import annotations

import atexit
import threading
import time
from enum import Enum
from pathlib import Path
from typing import TypeVar

from badlog._text import is_letter_or_digit
from badlog.robot import _standard_error
from badlog.robot._bag_text import header_lines, row_of
from badlog.robot._events import EventTexts
from badlog.robot._faults import Faults, describe
from badlog.robot._sink import LogFile, RowSink
from badlog.robot._sync import SyncThread
from badlog.robot._topics import EventTopic, NumberText, SubscribedTopic, Topic

T = TypeVar("T", bound=Topic)


class DuplicateNameError(ValueError):
    """A topic or a value was created with a name that is already taken."""


class InvalidModeError(RuntimeError):
    """Something was done too early or too late: a topic created before `init` or after `finish_initialization`."""


class LogState(Enum):
    """The states of a log."""

    SETTING_UP = "setting up"
    """Topics and values can be created; nothing is logged yet."""
    LOGGING = "logging"
    """Rows are being written."""
    FAILING = "failing"
    """Rows cannot currently be written, or go to a file that was deleted; they are lost and counted."""
    CLOSED = "closed"
    """The log was closed; calls are ignored."""


class LogSession:
    """One log. Its lock is held while a row is built and written, and never while the robot's callables are called."""

    def __init__(self, flushes_each_row: bool) -> None:
        self._flushes_each_row = flushes_each_row
        self._lock = threading.RLock()
        self._is_sampling = threading.Lock()
        self._names: set[str] = set()
        self._values: list[tuple[str, str]] = []
        self._topics: list[Topic] = []
        self._subscribers: dict[str, SubscribedTopic] = {}
        self._file: LogFile | None = None
        self._sink: RowSink | None = None
        self._sync_thread: SyncThread | None = None
        self._syncs = True
        self._phase = LogState.SETTING_UP
        # A caller that holds the lock while a row is built is the program's own formatter.
        self._is_in_row = False
        self._closes_after_row = False
        self.faults = Faults()
        self.text = NumberText(self.faults)

    @property
    def state(self) -> LogState:
        is_writable = self._sink is not None and not self._sink.is_failing and self._file is not None and not self._file.is_missing
        return LogState.FAILING if self._phase is LogState.LOGGING and not is_writable else self._phase

    def open(self, path: Path, is_compressed: bool) -> None:
        """Creates the file; a failure is reported once."""
        file = LogFile.open(path, is_compressed, self.faults)
        if file is not None:
            self._file = file
            self._sink = RowSink(file, self._flushes_each_row, self.faults)
            # So that waiting rows are written when the program ends normally.
            atexit.register(self.close)

    def add(self, topic: T) -> T:
        with self._lock:
            self._claim(topic.name)
            self._topics.append(topic)
            if isinstance(topic, SubscribedTopic):
                self._subscribers[topic.name] = topic
        return topic

    def add_value(self, name: str, text: str) -> None:
        with self._lock:
            self._claim(name)
            self._values.append((name, text))

    def finish_setup(self) -> None:
        with self._lock:
            if self._phase is not LogState.SETTING_UP:
                raise InvalidModeError("The log was set up already: call finish_initialization() only once.")
            rooms = [topic.texts for topic in self._topics if isinstance(topic, EventTopic)]
            rooms += [topic.texts for topic in self._subscribers.values() if topic.is_event_log]
            self.faults.room = rooms[0] if rooms else None
            if self._sink is not None and self._file is not None:
                described = [(topic.name, topic.unit, topic.attributes) for topic in self._topics]
                texts: list[EventTexts] = [topic.texts for topic in self._topics if isinstance(topic, (EventTopic, SubscribedTopic))]
                self._sink.begin(header_lines(described, self._values), texts)
                self._start_syncing(self._file, self._sink)
            self._phase = LogState.LOGGING

    def update(self) -> None:
        if self._phase is not LogState.LOGGING:
            self._ignored("update_topics()")
            return
        # The callables may take locks of their own, or call this again. For a second thread, the first one already does the work.
        if not self._is_sampling.acquire(blocking=False):
            return
        try:
            for topic in self._topics:
                topic.sample()
            with self._lock:
                if self._is_in_row:
                    self._ignored("update_topics()")
                    return
                self.text.current = self.text.function
                for topic in self._topics:
                    topic.commit()
        finally:
            self._is_sampling.release()

    def log(self) -> None:
        with self._lock:
            if self._phase is not LogState.LOGGING or self._is_in_row:
                self._ignored("log()")
            elif self._sink is None:
                self.faults.count("rows_missed")
            else:
                self._write_row(self._sink)
            if self._closes_after_row:
                self.close()

    def _write_row(self, sink: RowSink) -> None:
        began = time.monotonic_ns()
        if sink.is_refusing(began):
            sink.miss_row()
            return
        self._is_in_row = True
        try:
            row = row_of([topic.cell() for topic in self._topics])
            sink.add_row(row, began)
        except Exception as failure:
            # For example, too little memory for a text: this row is lost, but the robot keeps running.
            sink.drop_row()
            reason = describe(failure)
            self.faults.report_once("row", lambda: f"A row of the log was lost: {reason}.")
        finally:
            self._is_in_row = False

    def flush(self) -> None:
        with self._lock:
            if self._phase is LogState.LOGGING and not self._is_in_row and self._sink is not None:
                self._sink.flush()

    def publish(self, name: str, value: object) -> None:
        """Publishes to the topic of that name, or reports why not. Values published during setup are kept for the first row."""
        topic = self._subscribers.get(name) if isinstance(name, str) else None
        if topic is None:
            why = f'Values published to "{name}" are ignored: create_topic_subscriber() was not called for it.'
            self.faults.publish_ignored(str(name), why)
        else:
            self.publish_to(topic, value)

    def publish_to(self, topic: SubscribedTopic, value: object) -> None:
        if isinstance(value, str):
            topic.publish(value)
            return
        try:
            topic.publish(float(value))  # type: ignore[arg-type]
        except Exception:
            why = f'What was published to the topic "{topic.name}" is neither a number nor a text; that is ignored.'
            self.faults.publish_ignored(topic.name, why)

    def set_syncing(self, enabled: bool) -> None:
        with self._lock:
            self._syncs = enabled
            if self._sync_thread is not None:
                self._sync_thread.syncs = enabled

    def close(self) -> None:
        with self._lock:
            if self._phase is LogState.CLOSED:
                return
            if self._is_in_row:
                self._closes_after_row = True
                return
            self._phase = LogState.CLOSED
            if self._sink is not None:
                self._sink.finish()
            thread = self._sync_thread
            self._sync_thread = None
            if thread is not None:
                thread.finish()
            elif self._file is not None:
                self._file.close(self.faults)
        atexit.unregister(self.close)

    def _claim(self, name: str) -> None:
        if self._phase is not LogState.SETTING_UP:
            raise InvalidModeError(f'"{name}" was created too late: create all topics and values before finish_initialization().')
        if name in self._names:
            raise DuplicateNameError(f'There is already a topic or value "{name}" in this log. Give one of the two another name.')
        self._names.add(name)
        odd = next((char for char in name if char not in " _/" and not is_letter_or_digit(char)), None)
        if odd is not None:
            _standard_error.print_soon(f"The name \"{name}\" has the character '{odd}'; letters, digits, spaces, _ and / are safer.")

    def _ignored(self, call: str) -> None:
        if self._phase is LogState.CLOSED:
            why = f"{call} is ignored, because the log was closed."
        elif self._phase is LogState.SETTING_UP:
            why = f"{call} is ignored until finish_initialization() is called."
        else:
            why = f"{call} is ignored while a row is being written; do not call it from the function given to set_double_to_string_function()."
        self.faults.call_ignored(call, why)

    def _start_syncing(self, file: LogFile, sink: RowSink) -> None:
        thread = SyncThread(file, sink, self.faults, self._syncs, self._flush_waiting)
        try:
            thread.start()
        except RuntimeError as failure:
            reason = describe(failure)
            self.faults.report_once("thread", lambda: f"The log {file.path} is not synced: {reason}.")
        else:
            self._sync_thread = thread

    def _flush_waiting(self) -> None:
        with self._lock:
            if self._phase is LogState.LOGGING and self._sink is not None:
                self._sink.flush_waiting()

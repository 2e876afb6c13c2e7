"""Events that wait for a row, and events in rows that are not written yet. If writing fails, the latter wait again."""

from __future__ import annotations

import re
import threading

from badlog._text import BLANKS
from badlog.robot._faults import Faults

_SEPARATOR = "; "
_MAX_CHARACTERS = 10_000
_NO_EVENTS = ("", "null", "true", "false", "nan", "inf", "+inf", "-inf", "infinity", "-infinity", "+infinity", "+nan", "-nan")

# The texts that Java reads as numbers, so that all ports write the same.
_NUMBER = re.compile(
    r"[+-]?(?:(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:e[+-]?[0-9]+)?|0x(?:[0-9a-f]+\.?|[0-9a-f]*\.[0-9a-f]+)p[+-]?[0-9]+)[fd]?"
)


class EventTexts:
    """Thread-safe."""

    def __init__(self, faults: Faults) -> None:
        self._faults = faults
        self._lock = threading.Lock()
        self._waiting: list[str] = []
        self._taken: list[str] = []
        self._characters = 0

    def add(self, text: str) -> None:
        with self._lock:
            is_full = self._characters + len(text) > _MAX_CHARACTERS
            if not is_full:
                self._waiting.append(text)
                self._characters += len(text) + len(_SEPARATOR)
        if is_full:
            self._faults.count("events_dropped")

    def take(self) -> str | None:
        """Takes all waiting events, and returns them as the text of one cell, or None. The text never looks like a number."""
        if not self._waiting:
            return None
        with self._lock:
            text = _SEPARATOR.join(self._waiting)
            self._taken += self._waiting
            self._waiting = []
        return text if _is_read_as_event(text) else f"event {text}"

    def written(self) -> None:
        """Forgets the events of rows that are written now."""
        if self._taken:
            with self._lock:
                self._characters -= sum(len(text) + len(_SEPARATOR) for text in self._taken)
                self._taken = []

    def restore(self) -> None:
        """Lets the events of lost rows wait again."""
        if self._taken:
            with self._lock:
                self._waiting = self._taken + self._waiting
                self._taken = []

    def end(self) -> None:
        """Counts the events that still wait as dropped, because no row will take them."""
        with self._lock:
            dropped = len(self._waiting)
            self._waiting = []
        self._faults.count("events_dropped", dropped)


def _is_read_as_event(text: str) -> bool:
    word = text.strip(BLANKS).lower()
    return word not in _NO_EVENTS and _NUMBER.fullmatch(word) is None

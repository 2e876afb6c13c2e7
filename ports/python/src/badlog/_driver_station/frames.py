"""Finds the headers and the frames after them: records or entries. If frames do not continue, it searches for where several do."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable
from typing import Protocol

from badlog._driver_station.station_times import HEADER_SIZE, NEAR, seconds_at

MORE, NONE = 0, -1
"""The results of `Frames.size_at` without a frame: the file ends inside it, or none begins there."""

# The headers of the two files of a pair have the same time, to this many seconds.
_MAX_DIFFERENCE = 2.0
# This many frames in a row are not a coincidence.
_CERTAIN_FRAMES = 3


class Frames(Protocol):
    """The sequence in a file of the Driver Station: records, or entries."""

    may_end: bool
    """Whether the header of another file may follow."""

    def size_at(self, at: int) -> int:
        """The size in bytes of the frame at `at`, or MORE, or NONE."""

    def is_sure(self, at: int) -> bool:
        """Whether the frame at `at`, which is complete, is certainly one, and not damage that looks like it."""

    def take(self, at: int, size: int, until: int, most: int) -> tuple[int, int]:
        """Reads the frame at `at`, and more like it that end before `until`, at most `most` in all. Returns where they end, and their number."""

    def skip(self, count: int) -> None:
        """Records that `count` bytes were lost."""


class FrameSplitter:
    """Reads `data`.

    `begin` receives the place of a header, and returns the frames that follow it, or None if none can. `skipped` receives each range without
    frames.
    """

    def __init__(self, data: bytes, most: int, begin: Callable[[int], Frames | None], skipped: Callable[[int, int], None]) -> None:
        self._data = data
        self._end = len(data)
        self._most = most
        self._begin = begin
        self._skipped = skipped
        self._frames: Frames | None = None
        # The places at which another file's header may be. The first list is of those with a time in the same month, the second of those
        # with the same time.
        self._near: list[int] = []
        self._same: list[int] = []
        self._at = 0
        self.count = 0
        """The number of frames read."""
        self.lost_from = -1
        """The place after which no frames have been found; below 0 if they continue."""
        self.is_full = False
        """Whether there are more frames than the maximum."""
        while self._at < self._end and self._step():
            pass

    @property
    def pending_bytes(self) -> int:
        """The number of bytes at the end that are not a whole frame."""
        return self._end - self._at

    def _step(self) -> bool:
        """Advances by frames, a header or a lost byte. Returns False if nothing more can be read."""
        frames = self._frames
        if frames is None or _has(self._near if self.lost_from < 0 else self._same, self._at):
            return self._read_header()
        if self.count >= self._most:
            self.is_full = True
            return False
        return self._read_frames(frames) if self.lost_from < 0 else self._search(frames)

    def _read_header(self) -> bool:
        if self._end - self._at < HEADER_SIZE:
            return False
        before = self._frames
        if before is not None:
            self._end_search(before)
        frames = self._begin(self._at)
        if frames is None:
            return False
        self._near = self._headers_after(self._at) if before is None and frames.may_end else []
        seconds = seconds_at(self._data, self._at + 4)
        self._same = [place for place in self._near if abs(seconds_at(self._data, place + 4) - seconds) < _MAX_DIFFERENCE]
        self._frames = frames
        self._at += HEADER_SIZE
        return True

    def _headers_after(self, header: int) -> list[int]:
        data = self._data
        seconds = seconds_at(data, header + 4)
        signature = data[header : header + 4] + bytes(4)
        places = []
        place = data.find(signature, header + HEADER_SIZE)
        while 0 <= place <= self._end - HEADER_SIZE:
            if abs(seconds_at(data, place + 4) - seconds) < NEAR:
                places.append(place)
            place = data.find(signature, place + 1)
        return places

    def _read_frames(self, frames: Frames) -> bool:
        at = self._at
        size = frames.size_at(at)
        if size == NONE:
            self.lost_from = at
            return True
        # A record that was cut ends where the next file begins.
        following = _next(self._same, at + 1)
        if following is not None and following < (self._end if size == MORE else at + size):
            self.lost_from = at
            self._at = following
            return True
        if size == MORE:
            return False
        until = _next(self._near, at + 1)
        self._at, count = frames.take(at, size, self._end if until is None else until, self._most - self.count)
        self.count += count
        return True

    def _search(self, frames: Frames) -> bool:
        place = self._at
        for found in range(_CERTAIN_FRAMES):
            if found > 0 and (place == self._end or _has(self._same, place)):
                break
            size = frames.size_at(place)
            if size <= 0 or not frames.is_sure(place):
                self._at += 1
                return True
            place += size
        self._end_search(frames)
        return True

    def _end_search(self, frames: Frames) -> None:
        if self.lost_from >= 0:
            self._skipped(self.lost_from, self._at)
            frames.skip(self._at - self.lost_from)
            self.lost_from = -1


def _next(places: list[int], at: int) -> int | None:
    index = bisect_left(places, at)
    return places[index] if index < len(places) else None


def _has(places: list[int], at: int) -> bool:
    return bool(places) and _next(places, at) == at

"""Makes rows of a log without rows, by the rules of `docs/wpilog.md`, “Converting to rows”."""

from __future__ import annotations

import math
from array import array
from typing import Any

from badlog._json import read_object
from badlog._samples import Samples
from badlog._timed.vectors import Vectors, uses_numpy, vectors_of
from badlog.recording import CellCounts, Recording, RecordingFormat, Topic, TopicKind

# The tolerance, in periods, for the last step of a period that divides the range.
_ROUNDING = 1e-9
_MICROSECOND = 1e-6
_MAX_ROWS = 1e8
# Times are rounded to this fraction of a second.
_ROUNDING_SCALE = 1e9
# A sample up to this much later than a row is in it. Times of rows are rounded, and 829 times 0.02 s is 16.580000000000002 s.
_MAX_LATENESS = 1 / _ROUNDING_SCALE


def periodic_times(recording: Recording, period: float) -> list[float]:
    """Times that are `period` s apart, from the first sample on; the last one is not before the last sample."""
    if not period > 0:
        raise ValueError(f"A period must be above 0 s, but is {period}.")
    ranges = [(float(times[0]), float(times[-1])) for times in (topic.times for topic in recording.topics) if times is not None and len(times) > 0]
    if not ranges:
        return []
    first = min(start for start, _ in ranges)
    steps = math.ceil((max(end for _, end in ranges) - first) / period - _ROUNDING)
    if steps >= _MAX_ROWS:
        raise ValueError(f"A period of {period} s gives {steps} rows, which are too many.")
    times = (first + row * period for row in range(steps + 1))
    return [math.floor(time * _ROUNDING_SCALE + 0.5) / _ROUNDING_SCALE for time in times] if period >= _MICROSECOND else list(times)


def times_of(topic: Topic) -> list[float]:
    """The times at which `topic` has samples: each once."""
    return sorted({float(time) for time in topic.times}) if topic.times is not None else []


def resampled(recording: Recording, rows: list[float]) -> Recording:
    """The recording with a row for each of `rows`. Each topic has its last value at or before that time, and nothing before its first sample.

    If the log was made from a bag, a topic that was sparse there has each value only in the first row that is not before it.
    """
    vectors = vectors_of(b"", uses_numpy())
    name = "Time"
    copy = 2
    while name in recording:
        name = f"Time ({copy})"
        copy += 1
    counts = CellCounts(len(rows), 0, 0, 0, 0, 0)
    axis = Topic(name, "s", ("xaxis", "hide"), counts, Samples.of(array("d", rows)), (), (), (), [])
    topics = [axis, *(_held(topic, rows, vectors) for topic in recording.topics)]
    return Recording(RecordingFormat.BAG, None, recording.values, topics, len(rows), recording.problems, recording.path)


def _held(topic: Topic, rows: list[float], vectors: Vectors) -> Topic:
    last = vectors.last_before(topic.times, [row + _MAX_LATENESS for row in rows])
    text_of = dict(zip(map(int, topic._text_rows), map(int, topic._text_ids)))
    if _was_sparse(topic):
        # Rows do not hold its last value.
        last = vectors.whole([-1 if row > 0 and index == last[row - 1] else index for row, index in enumerate(last)])
    samples = vectors.held(topic.samples, last)
    is_event = topic.kind is TopicKind.EVENT or "log" in topic.attributes
    dictionary = list(topic._dictionary)
    found = _events(last, text_of, dictionary) if is_event else _states(last, text_of)
    numbers = len(rows) - vectors.not_finite(samples)
    infinite = vectors.count(vectors.infinite(samples))
    is_truth = topic.counts.truth_values > 0 and topic.counts.numbers == 0
    counts = CellCounts(
        numbers=0 if is_truth else numbers,
        not_finite=infinite,
        truth_values=numbers if is_truth else 0,
        texts=len(found),
        empty=len(rows) - numbers - infinite - len(found),
        gaps=_runs(vectors.written_nans(samples, None)),
    )
    attributes = (*topic.attributes, "log") if is_event and "log" not in topic.attributes else topic.attributes
    text_rows = array("q", [row for row, _ in found])
    text_ids = array("q", [id for _, id in found])
    return Topic(topic.name, topic.unit, attributes, counts, Samples.of(samples), text_rows, text_ids, dictionary, [])


def _was_sparse(topic: Topic) -> bool:
    """Whether badlog made the log from a bag in which the topic was sparse. Rows then do not repeat its last value."""
    roles = [value.text for name, value in read_object(topic.metadata) or [] if name == "badlog"]
    return roles[-1:] == ["sparse"]


def _states(last: Any, text_of: dict[int, int]) -> list[tuple[int, int]]:
    """The rows with a text, and its id."""
    return [(row, text_of[index]) for row, index in enumerate(map(int, last)) if index in text_of] if text_of else []


def _events(last: Any, text_of: dict[int, int], dictionary: list[str]) -> list[tuple[int, int]]:
    """The first row that is not before each event; several in one row are joined."""
    found: list[tuple[int, int]] = []
    ids: dict[str, int] = {}
    before = -1
    for row, index in enumerate(map(int, last)):
        texts = [text_of[sample] for sample in range(before + 1, index + 1) if sample in text_of]
        before = max(before, index)
        if len(texts) == 1:
            found.append((row, texts[0]))
        elif texts:
            joined = "; ".join(dictionary[id] for id in texts)
            if joined not in ids:
                ids[joined] = len(dictionary)
                dictionary.append(joined)
            found.append((row, ids[joined]))
    return found


def _runs(rows: list[int]) -> int:
    return sum(i == 0 or row != rows[i - 1] + 1 for i, row in enumerate(rows))

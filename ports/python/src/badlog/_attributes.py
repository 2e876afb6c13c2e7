"""The problems of topics' attributes, as reported by the page and the window."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from badlog.problem import Problem, ProblemKind, times_text
from badlog.recording import Topic, TopicKind

if TYPE_CHECKING:
    from badlog.recording import Recording

_PLAIN = ("hide", "log", "area", "zero", "xaxis", "delta", "differentiate", "integrate")
_DERIVATIONS = {"delta": "Delta", "differentiate": "Derivative", "integrate": "Integral"}

# Positions are wild if they are a hundred times as far from the others as those are from one another. At most one in a hundred is
# wild.
_OUTLIER_DISTANCE = 100.0
_POSITIONS_PER_OUTLIER = 100
_MIN_POSITIONS = 100
_POSITIONS_PER_IGNORED = 20
_MAX_EXAMINED = 2000


def attribute_problems(recording: Recording) -> list[Problem]:
    """The problems of all topics."""
    return _AttributeReader(recording).problems


class _AttributeReader:
    def __init__(self, recording: Recording) -> None:
        self.problems: list[Problem] = []
        self._recording = recording
        self._derived: dict[str, list[str]] = {}
        self._joins: dict[str, list[str]] = {}
        axes = []
        for topic in recording.topics:
            if self._read(topic):
                axes.append(topic)
        self._read_axes(axes)
        for topic in recording.topics:
            self._check_derivations(topic)
        self._check_joins()

    def _report(self, kind: ProblemKind, topic: Topic, message: str) -> None:
        self.problems.append(Problem(kind, message, None, topic.name))

    def _read(self, topic: Topic) -> bool:
        """Reads the attributes of one topic. Returns whether it is to be the x axis."""
        name = topic.name
        seen: list[str] = []
        derived = self._derived.setdefault(name, [])
        joins = self._joins.setdefault(name, [])
        for text in topic.attributes:
            if not text.strip():
                continue
            if text in seen:
                self._report(ProblemKind.DUPLICATE_ATTRIBUTE, topic, f"“{name}” has the attribute “{text}” twice.")
                continue
            seen.append(text)
            attribute, colon, argument = text.partition(":")
            if attribute == "join":
                if not argument.strip():
                    self._report(ProblemKind.UNFIT_ATTRIBUTE, topic, "“join” needs the name of a graph, as in join:Power/Currents.")
                elif argument not in joins:
                    joins.append(argument)
                continue
            if attribute not in _PLAIN:
                message = f"“{name}” has the attribute “{text}”, which is unknown and has no effect."
                self._report(ProblemKind.UNKNOWN_ATTRIBUTE, topic, message)
                continue
            if colon:
                message = f"“{attribute}” takes no argument; “:{argument}” was ignored."
                self._report(ProblemKind.UNFIT_ATTRIBUTE, topic, message)
            if attribute in _DERIVATIONS:
                derived.append(attribute)
            if attribute == "integrate" and _has_gaps(topic):
                message = f"“{name}” has gaps; its integral adds no area for them."
                self._report(ProblemKind.INTEGRAL_OVER_GAPS, topic, message)
        if "log" in seen and len(seen) > 1:
            others = ", ".join(text for text in seen if text != "log")
            message = f"“{name}” is an event log; its other attributes ({others}) have no effect."
            self._report(ProblemKind.UNFIT_ATTRIBUTE, topic, message)
        return any(text.partition(":")[0] == "xaxis" for text in seen)

    def _read_axes(self, axes: list[Topic]) -> None:
        if not axes:
            return
        axis = axes[0]
        for second in axes[1:]:
            message = f"“{second.name}” has the attribute xaxis, but “{axis.name}” already is the x axis."
            self._report(ProblemKind.SECOND_X_AXIS, second, message)
        if _has_numbers(axis) or self._recording.row_count == 0:
            self._check_axis(axis)
        else:
            message = f"“{axis.name}” has no numbers and cannot be the x axis; the row index is used instead."
            self._report(ProblemKind.UNFIT_ATTRIBUTE, axis, message)

    def _check_axis(self, axis: Topic) -> None:
        positions = axis.samples.tolist()
        finite = [position for position in positions if math.isfinite(position)]
        backwards = sum(following < before for before, following in zip(finite, finite[1:]))
        repeats = sum(following == before for before, following in zip(finite, finite[1:]))
        gaps = len(positions) - len(finite)
        wild = _wild_among(positions)
        name = axis.name
        if wild > 0:
            message = f"The x axis “{name}” is far off in {wild} of {len(positions)} rows. Check the robot's clock."
            self._report(ProblemKind.X_WILD, axis, message)
        if backwards > 0:
            message = f"The x axis “{name}” goes backwards{times_text(backwards)}, as when the robot's clock is set."
            self._report(ProblemKind.X_BACKWARDS, axis, message)
        if repeats > 0:
            self._report(ProblemKind.X_REPEATS, axis, f"The x axis “{name}” repeats a value{times_text(repeats)}.")
        if gaps > 0:
            self._report(ProblemKind.X_GAPS, axis, f"The x axis “{name}” has no value in {gaps} rows.")

    def _check_derivations(self, topic: Topic) -> None:
        if _is_event_log(topic) or _has_numbers(topic) or topic.kind is TopicKind.EMPTY:
            return
        for attribute in self._derived[topic.name]:
            message = f"“{topic.name} {_DERIVATIONS[attribute]}” cannot be calculated, because “{topic.name}” holds texts."
            self._report(ProblemKind.UNFIT_ATTRIBUTE, topic, message)

    def _check_joins(self) -> None:
        topics = {topic.name: topic for topic in self._recording.topics}
        graphs: dict[str, tuple[str, list[str]]] = {}
        for topic in self._recording.topics:
            if not _is_event_log(topic) and "hide" not in (text.partition(":")[0] for text in topic.attributes):
                graphs[topic.name] = (topic.unit, [_base_name(topic.name)])
        for topic in self._recording.topics:
            for graph in self._joins[topic.name]:
                if _is_event_log(topic) or topic.kind is TopicKind.STATE:
                    message = f"“{topic.name}” holds texts and cannot join the graph “{graph}”."
                    self._report(ProblemKind.UNFIT_ATTRIBUTE, topic, message)
                    continue
                if graph in topics:
                    self._report(ProblemKind.UNUSUAL_JOIN, topic, f"“{topic.name}” joins “{graph}”, which is the graph of a topic.")
                unit, lines = graphs.setdefault(graph, (topic.unit, []))
                if unit != topic.unit:
                    message = f"“{topic.name}” in {topic.unit} joins the graph “{graph}” in {unit}."
                    self._report(ProblemKind.UNUSUAL_JOIN, topic, message)
                line = _base_name(topic.name)
                if line in lines:
                    self._report(ProblemKind.UNUSUAL_JOIN, topic, f"The graph “{graph}” has several lines named “{line}”.")
                lines.append(line)


def _has_numbers(topic: Topic) -> bool:
    counts = topic.counts
    return counts.numbers + counts.not_finite + counts.truth_values > 0 and topic.kind is not TopicKind.EVENT


def _has_gaps(topic: Topic) -> bool:
    counts = topic.counts
    return _has_numbers(topic) and not topic.is_sparse and counts.not_finite + counts.texts + counts.empty > 0


def _is_event_log(topic: Topic) -> bool:
    return topic.kind is TopicKind.EVENT or "log" in (text.partition(":")[0] for text in topic.attributes)


def _base_name(name: str) -> str:
    """Its name inside its folder; a slash at the very end separates nothing."""
    return name[name.rfind("/", 0, max(len(name) - 1, 0)) + 1 :]


def _wild_among(positions: list[float]) -> int:
    """The number of positions so far away that the others would be too small to see on an axis."""
    step = max(1, len(positions) // _MAX_EXAMINED)
    some = sorted(position for position in positions[::step] if math.isfinite(position))
    if len(some) < _MIN_POSITIONS:
        return 0
    cut = len(some) // _POSITIONS_PER_IGNORED
    first = some[cut]
    last = some[len(some) - 1 - cut]
    reach = (last - first) * _OUTLIER_DISTANCE
    if not 0 < reach < math.inf:
        return 0
    wild = sum(math.isfinite(position) and not first - reach <= position <= last + reach for position in positions)
    return wild if wild <= len(positions) // _POSITIONS_PER_OUTLIER else 0

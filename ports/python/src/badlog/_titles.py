"""The titles of a file's columns, according to its first two lines and the rows after them."""

from __future__ import annotations

from collections import Counter, defaultdict, deque
from collections.abc import Iterable
from dataclasses import dataclass

from badlog._header import BagHeader, BagTopic
from badlog._text import is_letter_or_digit
from badlog.problem import ProblemKind, ProblemList

# If one title in this many is in line 1's order, line 1's order counts.
_NAMES_PER_MATCH = 4


@dataclass
class ColumnTitles:
    """A title for each column, and whether it may belong to another column."""

    titles: list[str]
    is_doubtful: list[bool]

    @classmethod
    def certain(cls, titles: list[str]) -> ColumnTitles:
        return cls(titles, [False] * len(titles))

    @classmethod
    def doubtful(cls, titles: list[str]) -> ColumnTitles:
        return cls(titles, [True] * len(titles))

    @classmethod
    def of(cls, names: list[str], titles: list[str], width: int) -> ColumnTitles:
        """The titles for `names` on line 1, `titles` on line 2, and rows of `width` cells. A `width` of 0 is not known.

        Line 1 wins if it has that many names.
        """
        if width == 0 or (len(titles) == width and len(names) != width) or Counter(names) == Counter(titles):
            return cls.certain(titles)
        if len(names) == width:
            return cls._paired(names, titles) if len(titles) == width else cls._of_names(names, titles)
        return cls.doubtful([titles[i] if i < len(titles) else "" for i in range(width)])

    @classmethod
    def _paired(cls, names: list[str], titles: list[str]) -> ColumnTitles:
        """Pairs names with titles if some of them differ."""
        same = sum(title == name for title, name in zip(titles, names))
        waiting = _Waiting(name for title, name in zip(titles, names) if title != name)
        # If line 2 has its own order, each title is at its place there.
        is_reordered = same * 2 < len(names)
        pairs: list[str | None] = []
        for title, name in zip(titles, names):
            if title == name:
                pairs.append(name)
            else:
                pairs.append(title if is_reordered and waiting.remove(title) else None)
        is_doubtful = [pair is None for pair in pairs]
        result = []
        for pair, name in zip(pairs, names):
            if pair is None:
                pair = name if not is_reordered and waiting.remove(name) else waiting.remove_first()
            result.append(pair)
        return cls(result, is_doubtful)

    @classmethod
    def _of_names(cls, names: list[str], titles: list[str]) -> ColumnTitles:
        """Uses the names because there are too few or too many titles."""
        places: dict[str, deque[int]] = defaultdict(deque)
        for i, name in enumerate(names):
            places[name].append(i)
        found = [places[title].popleft() for title in titles if places.get(title)]
        is_at_end = titles[0] == names[0] or titles[-1] == names[-1]
        ascends = all(one < following for one, following in zip(found, found[1:]))
        # A hole may leave only the beginning or the end of a name.
        line = ",".join(names)
        rest = ",".join(titles)
        if (is_at_end and len(found) * _NAMES_PER_MATCH >= len(names) and ascends) or line.startswith(rest) or line.endswith(rest):
            return cls.certain(names)
        # Line 2 had its own order, which is known from both ends of the line inwards.
        left = _Waiting(names)
        first = 0
        while first < len(titles) and left.remove(titles[first]):
            first += 1
        last = len(titles)
        while last > first and left.remove(titles[last - 1]):
            last -= 1
        return cls.doubtful(titles[:first] + left.in_order() + titles[last:])


class _Waiting:
    """The names without a column so far, each as often as it occurs. The first of equal ones is removed first."""

    def __init__(self, names: Iterable[str]) -> None:
        self._names = list(names)
        self._is_left = [True] * len(self._names)
        self._places: dict[str, deque[int]] = defaultdict(deque)
        self._first = 0
        for i, name in enumerate(self._names):
            self._places[name].append(i)

    def remove(self, name: str) -> bool:
        """Removes the first of that name; False if there is none."""
        places = self._places.get(name)
        while places:
            i = places.popleft()
            if self._is_left[i]:
                self._is_left[i] = False
                return True
        return False

    def remove_first(self) -> str:
        while not self._is_left[self._first]:
            self._first += 1
        self._is_left[self._first] = False
        return self._names[self._first]

    def in_order(self) -> list[str]:
        return [name for name, is_left in zip(self._names, self._is_left) if is_left]


@dataclass
class HeaderColumns:
    """The columns of line 2, matched with the topics of line 1."""

    names: list[str]
    """The name of each column, unique, in the order of line 2."""
    topics: list[BagTopic | None]
    """For each column, its topic of line 1, or None."""
    order: list[int]
    """The columns in display order: first in the order of line 1, then those that line 1 does not name."""

    @classmethod
    def match(cls, header: BagHeader | None, titles: list[str], line: int, problems: ProblemList) -> HeaderColumns:
        """Matches by name, the first of equal names to the first."""
        described = header.topics if header is not None else []
        waiting: dict[str, deque[int]] = defaultdict(deque)
        for index, topic in enumerate(described):
            waiting[topic.name].append(index)
        topic_of_column = [waiting[title].popleft() if waiting.get(title) else None for title in titles]
        for index in sorted(index for left in waiting.values() for index in left):
            name = described[index].name
            message = f"The header describes “{name}”, but line {line} has no such column."
            problems.add(ProblemKind.TOPIC_WITHOUT_COLUMN, message, line, name)
        names = _unique_names(titles, line, problems)
        if header is not None:
            _report_columns(titles, names, topic_of_column, line, problems)
        places = [len(described) + i if index is None else index for i, index in enumerate(topic_of_column)]
        order = sorted(range(len(titles)), key=places.__getitem__)
        return cls(names, [None if index is None else described[index] for index in topic_of_column], order)


def _unique_names(titles: list[str], line: int, problems: ProblemList) -> list[str]:
    names = []
    given: set[str] = set()
    copies: dict[str, int] = {}
    for i, title in enumerate(titles):
        wanted = title or f"Column {i + 1}"
        name = wanted
        copy = copies.get(wanted, 2)
        while name in given:
            name = f"{wanted} ({copy})"
            copy += 1
        given.add(name)
        copies[wanted] = copy
        if name != wanted:
            message = f"There are several topics named “{wanted}”; this one is shown as “{name}”."
            problems.add(ProblemKind.DUPLICATE_TOPIC, message, line, name)
        names.append(name)
    return names


def _report_columns(titles: list[str], names: list[str], topics: list[int | None], line: int, problems: ProblemList) -> None:
    for title, name, topic in zip(titles, names, topics):
        if topic is None:
            message = f"Column “{name}” is not described in the header; it is shown without a unit."
            problems.add(ProblemKind.COLUMN_WITHOUT_TOPIC, message, line, name)
        odd = next((char for char in title if char not in " _/" and not is_letter_or_digit(char)), None)
        if odd is not None:
            message = f"The name “{name}” has a “{odd}”; names are safest with letters, digits, space, _ and / only."
            problems.add(ProblemKind.UNUSUAL_NAME, message, line, name)

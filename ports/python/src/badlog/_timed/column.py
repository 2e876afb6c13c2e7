"""The samples of one topic that has times of its own, and the topic made of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from badlog._samples import Samples
from badlog._text import decode
from badlog._timed.vectors import Numbers, Places, Vectors
from badlog.problem import ProblemKind, ProblemList, times_text
from badlog.recording import CellCounts, Topic

NUMBERS, TRUTHS, TEXTS = range(3)


class Timestamps:
    """The times of one or several columns, in s, in the order of the file."""

    def __init__(self, seconds: Numbers, vectors: Vectors) -> None:
        self._seconds = seconds
        self._vectors = vectors
        self._is_finished = False
        self.times = Samples.of(seconds)
        """The times, ascending; valid after `finish`."""
        self.order: Places | None = None
        """For each of `times`, the index of its sample, or None if they were in order; valid after `finish`."""
        self.disorder = 0
        """The number of times that follow a later one; valid after `finish`."""

    def __len__(self) -> int:
        return len(self._seconds)

    def finish(self, first: float, last: float) -> None:
        """Drops times outside these two, and sorts the others; times before 0 are moved to `first`. May be called again."""
        if not self._is_finished:
            self._is_finished = True
            times, self.order, self.disorder = self._vectors.order(self._seconds, first, last)
            self.times = Samples.of(times)

    def taken(self, indices: Places) -> Timestamps:
        """The times at `indices`, as timestamps of their own."""
        return Timestamps(self._vectors.take(self._seconds, indices), self._vectors)


@dataclass
class Column:
    """The samples of one topic in the order of the file: numbers, truth values, or texts, and gaps among them."""

    path: str
    """The part of the topic's name after the entry's."""
    sort: int
    """`NUMBERS`, `TRUTHS` or `TEXTS`."""
    size: int
    numbers: Numbers = None
    """One for each sample, NaN for a gap; nothing in a column of texts."""
    is_gap: Any = None
    """For each sample, whether it is a gap; None if none is."""
    text_rows: Any = ()
    text_ids: Any = ()
    dictionary: Sequence[str] = ()
    rounded: int = 0
    """The number of whole numbers that could not be kept exactly."""
    saw_other_text: bool = False
    """Whether a text was not UTF-8."""

    @staticmethod
    def of_texts(path: str, size: int, rows: Sequence[int], texts: Iterable[bytes], vectors: Vectors) -> Column:
        """A column of `size` samples: texts at `rows`, and gaps elsewhere."""
        ids: dict[bytes, int] = {}
        text_ids = vectors.whole([ids.setdefault(text, len(ids)) for text in texts])
        decoded = [decode(text) for text in ids]
        is_gap = vectors.gaps_outside(size, vectors.whole(rows)) if len(rows) < size else None
        return Column(
            path,
            TEXTS,
            size,
            is_gap=is_gap,
            text_rows=vectors.whole(rows),
            text_ids=text_ids,
            dictionary=[text for text, _ in decoded],
            saw_other_text=any(was_not_utf8 for _, was_not_utf8 in decoded),
        )

    def spread(self, size: int, positions: Places, vectors: Vectors) -> Column:
        """Moves the samples to `positions` among `size`; all others are gaps."""
        self.size = size
        self.is_gap = vectors.gaps_outside(size, positions)
        if self.sort == TEXTS:
            self.text_rows = vectors.take(positions, self.text_rows)
        else:
            self.numbers = vectors.spread(self.numbers, size, positions)
        return self

    def topic(
        self,
        name: str,
        unit: str,
        attributes: tuple[str, ...],
        timestamps: Timestamps,
        vectors: Vectors,
        problems: ProblemList,
        type: str = "",
        metadata: str = "",
    ) -> Topic:
        """The topic `name` with these samples at the times of `timestamps`, which must be finished. Reports the oddities of the samples."""
        order = timestamps.order
        not_finite = self._not_finite(vectors)
        if order is not None:
            self._reorder(order, vectors)
        counts = self._counts(not_finite, vectors)
        has_numbers = self.sort != TEXTS
        written_nans = vectors.written_nans(self.numbers, self.is_gap) if has_numbers and counts.not_finite > 0 else []
        samples = Samples.of(self.numbers if has_numbers else vectors.nans(self.size))
        if timestamps.disorder > 0:
            message = f"“{name}” goes back in time{times_text(timestamps.disorder)}; its samples were sorted."
            problems.add(ProblemKind.TIMES_SORTED, message, topic=name, count=timestamps.disorder)
        if self.saw_other_text:
            problems.add(ProblemKind.NOT_UTF8, f"Texts in “{name}” are not UTF-8; they were read as Windows-1252.", topic=name)
        if self.rounded > 0:
            message = f"Whole numbers in “{name}” are too large to be kept exactly{times_text(self.rounded)}."
            problems.add(ProblemKind.NUMBERS_ROUNDED, message, topic=name, count=self.rounded)
        if counts.not_finite > 0:
            message = f"“{name}” is NaN or infinite in {counts.not_finite} of {counts.total} samples; these are kept, and drawn as gaps."
            problems.add(ProblemKind.NOT_FINITE, message, topic=name, count=counts.not_finite)
        return Topic(
            name, unit, attributes, counts, samples, self.text_rows, self.text_ids, self.dictionary, written_nans, timestamps.times, type, metadata
        )

    def _not_finite(self, vectors: Vectors) -> int:
        """The number of samples that are not finite, without gaps."""
        if self.sort != NUMBERS:
            return 0
        return vectors.not_finite(self.numbers) - (0 if self.is_gap is None else vectors.count(self.is_gap))

    def _reorder(self, order: Places, vectors: Vectors) -> None:
        self.size = len(order)
        if self.is_gap is not None:
            self.is_gap = vectors.take(self.is_gap, order)
        if self.sort != TEXTS:
            self.numbers = vectors.take(self.numbers, order)
            return
        text_at = dict(zip(map(int, self.text_rows), range(len(self.text_rows))))
        found = [(row, text_at[index]) for row, index in enumerate(map(int, order)) if index in text_at]
        self.text_rows = vectors.whole([row for row, _ in found])
        self.text_ids = vectors.take(self.text_ids, vectors.whole([at for _, at in found]))

    def _counts(self, not_finite: int, vectors: Vectors) -> CellCounts:
        texts = len(self.text_rows)
        gaps = 0 if self.is_gap is None else vectors.count(self.is_gap)
        if self.sort == NUMBERS and not_finite > 0:
            not_finite = vectors.not_finite(self.numbers) - gaps
        numeric = self.size - texts - gaps - not_finite
        return CellCounts(
            numbers=0 if self.sort == TRUTHS else numeric,
            not_finite=not_finite,
            truth_values=numeric if self.sort == TRUTHS else 0,
            texts=texts,
            empty=gaps,
            gaps=1 if texts > 0 else gaps,
        )

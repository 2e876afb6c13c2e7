"""The started entries of a file, and their records."""

from __future__ import annotations

from badlog._text import decode
from badlog._timed.record_problems import add_skipped
from badlog._wpilog.entry import VALUE_METADATA, Entry
from badlog._wpilog.record_head import CONTROL_HEAD, FINISH, START, RecordHead, control_texts
from badlog._wpilog.record_runs import PlainRuns, RecordRuns
from badlog._wpilog.record_table import RecordTable
from badlog._wpilog.time_histogram import NEVER, TimeHistogram
from badlog.problem import ProblemList

# The start of an entry with more records than this was lost; fewer may be damage.
_MAX_STRAY_RECORDS = 1
_MAX_UNKNOWN = 1000


class Entries:
    """Receives the records of a file: a `RecordSink`."""

    def __init__(self, data: bytes, problems: ProblemList, with_numpy: bool) -> None:
        self._data = data
        self._problems = problems
        self._by_name: dict[tuple[str, str, bool], Entry] = {}
        self.by_id: dict[int, Entry] = {}
        self.table = RecordTable()
        """The records of all entries."""
        self.histogram = TimeHistogram()
        """The times of most records."""
        self._runs = _runs_of(self, data, with_numpy)
        self.record_count = 0
        """The number of records of all kinds."""
        self.wild_count = 0
        """The number of records with impossible times."""
        self.first_wild: Entry | None = None
        """The entry of the first of them."""
        self.early_count = 0
        """The number of records with times before 0."""
        self.first_early: Entry | None = None
        """The entry of the first of them."""
        self.unknown_count = 0
        """The number of records that do not belong to a started entry."""
        self.unknown_counts: dict[int, int] = {}
        """The ids in such records, and the number of each; not all ids, if damage produced thousands."""
        self.bad_control_count = 0
        """The number of control records that cannot be understood."""
        self.has_gaps = False
        """Whether bytes between records were skipped."""

    @property
    def all(self) -> list[Entry]:
        """The entries, in the order in which they were first started."""
        return list(self._by_name.values())

    def is_stranger(self, id: int) -> bool:
        """Whether more records of `id`, which is not an entry's id, are to be expected, because there were so
        many.
        """
        return self.unknown_counts.get(id, 0) > _MAX_STRAY_RECORDS

    def record(self, head: RecordHead, start: int, until: int) -> None:
        """Receives the record that begins at `start` and ends at `until`."""
        self.record_count += 1
        if head.id == 0:
            self._control(until - head.size, until)
        else:
            self._take(head, until - head.size)

    def records(self, at: int, most: int, most_bytes: int) -> tuple[int, float]:
        """Receives the records from `at` on that fit at a quick look."""
        run = self._runs.read(at, most, most_bytes)
        self.record_count += run.count
        return run.end, run.micros

    def skipped(self, start: int, until: int) -> None:
        """Called if the bytes from `start` until `until` are not records, but those after them are."""
        self.has_gaps = True
        add_skipped(self._problems, start, until)

    def _take(self, head: RecordHead, start: int) -> None:
        micros = head.micros
        entry = head.entry
        if entry is None:
            self.unknown_count += 1
            # A damaged file could contain millions.
            if head.id in self.unknown_counts or len(self.unknown_counts) < _MAX_UNKNOWN:
                self.unknown_counts[head.id] = self.unknown_counts.get(head.id, 0) + 1
            return
        if -NEVER < micros < 0:
            self.early_count += 1
            self.first_early = self.first_early or entry
        elif micros < 0 or not self.histogram.add(micros):
            self.wild_count += 1
            self.first_wild = self.first_wild or entry
            return
        self.table.add(entry.number, micros, start, head.size)

    def _control(self, start: int, until: int) -> None:
        data = self._data
        places = control_texts(data, start, until)
        if places is None:
            self.bad_control_count += 1
            return
        kind = data[start]
        id = int.from_bytes(data[start + 1 : start + CONTROL_HEAD], "little")
        texts = [decode(data[begin:end])[0] for begin, end in places]
        if kind == START:
            self._start(id, texts[0], texts[1], texts[2])
        elif kind == FINISH:
            self.by_id.pop(id, None)
            self._runs.start(id, None)
        elif id in self.by_id:
            self.by_id[id].metadata = texts[0]

    def _start(self, id: int, name: str, type: str, metadata: str) -> None:
        # A topic may have the same name as a value.
        key = (name, type, metadata == VALUE_METADATA and type == "string")
        entry = self._by_name.get(key)
        if entry is None:
            entry = self._by_name[key] = Entry(*key, number=len(self._by_name))
        if metadata:
            entry.metadata = metadata
        self.by_id[id] = entry
        self._runs.start(id, entry)


def _runs_of(entries: Entries, data: bytes, with_numpy: bool) -> RecordRuns:
    if with_numpy:
        from badlog._wpilog.numpy_runs import NumpyRuns

        return NumpyRuns(data, entries.table, entries.histogram)
    return PlainRuns(data, entries.by_id, entries.table, entries.histogram)

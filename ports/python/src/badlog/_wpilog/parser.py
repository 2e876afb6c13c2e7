"""Makes a recording from the bytes of a WPILOG, by the rules of `docs/wpilog.md`. Never raises because of the bytes."""

from __future__ import annotations

from badlog._text import BLANKS, decode
from badlog._timed.record_problems import add_cut, add_lost, add_too_many
from badlog._timed.vectors import Vectors, vectors_of
from badlog._wpilog.decoding import Decoding
from badlog._wpilog.entries import Entries
from badlog._wpilog.entry import MESSAGE_SCHEMA, Entry
from badlog._wpilog.match_values import MatchValues
from badlog._wpilog.message_types import MessageTypes
from badlog._wpilog.record_head import MAX_PAYLOAD_BYTES
from badlog._wpilog.record_splitter import HEADER, MAGIC, RecordSplitter, header_end
from badlog._wpilog.record_table import EntryRecords
from badlog._wpilog.struct_schemas import StructSchemas
from badlog._wpilog.time_histogram import Cluster
from badlog._wpilog.topics import TopicMaker, report_entry
from badlog.problem import ProblemKind, ProblemList, times_text
from badlog.recording import Recording, RecordingFormat, Value

_STRUCT_SCHEMA = ".schema/struct:"
# The text that badlog's own writer puts in the header, which is not worth showing.
_OWN_HEADER = '{"writer":"badlog"}'
# The maximum number of entries listed in a message.
_MAX_NAMED = 8


def is_wpilog(data: bytes) -> bool:
    """Whether the file that holds `data` is a WPILOG."""
    return data.startswith(MAGIC)


def parse(data: bytes, max_rows: int, with_numpy: bool) -> Recording:
    """The recording of a WPILOG that holds `data`, inflated; at most `max_rows` records are read."""
    problems = ProblemList()
    start = header_end(data)
    refusal = _refusal(data, start)
    if refusal is not None:
        problems.add(ProblemKind.NOT_A_RECORDING, refusal)
        return Recording(RecordingFormat.WPILOG, None, [], [], 0, problems.to_list())
    return _WpilogParser(data, start, max_rows, with_numpy, problems).recording()


def _refusal(data: bytes, start: int | None) -> str | None:
    """The reason why this is not a readable WPILOG; None if it is one, or if its header is cut."""
    if start is None:
        is_possible = len(data) < HEADER or int.from_bytes(data[HEADER - 4 : HEADER], "little") <= MAX_PAYLOAD_BYTES
        return None if is_possible else "This is not a WPILOG file."
    version = data[len(MAGIC) + 1]
    return None if version == 1 else f"This is a WPILOG of version {version}; this version of badlog reads version 1."


class _WpilogParser:
    def __init__(self, data: bytes, start: int | None, max_rows: int, with_numpy: bool, problems: ProblemList) -> None:
        self._data = data
        self._start = start
        self._max_rows = max_rows
        self._problems = problems
        self._with_numpy = with_numpy
        self._vectors: Vectors = vectors_of(data, with_numpy)
        self._entries = Entries(data, problems, with_numpy)

    def recording(self) -> Recording:
        problems = self._problems
        if self._start is None:
            add_cut(problems)
        else:
            self._report_end(RecordSplitter(self._data, self._start, self._entries, self._max_rows))
        entries = self._entries
        cluster = entries.histogram.largest_cluster()
        all_entries = entries.all
        groups = entries.table.by_entry(len(all_entries), self._with_numpy)
        match, decoding = self._listen(all_entries, groups)
        decoded = [decoding.decode(entry, records) for entry, records in zip(all_entries, groups)]
        for entry, one in zip(all_entries, decoded):
            report_entry(entry, one, problems)
        self._report_lost_records(cluster)
        first, last = (0.0, 0.0) if cluster is None else (cluster.start / 1e6, (cluster.until - 1) / 1e6)
        maker = TopicMaker(first, last, self._vectors, problems)
        topics = [topic for entry, one in zip(all_entries, decoded) if not entry.is_value for topic in maker.topics_of(entry, one)]
        if all(len(topic) == 0 for topic in topics):
            problems.add(ProblemKind.NO_ROWS, "There are no samples; the robot may have been switched off too early.")
        values = match.values(0.0 if cluster is None else cluster.start) + self._extra_header()
        return Recording(RecordingFormat.WPILOG, None, values, topics, 0, problems.to_list())

    def _listen(self, entries: list[Entry], groups: list[EntryRecords]) -> tuple[MatchValues, Decoding]:
        """Passes on the records with information about the whole run or about types, in the order of the file."""
        data = self._data
        match = MatchValues()
        structs = StructSchemas()
        messages = MessageTypes()
        heard = [
            (int(index), entry, float(micros), data[int(start) : int(start + size)])
            for entry, records in zip(entries, groups)
            if match.concerns(entry) or _is_schema(entry)
            for index, micros, start, size in zip(records.indices, records.micros, records.starts, records.sizes)
        ]
        heard.sort(key=lambda record: record[0])
        for index, entry, micros, payload in heard:
            if entry.type == MESSAGE_SCHEMA:
                messages.add(payload, index)
            elif _is_schema(entry):
                structs.add(entry.name.partition(_STRUCT_SCHEMA)[2], payload.decode("utf-8", "replace"), index)
            else:
                match.hear(entry, micros, payload)
        return match, Decoding(data, self._vectors, structs, messages)

    def _extra_header(self) -> list[Value]:
        if self._start is None:
            return []
        text, _ = decode(self._data[HEADER : self._start])
        return [Value("Extra Header", text)] if text.strip(BLANKS) and text != _OWN_HEADER else []

    def _report_end(self, splitter: RecordSplitter) -> None:
        if splitter.is_full:
            add_too_many(self._problems, self._max_rows)
        elif splitter.readable_end >= 0:
            add_lost(self._problems, splitter.readable_end, len(self._data))
        elif splitter.is_cut:
            add_cut(self._problems)

    def _report_lost_records(self, cluster: Cluster | None) -> None:
        entries = self._entries
        problems = self._problems
        if entries.unknown_count > 0:
            ids = list(entries.unknown_counts)
            numbers = ", ".join(map(str, ids[:_MAX_NAMED])) + (", …" if len(ids) > _MAX_NAMED else "")
            is_one = entries.unknown_count == 1
            records = "1 record belongs" if is_one else f"{entries.unknown_count} records belong"
            owners = f"an entry (number {numbers})" if len(ids) == 1 else f"entries (numbers {numbers})"
            cause = "whose start may be among the skipped bytes" if entries.has_gaps else "that this file never starts, or has finished"
            message = f"{records} to {owners} {cause}, and {'was' if is_one else 'were'} dropped."
            problems.add(ProblemKind.UNKNOWN_ENTRY, message, count=entries.unknown_count)
        if entries.bad_control_count > 0:
            message = f"Malformed records that should start, describe or finish an entry were dropped{times_text(entries.bad_control_count)}."
            problems.add(ProblemKind.BAD_RECORD, message, count=entries.bad_control_count)
        if entries.first_early is not None:
            message = (
                f"Records from before the robot's clock started, such as one of “{entries.first_early.name}”, "
                f"were moved to the start of the log{times_text(entries.early_count)}."
            )
            problems.add(ProblemKind.EARLY_TIMES, message, count=entries.early_count)
        wild = entries.wild_count + (0 if cluster is None else entries.histogram.total - cluster.records)
        if wild > 0:
            example = "" if entries.first_wild is None else f", such as one of “{entries.first_wild.name}”"
            message = f"Records with impossible times, or days away from all others{example}, were dropped{times_text(wild)}."
            problems.add(ProblemKind.WILD_TIMES, message, count=wild)


def _is_schema(entry: Entry) -> bool:
    return entry.type == MESSAGE_SCHEMA or (entry.type == "structschema" and _STRUCT_SCHEMA in entry.name)

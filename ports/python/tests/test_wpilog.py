"""WPILOGs: cases that the corpus lacks, damage, and the results of WPILib's own reader for the same bytes."""

from __future__ import annotations

import gzip
import lzma
import math
import os
import random
import struct
import tracemalloc
from collections import defaultdict
from pathlib import Path
from typing import Any

import pytest
from damage import damaged
from wpilog_writer import DESCRIPTOR, WpilogWriter, field, moving_robot, proto

import badlog
from badlog import ProblemKind, RecordingFormat, TopicKind
from badlog._timed.vectors import uses_numpy
from badlog._wpilog import parser

WAYS = [False, True] if uses_numpy() else [False]
REAL_LOGS = os.environ.get("BADLOG_REAL_LOGS")

both_ways = pytest.mark.parametrize("with_numpy", WAYS, ids=lambda with_numpy: "numpy" if with_numpy else "plain")


def parsed(data: bytes, with_numpy: bool, max_rows: int = badlog.MAX_ROWS) -> badlog.Recording:
    return parser.parse(data, max_rows, with_numpy)


def kinds_of(recording: badlog.Recording) -> list[str]:
    return [problem.kind.value for problem in recording.problems]


def described(recording: badlog.Recording) -> list[Any]:
    topics = [(topic, topic.type, list(map(repr, _floats(topic.times))), list(map(repr, _floats(topic.samples))), topic.texts) for topic in recording.topics]
    return [topics, recording.values, sorted(map(str, recording.problems))]


def _floats(numbers: Any) -> list[float]:
    return [float(number) for number in numbers]


def test_a_wpilog_is_an_object_like_a_bags(tmp_path: Path) -> None:
    path = tmp_path / "match.wpilog"
    path.write_bytes(moving_robot(30))
    recording = badlog.read(path)
    assert recording.format is RecordingFormat.WPILOG and not recording.format.has_rows
    assert recording.row_count == 0 and recording.x_axis is None
    angle = recording["/Arm/Angle"]
    assert (angle.unit, angle.type, angle.kind) == ("deg", "double", TopicKind.NUMERIC)
    assert angle.times is not None and len(angle.times) == len(angle.samples) == len(angle)
    assert recording["NT:/SmartDashboard/Speed"].unit == "m/s"
    assert recording["count"].attributes == ("hide", "join:Counts")
    assert recording["Drive/Pose/state"].kind is TopicKind.STATE
    assert recording["/Arm/Angle (2)"].type == "int64"
    assert recording["never"].kind is TopicKind.EMPTY
    assert recording.value("Event Name") == "MILLC" and recording.value("Match Number") == "42" and recording.value("Alliance") == "Red"
    assert [event.text for event in recording.events] == ['loop 0 "overrun"', 'loop 10 "overrun"', 'loop 20 "overrun"']
    assert recording.events[1].x == 1.2
    assert list(recording.x_of("messages")) == [1.0, 1.2, 1.4]
    assert "samples" in repr(recording)


@pytest.mark.skipif(not uses_numpy(), reason="NumPy is not installed")
def test_numbers_and_times_are_read_only_arrays_of_numpy_in_small_and_large_logs() -> None:
    import numpy

    for size in (10, 6000):
        recording = badlog.read(moving_robot(size))
        for topic in recording.topics:
            for numbers in (topic.times, topic.samples):
                assert isinstance(numbers, numpy.ndarray) and numbers.dtype == numpy.float64 and not numbers.flags.writeable


@pytest.mark.skipif(not uses_numpy(), reason="NumPy is not installed")
def test_a_large_log_is_read_alike_with_and_without_numpy() -> None:
    data = moving_robot(1500, seed=3)
    assert described(parsed(data, True)) == described(parsed(data, False))


def test_compressed_logs_are_inflated_and_a_cut_is_a_problem(tmp_path: Path) -> None:
    data = moving_robot(30)
    whole = described(badlog.read(data))
    for pack in (gzip.compress, lzma.compress):
        packed = pack(data)
        path = tmp_path / "log.wpilogxz"
        path.write_bytes(packed)
        assert described(badlog.read(path)) == whole
        cut = badlog.read(packed[: len(packed) * 2 // 3])
        assert kinds_of(cut)[0] == "GZIP_CUT" and cut.is_salvaged
        assert described(badlog.read(pack(data[:9000]) + pack(data[9000:]))) == whole


@both_ways
def test_no_more_records_are_read_than_the_maximum(with_numpy: bool) -> None:
    recording = parsed(moving_robot(500), with_numpy, max_rows=1000)
    assert kinds_of(recording).count("TOO_MANY_ROWS") == 1
    assert recording.is_salvaged and 0 < recording.sample_count < 4000


@both_ways
def test_structs_wait_for_their_schema_up_to_a_mebibyte(with_numpy: bool) -> None:
    log = WpilogWriter().start(1, "large", "struct:L").start(2, "small", "struct:L").start(3, "/.schema/struct:L", "structschema")
    log.record(2, 5, bytes(60_000))
    for i in range(18):
        log.record(1, 10 + i, bytes(60_000))
    recording = parsed(log.string(3, 40, "char text[60000]").record(1, 50, bytes(60_000)).data, with_numpy)
    assert recording["large"].unit == "B" and len(recording["large"]) == 19
    assert recording["small/text"].texts == [(0, "")]
    assert kinds_of(recording) == ["NOT_DECODED"]


@both_ways
def test_ids_of_four_bytes_and_ids_that_are_used_again_are_read(with_numpy: bool) -> None:
    log = WpilogWriter().start(70_000, "a", "double").start(0xFFFFFFFF, "b", "int64").start(3, "c", "boolean")
    for i in range(300):
        log.double(70_000, i, i / 4).integer(0xFFFFFFFF, i, -i).record(3, i, b"\1")
    log.finish(3).start(3, "d", "string")
    for i in range(300):
        log.string(3, 300 + i, str(i % 5))
    recording = parsed(log.data, with_numpy)
    assert [len(topic) for topic in recording.topics] == [300, 300, 300, 300]
    assert recording["b"].samples[299] == -299 and recording["d"].texts[7] == (7, "2")
    assert recording.problems == []


@both_ways
def test_a_log_that_is_cut_anywhere_keeps_the_whole_records_before(with_numpy: bool) -> None:
    data = moving_robot(4)
    whole = parsed(data, with_numpy)
    for size in range(0, len(data), 3):
        recording = parsed(data[:size], with_numpy)
        assert recording.sample_count <= whole.sample_count
        # An entry with its schema or elements cut off is one topic.
        assert all(any(name.startswith(topic.name) for name in whole) for topic in recording.topics)


@both_ways
def test_no_damage_raises_and_every_sample_has_its_time(with_numpy: bool) -> None:
    source = random.Random(11)
    for seed in range(150):
        recording = parsed(damaged(moving_robot(15, seed % 10), source), with_numpy)
        for topic in recording.topics:
            assert topic.times is not None
            times = _floats(topic.times)
            assert len(times) == len(topic.samples) == len(topic) and times == sorted(times) and all(map(math.isfinite, times))
            assert all(0 <= row < len(topic) for row, _ in topic.texts)
        assert all(isinstance(problem.kind, ProblemKind) for problem in recording.problems)


@both_ways
def test_random_bytes_never_raise(with_numpy: bool) -> None:
    source = random.Random(12)
    for _ in range(300):
        parsed(b"WPILOG" + source.choice([b"\0\1", b"\0\1\0\0\0\0", b""]) + source.randbytes(source.randrange(400)), with_numpy)


@both_ways
def test_hostile_sizes_take_no_memory(with_numpy: bool) -> None:
    header = b"WPILOG\0\1"
    start = WpilogWriter().start(1, "a", "string").start(2, "b", "string[]").start(3, "c", "struct:S[]").start(4, "/.schema/struct:S", "structschema")
    hostile = [
        header + b"\xff\xff\xff\xff",
        header + b"\xff\xff\xff\0",
        start.data + b"\x7f\1\0\0\0\xff\xff\xff\x7f" + bytes(8),
        start.data + b"\x7c\1\xff\xff\xff\0" + bytes(8),
        WpilogWriter().raw(start.data[12:]).record(2, 5, b"\xff\xff\xff\x7f").record(2, 6, b"\xff\xff\xff\xff\0\0\0\0").data,
        WpilogWriter().raw(start.data[12:]).string(4, 5, "double x[2147483647]; char c[999999999999]").record(3, 6, bytes(80)).data,
        WpilogWriter().raw(start.data[12:]).string(4, 5, "S s[1000]; S t").record(3, 6, bytes(80)).data,
        WpilogWriter().raw(start.data[12:]).string(4, 5, "enum {" + "a=1," * 5000).record(3, 6, bytes(80)).data,
    ]
    for data in hostile:
        tracemalloc.start()
        parsed(data, with_numpy)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert peak < 20_000_000


@both_ways
def test_endless_messages_and_those_with_too_many_values_are_shown_as_sizes(with_numpy: bool) -> None:
    chain = b"".join(proto(4, proto(1, f"M{i}".encode()) + field("m", 1, 11, f".M{i + 1}", is_list=i % 2 == 0)) for i in range(3000))
    wide = proto(4, proto(1, b"Wide") + b"".join(field(f"v{i}", i + 1, 1) for i in range(1100)))
    self_containing = proto(4, proto(1, b"Self") + field("self", 1, 11, ".Self", is_list=True) + field("x", 2, 1))
    log = WpilogWriter().start(1, "/.schema/proto:a", "proto:FileDescriptorProto").start(2, "chain", "proto:M0").start(3, "wide", "proto:Wide")
    log.start(4, "self", "proto:Self").record(1, 1, chain + wide + self_containing)
    nested = proto(2, 1.5)
    for _ in range(3000):
        nested = proto(1, nested)
    recording = parsed(log.record(2, 2, b"").record(3, 3, b"").record(4, 4, nested).data, with_numpy)
    assert recording["chain"].unit == recording["wide"].unit == "B"
    assert list(recording["self/x"].samples) == [0.0]


@both_ways
def test_large_schemas_and_messages_of_many_fields_take_no_memory(with_numpy: bool) -> None:
    log = WpilogWriter().start(1, "/.schema/struct:S", "structschema").start(2, "/.schema/proto:a", "proto:FileDescriptorProto")
    log.start(3, "target", "proto:test.Target").record(2, 1, DESCRIPTOR).string(1, 2, "double x;" * 150_000).record(2, 3, proto(9, 1) * 600_000)
    data = log.record(3, 4, proto(9, 1) * 50_000).record(3, 5, proto(4, bytes(800_000))).data
    tracemalloc.start()
    recording = parsed(data, with_numpy)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 4 * len(data)
    assert float(recording["target/errors[255]"].samples[-1]) == 0.0
    assert [problem.count for problem in recording.problems if problem.kind is ProblemKind.TOO_MANY_TOPICS] == [100_000 - 256]


@both_ways
def test_the_values_of_small_messages_are_bounded(with_numpy: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("badlog._wpilog.blocks._MIN_MESSAGE_VALUES", 5000)
    wide = proto(4, proto(1, b"Wide") + b"".join(field(f"v{i}", i + 1, 1) for i in range(1000)))
    log = WpilogWriter().start(1, "/.schema/proto:a", "proto:FileDescriptorProto").start(2, "wide", "proto:Wide").record(1, 1, wide)
    for i in range(100):
        log.record(2, 2 + i, b"")
    recording = parsed(log.data, with_numpy)
    assert len(recording["wide"]) == 100 and recording["wide"].unit == "B"
    assert kinds_of(recording) == ["NOT_DECODED"]


def _wpilib_values(path: Path) -> dict[tuple[str, str], list[tuple[int, Any]]]:
    """The records that WPILib's own reader finds, by name and type of their entry."""
    log = pytest.importorskip("wpiutil.log", reason="WPILib's reader, robotpy-wpiutil, is not installed")
    getters = {
        "boolean": "getBoolean", "int64": "getInteger", "float": "getFloat", "double": "getDouble", "string": "getString", "json": "getString",
        "boolean[]": "getBooleanArray", "int64[]": "getIntegerArray", "float[]": "getFloatArray", "double[]": "getDoubleArray", "string[]": "getStringArray",
    }  # fmt: skip
    reader = log.DataLogReader(os.fspath(path))
    assert reader.isValid()
    entries: dict[int, tuple[str, str]] = {}
    values: dict[tuple[str, str], list[tuple[int, Any]]] = defaultdict(list)
    for record in reader:
        if record.isStart():
            start = record.getStartData()
            entries[start.entry] = (start.name, start.type)
        elif not record.isControl():
            name, type = entries[record.getEntry()]
            if type in getters:
                values[name, type].append((record.getTimestamp(), getattr(record, getters[type])()))
    return values


def _must_agree_with_wpilib(path: Path) -> int:
    """Compares each value of the log. Returns their number."""
    recording = badlog.read(path)
    first = min(_floats(topic.times)[0] for topic in recording.topics if len(topic) > 0)
    compared = 0
    for (name, type), records in _wpilib_values(path).items():
        own = [topic for topic in recording.topics if topic.type == type and (topic.name.partition("[")[0] == name or topic.name in (name, f"{name} (2)"))]
        expected: dict[int, list[tuple[float, Any]]] = defaultdict(list)
        for micros, value in records:
            time = first if micros < 0 or micros >= 1 << 63 else micros / 1e6
            elements = value if type.endswith("[]") else [value]
            for index, element in enumerate(elements):
                expected[index].append((time, element))
                compared += 1
        for index, pairs in expected.items():
            topic = next(topic for topic in own if not type.endswith("[]") or topic.name.endswith(f"[{index}]"))
            assert topic.times is not None
            texts = dict(topic.texts)
            # Without gaps, which end the elements of an array.
            found = [
                (float(topic.times[i]), texts.get(i, float(topic.samples[i])))
                for i in range(len(topic))
                if i in texts or not math.isnan(topic.samples[i]) or i in topic._written_nans
            ]
            pairs.sort(key=lambda pair: pair[0])
            assert [repr(time) for time, _ in found] == [repr(time) for time, _ in pairs], topic.name
            assert [_comparable(value) for _, value in found] == [_comparable(value) for _, value in pairs], topic.name
    return compared


def _comparable(value: Any) -> str:
    return value if isinstance(value, str) else repr(float(value))


def test_wpilibs_reader_finds_the_same_values(tmp_path: Path) -> None:
    path = tmp_path / "log.wpilog"
    path.write_bytes(moving_robot(80, seed=6))
    assert _must_agree_with_wpilib(path) > 600


@pytest.mark.skipif(REAL_LOGS is None, reason="BADLOG_REAL_LOGS names no folder of real logs")
def test_wpilibs_reader_finds_the_same_values_in_real_logs() -> None:
    logs = sorted(Path(str(REAL_LOGS)).glob("*.wpilog"))
    if not logs:
        pytest.skip(f"{REAL_LOGS} has no .wpilog")
    for log in logs:
        assert _must_agree_with_wpilib(log) > 1000
        assert not badlog.read(log).is_salvaged


def test_rows_have_the_last_values() -> None:
    log = WpilogWriter().start(1, "a", "double").start(2, "state", "string").start(3, "messages", "string").start(4, "on", "boolean")
    log.double(1, 0, 1.0).double(1, 30_000, 3.0).string(2, 10_000, "idle").string(2, 35_000, "up").record(4, 15_000, b"\1")
    log.string(3, 1_000, "one").string(3, 19_000, "two").string(3, 40_000, "three").double(1, 60_000, math.nan)
    rows = badlog.read(log.data).resampled(0.02)
    assert rows.format is RecordingFormat.BAG and rows.row_count == 4
    assert list(rows["Time"].samples) == [0.0, 0.02, 0.04, 0.06] and rows.x_axis is rows["Time"]
    assert [str(number) for number in _floats(rows["a"].samples)] == ["1.0", "1.0", "3.0", "nan"]
    assert rows["state"].texts == [(1, "idle"), (2, "up"), (3, "up")]
    assert rows["messages"].texts == [(1, "one; two"), (2, "three")]
    assert rows["on"].kind is TopicKind.BOOLEAN and rows["on"].counts.empty == 1
    at_states = badlog.read(log.data).resampled(rows_at="state")
    assert list(at_states["Time"].samples) == [0.01, 0.035] and list(at_states["a"].samples) == [1.0, 3.0]


@both_ways
def test_a_topic_of_which_badlog_wrote_only_parts_has_its_former_type(with_numpy: bool) -> None:
    log = WpilogWriter().start(1, "Pose/x", "double", '{"badlog":"type struct:Pose2d"}').start(2, "Count", "int64", '{"unit":"B","badlog":"type raw"}')
    log.start(3, "seen", "double", '{"badlog":"sparse"}')
    log.double(1, 20_000, 1.5).integer(2, 20_000, 8).double(3, 20_000, 2.5)
    recording = parsed(log.data, with_numpy)
    assert [topic.type for topic in recording.topics] == ["struct:Pose2d", "raw", "double"]
    assert list(recording["Pose/x"].samples) == [1.5]


def test_a_topic_that_was_sparse_in_a_bag_is_sparse_in_rows_again() -> None:
    log = WpilogWriter().start(1, "t", "double").start(2, "seen", "double", '{"badlog":"sparse"}')
    for index in range(10):
        log.double(1, index * 20_000, 1.0)
    log.double(2, 20_000, 5.0).double(2, 110_000, 6.0).double(2, 115_000, 7.0)
    rows = badlog.read(log.data).resampled(0.02)
    seen = _floats(rows["seen"].samples)
    assert [(row, number) for row, number in enumerate(seen) if number == number] == [(1, 5.0), (6, 7.0)]
    assert rows["seen"].is_sparse and rows["seen"].counts.empty == 8


def test_impossible_rows_are_reported_in_one_sentence() -> None:
    log = badlog.read(moving_robot(5))
    for wrong in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match="must be above 0"):
            log.resampled(wrong)
    with pytest.raises(ValueError, match="too many"):
        log.resampled(1e-12)
    with pytest.raises(ValueError, match="Pass either"):
        log.resampled()
    with pytest.raises(KeyError, match="no topic “x”"):
        log.resampled(rows_at="x")
    with pytest.raises(ValueError, match="has rows already"):
        badlog.read(b"a,b\n1,2\n").resampled(0.02)


def test_a_table_without_rows_is_an_error_that_names_resampled() -> None:
    log = badlog.read(moving_robot(5))
    pytest.importorskip("pyarrow")
    with pytest.raises(ValueError, match=r"recording\.resampled\(0\.02\)"):
        log.to_arrow()
    for library in ("pandas", "polars"):
        pytest.importorskip(library)
        with pytest.raises(ValueError, match="times of its own"):
            getattr(log, f"to_{library}")()
    rows = log.resampled(0.02)
    assert rows.to_arrow().num_rows == len(rows.to_pandas(index="Time")) == len(rows.to_polars()) == rows.row_count
    assert log["messages"].to_arrow().to_pylist() == ['loop 0 "overrun"']


def test_struct_values_are_unpacked_where_the_schema_says() -> None:
    schema = "enum {off=0, on=-1} int8 mode; uint16 low:4; uint16 high:12; bool set:1; char name[4]; double xs[2]"
    payload = struct.pack("<bHB4s2d", -1, 0xABC5, 1, b"ab\0\0", 1.5, -2.5)
    log = WpilogWriter().start(1, "/.schema/struct:S", "structschema").start(2, "s", "struct:S").string(1, 1, schema).record(2, 2, payload)
    recording = badlog.read(log.data)
    assert recording["s/mode"].texts == [(0, "on")] and recording["s/name"].texts == [(0, "ab")]
    assert [float(recording[name].samples[0]) for name in ("s/low", "s/high", "s/set", "s/xs[0]", "s/xs[1]")] == [5, 0xABC, 1, 1.5, -2.5]

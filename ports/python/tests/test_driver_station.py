"""Logs of the Driver Station: cases that the corpus lacks, damage, and another reader's results for real logs."""

from __future__ import annotations

import gzip
import importlib.util
import math
import os
import random
import tracemalloc
from pathlib import Path
from typing import Any

import pytest
from damage import damaged
from station_writer import BOTH_TELEOP, DseventsWriter, DslogWriter, pdh, pdp, short_match, told_in_match

import badlog
from badlog import ProblemKind, RecordingFormat, TopicKind
from badlog._driver_station import parser
from badlog._timed.vectors import uses_numpy

WAYS = [False, True] if uses_numpy() else [False]
REAL_LOGS = os.environ.get("BADLOG_REAL_LOGS")

both_ways = pytest.mark.parametrize("with_numpy", WAYS, ids=lambda with_numpy: "numpy" if with_numpy else "plain")


def parsed(data: bytes, with_numpy: bool, max_rows: int = badlog.MAX_ROWS) -> badlog.Recording:
    return parser.parse(data, max_rows, with_numpy)


def samples(recording: badlog.Recording, name: str) -> list[float]:
    return [float(number) for number in recording[f"Driver Station/{name}"].samples]


def described(recording: badlog.Recording) -> list[Any]:
    topics = [
        (topic, list(map(repr, map(float, topic.times if topic.times is not None else []))), list(map(repr, map(float, topic.samples))), topic.texts)
        for topic in recording.topics
    ]
    return [topics, recording.values, sorted(map(str, recording.problems))]


def test_a_dslog_is_an_object_like_a_bags() -> None:
    recording = badlog.read(short_match().data)
    assert recording.format is RecordingFormat.DRIVER_STATION and recording.problems == []
    assert recording.value("Start Time") == "2026-03-07 15:04:05 UTC"
    battery = recording["Driver Station/Battery Voltage"]
    assert battery.unit == "V" and battery.kind is TopicKind.NUMERIC and battery.times is not None
    assert float(battery.times[50]) == 1.0
    assert recording["Driver Station/DS Mode"].texts[30] == (30, "Disabled")
    assert recording["PDP/Channel 3"].attributes == ("hide", "join:PDP/Channel Currents")


@both_ways
def test_values_that_the_robot_has_not_measured_are_gaps(with_numpy: bool) -> None:
    log = DslogWriter().record(volts=math.nan, trip=255).record(volts=37.375, trip=9).record(volts=12.5, trip=255).record(volts=12.5, trip=10)
    recording = parsed(log.data, with_numpy)
    assert list(map(str, samples(recording, "Battery Voltage"))) == ["nan", "nan", "12.5", "12.5"]
    assert list(map(str, samples(recording, "Trip Time"))) == ["nan", "4.5", "nan", "5.0"]
    assert samples(recording, "Comms Connected") == [0, 0, 0, 1]
    for name, measured in (("CPU Utilization", "40.0"), ("CAN Utilization", "30.0")):
        assert list(map(str, samples(recording, name))) == ["nan", "nan", measured, measured]
    battery = recording["Driver Station/Battery Voltage"]
    assert (battery.counts.empty, battery.counts.not_finite) == (2, 0)


@both_ways
def test_the_currents_of_a_power_distribution_equal_the_written_ones(with_numpy: bool) -> None:
    log = DslogWriter().record(power=pdp(lambda channel: 1023 - channel)).record(power=pdh(lambda channel: 37 * channel % 256))
    recording = parsed(log.data, with_numpy)
    assert [float(recording[f"PDP/Channel {channel}"].samples[0]) for channel in range(16)] == [(1023 - channel) / 8 for channel in range(16)]
    expected = [37 * channel % 256 / (8 if channel < 20 else 16) for channel in range(24)]
    assert [float(recording[f"PDH/Channel {channel}"].samples[0]) for channel in range(24)] == expected
    assert float(recording["PDH/Total Current"].samples[0]) == sum(expected)
    assert float(recording["PDP/Bus Voltage"].samples[0]) == pytest.approx(12.2)


def test_a_dslog_is_read_with_the_dsevents_of_its_name(tmp_path: Path) -> None:
    log, events = short_match().data, told_in_match().data
    both = described(badlog.read(log + events))
    for name, other, pack in (
        ("a.dslog", "a.dsevents", bytes),
        ("B.DSLOG", "B.DSEVENTS", bytes),
        ("c.dslog.gz", "c.dsevents.gz", gzip.compress),
    ):
        path = tmp_path / name
        path.write_bytes(pack(log))
        assert described(badlog.read(path)) == described(badlog.read(log))
        (tmp_path / other).write_bytes(pack(events))
        recording = badlog.read(path)
        assert described(recording) == both
        assert recording.path == os.fspath(path) and recording.value("Event Name") == "MILLC"
        assert described(badlog.read(tmp_path / other)) == described(badlog.read(events))
    found = [Path(str(recording.path)).name for recording in badlog.read_folder(tmp_path)]
    assert found == ["B.DSLOG", "a.dslog", "c.dslog.gz"]


def test_events_have_their_times_the_oldest_of_an_entry_first() -> None:
    recording = badlog.read(told_in_match().data)
    console = [event.text for event in recording.events if event.topic == "Driver Station/Console"]
    assert console == ["\tfirst", "ready"]
    error = next(event for event in recording.events if event.text.startswith("ERROR"))
    assert error.text == "ERROR -200 CTR: No response at Talon FX 63\n \tat one\n\tat two" and error.x == pytest.approx(0.9)
    assert samples(recording, "Laptop Battery") == [100]
    assert [problem.kind for problem in recording.problems] == [ProblemKind.TIMES_SORTED]


@pytest.mark.skipif(not uses_numpy(), reason="NumPy is not installed")
def test_a_damaged_log_is_read_alike_with_and_without_numpy() -> None:
    source = random.Random(21)
    for seed in range(60):
        data = damaged(short_match(seed).data + told_in_match().data, source)
        assert described(parsed(data, True)) == described(parsed(data, False))


@both_ways
def test_a_log_that_is_cut_anywhere_keeps_the_whole_records_before(with_numpy: bool) -> None:
    data = short_match(2, 120).data
    whole = samples(parsed(data, with_numpy), "Packet Loss")
    for size in range(20, len(data), 7):
        recording = parsed(data[:size], with_numpy)
        kept = samples(recording, "Packet Loss")
        assert kept == whole[: len(kept)]


@both_ways
def test_no_damage_raises_and_every_sample_has_its_time(with_numpy: bool) -> None:
    source = random.Random(22)
    version_3 = DslogWriter(3).record(BOTH_TELEOP).record().record().data
    for seed in range(150):
        base = [short_match(seed, 60).data + told_in_match().data, told_in_match().data, version_3][seed % 3]
        recording = parsed(damaged(base, source), with_numpy)
        for topic in recording.topics:
            assert topic.times is not None
            times = [float(time) for time in topic.times]
            assert len(times) == len(topic.samples) == len(topic) and times == sorted(times)
        assert all(isinstance(problem.kind, ProblemKind) for problem in recording.problems)


@both_ways
def test_random_bytes_after_a_header_never_raise(with_numpy: bool) -> None:
    source = random.Random(23)
    header = DslogWriter().data
    for _ in range(200):
        parsed(header[: source.choice([9, 15, 20])] + source.randbytes(source.randrange(300)), with_numpy)


@both_ways
def test_hostile_sizes_take_no_memory(with_numpy: bool) -> None:
    head = DslogWriter().record().data[:-4]
    entry = DseventsWriter().entry(1, "x").data[:-5]
    for data in (head + b"\x7f\xff\xff\xff", head + b"\0\0\x10\0", head + b"\xff\xff\xff\xff", entry + b"\x7f\xff\xff\xff", entry + b"\0\x0f\xff\xff"):
        tracemalloc.start()
        recording = parsed(data + bytes(100), with_numpy)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert peak < 5_000_000 and recording.is_salvaged


@both_ways
def test_no_more_records_are_read_than_the_maximum(with_numpy: bool) -> None:
    recording = parsed(short_match().data, with_numpy, max_rows=12 * 100)
    assert len(recording["Driver Station/Battery Voltage"]) == 100
    assert [problem.kind for problem in recording.problems] == [ProblemKind.TOO_MANY_ROWS]


@pytest.mark.skipif(REAL_LOGS is None, reason="BADLOG_REAL_LOGS names no folder of real logs")
def test_another_reader_finds_the_same_values_in_real_logs() -> None:
    reader = next(Path(str(REAL_LOGS)).rglob("oracle.py"), None)
    if reader is None:
        pytest.skip(f"{REAL_LOGS} has no oracle.py, the other reader of Driver Station logs")
    specification = importlib.util.spec_from_file_location("oracle", reader)
    assert specification is not None and specification.loader is not None
    oracle: Any = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(oracle)
    for log in sorted(reader.parent.glob("*.dslog")):
        recording = badlog.read(log.read_bytes())
        _, _, records = oracle.log(log)
        assert recording.problems == []
        volts = [math.nan if record["volts"] > 255.99 else record["volts"] for record in records]
        trips = [math.nan if record["trip_ms"] == 127.5 else record["trip_ms"] for record in records]
        assert list(map(str, samples(recording, "Battery Voltage"))) == list(map(str, map(float, volts)))
        assert list(map(str, samples(recording, "Trip Time"))) == list(map(str, map(float, trips)))
        power = next((topic.name for topic in recording.topics if topic.name.endswith("/Channel 0")), "")
        amps = [record["amps"] for record in records if "amps" in record]
        for channel in range(len(amps[0]) if amps else 0):
            own = [float(number) for number in recording[power.replace("0", str(channel))].samples]
            assert [number for number in own if not math.isnan(number)] == [record[channel] for record in amps]


def test_rows_every_20_ms_hold_each_record_at_its_own_time() -> None:
    # 829 times 0.02 s is a little more than 16.58 s.
    log = DslogWriter()
    for index in range(1500):
        log.record(cpu=index % 100)
    whole = badlog.read(log.data)
    rows = whole.resampled(0.02)
    assert rows.row_count == 1500
    for name in ("Driver Station/Battery Voltage", "Driver Station/CPU Utilization"):
        assert list(map(str, rows[name].samples)) == list(map(str, whole[name].samples))

"""The logger for RobotPy never raises into the loop, and loses no row after its call of `log()` returned."""

from __future__ import annotations

import errno
import gzip
import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import badlog
from badlog import ProblemKind
from badlog.robot import BadLog, DataInferMode, DuplicateNameError, InvalidModeError, LogState, _standard_error
from badlog.robot._output import AppendFile

KILLS = 200
HERE = Path(__file__).parent


@pytest.fixture
def path(tmp_path: Path) -> Iterator[Path]:
    yield tmp_path / "log.bag"
    if BadLog._current is not None:
        BadLog._current.close()


def row(log: BadLog) -> None:
    log.update_topics()
    log.log()


def rows_in(path: Path) -> list[str]:
    return path.read_text(encoding="utf-8").split("\n")[2:-1]


def test_a_callable_that_raises_or_returns_none_leaves_a_gap_and_is_reported_once(path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    log = BadLog.init(path)
    BadLog.create_topic("Raises", "V", lambda: 1 / 0)
    BadLog.create_topic_str("None", "ul", lambda: None)
    BadLog.create_topic("Text", "V", lambda: "fast")  # type: ignore[arg-type, return-value]
    BadLog.create_topic_int("Fine", "ul", lambda: 2**70)
    events = BadLog.create_events("Events")
    log.finish_initialization()
    row(log)
    events.event("second")
    row(log)
    assert rows_in(path)[0].startswith(',,,1180591620717411303424,"The topic ""Raises"" raised ZeroDivisionError: division by zero')
    assert rows_in(path)[1] == ",,,1180591620717411303424,second"
    assert log.counters().cells_missed == 6
    assert _standard_error.await_printed(60)
    messages = capfd.readouterr().err
    assert messages.count("Raises") == messages.count("None") - messages.count("gave None") == 1
    assert messages.startswith('badlog: The topic "Raises" raised ZeroDivisionError')


def test_calls_that_come_too_early_or_too_late_are_ignored_and_counted(path: Path) -> None:
    log = BadLog.init(path)
    BadLog.create_topic_subscriber("A", "V", DataInferMode.LAST)
    row(log)
    BadLog.publish("A", 1.5)
    log.finish_initialization()
    row(log)
    BadLog.publish("None", 1)
    BadLog.publish("A", None)  # type: ignore[arg-type]
    BadLog.publish(None, 1)  # type: ignore[arg-type]
    row(log)
    log.close()
    row(log)
    log.flush()
    log.close()
    assert rows_in(path) == ["1.5000", "1.5000"]
    assert log.counters().calls_ignored == 7
    assert log.state is LogState.CLOSED


def test_mistakes_during_setup_raise(path: Path) -> None:
    log = BadLog.init(path)
    BadLog.create_value("A", "1")
    with pytest.raises(DuplicateNameError, match='is already a topic or value "A"'):
        BadLog.create_topic("A", "V", lambda: 1.0)
    log.finish_initialization()
    with pytest.raises(InvalidModeError, match='"B" was created too late'):
        BadLog.create_events("B")
    with pytest.raises(InvalidModeError, match="only once"):
        log.finish_initialization()


def test_a_second_log_closes_the_first(path: Path, tmp_path: Path) -> None:
    first = BadLog.init(path)
    with BadLog.init(tmp_path / "second.bag") as second:
        assert [first.state, second.state] == [LogState.CLOSED, LogState.SETTING_UP]
    assert [second.state] == [LogState.CLOSED]


def test_events_of_a_row_are_one_text_that_is_not_a_number(path: Path) -> None:
    log = BadLog.init(path)
    events = BadLog.create_events("Events")
    log.finish_initialization()
    for texts in (["one", "two, three"], [], ["42"], ["true"]):
        for text in texts:
            events.event(text)
        row(log)
    assert rows_in(path) == ['"one; two, three"', '""', "event 42", "event true"]
    recording = badlog.read(path)
    assert [event.text for event in recording.events] == ["one; two, three", "event 42", "event true"]


def test_a_formatter_that_fails_leaves_a_gap_and_one_that_calls_the_log_is_ignored(path: Path) -> None:
    log = BadLog.init(path)
    BadLog.create_topic("A", "V", lambda: 1.25)
    log.finish_initialization()

    def meddling(value: float) -> str:
        log.log()
        log.update_topics()
        log.flush()
        return f"{value:.1f}"

    for function in (lambda value: str(1 / 0), lambda value: None, meddling, None):
        log.set_double_to_string_function(function)  # type: ignore[arg-type]
        row(log)
    assert rows_in(path) == ['""', '""', "1.2", "1.2500"]

    def closing(value: float) -> str:
        log.close()
        return "last"

    log.set_double_to_string_function(closing)
    row(log)
    assert rows_in(path)[-1] == "last"
    assert log.state is LogState.CLOSED


def test_a_log_that_cannot_be_created_is_reported_and_the_robot_continues(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    log = BadLog.init(tmp_path / "file" / "log.bag")
    BadLog.create_topic("A", "V", lambda: 1.0)
    log.finish_initialization()
    row(log)
    assert log.state is LogState.FAILING
    assert log.counters().rows_missed == 1
    log.close()
    assert _standard_error.await_printed(60)
    assert "cannot be created" in capfd.readouterr().err


def test_rows_lost_to_a_full_disk_are_counted_and_their_events_are_logged_later(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    log = BadLog.init(path)
    BadLog.create_topic_int("Row", "ul", lambda: 7)
    events = BadLog.create_events("Events")
    log.finish_initialization()
    row(log)
    write = os.write

    def full(file: int, data: bytes) -> int:
        # Half of it still fits.
        if data.endswith(b"\n"):
            write(file, data[: len(data) // 2])
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("badlog.robot._output.os.write", full)
    events.event("before")
    row(log)
    assert log.state is LogState.FAILING
    row(log)
    monkeypatch.undo()
    while log.counters().rows_written < 2:
        row(log)
        time.sleep(0.01)
    recording = badlog.read(path)
    assert [problem.kind.value for problem in recording.problems] == []
    text = recording.events[0].text
    assert text.startswith("before; ") and "cannot be written" in text
    row(log)
    assert "rows before this one could not be written" in badlog.read(path).events[-1].text


def test_rows_without_flush_are_written_soon(path: Path) -> None:
    log = BadLog.init(path, flush=False)
    BadLog.create_topic("A", "V", lambda: 1.0)
    log.finish_initialization()
    row(log)
    end = time.monotonic() + 60
    while not rows_in(path) and time.monotonic() < end:
        time.sleep(0.01)
    assert rows_in(path) == ["1.0000"]


def test_a_deleted_file_is_noticed(path: Path) -> None:
    log = BadLog.init(path)
    BadLog.create_topic("A", "V", lambda: 1.0)
    log.finish_initialization()
    path.unlink()
    end = time.monotonic() + 60
    while log.state is not LogState.FAILING and time.monotonic() < end:
        time.sleep(0.01)
    row(log)
    assert log.state is LogState.FAILING
    assert log.counters().rows_missed == 1


def test_each_row_is_one_write(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    writes: list[bytes] = []
    write = os.write

    def recorded(file: int, data: bytes) -> int:
        writes.append(data)
        return write(file, data)

    monkeypatch.setattr("badlog.robot._output.os.write", recorded)
    log = BadLog.init(path)
    for i in range(50):
        BadLog.create_topic(f"Topic {i}", "V", lambda: 12.5)
    log.finish_initialization()
    for _ in range(20):
        row(log)
    assert len(writes) == 21


def test_each_row_of_a_gzip_log_can_be_inflated_and_close_adds_the_end(path: Path) -> None:
    log = BadLog.init(path, compress=True)
    BadLog.create_topic("A", "V", lambda: 1.0)
    log.finish_initialization()
    packed = Path(f"{path}.gz")
    for count in range(1, 4):
        row(log)
        recording = badlog.read(packed)
        assert recording.row_count == count and recording.problems == []
    log.close()
    assert gzip.decompress(packed.read_bytes()).endswith(b"\nA\n1.0000\n1.0000\n1.0000\n")


def test_threads_may_publish_log_and_close_at_once(path: Path) -> None:
    log = BadLog.init(path)
    BadLog.create_topic_subscriber("A", "V", DataInferMode.LAST)
    events = BadLog.create_events("Events")
    log.finish_initialization()

    def work(seed: int) -> None:
        for i in range(300):
            BadLog.publish("A", seed * 1000 + i)
            events.event(f"thread {seed} loop {i}")
            row(log)

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(work, range(8)))
    log.close()
    recording = badlog.read(path)
    assert recording.row_count == 2400 and recording.problems == []
    told = [text for event in recording.events for text in event.text.split("; ")]
    assert len(told) + log.counters().events_dropped == 2400


def test_a_full_standard_error_never_blocks_the_loop(tmp_path: Path) -> None:
    program = (
        "from badlog.robot import BadLog\n"
        f"log = BadLog.init({str(tmp_path / 'log.bag')!r})\n"
        "for i in range(300): BadLog.create_topic(f'Topic {i} ' + 'x' * 1000, 'V', lambda: 1 / 0)\n"
        "log.finish_initialization()\n"
        "log.update_topics(); log.log()\n"
        "print('done', flush=True)\n"
    )
    environment = {**os.environ, "PYTHONPATH": str(HERE.parent / "src")}
    robot = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment)
    assert robot.stdout is not None and robot.stderr is not None
    # Its standard error is a pipe of 64 KiB without a reader.
    assert robot.stdout.readline() == b"done\n"
    robot.kill()
    robot.wait()
    robot.stdout.close()
    robot.stderr.close()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system cannot fork")
def test_killed_robots_leave_every_row_for_which_log_returned(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": str(HERE.parent / "src")}
    command = [sys.executable, str(HERE / "killed_robots.py"), str(tmp_path), str(KILLS)]
    killed = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert killed.stderr == ""
    faults = [_fault_of(tmp_path, number) for number in range(KILLS)]
    assert [fault for fault in faults if fault] == []


def _fault_of(folder: Path, number: int) -> str | None:
    """The fault of a killed robot's log, or None."""
    rows = int((folder / f"{number}.returned").read_text())
    recording = badlog.read(folder / (f"{number}.bag.gz" if number % 2 == 1 else f"{number}.bag"))
    samples = recording["Row"].samples.tolist() if "Row" in recording else []
    # Only the row with an unfinished call of log() may be cut, with the compressed bytes that hold it. Nothing before it may be cut.
    cut = [problem for problem in recording.problems if problem.severity.name == "ERROR" and problem.kind is not ProblemKind.GZIP_CUT]
    lost = [problem for problem in cut if (problem.line or 0) < 3 + rows]
    if rows > 0 and samples[:rows] == list(range(rows)) and not lost:
        return None
    return f"robot {number}: {rows} rows returned, {len(samples)} found, {recording.problems}"


def test_a_failed_append_leaves_the_file_unchanged(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = AppendFile(path)
    file.append(b"one\n")
    monkeypatch.setattr("badlog.robot._output.os.write", lambda *_: (_ for _ in ()).throw(OSError(errno.EIO, "no")))
    with pytest.raises(OSError):
        file.append(b"two\n")
    monkeypatch.undo()
    file.append(b"three\n")
    file.close()
    assert path.read_bytes() == b"one\nthree\n"


def test_a_callable_may_wait_for_a_thread_that_publishes(path: Path) -> None:
    log = BadLog.init(path)
    publisher = BadLog.create_publisher("A", "V", DataInferMode.LAST)

    def ask() -> float:
        thread = threading.Thread(target=lambda: publisher.publish(3.0))
        thread.start()
        thread.join()
        return 1.0

    BadLog.create_topic("B", "V", ask)
    log.finish_initialization()
    row(log)
    assert rows_in(path) == ["3.0000,1.0000"]

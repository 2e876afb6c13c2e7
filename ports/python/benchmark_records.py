"""Measures the speed of reading in one run. Reads a WPILOG, a log of the Driver Station, and a bag with the WPILOG's samples.

    python ports/python/benchmark_records.py LOG.bag [runs] [copies]

The rows of the bag are repeated `copies` times, and written as a bag and as a WPILOG. The log of the Driver Station is written by `tests`.
"""

from __future__ import annotations

import math
import struct
import sys
import time
from collections.abc import Callable
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE / "src"), str(HERE / "tests")]

from station_writer import DslogWriter, pdh  # noqa: E402
from wpilog_writer import WpilogWriter  # noqa: E402

import badlog  # noqa: E402
from badlog import _bag_parser, reading  # noqa: E402
from badlog._driver_station import parser as driver_station_parser  # noqa: E402
from badlog._wpilog import parser as wpilog_parser  # noqa: E402


def main() -> None:
    path = Path(sys.argv[1])
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    copies = int(sys.argv[3]) if len(sys.argv) > 3 else 8
    bag = path.read_bytes()
    head = bag.index(b"\n", bag.index(b"\n") + 1) + 1
    bag = bag[:head] + bag[head:] * copies
    wpilog = as_wpilog(badlog.read(path), copies)
    dslog = driver_station_log(12_000 * copies)
    ways: dict[str, tuple[bytes, Callable[[], badlog.Recording]]] = {
        "bag": (bag, lambda: _bag_parser.parse(bag, badlog.MAX_ROWS, reading._has_arrow())),
        "bag, only Python": (bag, lambda: _bag_parser.parse(bag, badlog.MAX_ROWS, False)),
        "WPILOG": (wpilog, lambda: wpilog_parser.parse(wpilog, badlog.MAX_ROWS, reading.uses_numpy())),
        "WPILOG, only Python": (wpilog, lambda: wpilog_parser.parse(wpilog, badlog.MAX_ROWS, False)),
        "dslog": (dslog, lambda: driver_station_parser.parse(dslog, badlog.MAX_ROWS, reading.uses_numpy())),
        "dslog, only Python": (dslog, lambda: driver_station_parser.parse(dslog, badlog.MAX_ROWS, False)),
    }
    # In turn, so that other work of the machine slows all of them.
    best: dict[str, float] = dict.fromkeys(ways, math.inf)
    samples: dict[str, int] = {}
    for _ in range(runs):
        for name, (_, way) in ways.items():
            began = time.process_time()
            recording = way()
            # Includes lazy work, as for a user of the samples.
            for topic in recording.topics:
                _ = topic.samples
            best[name] = min(best[name], time.process_time() - began)
            samples[name] = recording.sample_count
    print(f"{path.name}, {copies} times; best of {runs}")
    for name, (data, _) in ways.items():
        base = "bag, only Python" if name.endswith("Python") else "bag"
        bytes_per_second = len(data) / best[name]
        samples_per_second = samples[name] / best[name]
        ratios = (bytes_per_second * best[base] / len(bag), samples_per_second * best[base] / samples[base])
        print(
            f"{name:20} {len(data) / 1e6:6.1f} MB {samples[name] / 1e6:6.2f} M samples {best[name]:6.2f} s  {bytes_per_second / 1e6:6.1f} MB/s  "
            f"{samples_per_second / 1e6:6.2f} M samples/s  {ratios[0]:5.2f} × the bag's bytes/s, {ratios[1]:5.2f} × its samples/s"
        )


def as_wpilog(recording: badlog.Recording, copies: int) -> bytes:
    """All samples of the recording, each as a record."""
    log = WpilogWriter()
    for id, topic in enumerate(recording.topics, 1):
        is_text = topic.kind in (badlog.TopicKind.STATE, badlog.TopicKind.EVENT)
        log.start(id, topic.name, "string" if is_text else "boolean" if topic.kind is badlog.TopicKind.BOOLEAN else "double")
    texts = [dict(topic.texts) for topic in recording.topics]
    for row in range(recording.row_count * copies):
        own = row % recording.row_count
        for id, topic in enumerate(recording.topics, 1):
            micros = row * 20_000 + id
            number = float(topic.samples[own])
            if own in texts[id - 1]:
                log.string(id, micros, texts[id - 1][own])
            elif topic.kind is badlog.TopicKind.BOOLEAN:
                log.record(id, micros, bytes([int(number == 1)]))
            elif not math.isnan(number):
                log.record(id, micros, struct.pack("<d", number))
    return log.data


def driver_station_log(records: int) -> bytes:
    """A log of so many records, each with a power distribution."""
    log = DslogWriter()
    for i in range(records):
        log.record(volts=12 - i % 50 / 16, cpu=i % 200, power=pdh(lambda channel: (channel + i) % 256))
    return log.data


if __name__ == "__main__":
    main()

"""Runs robots, one after another, and kills each within its loop: `killed_robots.py FOLDER COUNT`.

Robot N logs to `N.bag`, gzipped if N is odd; `N.returned` says how many of its calls of `log()` had returned. The robots count in memory that they
share with this program, so that the count is correct however they end.
"""

from __future__ import annotations

import math
import mmap
import os
import random
import signal
import struct
import sys
import time
from pathlib import Path

from badlog.robot import BadLog, DataInferMode


def main() -> None:
    folder = Path(sys.argv[1])
    for number in range(int(sys.argv[2])):
        returned = mmap.mmap(-1, 8)
        robot = os.fork()
        if robot == 0:
            run(folder / f"{number}.bag", number % 2 == 1, returned)
        while rows(returned) == 0:
            time.sleep(0.0005)
        time.sleep(random.Random(number).uniform(0, 0.03))
        os.kill(robot, signal.SIGKILL)
        os.waitpid(robot, 0)
        (folder / f"{number}.returned").write_text(str(rows(returned)))


def rows(returned: mmap.mmap) -> int:
    return int(struct.unpack(">q", returned[:8])[0])


def run(path: Path, compress: bool, returned: mmap.mmap) -> None:
    log = BadLog.init(path, compress=compress)
    row = 0
    BadLog.create_topic_int("Row", "ul", lambda: row)
    BadLog.create_topic("Sine", "ul", lambda: math.sin(row))
    for i in range(10):
        BadLog.create_topic(f"Topic/{i}", "V", lambda i=i: row * 0.1 * i)  # type: ignore[misc]
    BadLog.create_topic_bool("Odd", "ul", lambda: row % 2 == 1)
    events = BadLog.create_events("Events")
    publisher = BadLog.create_publisher("Published", "ul", DataInferMode.LAST)
    log.finish_initialization()
    while True:
        publisher.publish(row * 0.5)
        if row % 100 == 7:
            events.event(f'row {row}, "quoted"')
        log.update_topics()
        log.log()
        row += 1
        returned[:8] = struct.pack(">q", row)


if __name__ == "__main__":
    main()

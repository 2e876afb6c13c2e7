"""Measures how fast a bag is read, beside Polars' `read_csv` on the same rows, in one run.

    python ports/python/benchmark.py LOG.bag [runs]
"""

from __future__ import annotations

import io
import sys
import time
from collections.abc import Callable
from pathlib import Path

import polars

import badlog


def main() -> None:
    path = Path(sys.argv[1])
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    data = path.read_bytes()
    rows = data[data.index(b"\n") + 1 :]
    ways: dict[str, Callable[[], object]] = {
        "polars.read_csv": lambda: polars.read_csv(io.BytesIO(rows)),
        "badlog.read": lambda: badlog.read(data),
        "badlog.read, samples": lambda: [topic.samples for topic in badlog.read(data).topics],
        "badlog.read, to_polars": lambda: badlog.read(data).to_polars(),
    }
    # In turn, so that other work of the machine slows all of them.
    times: dict[str, list[float]] = {name: [] for name in ways}
    for _ in range(runs):
        for name, way in ways.items():
            began = time.perf_counter()
            way()
            times[name].append(time.perf_counter() - began)
    best = {name: min(taken) for name, taken in times.items()}
    print(f"{path.name}: {len(data) / 1e6:.0f} MB, best of {runs}")
    for name, seconds in best.items():
        print(f"{name:24} {seconds:6.2f} s  {best['polars.read_csv'] / seconds:6.1%} of Polars' speed")


if __name__ == "__main__":
    main()

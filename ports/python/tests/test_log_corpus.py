"""Reads the corpus of logs without rows, `libraries/formats/conformance`, which all languages' readers must read alike."""

from __future__ import annotations

import json
import math
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from write_log_corpus import FOLDER, logs

import badlog
from badlog._driver_station import parser as driver_station_parser
from badlog._timed.vectors import uses_numpy
from badlog._wpilog import parser as wpilog_parser

LOGS = sorted(log for log in FOLDER.iterdir() if log.suffix in (".wpilog", ".dslog", ".dsevents"))
WAYS = [False, True] if uses_numpy() else [False]


def test_the_corpus_equals_the_output_of_its_writer() -> None:
    assert {log.name: log.read_bytes() for log in LOGS} == logs()


@pytest.mark.parametrize("with_numpy", WAYS, ids=lambda with_numpy: "numpy" if with_numpy else "plain")
@pytest.mark.parametrize("log", LOGS, ids=lambda log: log.name)
def test_a_log_of_the_corpus_is_read_as_the_kotlin_reader_does(log: Path, with_numpy: bool) -> None:
    expected = json.loads(log.with_name(f"{log.name}.json").read_text(encoding="utf-8"))
    parser = wpilog_parser if log.suffix == ".wpilog" else driver_station_parser
    recording = parser.parse(log.read_bytes(), badlog.MAX_ROWS, with_numpy)
    assert recording.format.value == expected["format"]
    assert [[value.name, value.text] for value in recording.values] == expected["values"]
    assert [_topic(topic) for topic in recording.topics] == [_expected(topic) for topic in expected["topics"]]
    found = Counter((problem.kind.value, problem.topic, problem.count, problem.message) for problem in recording.problems)
    assert found == Counter((problem["kind"], problem["topic"], problem["count"], problem["message"]) for problem in expected["problems"])


def _topic(topic: badlog.Topic) -> dict[str, Any]:
    counts = topic.counts
    assert topic.times is not None
    return {
        "name": topic.name,
        "unit": topic.unit,
        "attributes": list(topic.attributes),
        "kind": topic.kind.value,
        "type": topic.type,
        "metadata": topic.metadata,
        "counts": [counts.numbers, counts.not_finite, counts.truth_values, counts.texts, counts.empty, counts.gaps],
        "times": [repr(float(time)) for time in topic.times],
        "samples": [repr(float(sample)) for sample in topic.samples],
        "texts": [list(text) for text in topic.texts],
    }


def _expected(topic: dict[str, Any]) -> dict[str, Any]:
    samples = [repr(_number(sample)) for sample in topic["samples"]] or [repr(math.nan)] * len(topic["times"])
    return {**topic, "times": [repr(_number(time)) for time in topic["times"]], "samples": samples}


def _number(number: float | str) -> float:
    return float(number.replace("Infinity", "inf")) if isinstance(number, str) else float(number)

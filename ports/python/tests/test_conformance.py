"""Reads the corpus of bags, `core/conformance`, and compares with its expectations."""

from __future__ import annotations

import json
import math
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from badlog import _bag_parser, reading
from badlog.recording import Topic

CORPUS = Path(__file__).parents[3] / "core" / "conformance"
BAGS = sorted(CORPUS.glob("*.bag"))
WAYS = [False, True] if reading._has_arrow() else [False]


def test_the_corpus_is_there() -> None:
    assert len(BAGS) > 100


@pytest.mark.parametrize("uses_arrow", WAYS, ids=lambda uses_arrow: "arrow" if uses_arrow else "plain")
@pytest.mark.parametrize("bag", BAGS, ids=lambda bag: bag.stem)
def test_a_file_of_the_corpus_is_read_as_expected(bag: Path, uses_arrow: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("badlog._rows._MIN_ARROW_BYTES", 1)
    expected = json.loads(bag.with_suffix(".json").read_text(encoding="utf-8"))
    recording = _bag_parser.parse(bag.read_bytes(), reading.MAX_ROWS, uses_arrow)
    why = expected["description"]
    assert recording.format.value == expected["format"], why
    assert [{"name": value.name, "value": value.text} for value in recording.values] == expected["values"], why
    assert recording.row_count == expected["rowCount"], why
    assert [_topic(topic, recording.row_count) for topic in recording.topics] == [_expected(topic) for topic in expected["topics"]], why
    assert _problems(recording.problems) == _expected_problems(expected["problems"]), why
    assert _problems(recording.attribute_problems) == _expected_problems(expected["attributeProblems"]), why


def _topic(topic: Topic, rows: int) -> dict[str, Any]:
    counts = topic.counts
    written_nans = set(topic._written_nans)
    return {
        "name": topic.name,
        "unit": topic.unit,
        "attributes": list(topic.attributes),
        "kind": topic.kind.value,
        "counts": {
            "numbers": counts.numbers,
            "notFinite": counts.not_finite,
            "truthValues": counts.truth_values,
            "texts": counts.texts,
            "empty": counts.empty,
        },
        "samples": ["NaN" if row in written_nans else _sample(float(topic.samples[row])) for row in range(rows)],
        "texts": [list(text) for text in topic.texts],
    }


def _sample(number: float) -> Any:
    if math.isnan(number):
        return None
    # As text, because -0.0 == 0.0.
    return repr(number)


def _expected(topic: dict[str, Any]) -> dict[str, Any]:
    names = {"Infinity": "inf", "-Infinity": "-inf", "NaN": "NaN"}
    samples = [None if it is None else names[it] if isinstance(it, str) else repr(float(it)) for it in topic["samples"]]
    return {**topic, "samples": samples}


def _problems(problems: list[Any]) -> Counter[Any]:
    return Counter((problem.kind.value, problem.line, problem.topic) for problem in problems)


def _expected_problems(problems: list[dict[str, Any]]) -> Counter[Any]:
    return Counter((problem["kind"], problem["line"], problem["topic"]) for problem in problems)

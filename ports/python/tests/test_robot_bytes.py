"""The logger for RobotPy writes the same bytes as jvm-robot."""

from __future__ import annotations

import random
import struct
from fractions import Fraction
from pathlib import Path

import pytest
import recorded_script

import badlog
from badlog.robot import BadLog, DataInferMode
from badlog.robot._bag_text import text_cell, title_of
from badlog.robot._numbers import five_digits, microseconds

ROOT = Path(__file__).parents[3]
NUMBERS = ROOT / "core" / "conformance" / "numbers" / "five-digits.txt"


def test_a_recorded_script_of_calls_writes_the_same_bytes_as_with_the_original_and_in_java(tmp_path: Path) -> None:
    recorded_script.run(tmp_path / "script.bag", 200)
    recorded = (ROOT / "jvm-robot" / "src" / "test" / "resources" / "recorded-script.bag").read_bytes()
    assert (tmp_path / "script.bag").read_bytes() == recorded


def test_the_white_papers_example_writes_the_bytes_of_the_original(tmp_path: Path) -> None:
    match_time = 15.0
    log = BadLog.init(tmp_path / "test.bag")
    BadLog.create_value("Match_Number", "8")
    BadLog.create_topic("Match_Time", "s", lambda: match_time)
    BadLog.create_topic_subscriber("Random_Numbers", BadLog.UNITLESS, DataInferMode.DEFAULT, "integrate")
    log.finish_initialization()
    for number in (0.25, 0.7071067811865476, 1e-5):
        BadLog.publish("Random_Numbers", number)
        log.update_topics()
        log.log()
        match_time -= 0.02
    assert (tmp_path / "test.bag").read_text() == (
        '{"topics":[{"unit":"s","name":"Match_Time","attrs":[]},{"unit":"ul","name":"Random_Numbers","attrs":["integrate"]}],'
        '"values":[{"name":"Match_Number","value":"8"}]}\n'
        "Match_Time,Random_Numbers\n15.000,0.25000\n14.980,0.70711\n14.960,1.0000e-05\n"
    )
    log.close()


@pytest.mark.parametrize(
    ("value", "text"),
    [
        *((0.0, "0.0000"), (-0.0, "-0.0000"), (12.3456, "12.346"), (-100.0, "-100.00"), (1e-4, "0.00010000"), (123456.0, "1.2346e+05")),
        *((2.00005, "2.0001"), (99999.5, "1.0000e+05"), (99999.4, "99999"), (9.99995e-5, "0.00010000"), (5e-324, "4.9000e-324")),
        *((float("nan"), "NaN"), (float("-inf"), "-Infinity"), (1.7976931348623157e308, "1.7977e+308"), (0.0123456, "0.012346")),
        *((99999.99999999999, "1.0000e+05"), (9999.99999, "10000"), (-0.99999999, "-1.0000")),
    ],
)
def test_a_number_has_five_digits(value: float, text: str) -> None:
    assert five_digits(value) == text


def test_quick_numbers_equal_exact_arithmetic() -> None:
    random_source = random.Random(3)
    for _ in range(20_000):
        value = random_source.choice((random_source.uniform(-1e5, 1e5), 10 ** random_source.uniform(-4, 5)))
        text = five_digits(value)
        assert len(text.lstrip("-0.").replace(".", "")) == 5
        unit = Fraction(10) ** -len(text.partition(".")[2])
        assert abs(Fraction(text) - Fraction(value)) <= unit / 2 + abs(Fraction(value)) / 2**52


def test_the_numbers_of_the_corpus_have_its_texts() -> None:
    tried = 0
    for line in NUMBERS.read_text().splitlines():
        if line.startswith("digest"):
            continue
        bits, text = line.split(" ")
        (value,) = struct.unpack(">d", bytes.fromhex(bits))
        assert five_digits(value) == text, bits
        tried += 1
    assert tried > 1000


@pytest.mark.parametrize(
    ("value", "text"),
    [
        *((0.02, "0.020000"), (100.02, "100.020000"), (-0.0, "0.000000"), (-1e-9, "0.000000"), (-2.5, "-2.500000")),
        *((1.9999999, "2.000000"), (1e19, "1.0000e+19"), (float("inf"), "Infinity")),
    ],
)
def test_an_x_axis_has_six_decimals(value: float, text: str) -> None:
    assert microseconds(value) == text


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        *(("plain", b"plain"), ("", b""), ("a,b", b'"a,b"'), (' "quoted"', b'" ""quoted"""'), ("two\nlines", b'"two\nlines"')),
        *(("a\0b", "a\ufffdb".encode()), ("\ud83e", "\ufffd".encode()), ("\ud83e\udd16", "🤖".encode()), ("x\xa0", b'"x\xc2\xa0"')),
    ],
)
def test_a_text_is_quoted_as_readers_need_it(text: str, cell: bytes) -> None:
    assert text_cell(text) == cell


@pytest.mark.parametrize("name", ["a\nb", "a\r\nb", "\n", "a\0b", "\ud83e", "a🤖b", 'a "b", c'])
def test_characters_that_titles_cannot_hold_are_replaced_in_both_header_lines(name: str, tmp_path: Path) -> None:
    log = BadLog.init(tmp_path / "log.bag")
    BadLog.create_topic(name, "s", lambda: 1.5, "xaxis", "hide")
    BadLog.create_topic("Other", "V", lambda: 2.0)
    log.finish_initialization()
    log.update_topics()
    log.log()
    recording = badlog.read(tmp_path / "log.bag")
    assert recording.topics[0].name == title_of(name)
    assert [(topic.unit, topic.attributes) for topic in recording.topics] == [("s", ("xaxis", "hide")), ("V", ())]
    assert list(recording.topics[0].samples) == [1.5]
    assert {problem.kind.value for problem in recording.problems} <= {"UNUSUAL_NAME"}
    log.close()

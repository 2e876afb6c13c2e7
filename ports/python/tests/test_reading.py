"""Reads files and folders, compressed and damaged, and queries recordings."""

from __future__ import annotations

import gzip
import io
import math
import random
import re
import zlib
from pathlib import Path

import pytest

import badlog
from badlog import ProblemKind, _bag_parser, reading

ROOT = Path(__file__).parents[3]
SAMPLES = ROOT / "samples"
HEADER = b'{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Events","attrs":["log"]}],"values":[{"name":"Match","value":"8"}]}\n'
BAG = HEADER + b"Time,Events\n0.5,\n1.0,armed\n1.5,\n"


def kinds_of(recording: badlog.Recording) -> list[str]:
    return [problem.kind.value for problem in recording.problems]


def test_a_path_bytes_and_an_open_file_give_the_same(tmp_path: Path) -> None:
    path = tmp_path / "log"
    path.write_bytes(BAG)
    for recording in (badlog.read(path), badlog.read(str(path)), badlog.read(BAG), badlog.read(io.BytesIO(BAG))):
        assert recording.row_count == 3
        assert list(recording["Time"].samples) == [0.5, 1.0, 1.5]
        assert recording.problems == []


def test_a_recording_answers_by_name() -> None:
    recording = badlog.read(BAG)
    assert list(recording) == ["Time", "Events"]
    assert "Time" in recording and "Speed" not in recording
    assert recording.units == {"Time": "s"}
    assert recording.value("Match") == "8"
    assert recording.value("Event", "none") == "none"
    assert recording.x_axis is recording["Time"]
    assert recording.events == [badlog.Event(1.0, "Events", "armed")]
    with pytest.raises(KeyError, match="no topic “Speed”; it has 2"):
        recording["Speed"]


def test_a_missing_file_is_the_systems_error(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        badlog.read(tmp_path / "none.bag")


def test_a_gzip_file_is_inflated_whatever_its_name(tmp_path: Path) -> None:
    path = tmp_path / "log.bag"
    path.write_bytes(gzip.compress(BAG))
    assert badlog.read(path).row_count == 3
    assert kinds_of(badlog.read(path)) == []


def test_a_gzip_stream_that_was_flushed_and_never_closed_is_whole() -> None:
    packer = zlib.compressobj(wbits=31)
    flushed = packer.compress(BAG) + packer.flush(zlib.Z_SYNC_FLUSH)
    assert kinds_of(badlog.read(flushed)) == []


def test_all_gzip_members_are_read_and_remains_are_ignored() -> None:
    both = gzip.compress(BAG[:100]) + gzip.compress(BAG[100:]) + bytes(40)
    recording = badlog.read(both)
    assert recording.row_count == 3
    assert kinds_of(recording) == []


@pytest.mark.parametrize("cut", [12, 40, 90])
def test_everything_that_inflates_of_a_cut_gzip_file_is_read(cut: int) -> None:
    rows = b"".join(b"%d.5,\n" % row for row in range(500))
    whole = gzip.compress(HEADER + b"Time,Events\n" + rows)
    recording = badlog.read(whole[:-cut])
    assert kinds_of(recording)[0] == "GZIP_CUT"
    assert 0 < recording.row_count < 500
    assert recording.is_salvaged


def test_a_gzip_file_damaged_in_the_middle_is_read_up_to_the_damage() -> None:
    rows = b"".join(b"%d.5,%d\n" % (row, row * row % 9973) for row in range(3000))
    damaged = bytearray(gzip.compress(HEADER + b"Time,Events\n" + rows))
    damaged[len(damaged) // 2 : len(damaged) // 2 + 40] = b"\xff" * 40
    recording = badlog.read(damaged)
    assert "GZIP_CUT" in kinds_of(recording)
    assert recording.row_count > 1000


def test_no_more_rows_are_read_than_the_maximum() -> None:
    recording = badlog.read(BAG, max_rows=2)
    assert recording.row_count == 2
    assert kinds_of(recording) == ["TOO_MANY_ROWS"]


@pytest.mark.parametrize("data", [b"\x7fELF\x02\x01\x01" + bytes(range(14, 31)) * 9, b"\x89PNG\r\n\x1a\n" + bytes(range(256))])
def test_the_problem_of_a_foreign_file_names_the_readable_formats(data: bytes) -> None:
    recording = badlog.read(data)
    assert not recording.is_readable
    assert recording.topics == []
    (problem,) = recording.problems
    assert all(name in problem.message for name in ("bag", "CSV", "WPILOG", ".dslog", ".dsevents"))


@pytest.mark.parametrize("name", ["a.wpilog", "a.dslog", "a.DSEVENTS", "a.wpilog.gz"])
def test_the_problem_of_a_binary_log_without_its_beginning_says_so(name: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_bytes(bytes(100) + bytes(range(256)))
    recording = badlog.read(path)
    assert not recording.is_readable
    assert "its beginning is lost" in recording.problems[0].message and "CSV" in recording.problems[0].message


@pytest.mark.parametrize("char, name", [(";", "semicolons"), ("\t", "tabs")])
def test_columns_separated_otherwise_are_refused_even_with_decimal_commas(char: str, name: str) -> None:
    for point in ".,":
        rows = (f"0{point}0{row}{char}1{row}{point}5{char}{row}\n" for row in range(10))
        recording = badlog.read(f"Zeit{char}Spannung{char}Strom\n{''.join(rows)}".encode())
        assert not recording.topics
        assert recording.problems[0].message.startswith(f"The columns are separated by {name};")


def test_the_content_decides_never_the_name(tmp_path: Path) -> None:
    path = tmp_path / "really a bag.wpilog"
    path.write_bytes(BAG)
    assert badlog.read(path).format is badlog.RecordingFormat.BAG


def test_a_folder_is_read_in_order_and_only_its_logs(tmp_path: Path) -> None:
    (tmp_path / "b").mkdir()
    (tmp_path / ".git").mkdir()
    for name in ("b/2.bag.gz", "a.bag", ".git/x.bag", "notes.txt"):
        (tmp_path / name).write_bytes(gzip.compress(BAG) if name.endswith(".gz") else BAG)
    (tmp_path / "prose.csv").write_text("only\nwords\nhere\n")
    found = [Path(str(recording.path)).relative_to(tmp_path).as_posix() for recording in badlog.read_folder(tmp_path)]
    assert found == ["a.bag", "b/2.bag.gz"]
    with pytest.raises(NotADirectoryError, match="is not a folder"):
        badlog.read_folder(tmp_path / "a.bag")


def test_the_samples_of_the_project_open() -> None:
    recordings = {Path(str(recording.path)).name: recording for recording in badlog.read_folder(SAMPLES)}
    assert recordings["qualification-42.bag"].row_count == 7794
    assert recordings["practice.bag"].is_salvaged
    assert len(recordings["qualification-57.bag.gz"].events) > 0


@pytest.mark.skipif(not reading._has_arrow(), reason="pyarrow or numpy is not installed")
def test_arrow_and_python_read_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("badlog._rows._MIN_ARROW_BYTES", 200)
    random_source = random.Random(1)
    cells = [b"1.25", b"-0", b"", b"null", b"NULL", b"nan", b"-nan", b"inf", b"1e400", b"true", b"False", b" 7 ", b"text", b'"1,5"', b'"a, ""b"""']
    cells += [b"\xe9", b"+5", b"5.", b".5", b"1_0", b"0x10", b"\t", b"nan(1)", b'""', b"1e-400", b"#N/A", b"n/a", b"1d", b"\xc3\xa9"]
    for _ in range(150):
        few = random_source.sample(cells, random_source.choice([1, 2, 5]))
        rows = []
        for i in range(random_source.choice([3, 60, 400])):
            row = [b"%d.5" % i] + [random_source.choice(few) if random_source.random() < 0.2 else b"%d" % i for _ in range(3)]
            if random_source.random() < 0.005:
                row = row[: random_source.randrange(6)]
            rows.append(b",".join(row) + random_source.choice([b"\n", b"\r\n"]))
        data = b"A,B,C,D\n" + b"".join(rows)
        by_arrow = _bag_parser.parse(data, 10**6, True)
        by_python = _bag_parser.parse(data, 10**6, False)
        assert sorted(map(str, by_arrow.problems)) == sorted(map(str, by_python.problems))
        for one, other in zip(by_arrow.topics, by_python.topics):
            assert one == other
            assert list(map(repr, one.samples.tolist())) == list(map(repr, other.samples.tolist()))
            assert one.texts == other.texts
            assert one._written_nans == other._written_nans


def test_no_damage_raises() -> None:
    random_source = random.Random(2)
    seeds = [bag.read_bytes() for bag in sorted((ROOT / "core" / "conformance").glob("*.bag"))]
    tokens = [b'"', b"\n", b"\r", b",", b"\0\0", b"\xff\xfe", b"{", b"nan", b"1e400", b"\x1f\x8b\x08", b"1,5", b"\xe9"]
    for _ in range(1500):
        data = bytearray(random_source.choice(seeds))
        for _ in range(random_source.choice([1, 3, 10])):
            at = random_source.randrange(len(data) + 1)
            if random_source.random() < 0.6:
                data[at:at] = random_source.choice(tokens)
            else:
                del data[at : at + random_source.choice([1, 5, 60])]
        recording = badlog.read(data)
        assert all(len(topic) == recording.row_count for topic in recording.topics)
        assert all(isinstance(problem.kind, ProblemKind) for problem in recording.problems + recording.attribute_problems)


def test_the_kinds_of_problems_and_their_severities_equal_the_guide() -> None:
    guides = [(ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8") for name in ("bag-format", "wpilog", "driver-station")]
    told = {kind for guide in guides for kind in re.findall(r"`([A-Z0-9_]+)` (error|warning|note)", guide)}
    assert told == {(kind.value, kind.severity.name.lower()) for kind in ProblemKind}


def test_the_version_equals_the_projects() -> None:
    properties = (ROOT / "gradle.properties").read_text(encoding="utf-8")
    assert f"version={badlog.__version__}\n" in properties


def test_a_cell_that_is_not_a_number_is_nan_in_the_samples() -> None:
    assert math.isnan(badlog.read(b"a,b\n1,\n2,3\n")["b"].samples[0])

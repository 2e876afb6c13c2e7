"""Recordings as tables of Arrow, pandas and Polars: nothing is lost on the way, and units go with them."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

import badlog

numpy = pytest.importorskip("numpy")
pyarrow = pytest.importorskip("pyarrow")

BAG = (
    '{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Voltage","unit":"V"},{"name":"Enabled"},'
    '{"name":"State"},{"name":"Events","attrs":["log"]}],"values":[{"name":"Match Number","value":"8"}]}\n'
    "Time,Voltage,Enabled,State,Events\n"
    "0.5,12.5,true,idle,\n"
    "1.0,,false,idle,armed\n"
    '1.5,NaN,,7,"over, done"\n'
    "2.0,11,true,moving,\n"
).encode()
SAMPLES = Path(__file__).parents[3] / "samples"


def test_a_table_of_arrow_has_types_gaps_units_and_values() -> None:
    table = badlog.read(BAG).to_arrow()
    assert table.column_names == ["Time", "Voltage", "Enabled", "State", "Events"]
    voltage = table.column("Voltage").to_pylist()
    assert voltage[:2] == [12.5, None] and math.isnan(voltage[2]) and voltage[3] == 11.0
    assert table.column("Enabled").to_pylist() == [True, False, None, True]
    assert table.column("State").to_pylist() == ["idle", "idle", "7", "moving"]
    assert table.column("Events").to_pylist() == [None, "armed", "over, done", None]
    assert table.field("Voltage").metadata == {b"unit": b"V", b"attributes": b"[]", b"kind": b"numeric"}
    assert json.loads(table.field("Time").metadata[b"attributes"]) == ["xaxis"]
    assert json.loads(table.schema.metadata[b"values"]) == [["Match Number", "8"]]


def test_units_survive_in_a_parquet_file(tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    parquet.write_table(badlog.read(BAG).to_arrow(), tmp_path / "log.parquet")
    assert parquet.read_table(tmp_path / "log.parquet").field("Voltage").metadata[b"unit"] == b"V"


def test_a_data_frame_of_pandas_has_types_an_index_and_units() -> None:
    pandas = pytest.importorskip("pandas")
    frame = badlog.read(BAG).to_pandas(index="Time")
    assert list(frame.index) == [0.5, 1.0, 1.5, 2.0] and frame.index.name == "Time"
    assert list(frame.columns) == ["Voltage", "Enabled", "State", "Events"]
    assert frame["Voltage"].mean() == 11.75
    assert frame["Enabled"].dtype == "boolean" and bool(frame["Enabled"].iloc[1]) is False and frame["Enabled"].iloc[2] is pandas.NA
    assert (frame["State"] == "idle").sum() == 2
    assert frame["Events"].dropna().tolist() == ["armed", "over, done"]
    assert frame.attrs["units"] == {"Time": "s", "Voltage": "V"}
    assert frame.attrs["values"] == {"Match Number": "8"}


def test_a_data_frame_of_polars_has_types_and_nulls() -> None:
    polars = pytest.importorskip("polars")
    frame = badlog.read(BAG).to_polars()
    assert frame["Voltage"].null_count() == 1
    assert frame["Enabled"].dtype == polars.Boolean
    assert frame["Events"].drop_nulls().to_list() == ["armed", "over, done"]


@pytest.mark.parametrize("uses_arrow", [False, True])
def test_all_tables_of_a_match_agree(uses_arrow: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pandas")
    monkeypatch.setattr("badlog.reading._has_arrow", lambda: uses_arrow)
    for name in ("qualification-42.bag", "practice.bag", "elevator-bench.csv"):
        recording = badlog.read(SAMPLES / name)
        table = recording.to_arrow()
        frame = recording.to_pandas()
        assert table.num_rows == len(frame) == recording.row_count
        for topic in recording.topics:
            column = table.column(topic.name)
            assert column.null_count == int(frame[topic.name].isna().sum()) - len(topic._written_nans)
            if topic.kind in (badlog.TopicKind.STATE, badlog.TopicKind.EVENT):
                rows = [row for row, text in enumerate(column.to_pylist()) if text is not None]
                assert len(rows) == len(topic) - topic.counts.empty
                assert [column[row].as_py() for row, _ in topic.texts] == [text for _, text in topic.texts]


def test_an_empty_log_and_odd_texts_have_tables() -> None:
    pytest.importorskip("pandas")
    for data in (b"", b"a,b\n", '{"topics":[{"name":"\\ud800"}]}\nx\nword\nété\n'.encode(), b"a,b\n1,\xe9\n2,\xc3\xa9\n3,\xe9\n"):
        recording = badlog.read(data)
        assert recording.to_arrow().num_rows == recording.row_count or not recording.topics
        assert len(recording.to_pandas()) == recording.row_count

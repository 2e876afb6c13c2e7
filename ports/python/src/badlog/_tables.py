"""Recordings as tables of Arrow, pandas and Polars. Each library is imported only when it is needed."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from badlog.recording import Recording, Topic, TopicKind

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow


def column_of(topic: Topic) -> pyarrow.Array | pyarrow.ChunkedArray:
    """The cells of one topic, with null for a gap."""
    import pyarrow

    if topic.kind in (TopicKind.STATE, TopicKind.EVENT):
        return _texts_of(topic)
    numbers = topic._samples.to_arrow(topic._written_nans)
    return numbers.cast(pyarrow.bool_()) if topic.kind is TopicKind.BOOLEAN else numbers


def _texts_of(topic: Topic) -> pyarrow.Array:
    """Texts as a dictionary; the numbers among them as texts, too, so that nothing is lost."""
    import numpy
    import pyarrow

    # Different bytes may decode to the same text.
    places: dict[str, int] = {}
    place_of = numpy.array([places.setdefault(_encodable(text), len(places)) for text in topic._dictionary], dtype=numpy.int32)
    ids = numpy.full(len(topic), -1, dtype=numpy.int32)
    ids[numpy.asarray(topic._text_rows, dtype=numpy.int64)] = place_of[numpy.asarray(topic._text_ids, dtype=numpy.int64)]
    has_number = ~numpy.isnan(topic.samples)
    has_number[topic._written_nans] = True
    for row in numpy.flatnonzero(has_number).tolist():
        number = float(topic.samples[row])
        text = str(int(number)) if number.is_integer() and abs(number) < 1e15 else repr(number)
        ids[row] = places.setdefault(text, len(places))
    return pyarrow.DictionaryArray.from_arrays(pyarrow.array(ids, mask=ids < 0), pyarrow.array(list(places), pyarrow.string()))


def table_of(recording: Recording) -> pyarrow.Table:
    """A column for each topic. Units, attributes and kinds are metadata of the fields; values and problems are metadata of the table."""
    import pyarrow

    _require_rows(recording)

    fields = []
    columns: list[Any] = []
    for topic in recording.topics:
        column = column_of(topic)
        metadata = {"unit": topic.unit, "attributes": json.dumps(topic.attributes), "kind": topic.kind.value}
        fields.append(pyarrow.field(_encodable(topic.name), column.type, metadata={key: _encodable(text) for key, text in metadata.items()}))
        columns.append(column)
    values = json.dumps([[value.name, value.text] for value in recording.values])
    problems = json.dumps([str(problem) for problem in recording.problems])
    return pyarrow.table(columns, schema=pyarrow.schema(fields, metadata={"values": values, "problems": problems}))


def pandas_of(recording: Recording, index: str | None) -> pandas.DataFrame:
    """A data frame with `units`, `attributes`, `values` and `problems` in its `attrs`."""
    import pandas

    _require_rows(recording)
    columns: dict[str, Any] = {}
    for topic in recording.topics:
        columns[_encodable(topic.name)] = _series_of(topic)
    frame = pandas.DataFrame(columns, index=pandas.RangeIndex(recording.row_count), copy=False)
    if index is not None:
        frame.index = pandas.Index(recording[index].samples, name=_encodable(index))
        frame = frame.drop(columns=_encodable(index))
    frame.attrs = {
        "units": recording.units,
        "attributes": {topic.name: list(topic.attributes) for topic in recording.topics if topic.attributes},
        "values": {value.name: value.text for value in recording.values},
        "problems": [str(problem) for problem in recording.problems],
    }
    return frame


def _require_rows(recording: Recording) -> None:
    if recording.format.has_rows:
        return
    message = (
        "A table has rows, but in a WPILOG or a Driver Station log each topic has times of its own; "
        "make rows first, such as every 20 ms: recording.resampled(0.02)."
    )
    raise ValueError(message)


def _series_of(topic: Topic) -> Any:
    import numpy
    import pandas

    if topic.kind in (TopicKind.STATE, TopicKind.EVENT):
        texts = _texts_of(topic)
        categories = pandas.CategoricalDtype(texts.dictionary.to_pylist())
        return pandas.Categorical.from_codes(texts.indices.fill_null(-1).to_numpy(zero_copy_only=False), dtype=categories)
    if topic.kind is TopicKind.BOOLEAN:
        if topic.counts.gaps == 0:
            return topic.samples.astype(numpy.bool_)
        is_gap = numpy.isnan(topic.samples)
        return pandas.arrays.BooleanArray(numpy.where(is_gap, 0, topic.samples).astype(numpy.bool_), is_gap)
    return topic.samples


def polars_of(recording: Recording) -> polars.DataFrame:
    """A data frame of Polars."""
    import polars

    frame = polars.from_arrow(table_of(recording))
    assert isinstance(frame, polars.DataFrame)
    return frame


def _encodable(text: str) -> str:
    """The text without lone surrogates, which JSON can express and UTF-8 cannot."""
    return text.encode("utf-8", "surrogatepass").decode("utf-8", "replace") if not text.isascii() else text

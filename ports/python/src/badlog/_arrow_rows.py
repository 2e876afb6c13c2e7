"""Reads plain rows with pyarrow's CSV reader, which uses several threads.

Arrow only gets lines without NULs, lone carriage returns, and quotes that RFC 4180 does not allow. Its results are checked: only finite doubles are
used as they are; every other cell is read again by the rules of the format.
"""

from __future__ import annotations

import re
from typing import Any

from badlog import _cell
from badlog._cell import read_cell, read_decimal_comma
from badlog._column import Column

_COLUMN = re.compile(r"CSV column #([0-9]+)")
_BLOCK_BYTES = 1 << 20
_NO_NUMBERS = ["", "null", "NULL"]


class ArrowRows:
    """The columns of one file. Remembers which of them have had anything other than numbers."""

    def __init__(self, columns: list[Column]) -> None:
        import numpy
        import pyarrow
        from pyarrow import compute, csv

        self._numpy = numpy
        self._arrow = pyarrow
        self._compute = compute
        self._csv = csv
        self._columns = columns
        self._names = [str(i) for i in range(len(columns))]
        self._has_texts = [False] * len(columns)
        self._texts = pyarrow.dictionary(pyarrow.int32(), pyarrow.binary())

    def read(self, data: bytes, start: int, until: int, rows: int, row: int, line: int) -> bool:
        """Adds `rows` rows from number `row` on, which is on `line`. Returns False, and adds nothing, if one of them is not plain."""
        if row == 0:
            first = data[start : data.index(b"\n", start)].rstrip(b"\r").split(b",")
            for i, cell in enumerate(first[: len(self._columns)]):
                self._has_texts[i] = read_cell(cell)[0] not in (_cell.NUMBER, _cell.EMPTY)
        table = self._table(data, start, until)
        if table is None or table.num_rows != rows:
            return False
        odd = [] if rows == 0 else [i for i in range(len(self._columns)) if not self._has_texts[i] and not self._is_finite(table.column(i))]
        bytes_of_odd = self._bytes_of(data, start, until, odd)
        for i, column in enumerate(self._columns):
            if self._has_texts[i]:
                self._add_texts(column, table.column(i), row, line)
            else:
                self._add_numbers(column, table.column(i), bytes_of_odd.get(i), row, line)
        return True

    def _table(self, data: bytes, start: int, until: int) -> Any:
        while True:
            types = {name: self._texts if is_text else self._arrow.float64() for name, is_text in zip(self._names, self._has_texts)}
            try:
                return self._read_csv(data, start, until, types)
            except self._arrow.ArrowInvalid as failure:
                place = _COLUMN.search(str(failure))
                if place is None or self._has_texts[int(place.group(1))]:
                    return None
                self._has_texts[int(place.group(1))] = True

    def _read_csv(self, data: bytes, start: int, until: int, types: dict[str, Any]) -> Any:
        csv = self._csv
        source = self._arrow.BufferReader(self._arrow.py_buffer(memoryview(data)[start:until]))
        return csv.read_csv(
            source,
            read_options=csv.ReadOptions(column_names=self._names, block_size=_BLOCK_BYTES),
            parse_options=csv.ParseOptions(ignore_empty_lines=True),
            convert_options=csv.ConvertOptions(
                column_types=types, include_columns=list(types), null_values=_NO_NUMBERS, check_utf8=False, strings_can_be_null=False
            ),
        )

    def _is_finite(self, numbers: Any) -> bool:
        total = self._compute.sum(numbers).as_py()
        return total is None or total - total == 0.0

    def _bytes_of(self, data: bytes, start: int, until: int, odd: list[int]) -> dict[int, Any]:
        """The cells, as in the file, of columns in which Arrow found a number that is not finite."""
        if not odd:
            return {}
        table = self._read_csv(data, start, until, {self._names[i]: self._arrow.binary() for i in odd})
        return {i: table.column(self._names[i]) for i in odd}

    def _add_numbers(self, column: Column, numbers: Any, cells: Any, row: int, line: int) -> None:
        if cells is not None:
            whole = numbers.to_numpy(zero_copy_only=False).copy()
            # Arrow returns NaN for a null, too.
            odd = self._numpy.flatnonzero(~self._numpy.isfinite(whole))
            kinds = self._numpy.full(len(whole), _cell.NUMBER, dtype=self._numpy.uint8)
            for i, cell in zip(odd.tolist(), cells.take(self._arrow.array(odd)).to_pylist()):
                kinds[i], whole[i] = read_cell(cell)
                if kinds[i] == _cell.TEXT:
                    column.add_text(row + i, cell, line + i)
                else:
                    column.add_odd_number(row + i, int(kinds[i]), float(whole[i]), line + i)
            self._add_gaps(column, (kinds == _cell.EMPTY) | (kinds == _cell.TEXT), row)
            column.add_empty(int((kinds == _cell.EMPTY).sum()))
            column.samples.add_part(whole)
            return
        if numbers.null_count > 0:
            self._add_gaps(column, numbers.is_null().to_numpy(), row)
            column.add_empty(numbers.null_count)
        for chunk in numbers.chunks:
            column.samples.add_part(chunk)

    def _add_texts(self, column: Column, cells: Any, row: int, line: int) -> None:
        numpy = self._numpy
        whole = cells.unify_dictionaries().combine_chunks()
        if hasattr(whole, "chunks"):
            whole = whole.chunk(0)
        ids = whole.indices.to_numpy()
        different = whole.dictionary.to_pylist()
        read = [_read(cell, column) for cell in different]
        kinds = numpy.array([kind for kind, _ in read], dtype=numpy.uint8)[ids]
        column.samples.add_part(numpy.array([number for _, number in read])[ids])
        column.add_empty(int((kinds == _cell.EMPTY).sum()))
        column.add_truth_values(int((kinds == _cell.TRUTH_VALUE).sum()))
        for i in numpy.flatnonzero((kinds == _cell.NOT_FINITE) | (kinds == _cell.DECIMAL_COMMA)).tolist():
            column.add_odd_number(row + i, int(kinds[i]), read[ids[i]][1], line + i)
        self._add_gaps(column, (kinds == _cell.EMPTY) | (kinds == _cell.TEXT), row)
        places = numpy.flatnonzero(kinds == _cell.TEXT)
        if len(places) == 0:
            return
        place_of: dict[int, int] = {}
        of_texts = ids[places]
        _, firsts = numpy.unique(of_texts, return_index=True)
        for first in numpy.sort(firsts).tolist():
            id = int(of_texts[first])
            place_of[id] = column.id_of(different[id], line + int(places[first]))
        known = numpy.zeros(len(different), dtype=numpy.int64)
        known[list(place_of)] = list(place_of.values())
        column.text_ids.frombytes(known[of_texts].tobytes())
        column.text_rows.frombytes((places.astype(numpy.int64) + row).tobytes())
        column.mark_text(different[of_texts[0]], different[of_texts[-1]], line + int(places[0]))

    def _add_gaps(self, column: Column, is_gap: Any, row: int) -> None:
        numpy = self._numpy
        places = numpy.flatnonzero(is_gap)
        if len(places) > 0:
            runs = 1 + int((numpy.diff(places) > 1).sum())
            column.add_gaps(row + int(places[0]), row + int(places[-1]), runs)


def _read(cell: bytes, column: Column) -> tuple[int, float]:
    # Only a cell that had quotes can contain a comma.
    with_comma = read_decimal_comma(cell) if b"," in cell and column.reads_decimal_comma else None
    return read_cell(cell) if with_comma is None else (_cell.DECIMAL_COMMA, with_comma)

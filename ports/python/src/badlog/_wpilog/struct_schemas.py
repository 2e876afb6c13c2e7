"""The structs with schemas in the file."""

from __future__ import annotations

from badlog._wpilog.layout import SCHEMA_TYPES, ValueLayout
from badlog._wpilog.struct_packing import StructField, StructPacking
from badlog._wpilog.struct_schema import read_schema

_MAX_DEPTH = 32
_MAX_SCHEMAS = 10_000
# A struct with the maximum number of shown values needs no more text.
_MAX_CHARACTERS = 1 << 20


class StructSchemas:
    """The schemas, by the names of their structs."""

    def __init__(self) -> None:
        self._fields: dict[str, tuple[list[StructField], int]] = {}
        self._layouts: dict[str, tuple[ValueLayout, int] | None] = {}

    def add(self, name: str, schema: str, since: int) -> None:
        """Adds the schema of struct `name`, which is known from record number `since` on. Of two with the same name, the first counts, since records
        may already have been read with it."""
        if name in self._fields or len(self._fields) == _MAX_SCHEMAS or len(schema) > _MAX_CHARACTERS:
            return
        fields = read_schema(schema)
        if fields is not None:
            self._fields[name] = (fields, since)

    def layout_of(self, name: str) -> tuple[ValueLayout, int] | None:
        """The layout of struct `name`, and the number of the record from which on it is known. None if a schema is missing, invalid, or too large."""
        return self._layout_of(name, 0)

    def _layout_of(self, name: str, depth: int) -> tuple[ValueLayout, int] | None:
        if name in self._layouts:
            return self._layouts[name]
        declared = self._fields.get(name)
        if declared is None:
            return None
        # A struct that contains itself would never end.
        layout = self._laid_out(*declared, depth) if depth < _MAX_DEPTH else None
        if depth == 0 or layout is not None:
            self._layouts[name] = layout
        return layout

    def _laid_out(self, declared: list[StructField], since: int, depth: int) -> tuple[ValueLayout, int] | None:
        packing = StructPacking()
        for field in declared:
            type = SCHEMA_TYPES.get(field.type)
            if type is not None:
                is_fitting = packing.add_bits(field, type) if field.bits > 0 else packing.add(field, type)
            elif field.bits > 0 or field.names is not None:
                is_fitting = False
            else:
                nested = self._layout_of(field.type, depth + 1)
                is_fitting = nested is not None and packing.add_struct(field, nested[0])
                since = since if nested is None else max(since, nested[1])
            if not is_fitting:
                return None
        return packing.layout(), since

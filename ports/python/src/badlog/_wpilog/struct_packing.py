"""Assigns the fields of a struct to their places."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from badlog._wpilog.layout import BOOL, CHAR, Leaf, ValueLayout, ValueType

# Each is a topic and a graph.
_MAX_LEAVES = 1024
_MAX_WIDTH = 1 << 16


@dataclass(frozen=True)
class StructField:
    """One declaration of a struct's schema."""

    name: str
    type: str
    """The name of a `ValueType` or of another struct."""
    count: int | None = None
    """For an array, the number of elements; otherwise None."""
    bits: int = 0
    """For a bit-field, the number of bits; otherwise 0."""
    names: Mapping[int, bytes] | None = None
    """For an enumeration, the names of its numbers; otherwise None."""


class StructPacking:
    """Assigns offsets to the fields of a struct: one after another without padding.

    Consecutive bit-fields of the same width share their bytes, lowest bits first; a boolean one shares the bytes of any preceding bit-field. The
    methods that add return False for an impossible field, or if the struct becomes too large.
    """

    def __init__(self) -> None:
        self._leaves: list[Leaf] = []
        self._offset = 0
        self._open_width = 0
        self._used_bits = 0

    def layout(self) -> ValueLayout:
        """The layout of the added fields."""
        return ValueLayout(self._offset + self._open_width, tuple(self._leaves))

    def add(self, field: StructField, type: ValueType) -> bool:
        """Adds a value, a text or an array of values."""
        self._end_bits()
        if field.names is not None and not type.is_integer:
            return False
        if type is CHAR:
            return self._add_text(field)
        return self._add_each(field, ValueLayout(type.width, (Leaf("", 0, type, names=field.names),)))

    def add_struct(self, field: StructField, nested: ValueLayout) -> bool:
        """Adds a struct, or an array of structs."""
        self._end_bits()
        if len(nested.leaves) * (1 if field.count is None else field.count) + len(self._leaves) > _MAX_LEAVES:
            return False
        return self._add_each(field, nested)

    def add_bits(self, field: StructField, type: ValueType) -> bool:
        """Adds a bit-field."""
        is_bool = type is BOOL
        if not (type.is_integer or (is_bool and field.bits == 1)) or field.bits > type.width * 8:
            return False
        if field.count is not None or len(self._leaves) == _MAX_LEAVES:
            return False
        joins_any = is_bool and self._open_width > 0 and self._used_bits < self._open_width * 8
        if not joins_any and (self._open_width != type.width or self._used_bits + field.bits > self._open_width * 8):
            self._end_bits()
            self._open_width = type.width
        self._leaves.append(Leaf("/" + field.name, self._offset, type, bits=field.bits, shift=self._used_bits, names=field.names))
        self._used_bits += field.bits
        return self._offset <= _MAX_WIDTH

    def _add_text(self, field: StructField) -> bool:
        count = 1 if field.count is None else field.count
        if count > _MAX_WIDTH - self._offset or len(self._leaves) == _MAX_LEAVES:
            return False
        self._leaves.append(Leaf("/" + field.name, self._offset, CHAR, count))
        self._offset += count
        return True

    def _add_each(self, field: StructField, layout: ValueLayout) -> bool:
        count = 1 if field.count is None else field.count
        width = layout.width
        if width * count > _MAX_WIDTH - self._offset or (width > 0 and count > _MAX_LEAVES - len(self._leaves)):
            return False
        if width == 0:
            return True
        for i in range(count):
            prefix = f"/{field.name}" if field.count is None else f"/{field.name}[{i}]"
            self._leaves += [leaf.inside(prefix, self._offset) for leaf in layout.leaves]
            self._offset += width
        return True

    def _end_bits(self) -> None:
        self._offset += self._open_width
        self._open_width = 0
        self._used_bits = 0

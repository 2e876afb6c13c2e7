"""The encoding of single values, and of records of a fixed size."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from badlog._timed.column import NUMBERS, TRUTHS, Column
from badlog._timed.vectors import Places, Vectors


@dataclass(frozen=True)
class ValueType:
    """The encoding of a single value."""

    name: str
    """Its name in a struct's schema."""
    width: int
    """Its size in bytes; for a text, 1 per character."""
    code: str
    """Its name for `struct` and NumPy."""
    is_signed: bool = False
    """Whether a bit-field of it has a sign."""

    @property
    def is_integer(self) -> bool:
        """Whether it may be a bit-field or an enumeration."""
        return self.name.startswith(("int", "uint"))


BOOL = ValueType("bool", 1, "<B")
CHAR = ValueType("char", 1, "<B")
INT64 = ValueType("int64", 8, "<q", True)
UINT64 = ValueType("uint64", 8, "<Q")
FLOAT = ValueType("float", 4, "<f")
DOUBLE = ValueType("double", 8, "<d")
_INTEGERS = [
    ValueType("int8", 1, "<b", True),
    ValueType("int16", 2, "<h", True),
    ValueType("int32", 4, "<i", True),
    INT64,
    ValueType("uint8", 1, "<B"),
    ValueType("uint16", 2, "<H"),
    ValueType("uint32", 4, "<I"),
    UINT64,
]

SCHEMA_TYPES: Mapping[str, ValueType] = {
    **{type.name: type for type in [BOOL, CHAR, *_INTEGERS, FLOAT, DOUBLE]},
    "float32": FLOAT,
    "float64": DOUBLE,
}
"""The types of a struct's schema, by name."""


@dataclass(frozen=True)
class Leaf:
    """One value inside a record of a fixed layout."""

    path: str
    """The part of the topic's name after the entry's: empty, or `/` and the names of the fields."""
    offset: int
    """Where it begins, in bytes."""
    type: ValueType
    count: int = 1
    """For a text, the number of characters; otherwise 1."""
    bits: int = 0
    """For a bit-field, the number of bits; otherwise 0."""
    shift: int = 0
    """The index of its first bit."""
    names: Mapping[int, bytes] | None = None
    """For an enumeration, the names of its numbers; otherwise None."""

    def inside(self, prefix: str, offset: int) -> Leaf:
        """The same value inside something that begins at `offset` and is called `prefix`."""
        return replace(self, path=prefix + self.path, offset=offset + self.offset)

    def column(self, path: str, data: bytes, places: Places, vectors: Vectors) -> Column:
        """The values in the records that begin at `places`."""
        size = len(places)
        at = vectors.plus(places, self.offset)
        if self.names is not None or self.bits > 0:
            return self._of_integers(path, self._integers(at, vectors), size, vectors)
        if self.type is CHAR:
            # A text shorter than its field is padded with NULs.
            texts = [data[start : start + self.count].partition(b"\0")[0] for start in at]
            return Column.of_texts(path, size, range(size), texts, vectors)
        if self.type is BOOL:
            return Column(path, TRUTHS, size, vectors.truths(vectors.integers(at, 1)))
        if self.type.width == 8 and self.type is not DOUBLE:
            return self._of_integers(path, self._integers(at, vectors), size, vectors)
        return Column(path, NUMBERS, size, vectors.floats(self.type.code, at))

    def _of_integers(self, path: str, integers: Any, size: int, vectors: Vectors) -> Column:
        names = self.names
        if names is not None:
            texts = [names.get(number) or str(number).encode() for number in map(int, integers)]
            return Column.of_texts(path, size, range(size), texts, vectors)
        if self.type is BOOL:
            return Column(path, TRUTHS, size, vectors.truths(integers))
        numbers, rounded = vectors.doubles(integers)
        return Column(path, NUMBERS, size, numbers, rounded=rounded)

    def _integers(self, at: Places, vectors: Vectors) -> Any:
        # A boolean bit-field may be in the bytes of the integer before it.
        width = (self.shift + self.bits + 7) // 8 if self.bits > 0 else self.type.width
        integers = vectors.integers(at, width)
        bits = self.bits or width * 8
        if self.bits > 0:
            integers = vectors.shifted(integers, self.shift, self.bits)
        is_signed = self.type.is_signed or (self.names is not None and bits == 64)
        return vectors.signed(integers, bits) if is_signed else integers


@dataclass(frozen=True)
class ValueLayout:
    """The content of a record with a fixed size."""

    width: int
    """The size in bytes."""
    leaves: tuple[Leaf, ...]
    """Its values, nested ones in the place of their struct."""

    @staticmethod
    def of(type: str) -> ValueLayout | None:
        """The layout of an entry's type, if it is a simple one."""
        return _SIMPLE.get(type)


_SIMPLE = {
    name: ValueLayout(type.width, (Leaf("", 0, type),)) for name, type in [("boolean", BOOL), ("int64", INT64), ("float", FLOAT), ("double", DOUBLE)]
}

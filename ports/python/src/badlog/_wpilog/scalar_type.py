"""The types of single values in messages of Protocol Buffers."""

from __future__ import annotations

import struct
from dataclasses import dataclass

from badlog._wpilog.wire_format import FIXED_32, FIXED_64, SIZED, VARINT

_LIMIT = 1 << 53


@dataclass(frozen=True)
class ScalarType:
    """A type of single values."""

    name: str
    """Its name in a schema."""
    wire: int
    """How it is encoded."""

    @property
    def is_text(self) -> bool:
        """Whether its values are shown as texts."""
        return self.name in ("string", "enum")

    def number(self, bits: int) -> float:
        """The number, or 1 for true, that has these bits."""
        name = self.name
        if name == "double":
            number: float = struct.unpack("<d", bits.to_bytes(8, "little"))[0]
            return number
        if name == "float":
            number = struct.unpack("<f", (bits & 0xFFFFFFFF).to_bytes(4, "little"))[0]
            return number
        return float(bits != 0) if name == "bool" else float(self.integer(bits))

    def integer(self, bits: int) -> int:
        """The whole number that has these bits."""
        name = self.name
        if name.startswith("sint"):
            # Small numbers of either sign are encoded as small ones: 0, -1, 1, -2.
            bits = (bits >> 1) ^ (-(bits & 1) & ((1 << 64) - 1))
        width = 32 if name.endswith("32") or name == "enum" else 64
        bits &= (1 << width) - 1
        is_unsigned = name.startswith("uint") or name.startswith("fixed")
        return bits if is_unsigned or bits >> (width - 1) == 0 else bits - (1 << width)

    def is_rounded(self, bits: int) -> bool:
        """Whether a double cannot keep it exactly."""
        return self.name.endswith("64") and not -_LIMIT <= self.integer(bits) <= _LIMIT


_TYPES = {
    1: ScalarType("double", FIXED_64),
    2: ScalarType("float", FIXED_32),
    3: ScalarType("int64", VARINT),
    4: ScalarType("uint64", VARINT),
    5: ScalarType("int32", VARINT),
    6: ScalarType("fixed64", FIXED_64),
    7: ScalarType("fixed32", FIXED_32),
    8: ScalarType("bool", VARINT),
    9: ScalarType("string", SIZED),
    12: ScalarType("bytes", SIZED),
    13: ScalarType("uint32", VARINT),
    14: ScalarType("enum", VARINT),
    15: ScalarType("sfixed32", FIXED_32),
    16: ScalarType("sfixed64", FIXED_64),
    17: ScalarType("sint32", VARINT),
    18: ScalarType("sint64", VARINT),
}


def scalar_type(id: int) -> ScalarType | None:
    """The type with this number in descriptors, `FieldDescriptorProto.Type`; None for others, such as messages."""
    return _TYPES.get(id)

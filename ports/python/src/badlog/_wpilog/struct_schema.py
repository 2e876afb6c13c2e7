"""Reads the schema of a struct.

It has declarations such as `double x`, `int16 counts[4]`, `uint8 mode:3` and `enum {off=0, on=1} int8 state`, with semicolons between them.
"""

from __future__ import annotations

import re

from badlog._text import BLANKS, is_letter_or_digit
from badlog._wpilog.struct_packing import StructField

_MAX_INT64 = (1 << 63) - 1
_DIGITS = re.compile("[0-9]*")


def read_schema(schema: str) -> list[StructField] | None:
    """The declarations of `schema`, in order, or None if it is not a schema."""
    try:
        return _SchemaReader(schema).fields()
    except _Malformed:
        return None


class _Malformed(Exception):
    pass


class _SchemaReader:
    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    def fields(self) -> list[StructField]:
        fields: list[StructField] = []
        while True:
            while self._peek() == ";":
                self._at += 1
            if not self._peek():
                return fields
            fields.append(self._field())
            if self._peek():
                self._expect(";")

    def _field(self) -> StructField:
        type = "enum" if self._peek() == "{" else self._word()
        names: dict[int, bytes] | None = None
        if self._peek() == "{":
            if type != "enum":
                raise _Malformed
            names = self._enumeration()
            type = self._word()
        name = self._word()
        count: int | None = None
        bits = 0
        following = self._peek()
        if following == "[":
            self._at += 1
            count = _int32(self._number())
            if count < 0:
                raise _Malformed
            self._expect("]")
        elif following == ":":
            self._at += 1
            bits = _int32(self._number())
            if not 1 <= bits <= 64:
                raise _Malformed
        return StructField(name, type, count, bits, names)

    def _enumeration(self) -> dict[int, bytes]:
        names: dict[int, bytes] = {}
        self._expect("{")
        while self._peek() != "}":
            name = self._word()
            self._expect("=")
            names[self._number()] = name.encode("utf-8", "replace")
            if self._peek() == ",":
                self._at += 1
            elif self._peek() != "}":
                raise _Malformed
        self._at += 1
        return names

    def _word(self) -> str:
        self._peek()
        text = self._text
        start = self._at
        while self._at < len(text) and (is_letter_or_digit(text[self._at]) or text[self._at] == "_"):
            self._at += 1
        if self._at == start or text[start] in "0123456789":
            raise _Malformed
        return text[start : self._at]

    def _number(self) -> int:
        is_negative = self._peek() == "-"
        self._at += is_negative
        digits = _DIGITS.match(self._text, self._at)
        assert digits is not None
        self._at = digits.end()
        significant = digits.group().lstrip("0")
        if not digits.group() or len(significant) > 19 or int(significant or "0") > _MAX_INT64:
            raise _Malformed
        number = int(significant or "0")
        return -number if is_negative else number

    def _expect(self, char: str) -> None:
        if self._peek() != char:
            raise _Malformed
        self._at += 1

    def _peek(self) -> str:
        """The next character that is not a blank, without consuming it; nothing at the end, or at a NUL."""
        while self._at < len(self._text) and self._text[self._at] in BLANKS:
            self._at += 1
        return self._text[self._at].strip("\0") if self._at < len(self._text) else ""


def _int32(number: int) -> int:
    """The lowest 32 bits, signed, as Kotlin's `toInt`."""
    return ((number + (1 << 31)) & 0xFFFFFFFF) - (1 << 31)

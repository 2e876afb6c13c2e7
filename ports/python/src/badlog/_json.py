"""Reads and writes the line of JSON.

Python's own `json` accepts `NaN`, and loses the text of a value, which the format needs: a unit that is a number is read as its JSON. So this
module follows RFC 8259 with one exception, control characters in strings, and keeps each value's text.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from badlog._text import is_letter_or_digit

_MAX_DEPTH = 100  # far deeper than any header
_BLANKS = re.compile(r"[ \t\n\r]*")
_PLAIN = re.compile(r'[^"\\]*')
_NUMBER = re.compile(r"-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?")
_ESCAPES = {'"': '"', "\\": "\\", "/": "/", "b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t"}
_HEX = re.compile(r"[0-9a-fA-F]{4}")


@dataclass(frozen=True)
class JsonValue:
    """A value: its JSON exactly as in the text, and its content."""

    json: str
    text: str | None = None
    items: list[JsonValue] | None = None
    members: list[tuple[str, JsonValue]] | None = None


class _Malformed(Exception):
    pass


def read_object(text: str) -> list[tuple[str, JsonValue]] | None:
    """The members of the JSON object that `text` is, in order, or None if it is not exactly one."""
    try:
        reader = _Reader(text)
        value = reader.value(0)
        reader.skip_blanks()
        return value.members if reader.at == len(text) else None
    except _Malformed:
        return None


class _Reader:
    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def value(self, depth: int) -> JsonValue:
        if depth > _MAX_DEPTH:
            raise _Malformed
        self.skip_blanks()
        start = self.at
        char = self.peek()
        if char == "{":
            members = self.members(depth)
            return JsonValue(self.text[start : self.at], members=members)
        if char == "[":
            items = self.items(depth)
            return JsonValue(self.text[start : self.at], items=items)
        if char == '"':
            string = self.string()
            return JsonValue(self.text[start : self.at], text=string)
        return JsonValue(self.word())

    def members(self, depth: int) -> list[tuple[str, JsonValue]]:
        members: list[tuple[str, JsonValue]] = []
        if self.is_empty("}"):
            return members
        while True:
            self.skip_blanks()
            if self.peek() != '"':
                raise _Malformed
            key = self.string()
            self.skip_blanks()
            self.expect(":")
            members.append((key, self.value(depth + 1)))
            if self.ends("}"):
                return members

    def items(self, depth: int) -> list[JsonValue]:
        items: list[JsonValue] = []
        if self.is_empty("]"):
            return items
        while True:
            items.append(self.value(depth + 1))
            if self.ends("]"):
                return items

    def is_empty(self, end: str) -> bool:
        self.at += 1
        self.skip_blanks()
        if self.peek() != end:
            return False
        self.at += 1
        return True

    def ends(self, end: str) -> bool:
        self.skip_blanks()
        if self.peek() == end:
            self.at += 1
            return True
        self.expect(",")
        return False

    def string(self) -> str:
        self.at += 1
        parts = []
        while True:
            plain = _PLAIN.match(self.text, self.at)
            assert plain is not None
            parts.append(plain.group())
            self.at = plain.end()
            end = self.peek()
            self.at += 1
            if end == '"':
                return "".join(parts)
            parts.append(self.escaped())

    def escaped(self) -> str:
        char = self.peek()
        self.at += 1
        if char != "u":
            if char not in _ESCAPES:
                raise _Malformed
            return _ESCAPES[char]
        high = self.unit()
        # A pair of surrogates is one character; a lone one stays as it is.
        if 0xD800 <= high < 0xDC00 and self.text.startswith("\\u", self.at):
            before = self.at
            self.at += 2
            low = self.unit()
            if 0xDC00 <= low < 0xE000:
                return chr(0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00))
            self.at = before
        return chr(high)

    def unit(self) -> int:
        digits = _HEX.match(self.text, self.at)
        if digits is None:
            raise _Malformed
        self.at += 4
        return int(digits.group(), 16)

    def word(self) -> str:
        start = self.at
        while self.at < len(self.text) and (is_letter_or_digit(self.text[self.at]) or self.text[self.at] in "+-."):
            self.at += 1
        word = self.text[start : self.at]
        if word not in ("true", "false", "null") and not _NUMBER.fullmatch(word):
            raise _Malformed
        return word

    def skip_blanks(self) -> None:
        blanks = _BLANKS.match(self.text, self.at)
        assert blanks is not None
        self.at = blanks.end()

    def peek(self) -> str:
        if self.at >= len(self.text):
            raise _Malformed
        return self.text[self.at]

    def expect(self, char: str) -> None:
        if self.peek() != char:
            raise _Malformed
        self.at += 1

"""Decodes text, and classifies blanks and letters as the JVM does, so that all readers agree."""

from __future__ import annotations

import unicodedata

BLANKS = "\t\n\x0b\x0c\r\x1c\x1d\x1e\x1f \xa0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u2028\u2029\u202f\u205f\u3000"
"""The whitespace of Java and Kotlin; Python's own `strip` also removes U+0085."""

_HIGH_CONTROLS = (
    "\u20ac\u0081\u201a\u0192\u201e\u2026\u2020\u2021\u02c6\u2030\u0160\u2039\u0152\u008d\u017d\u008f"
    "\u0090\u2018\u2019\u201c\u201d\u2022\u2013\u2014\u02dc\u2122\u0161\u203a\u0153\u009d\u017e\u0178"
)
# The only place where Windows-1252 differs from Latin-1; its five unassigned bytes stay controls, where Python's codec fails.
_WINDOWS_1252 = {0x80 + i: char for i, char in enumerate(_HIGH_CONTROLS)}


def decode(data: bytes) -> tuple[str, bool]:
    """The text, read as UTF-8 or otherwise as Windows-1252, and whether it was not UTF-8."""
    try:
        return data.decode("utf-8"), False
    except UnicodeDecodeError:
        return data.decode("latin-1").translate(_WINDOWS_1252), True


def excerpt(data: bytes, most: int) -> str:
    """The first `most` bytes of a text, for a message; a shortened text ends in an ellipsis."""
    if len(data) <= most:
        return decode(data)[0]
    end = most
    while end > 0 and data[end] & 0xC0 == 0x80:
        end -= 1
    return decode(data[:end])[0] + "…"


def is_letter_or_digit(char: str) -> bool:
    """Whether it is a letter or a digit of any script. As on the JVM, a character of two UTF-16 units counts as neither."""
    if ord(char) > 0xFFFF:
        return False
    return unicodedata.category(char) in ("Lu", "Ll", "Lt", "Lm", "Lo", "Nd")

"""The kinds of cells, and how their bytes are read."""

from __future__ import annotations

import math
import re

EMPTY, NUMBER, NOT_FINITE, TRUTH_VALUE, TEXT, DECIMAL_COMMA = range(6)

Cell = tuple[int, float, bytes]
"""One of the kinds above, its number or NaN, and its bytes if it is a text."""

NO_CELL: Cell = (EMPTY, math.nan, b"")

_DECIMAL = re.compile(rb"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_WITH_COMMA = re.compile(rb"[+-]?(?:[0-9]+,[0-9]*|,[0-9]+)(?:[eE][+-]?[0-9]+)?")
_WORDS: dict[bytes, tuple[int, float]] = {
    b"null": (EMPTY, math.nan),
    b"true": (TRUTH_VALUE, 1.0),
    b"false": (TRUTH_VALUE, 0.0),
    b"nan": (NOT_FINITE, math.nan),
    **{sign + word: (NOT_FINITE, math.inf) for sign in (b"", b"+") for word in (b"inf", b"infinity")},
    **{b"-" + word: (NOT_FINITE, -math.inf) for word in (b"inf", b"infinity")},
}
_MAX_WORD_LENGTH = len(b"-infinity")


def read_cell(cell: bytes) -> tuple[int, float]:
    """The kind and the number of the bytes inside any quotes."""
    word = cell.strip(b" \t")
    if not word:
        return EMPTY, math.nan
    if _DECIMAL.fullmatch(word):
        number = float(word)
        return (NUMBER if math.isfinite(number) else NOT_FINITE), number
    if len(word) > _MAX_WORD_LENGTH:
        return TEXT, math.nan
    return _WORDS.get(word.lower(), (TEXT, math.nan))


def read_decimal_comma(cell: bytes) -> float | None:
    """The number in bytes with a decimal comma, such as `1,2345`; None if they are not one."""
    return float(cell.replace(b",", b".")) if _WITH_COMMA.fullmatch(cell) else None

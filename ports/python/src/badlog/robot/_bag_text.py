"""The bytes of a bag's lines, as `jvm-robot` writes them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from badlog._text import BLANKS

_NEEDS_QUOTES = re.compile('[,"\n\r]')
_SHORT = {'"': '\\"', "\\": "\\\\", "/": "\\/", "\b": "\\b", "\f": "\\f", "\n": "\\n", "\r": "\\r", "\t": "\\t"}
_ESCAPED = re.compile('["\\\\/\x00-\x1f\x7f-\x9f\u2000-\u20ff]')


def text_cell(text: str) -> bytes:
    """The cell of a text, in quotes where RFC 4180 asks for them. A NUL, which in a bag is a sign of damage, becomes U+FFFD."""
    if text and (text[0] in BLANKS or text[-1] in BLANKS or _NEEDS_QUOTES.search(text)):
        return b'"' + _encoded(text).replace(b'"', b'""') + b'"'
    return _encoded(text)


def row_of(cells: Sequence[bytes]) -> bytes:
    """A row. A single empty cell is written in quotes, because readers skip blank lines."""
    return (b",".join(cells) or (b'""' if len(cells) == 1 else b"")) + b"\n"


def title_of(name: str) -> str:
    """The name in the form that a line of titles can hold."""
    return _encoded(name.replace("\n", " ").replace("\r", " ")).decode()


def header_lines(topics: Iterable[tuple[str, str, Sequence[str]]], values: Iterable[tuple[str, str]]) -> bytes:
    """Line 1 and line 2. They have the names, units and attributes of all topics, and the names and texts of all values."""
    topics = [(title_of(name), unit, attributes) for name, unit, attributes in topics]
    described = ",".join(
        f'{{"unit":{_quoted(unit)},"name":{_quoted(name)},"attrs":[{",".join(map(_quoted, attributes))}]}}'
        for name, unit, attributes in topics
    )
    known = ",".join(f'{{"name":{_quoted(name)},"value":{_quoted(text)}}}' for name, text in values)
    line = f'{{"topics":[{described}],"values":[{known}]}}\n'
    return line.encode("utf-8", "replace") + row_of([text_cell(name) for name, _, _ in topics])


def _quoted(text: str) -> str:
    """A JSON string in the original's form, which escapes more than necessary."""
    return '"' + _ESCAPED.sub(lambda match: _SHORT.get(match.group()) or f"\\u{ord(match.group()):04X}", text) + '"'


def _encoded(text: str) -> bytes:
    text = text.replace("\0", "\ufffd")
    try:
        return text.encode("utf-8")
    except UnicodeEncodeError:
        # Halves of surrogate pairs: two that follow one another are one character.
        return text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace").encode("utf-8")

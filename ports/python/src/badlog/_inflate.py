"""The bytes of a file, inflated if they are compressed with gzip or xz."""

from __future__ import annotations

import lzma
from dataclasses import dataclass

from badlog import _gzip
from badlog.problem import Problem, ProblemKind

# A small compressed file may contain more bytes than the memory.
_MAX_BYTES = 1 << 33
_XZ = b"\xfd7zXZ\x00"
_PIECE = 1 << 20
# Twice what `xz -9` needs.
_MEMORY = 1 << 27


@dataclass(frozen=True)
class Inflated:
    """The content of a file."""

    data: bytes
    problem: Problem | None = None
    """The problem if a part is missing; None if it is whole."""


def inflated(data: bytes, most: int = _MAX_BYTES) -> Inflated:
    """The content of the file with the bytes `data`, up to about `most` bytes. It is `data` itself if that is not compressed."""
    if _gzip.is_gzip(data):
        whole, is_cut = _gzip.inflate(data, most)
    elif data.startswith(_XZ):
        whole, is_cut = _inflate_xz(data, most)
    else:
        return Inflated(data)
    if is_cut:
        message = f"The compressed file is cut off or damaged; the {len(whole)} bytes before that were read."
        return Inflated(whole, Problem(ProblemKind.GZIP_CUT, message))
    if len(whole) >= most:
        message = f"The compressed file holds more than {most >> 30} GiB; the rest was not read. Inflate it, and cut it into parts."
        return Inflated(whole, Problem(ProblemKind.TOO_MANY_ROWS, message))
    return Inflated(whole)


def _inflate_xz(data: bytes, most: int) -> tuple[bytes, bool]:
    """The content of the file, up to about `most` bytes, and whether something is missing."""
    parts: list[bytes] = []
    size = 0
    rest = data
    while rest.startswith(_XZ) and size < most:
        inflater = lzma.LZMADecompressor(lzma.FORMAT_XZ, memlimit=_MEMORY)
        left = rest
        try:
            while not inflater.eof and size < most and (left or not inflater.needs_input):
                parts.append(inflater.decompress(left, _PIECE))
                left = b""
                size += len(parts[-1])
        except lzma.LZMAError:
            return b"".join(parts), True
        if not inflater.eof:
            return b"".join(parts), size < most
        # Streams may follow one another, with zeros between them.
        rest = inflater.unused_data.lstrip(b"\0")
    return b"".join(parts), False

"""Inflates a gzip file, and keeps everything that can be inflated.

A robot's file may lack its trailer or be cut anywhere, may be several gzip members in a row, and may end in NULs or other remains. Checksums are not
verified: knowing that one is wrong would restore nothing.
"""

from __future__ import annotations

import zlib

# The end of the empty block with which a flush completes a byte of the stream.
_FLUSH_MARK = b"\x00\x00\xff\xff"
_PIECE = 1 << 16
_TRAILER = 8

_CHECK, _EXTRA, _NAME, _COMMENT = 2, 4, 8, 16


def is_gzip(data: bytes) -> bool:
    """Whether a file that begins like this is compressed with gzip, whatever its name."""
    return data.startswith(b"\x1f\x8b")


def inflate(data: bytes, most: int) -> tuple[bytes, bool]:
    """The content of the file, up to about `most` bytes, and whether something is missing.

    A stream that was flushed but never closed lacks nothing; the original badlog leaves such streams.
    """
    parts: list[bytes] = []
    size = 0
    at = 0
    saw_body = False
    while at < len(data) and size < most:
        body = _body_after(data, at)
        if body is None:
            # Other bytes may follow the last member, but not in a file with only a beginning.
            return b"".join(parts), not saw_body
        saw_body = True
        inflater = zlib.decompressobj(-zlib.MAX_WBITS)
        at = body
        while at < len(data) and not inflater.eof and size < most:
            piece = data[at : at + _PIECE]
            before = inflater.copy()
            try:
                parts.append(inflater.decompress(piece))
            except zlib.error:
                parts.append(_until_fault(before, piece))
                return b"".join(parts), True
            size += len(parts[-1])
            at += len(piece)
        if not inflater.eof:
            return b"".join(parts), size < most and (at == body or not data.endswith(_FLUSH_MARK))
        at += _TRAILER - len(inflater.unused_data)
    return b"".join(parts), not saw_body


def _until_fault(inflater: zlib._Decompress, piece: bytes) -> bytes:
    """The content of `piece` before the byte at which it cannot be inflated further."""
    inflated = bytearray()
    try:
        for byte in piece:
            left = bytes([byte])
            # Byte by byte, because a failing call loses everything that it has inflated.
            while True:
                inflated += inflater.decompress(left, 1)
                left = inflater.unconsumed_tail
                if not left:
                    break
    except zlib.error:
        pass
    return bytes(inflated)


def _body_after(data: bytes, start: int) -> int | None:
    """The start of a member's deflated bytes, after its header (RFC 1952) at `start`. None without a whole header."""
    if data[start : start + 3] != b"\x1f\x8b\x08" or len(data) < start + 10:
        return None
    flags = data[start + 3]
    at = start + 10
    if flags & _EXTRA:
        at += 2 + int.from_bytes(data[at : at + 2], "little")
    for flag in (_NAME, _COMMENT):
        if flags & flag:
            end = data.find(b"\0", at)
            if end < 0:
                return None
            at = end + 1
    if flags & _CHECK:
        at += 2
    return at if at <= len(data) else None

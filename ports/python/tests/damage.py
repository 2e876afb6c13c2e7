"""Damages files like bad disks, power cuts and mischief."""

from __future__ import annotations

import random


def damaged(data: bytes, source: random.Random) -> bytes:
    """`data` with one or several faults."""
    out = bytearray(data)
    for _ in range(source.choice([1, 1, 2, 5])):
        if len(out) < 20:
            break
        at = source.randrange(len(out))
        size = source.choice([1, 4, 50, 500, 4096])
        fault = source.randrange(8)
        if fault == 0:
            del out[at:]
        elif fault == 1:
            out[at : at + size] = bytes(min(size, len(out) - at))
        elif fault == 2:
            out[at : at + size] = source.randbytes(min(size, len(out) - at))
        elif fault == 3:
            del out[at : at + size]
        elif fault == 4:
            out[at:at] = source.randbytes(size)
        elif fault == 5:
            out[at] ^= 1 << source.randrange(8)
        elif fault == 6:
            # A size that no file has.
            out[at : at + 4] = b"\xff\xff\xff\x7f"
        else:
            out[at:at] = out[source.randrange(len(out)) :][:size]
    return bytes(out)

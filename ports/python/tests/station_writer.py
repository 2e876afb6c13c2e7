"""Writes logs of the Driver Station byte by byte as the format says, for tests; independent of the tested code."""

from __future__ import annotations

import math
import random
import struct
from collections.abc import Callable

START = 3_855_740_645
"""2026-03-07 15:04:05 UTC, in s since 1904; files begin half a second later."""

# The status of robot and Driver Station in a record: a mode is on if its bit is 0.
BOTH_DISABLED, BOTH_AUTO, BOTH_TELEOP, ONLY_DS_TELEOP, BROWNOUT_IN_TELEOP, NO_ROBOT = 0xF6, 0xED, 0xDB, 0xDF, 0x5B, 0xF7


class DslogWriter:
    """The bytes of a `.dslog` that grows record by record."""

    def __init__(self, version: int = 4, start: int = START) -> None:
        self._version = version
        self._out = bytearray(_header(version, start))

    @property
    def data(self) -> bytes:
        return bytes(self._out)

    def record(
        self, status: int = BOTH_DISABLED, volts: float = 12.5, trip: int = 12, loss: int = 0, cpu: int = 80, can: int = 60, power: bytes = b""
    ) -> DslogWriter:
        raw = 0xFFFF if math.isnan(volts) else int(volts * 256)
        self._out += struct.pack(">BbHBBBBH", trip, loss, raw, cpu, status, can, 0, 0)
        if self._version > 3:
            self._out += struct.pack(">i", len(power)) + power
        else:
            self._out += power or pdp(lambda channel: channel)
        return self


class DseventsWriter:
    """The bytes of a `.dsevents` that grows entry by entry."""

    def __init__(self, start: int = START, version: int = 4) -> None:
        self._start = start
        self._out = bytearray(_header(version, start))

    @property
    def data(self) -> bytes:
        return bytes(self._out)

    def entry(self, seconds: float, text: str | bytes) -> DseventsWriter:
        """Adds an entry that is `seconds` s after the header's time."""
        whole, fraction = divmod(seconds + 0.5, 1)
        content = text.encode() if isinstance(text, str) else text
        self._out += struct.pack(">qQi", self._start + int(whole), int(fraction * 2**64), len(content)) + content
        return self


def _header(version: int, start: int) -> bytes:
    return struct.pack(">iqQ", version, start, 1 << 63)


def pdp(raw: Callable[[int], int], voltage: int = 164, temperature: int = 88) -> bytes:
    """The block of a PDP, bit by bit; its channels have `raw` eighths of an ampere."""
    bits = [""] * 3
    for channel in range(16):
        bits[channel // 6] += f"{raw(channel):010b}"
    groups = [int(group.ljust(64, "0"), 2).to_bytes(8, "big") for group in bits]
    return b"\0" + (groups[0] + groups[1] + groups[2])[:21] + bytes([255, voltage, temperature])


def pdh(raw: Callable[[int], int]) -> bytes:
    """The block of a PDH; its channels have `raw` eighths of an ampere, or sixteenths from channel 20 on."""
    words = [0] * 7
    for channel in range(20):
        words[channel // 3] |= raw(channel) << (10 * (channel % 3))
    packed = b"".join(word.to_bytes(4, "little") for word in words)[:27]
    return b"\1" + packed + bytes(raw(channel) for channel in range(20, 24)) + b"\0"


def short_match(seed: int = 1, records: int = 200) -> DslogWriter:
    """A match: before the robot answers, disabled, autonomous and teleop, with brownouts and link losses. A power distribution appears and changes.
    """
    source = random.Random(seed)
    log = DslogWriter()
    for _ in range(15):
        log.record(NO_ROBOT, volts=math.nan, trip=source.choice([255, 255, 3]), loss=25, cpu=0, can=0)
    for i in range(records):
        status = source.choice([BOTH_TELEOP] * 20 + [BROWNOUT_IN_TELEOP, ONLY_DS_TELEOP]) if i > 80 else (BOTH_AUTO if i > 30 else BOTH_DISABLED)
        blocks = [b"", pdp(lambda channel: (channel * 37 + i) % 1024), pdh(lambda channel: (channel * 9 + i) % 256), b"unknown"]
        power = blocks[0 if i < 10 else 1 if i < 90 else 2 if i < 150 else source.choice([0, 2, 3])]
        log.record(status, 12 + i % 8 / 256, source.choice([8, 9, 255 if i % 50 == 9 else 10]), source.choice([0, -2, 3]), i % 200, 50, power)
    return log


def told_in_match() -> DseventsWriter:
    """The messages of that match."""
    return (
        DseventsWriter()
        .entry(0.1, "FMS Connected:   Qualification - 42:1, Field Time: 26/3/7 10:4:5\n FMS Event Name: MILLC ")
        .entry(0.4, "<TagVersion>1 <time> 05.250 <message> ready <TagVersion>1 <time> 05.249 <message>  <TagVersion>1 <time> 05.248 <message> \tfirst ")
        .entry(
            0.9,
            "Info Joystick 0: (Xbox)6 axes. Warning Rail Faults: 5V - 1. <TagVersion>1 <time> 05.900 <count> 1 <flags> 1 <Code> -200 "
            "<details> CTR: No response <location> Talon FX 63 <stack> \tat one\n\tat two\n",
        )
        .entry(1.1, "Info roboRIO: Disk Free 84 MB, Memory Free 58 MB. DS Laptop: CPU 89% Batt 100%. ")
        .entry(2.2, "<TagVersion>1 <time> 07.1 <count> 1 <flags> 0 <Code> 1 <details> Loop time of 0.02s overrun\n <location>  <stack> ")
        .entry(2.1, b"\xff caf\xc3\xa9 ")
    )

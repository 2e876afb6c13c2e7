"""Writes WPILOGs byte by byte as the format says, for tests; independent of the tested code."""

from __future__ import annotations

import random
import struct


class WpilogWriter:
    """The bytes of a log that grows record by record."""

    def __init__(self, extra_header: str = "") -> None:
        self._out = bytearray(b"WPILOG\x00\x01" + text(extra_header))

    @property
    def data(self) -> bytes:
        return bytes(self._out)

    def start(self, id: int, name: str, type: str, metadata: str = "", at: int = 0) -> WpilogWriter:
        return self.record(0, at, b"\0" + struct.pack("<I", id) + text(name) + text(type) + text(metadata))

    def finish(self, id: int, at: int = 0) -> WpilogWriter:
        return self.record(0, at, b"\1" + struct.pack("<I", id))

    def metadata(self, id: int, metadata: str, at: int = 0) -> WpilogWriter:
        return self.record(0, at, b"\2" + struct.pack("<I", id) + text(metadata))

    def record(self, id: int, micros: int, payload: bytes) -> WpilogWriter:
        """A record with numbers in as few bytes as possible."""
        parts = [_shortest(id), _shortest(len(payload)), _shortest(micros & (1 << 64) - 1)]
        self._out.append(len(parts[0]) - 1 | len(parts[1]) - 1 << 2 | len(parts[2]) - 1 << 4)
        self._out += b"".join(parts) + payload
        return self

    def double(self, id: int, micros: int, *values: float) -> WpilogWriter:
        return self.record(id, micros, struct.pack(f"<{len(values)}d", *values))

    def integer(self, id: int, micros: int, *values: int) -> WpilogWriter:
        return self.record(id, micros, struct.pack(f"<{len(values)}q", *values))

    def string(self, id: int, micros: int, value: str) -> WpilogWriter:
        return self.record(id, micros, value.encode())

    def raw(self, data: bytes) -> WpilogWriter:
        self._out += data
        return self


def _shortest(number: int) -> bytes:
    return number.to_bytes(max(1, (number.bit_length() + 7) // 8), "little")


def text(value: str) -> bytes:
    """A text with its length before it."""
    return struct.pack("<I", len(value.encode())) + value.encode()


def proto(number: int, value: int | float | bytes) -> bytes:
    """A field of a message of Protocol Buffers: a varint, a double, or bytes."""
    if isinstance(value, float):
        return varint(number << 3 | 1) + struct.pack("<d", value)
    if isinstance(value, int):
        return varint(number << 3) + varint(value & (1 << 64) - 1)
    return varint(number << 3 | 2) + varint(len(value)) + value


def varint(number: int) -> bytes:
    """A number in 7 bits a byte."""
    out = bytearray()
    while number > 0x7F:
        out.append(number & 0x7F | 0x80)
        number >>= 7
    out.append(number)
    return bytes(out)


def field(name: str, number: int, type: int, type_name: str = "", is_list: bool = False, is_optional: bool = False) -> bytes:
    """A `FieldDescriptorProto` as a field of its message's descriptor."""
    content = proto(1, name.encode()) + proto(3, number) + proto(4, 3 if is_list else 1) + proto(5, type)
    content += proto(6, type_name.encode()) if type_name else b""
    return proto(2, content + (proto(17, 1) if is_optional else b""))


DESCRIPTOR = (
    proto(2, b"test")
    + proto(4, proto(1, b"Point") + field("x", 1, 1) + field("y", 2, 1))
    + proto(5, proto(1, b"Mode") + proto(2, proto(1, b"OFF") + proto(2, 0)) + proto(2, proto(1, b"ON") + proto(2, 1)))
    + proto(
        4,
        proto(1, b"Target")
        + field("id", 1, 5)
        + field("place", 2, 11, ".test.Point")
        + field("corners", 3, 11, ".test.Point", is_list=True)
        + field("errors", 4, 1, is_list=True)
        + field("name", 5, 9)
        + field("mode", 6, 14, ".test.Mode")
        + field("isLatched", 7, 8, is_optional=True)
        + field("bits", 8, 4),
    )
)
"""A `FileDescriptorProto` with the messages `test.Target` and `test.Point`."""


def target(source: random.Random) -> bytes:
    """A message `test.Target`."""
    point = proto(1, source.random()) + proto(2, source.uniform(-9, 9))
    message = proto(1, source.randrange(5)) if source.random() < 0.8 else b""
    message += proto(2, point) if source.random() < 0.8 else b""
    message += b"".join(proto(3, point) for _ in range(source.randrange(3)))
    message += proto(4, struct.pack("<2d", 0.5, 1.5)) if source.random() < 0.5 else proto(4, 2.5)
    message += proto(5, source.choice([b"left", b"right", b"\xff"]))
    message += proto(6, source.randrange(3))
    message += proto(7, 1) if source.random() < 0.5 else b""
    return message + (proto(8, source.choice([7, (1 << 64) - 1])) if source.random() < 0.5 else b"")


SCHEMA = "double x;Rotation rotation;int16 counts[2];char name[6];uint8 low:3;uint8 high:5;bool isOn:1;enum {off=0, on=1} int8 state;uint64 large;float f"


def moving_robot(records: int, seed: int = 1) -> bytes:
    """A log with a bit of everything, as from a busy robot; `records` times of it."""
    source = random.Random(seed)
    log = WpilogWriter('{"from":"a test"}')
    types = {
        1: ("/Arm/Angle", "double", '{"unit":"deg"}'),
        2: ("NT:/SmartDashboard/Speed", "double", '{"properties":{"unit":"m/s"},"source":"NT"}'),
        3: ("DS:enabled", "boolean", ""),
        4: ("messages", "string", ""),
        5: ("Drive/Pose", "struct:Pose", ""),
        6: ("Drive/Modules", "struct:Rotation[]", ""),
        7: ("axes", "float[]", ""),
        8: ("names", "string[]", ""),
        9: ("photo", "raw", ""),
        10: ("systemTime", "int64", '{"source":"DataLogManager"}'),
        11: ("Vision/Target", "proto:test.Target", ""),
        12: ("count", "int64", '{"attrs":["hide","join:Counts"]}'),
        13: ("State", "string", ""),
        14: ("NT:/FMSInfo/EventName", "string", ""),
        15: ("NT:/FMSInfo/MatchNumber", "int64", ""),
        16: ("NT:/FMSInfo/MatchType", "int64", ""),
        17: ("NT:/FMSInfo/IsRedAlliance", "boolean", ""),
        18: ("flags", "boolean[]", ""),
        19: ("never", "double", ""),
        20: ("Lost/Pose", "struct:Missing", ""),
        300: ("wide id", "double", ""),
        21: ("/.schema/struct:Pose", "structschema", ""),
        22: ("/.schema/struct:Rotation", "structschema", ""),
        23: ("/.schema/proto:test.proto", "proto:FileDescriptorProto", ""),
        24: ("/Arm/Angle", "int64", ""),
    }
    for id, (name, type, metadata) in types.items():
        log.start(id, name, type, metadata)
    log.string(14, 10, "MILLC").integer(15, 20, 42).integer(16, 30, 2).record(17, 40, b"\1")
    for i in range(records):
        t = 1_000_000 + i * 20_000
        log.double(1, t, source.uniform(0, 90)).double(2, t + 13, source.choice([0.0, 1.5, float("nan"), float("inf")]))
        rotation = struct.pack("<d", source.random())
        pose = struct.pack("<d", i * 0.1) + rotation + struct.pack("<2h6s", -i % 100, i % 7, source.choice([b"idle", b"moving", b""]))
        pose += bytes([source.randrange(256), source.randrange(2), source.randrange(3)]) + struct.pack("<Qf", source.choice([3, 1 << 63]), 0.25)
        log.record(5, t + 20, pose)
        log.record(6, t + 30, rotation * source.choice([4, 4, 4, 3, 0, 5]))
        if i == 3:
            log.string(21, t + 40, SCHEMA).string(22, t + 40, "double value").record(23, t + 40, DESCRIPTOR)
        log.record(7, t + 50, struct.pack("<2f", 0.5, -0.5)[: source.choice([4, 8])])
        names = [source.choice(["a", "Ω", "", "long name"]) for _ in range(source.randrange(3))]
        log.record(8, t + 60, struct.pack("<I", len(names)) + b"".join(map(text, names)))
        log.record(11, t + 70, target(source)).integer(12, t + 80, source.choice([i, -(1 << 60)]))
        log.record(18, t + 90, bytes([1, 0, 1][: source.randrange(4)])).double(300, t + 100, float(i))
        if i % 10 == 0:
            log.record(3, t, bytes([i // 10 % 2])).string(13, t, source.choice(["off", "on", "stuck"]))
            log.string(4, t, f"loop {i} \"overrun\"").record(9, t, bytes(i % 40)).record(20, t, b"123").integer(24, t, i)
            log.integer(10, t, 1_700_000_000_000_000 + t)
        if i % 25 == 7:
            log.double(1, t - 40_000, 1.0).double(1, -5_000_000, 3.0).record(5, t, b"short")
    return log.finish(2, 90_000_000).metadata(3, '{"x":1}', 90_000_000).data

"""Writes the logs of `libraries/formats/conformance`. Their expectations are written by the Kotlin reader, see the README there.

    python ports/python/tests/write_log_corpus.py
"""

from __future__ import annotations

import random
import struct
from pathlib import Path

from station_writer import BOTH_AUTO, BOTH_TELEOP, NO_ROBOT, DseventsWriter, DslogWriter, short_match, told_in_match
from wpilog_writer import WpilogWriter, field, moving_robot, proto

FOLDER = Path(__file__).parents[3] / "libraries" / "formats" / "conformance"


def logs() -> dict[str, bytes]:
    """The bytes of each log, by its name."""
    robot = moving_robot(12)
    hole = robot[:2500] + bytes(400) + robot[2900:]
    match = short_match(1, 60).data
    old = DslogWriter(3)
    for i in range(20):
        old.record(BOTH_AUTO if i < 9 else BOTH_TELEOP, 12 - i / 16)
    noise = random.Random(4).randbytes(90)
    return {
        "robot.wpilog": robot,
        "robot-cut.wpilog": robot[:-30],
        "robot-hole.wpilog": hole,
        "robot-noise.wpilog": robot[:3000] + noise + robot[3000:],
        "robot-flipped.wpilog": bytes(byte ^ (1 if i % 700 == 650 else 0) for i, byte in enumerate(robot)),
        "robot-without-starts.wpilog": robot[:12] + robot[1200:],
        "header.wpilog": robot[:12],
        "half-a-header.wpilog": robot[:9],
        "version-2.wpilog": b"WPILOG\0\2" + bytes(4),
        "times.wpilog": _times(),
        "wide-array.wpilog": _wide_array(),
        "late-schema.wpilog": _late_schema(),
        "bit-fields.wpilog": _bit_fields(),
        "properties.wpilog": _properties(),
        "deep-message.wpilog": _deep_message(),
        "match.dslog": match,
        "match-and-events.dslog": match + told_in_match().data,
        "match-cut.dslog": match[:-5],
        "match-cut-and-events.dslog": match[:-5] + told_in_match().data,
        "match-hole.dslog": match[:800] + bytes(300) + match[1100:],
        "match-noise.dslog": match[:1500] + noise + match[1500:],
        "version-3.dslog": old.data,
        "version-3-hole.dslog": old.data[:200] + bytes(140) + old.data[340:],
        "version-5.dslog": b"\0\0\0\5" + match[4:],
        "never-connected.dslog": _never_connected(),
        "header.dslog": match[:20],
        "events.dsevents": told_in_match().data,
        "events-noise.dsevents": told_in_match().data[:60] + noise + told_in_match().data[60:],
        "events-of-version-3.dsevents": DseventsWriter(version=3).entry(1, "Info hello Warning there").data,
    }


def _times() -> bytes:
    """Early, wild, repeated and disordered times."""
    log = WpilogWriter().start(1, "a", "double").start(2, "b", "string")
    for i, micros in enumerate([50, 40, 40, -7, 60, 1 << 54, 70, -(1 << 60), 80, 200_000_000_000, 90]):
        log.double(1, micros, float(i)).string(2, micros, f"text {i}")
    return log.data


def _wide_array() -> bytes:
    """More elements than are shown."""
    log = WpilogWriter().start(1, "a", "boolean[]").start(2, "b", "string[]")
    texts = struct.pack("<I", 300) + bytes(1200)
    return log.record(1, 10, bytes(300)).record(2, 20, texts).record(1, 30, bytes(2)).record(2, 40, b"\1\0\0\0").data


def _late_schema() -> bytes:
    """Structs that wait for their schema, some in vain."""
    log = WpilogWriter().start(1, "few", "struct:P").start(2, "vain", "struct:Q[]")
    log.start(4, "/.schema/struct:P", "structschema").start(6, "/.schema/struct:Q", "structschema")
    for i in range(20):
        log.double(1, 10 + i, i / 2).double(2, 10 + i, 1.0)
    return log.string(4, 40, "double x").string(6, 40, "double x; Missing m").double(1, 50, 7.0).data


def _bit_fields() -> bytes:
    """Every type of a struct's schema."""
    schema = (
        "int8 a:4; int8 b:4; uint16 c:9; bool d:1; uint16 e:6; enum{one=1,minus=-1} int8 f:2; int64 g:60; bool h:1; uint32 i; int32 j;"
        "uint16 k[2]; int16 l; uint8 m; int8 n; uint64 o; int64 p; float32 q; float64 r; bool s; char t; enum {x = 5} uint16 u;"
    )
    size = 1 + 2 + 1 + 8 + 4 + 4 + 4 + 2 + 1 + 1 + 8 + 8 + 4 + 8 + 1 + 1 + 2
    log = WpilogWriter().start(1, "/.schema/struct:All", "structschema").start(2, "all", "struct:All").start(3, "many", "struct:All[]").string(1, 1, schema)
    source = random.Random(3)
    for i in range(8):
        log.record(2, 10 + i, source.randbytes(size)).record(3, 10 + i, source.randbytes(size * (i % 3)))
    return log.data


def _properties() -> bytes:
    """Units and attributes in all places where programs and badlog put them."""
    metadata = [
        '{"properties":{"unit":"deg","badlog":["differentiate","join:Arm/Position"]},"source":"NT"}',
        '{"properties":{"badlog":"hide"},"source":"NT"}',
        '{"properties":{"badlog":["hide"]},"attrs":["zero"],"unit":"V"}',
        '{"properties":{"badlog":["hide"]},"attrs":[]}',
        '{"properties":{"badlog":[1,null,"area"],"unit":7}}',
        '{"properties":{"badlog":"xaxis"}}',
        '{"properties":["badlog"]}',
        '{"properties":{"badlog":',
    ]
    log = WpilogWriter()
    for i, entry_metadata in enumerate(metadata, 1):
        log.start(i, f"NT:/Telemetry/{i}", "double", entry_metadata).double(i, 1000 * i, 1.0)
    log.start(20, "messages", "string", '{"properties":{"badlog":["area"]}}').string(20, 9000, "text")
    return log.metadata(1, '{"properties":{"unit":"rad"}}', 10_000).data


def _deep_message() -> bytes:
    """Messages nested as deep as they are shown, and one deeper."""
    log = WpilogWriter().start(9, "/.schema/proto:a.proto", "proto:FileDescriptorProto")
    for id, depth in ((1, 100), (2, 101)):
        levels = b"".join(proto(4, proto(1, f"M{id}x{i}".encode()) + field("a", 1, 11, f"a.M{id}x{i + 1}")) for i in range(1, depth))
        last = proto(4, proto(1, f"M{id}x{depth}".encode()) + field("x", 1, 5))
        payload = proto(1, 7)
        for _ in range(1, depth):
            payload = proto(1, payload)
        log.record(9, id, proto(1, f"{id}.proto".encode()) + proto(2, b"a") + levels + last)
        log.start(id, f"deep {depth}", f"proto:a.M{id}x1").record(id, 1000 * id, payload)
    return log.data


def _never_connected() -> bytes:
    log = DslogWriter()
    for i in range(30):
        log.record(NO_ROBOT, volts=37.375 if i < 5 else float("nan"), trip=255 if i % 3 else 4, loss=25, cpu=0, can=0)
    return log.data


if __name__ == "__main__":
    for name, data in logs().items():
        (FOLDER / name).write_bytes(data)

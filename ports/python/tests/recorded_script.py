"""The calls of jvm-robot's `RecordedScript.java`, which the original and the C++ port make, too."""

from __future__ import annotations

import math
from pathlib import Path

from badlog.robot import BadLog, DataInferMode

_NUMBERS = (
    *(0.0, -0.0, 1.0, -1.0, 12.3456789, 99999.5, 99999.4, 100000.0, 1e-4, 9.9999e-5, 2.00005, 1e10, -1e300, 5e-324, 0.02, 13.0),
    *(1.7976931348623157e308, math.nan, math.inf, -math.inf, 0.1 + 0.2, 1.0 / 3, 12.125),
)


def run(path: Path, loops: int) -> None:
    """Writes the log of so many loops."""
    loop = 0

    def number(offset: int) -> float:
        return _NUMBERS[(loop + offset) % len(_NUMBERS)]

    def block() -> float:
        total = 0.0
        # In a loop, because sum() is more exact from Python 3.12 on.
        for i in range(5):
            total += number(i)
        return total

    log = BadLog.init(path, flush=False)
    BadLog.create_value("Match Number", "8")
    BadLog.create_value("Drivetrain/P", "0.25")
    BadLog.create_value("Quote", 'the "best" robot, \\o/')
    BadLog.create_value("Empty", "")
    BadLog.create_value("Control", "\b\f\n\r\t\x01\x7f\x85\xa0\u2028\u20ac\u00fc")
    BadLog.create_topic("Drivetrain/Left/Output", "V", lambda: number(0), "join:Drivetrain/Output", "hide")
    BadLog.create_topic("Drivetrain/Right/Output", "V", lambda: number(11), "join:Drivetrain/Output", "hide")
    BadLog.create_topic("Count", BadLog.UNITLESS, lambda: loop)
    BadLog.create_topic("Block", "A", block, "delta", "area")
    BadLog.create_topic_str("State", "ul", lambda: "idle" if loop % 3 == 0 else "moving, fast", "log")
    BadLog.create_topic_str("Nothing", "ul", lambda: "")
    BadLog.create_topic_subscriber("Default", "°", DataInferMode.DEFAULT)
    BadLog.create_topic_subscriber("Last", "Ω", DataInferMode.LAST, "integrate")
    BadLog.create_topic_subscriber("Text", "ul", DataInferMode.LAST)
    log.finish_initialization()
    for loop in range(loops):
        if loop == 121:
            log.set_double_to_string_function(lambda value: f"<{_java_round(value)}>")
        if loop % 2 == 1:
            BadLog.publish("Default", number(7))
        if loop % 5 == 2:
            BadLog.publish("Last", -1)
            BadLog.publish("Last", number(3))
        if loop % 7 == 3:
            BadLog.publish("Text", f"at {loop}, ready")
        log.update_topics()
        if loop % 4 != 3:
            log.log()
    log.flush()
    log.close()


def _java_round(value: float) -> int:
    if math.isnan(value):
        return 0
    if math.isinf(value):
        return 2**63 - 1 if value > 0 else -(2**63)
    return max(-(2**63), min(2**63 - 1, math.floor(value + 0.5)))

"""The logger for robots that run RobotPy. See `docs/python.md`."""

from badlog.robot._faults import LogCounters
from badlog.robot._session import DuplicateNameError, InvalidModeError, LogState
from badlog.robot._topics import DataInferMode
from badlog.robot.bad_log import BadLog, Events, Publisher

__all__ = [
    "BadLog",
    "DataInferMode",
    "DuplicateNameError",
    "Events",
    "InvalidModeError",
    "LogCounters",
    "LogState",
    "Publisher",
]

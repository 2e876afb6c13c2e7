"""badlog in Python: reads the logs of robots for notebooks, and logs on robots that run RobotPy.

Reading: `badlog.read(path)` and `badlog.read_folder(path)` give a `Recording`. See `docs/python.md`.
"""

from badlog._version import VERSION as __version__
from badlog.problem import Problem, ProblemKind, Severity
from badlog.reading import MAX_ROWS, read, read_folder
from badlog.recording import CellCounts, Event, Recording, RecordingFormat, Topic, TopicKind, Value

__all__ = [
    "MAX_ROWS",
    "CellCounts",
    "Event",
    "Problem",
    "ProblemKind",
    "Recording",
    "RecordingFormat",
    "Severity",
    "Topic",
    "TopicKind",
    "Value",
    "__version__",
    "read",
    "read_folder",
]

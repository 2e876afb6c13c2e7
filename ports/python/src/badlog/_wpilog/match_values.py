"""Values for the whole run, from certain entries: the match, and the time of day."""

from __future__ import annotations

from badlog._timed.wall_time import wall_time_text
from badlog._wpilog.entry import SYSTEM_TIME, Entry
from badlog.recording import Value

# The folders in which WPILib, and a logger based on it, put the field's information.
_SOURCES = ("FMSInfo/", "DriverStation/")
_MATCH_TYPES = ("Practice", "Qualification", "Elimination")
_TYPES = {"EventName": "string", "MatchNumber": "int64", "MatchType": "int64", "IsRedAlliance": "boolean", "AllianceStation": "int64"}


class MatchValues:
    """Collects the values from the records of some entries, in the order of the file."""

    def __init__(self) -> None:
        self._event: str | None = None
        self._match_type: str | None = None
        self._match_number: int | None = None
        self._alliance: str | None = None
        self._wall_offset: float | None = None
        self._own: dict[str, str] = {}

    def concerns(self, entry: Entry) -> bool:
        """Whether to pass the records of `entry`."""
        if entry.name == SYSTEM_TIME and entry.type == "int64" or entry.is_value:
            return True
        return any(source in entry.name for source in _SOURCES) and _TYPES.get(_base_name(entry.name)) == entry.type

    def hear(self, entry: Entry, micros: float, payload: bytes) -> None:
        """Receives a record of `entry`, at `micros` µs."""
        if entry.name == SYSTEM_TIME and entry.type == "int64":
            # Later values are better: a robot's clock is set when the Driver Station connects.
            if len(payload) == 8:
                self._wall_offset = float(_integer(payload)) - micros
        elif entry.is_value:
            self._own[entry.name] = payload.decode("utf-8", "replace")
        elif payload:
            self._hear_field(_base_name(entry.name), payload)

    def _hear_field(self, name: str, payload: bytes) -> None:
        if name == "EventName":
            self._event = payload.decode("utf-8", "replace")
        elif name == "IsRedAlliance":
            self._alliance = "Red" if payload[0] != 0 else "Blue"
        elif len(payload) == 8:
            number = _integer(payload)
            if name == "MatchNumber" and number > 0:
                self._match_number = number
            elif name == "MatchType" and 1 <= number <= len(_MATCH_TYPES):
                self._match_type = _MATCH_TYPES[number - 1]
            elif name == "AllianceStation" and 1 <= number <= 6:
                self._alliance = "Red" if number <= 3 else "Blue"

    def values(self, first_micros: float) -> list[Value]:
        """The values found, for a recording that begins at `first_micros`."""
        is_on_field = self._event is not None or self._match_number is not None
        offset = self._wall_offset
        found = {
            "Event Name": self._event,
            "Match Type": self._match_type,
            "Match Number": None if self._match_number is None else str(self._match_number),
            # Off the field, every robot is red.
            "Alliance": self._alliance if is_on_field else None,
            "Start Time": None if offset is None else wall_time_text(offset + first_micros),
        }
        own = [Value(name, text) for name, text in self._own.items()]
        return own + [Value(name, text) for name, text in found.items() if text is not None and name not in self._own]


def _integer(payload: bytes) -> int:
    return int.from_bytes(payload, "little", signed=True)


def _base_name(name: str) -> str:
    """Its name inside its folder; a slash at the very end separates nothing."""
    return name[name.rfind("/", 0, max(len(name) - 1, 0)) + 1 :]

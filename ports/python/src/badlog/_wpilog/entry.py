"""The information of a file about one name and type, under all ids with which it was started."""

from __future__ import annotations

from badlog._json import JsonValue, read_object
from badlog._wpilog.layout import ValueLayout
from badlog.recording import UNITLESS

SYSTEM_TIME = "systemTime"
"""The entry in which WPILib's loggers write the time of day."""

MESSAGE_SCHEMA = "proto:FileDescriptorProto"
"""The type of the entries that describe messages of Protocol Buffers."""

VALUE_METADATA = '{"badlog":"value"}'
"""The metadata that marks an entry as a value, written by badlog itself."""

_SCHEMA_FOLDER = "/.schema/"
# The names under which WPILib's logger puts the program's output, and the Driver Station of 2027 its own.
_MESSAGES = ("messages", "console")
_CONSOLE = "DS:/Dscomm/Console/"
# The name under which dashboards, and Telemetry from 2027 on, give an object's type. The object is made of the topics beside it.
_TYPE = "/.type"
# The beginning of the former type of a topic, if a WPILOG has only parts or sizes of its samples.
_TYPE_ROLE = "type "


class Entry:
    """One entry, and its last metadata."""

    def __init__(self, name: str, type: str, is_value: bool, number: int) -> None:
        self.name = name
        """The name exactly as in the file."""
        self.type = type
        """The type exactly as in the file."""
        self.is_value = is_value
        """Whether it is not a topic, but a value written by badlog."""
        self.number = number
        """Its index among the entries of the file."""
        self.metadata = ""
        self.is_array = type.endswith("[]")
        layout = ValueLayout.of(type.removesuffix("[]"))
        self.width = 0 if layout is None else layout.width
        """The size of a value in bytes; 0 if it varies."""
        self.has_one_size = self.width > 0 and not self.is_array
        """Whether all its records have the same size."""

    def fits(self, size: int) -> bool:
        """Whether a record of it may have a payload of `size` bytes."""
        width = self.width
        return width == 0 or (size % width == 0 if self.is_array else size == width)

    @property
    def unit(self) -> str:
        """The unit in its metadata. Loggers put it beside their own remarks, or in a NetworkTables topic's properties. """
        members = read_object(self.metadata) or []
        unit = _last(members, "unit") or _property(members, "unit")
        return UNITLESS if unit is None or unit.text is None else unit.text

    @property
    def topic_type(self) -> str:
        """The type of its topics. It is the former one if badlog wrote only parts or sizes of their samples."""
        role = _last(read_object(self.metadata) or [], "badlog")
        text = "" if role is None or role.text is None else role.text
        return text.removeprefix(_TYPE_ROLE) if text.startswith(_TYPE_ROLE) else self.type

    @property
    def attributes(self) -> tuple[str, ...]:
        """The attributes: from its metadata, from properties that a program sets, or the fixed ones of WPILib's own entries."""
        members = read_object(self.metadata) or []
        own = _last(members, "attrs")
        items = None if own is None else own.items
        if items is None:
            value = _property(members, "badlog")
            items = None if value is None else [value] if value.items is None else value.items
        if items is not None:
            return tuple(item.text for item in items if item.text is not None)
        if self.name in _MESSAGES or _CONSOLE in self.name:
            return ("log",)
        return ("hide",) if self.name == SYSTEM_TIME or _SCHEMA_FOLDER in self.name or self.name.endswith(_TYPE) else ()


def _property(members: list[tuple[str, JsonValue]], key: str) -> JsonValue | None:
    """A property of a NetworkTables topic."""
    properties = _last(members, "properties")
    return None if properties is None else _last(properties.members or [], key)


def _last(members: list[tuple[str, JsonValue]], key: str) -> JsonValue | None:
    return next((value for name, value in reversed(members) if name == key), None)

"""The types of messages with descriptors in the file, see `google/protobuf/descriptor.proto`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from badlog._wpilog.message_layout import MessageLayout, MessageList, MessageMember, MessagePart, MessageValue
from badlog._wpilog.scalar_type import ScalarType, scalar_type
from badlog._wpilog.wire_format import SIZED, WireField, fields_in

_MAX_TYPES = 10_000
# The largest descriptor that is read.
_MAX_BYTES = 1 << 20
_MAX_DEPTH = 32
# Each value is a topic, and a graph.
_MAX_SIZE = 1024
# The depth of nested messages that other readers of Protocol Buffers accept, too.
_MAX_NESTED = 100

_FILE_PACKAGE, _FILE_MESSAGE, _FILE_ENUM = 2, 4, 5
_MESSAGE_FIELD, _MESSAGE_NESTED, _MESSAGE_ENUM = 2, 3, 4
_NAME = 1
_FIELD_NUMBER, _FIELD_LABEL, _FIELD_TYPE, _FIELD_TYPE_NAME, _FIELD_ONE_OF, _FIELD_OPTIONAL = 3, 4, 5, 6, 9, 17
_ENUM_VALUE, _VALUE_NUMBER = 2, 2
_REPEATED = 3


@dataclass(frozen=True)
class _MessageField:
    number: int
    name: str
    # None if it is a message.
    type: ScalarType | None
    # The full name of its message or enumeration.
    type_name: str
    is_list: bool
    # Whether it may be missing; otherwise a missing field has its default.
    has_presence: bool


class MessageTypes:
    """The types, by their full names, such as `wpi.proto.ProtobufPose2d`."""

    def __init__(self) -> None:
        self._messages: dict[str, tuple[list[_MessageField], int]] = {}
        self._enumerations: dict[str, dict[int, bytes]] = {}

    def add(self, descriptor: bytes, since: int) -> None:
        """Adds the `FileDescriptorProto`, which is known from record number `since` on.

        Of two types with the same name, the first counts, since records may already have been read with it.
        """
        if len(self._messages) >= _MAX_TYPES or len(descriptor) > _MAX_BYTES:
            return
        folder = ""
        for field in _sized(descriptor, 0, len(descriptor)):
            if field.number == _FILE_PACKAGE:
                folder = _text(descriptor, field) + "."
        for field in _sized(descriptor, 0, len(descriptor)):
            if field.number == _FILE_MESSAGE:
                self._add_message(descriptor, field, folder, 0, since)
            elif field.number == _FILE_ENUM:
                self._add_enumeration(descriptor, field, folder)

    def layout_of(self, name: str) -> tuple[MessageLayout, int] | None:
        """The layout of the message `name`, and the number of the record from which on it is known. None if a descriptor is missing, or there are
        too many values.
        """
        building = _Building(self._messages, self._enumerations)
        layout = building.layout(name, frozenset([name]))
        return None if layout is None else (layout, building.since)

    def _add_message(self, data: bytes, message: WireField, folder: str, depth: int, since: int) -> None:
        if depth == _MAX_DEPTH:
            return
        name = folder + _name_in(data, message)
        fields = []
        for field in _sized(data, message.start, message.end):
            if field.number == _MESSAGE_FIELD:
                fields.append(_field_in(data, field))
            elif field.number == _MESSAGE_NESTED:
                self._add_message(data, field, f"{name}.", depth + 1, since)
            elif field.number == _MESSAGE_ENUM:
                self._add_enumeration(data, field, f"{name}.")
        self._messages.setdefault(name, (fields, since))

    def _add_enumeration(self, data: bytes, enumeration: WireField, folder: str) -> None:
        names: dict[int, bytes] = {}
        for field in _sized(data, enumeration.start, enumeration.end):
            if field.number == _ENUM_VALUE:
                number = 0
                for part in _fields(data, field.start, field.end):
                    if part.number == _VALUE_NUMBER:
                        number = ((part.bits + (1 << 31)) & 0xFFFFFFFF) - (1 << 31)
                names.setdefault(number, _name_in(data, field).encode("utf-8", "replace"))
        self._enumerations.setdefault(folder + _name_in(data, enumeration), names)


def _fields(data: bytes, start: int, until: int) -> Iterator[WireField]:
    return (field for field in fields_in(data, start, until) if field is not None)


def _sized(data: bytes, start: int, until: int) -> Iterator[WireField]:
    return (field for field in _fields(data, start, until) if field.wire == SIZED)


def _text(data: bytes, field: WireField) -> str:
    return data[field.start : field.end].decode("utf-8", "replace") if field.wire == SIZED else ""


def _name_in(data: bytes, described: WireField) -> str:
    # In messages, enumerations and their values alike, 1 is the name.
    name = ""
    for field in _sized(data, described.start, described.end):
        if field.number == _NAME:
            name = _text(data, field)
    return name


def _field_in(data: bytes, described: WireField) -> _MessageField:
    number = type = 0
    name = type_name = ""
    is_list = has_presence = False
    for field in _fields(data, described.start, described.end):
        if field.number == _NAME:
            name = _text(data, field)
        elif field.number == _FIELD_NUMBER:
            number = ((field.bits + (1 << 31)) & 0xFFFFFFFF) - (1 << 31)
        elif field.number == _FIELD_LABEL:
            is_list = field.bits == _REPEATED
        elif field.number == _FIELD_TYPE:
            type = field.bits & 0xFFFFFFFF
        elif field.number == _FIELD_TYPE_NAME:
            type_name = _text(data, field).removeprefix(".")
        elif field.number in (_FIELD_ONE_OF, _FIELD_OPTIONAL):
            has_presence = True
    return _MessageField(number, name, scalar_type(type), type_name, is_list, has_presence)


class _Building:
    """Builds the layout of one message, and the layouts of its lists' elements."""

    def __init__(self, messages: Mapping[str, tuple[list[_MessageField], int]], enumerations: Mapping[str, Mapping[int, bytes]]) -> None:
        self._messages = messages
        self._enumerations = enumerations
        self._values: list[MessageValue] = []
        self._lists: list[MessageList] = []
        self._part_count = 0
        self._list_size = 0
        self.since = 0
        """The number of the record from which on all descriptors are known."""

    def layout(self, name: str, within: frozenset[str]) -> MessageLayout | None:
        """The layout of the message `name`, which is inside the messages `within`."""
        outermost = self._part(name, "", within)
        return None if outermost is None else MessageLayout(tuple(self._values), tuple(self._lists), self._part_count, outermost)

    def _part(self, name: str, path: str, within: frozenset[str]) -> MessagePart | None:
        index = self._part_count
        self._part_count += 1
        known = self._messages.get(name)
        if known is None or len(within) > _MAX_NESTED:
            return None
        fields, since = known
        self.since = max(self.since, since)
        members: dict[int, MessageMember] = {}
        for field in fields:
            # A message that contains itself would never end.
            if field.type is None and field.type_name in within:
                continue
            member = self._member(field, f"{path}/{field.name}", within, index)
            if member is None:
                return None
            members[field.number] = member
            if len(self._values) + self._part_count + self._list_size > _MAX_SIZE:
                return None
        return MessagePart(index, members)

    def _member(self, field: _MessageField, path: str, within: frozenset[str], part: int) -> MessageMember | None:
        if not field.is_list:
            if field.type is None:
                return self._part(field.type_name, path, within | {field.type_name})
            value = self._value(field, field.type, len(self._values), path, part)
            self._values.append(value)
            return value
        if field.type is None:
            building = _Building(self._messages, self._enumerations)
            element = building.layout(field.type_name, within | {field.type_name})
            self.since = max(self.since, building.since)
        else:
            only = self._value(field, field.type, 0, "", 0)
            element = MessageLayout((only,), (), 1, MessagePart(0, {field.number: only}))
        if element is None:
            return None
        one = MessageList(len(self._lists), path, element, field.type)
        self._lists.append(one)
        self._list_size += element.size
        return one

    def _value(self, field: _MessageField, type: ScalarType, index: int, path: str, part: int) -> MessageValue:
        names = self._enumerations.get(field.type_name, {}) if type.name == "enum" else {}
        return MessageValue(index, path, type, part, field.has_presence, names)

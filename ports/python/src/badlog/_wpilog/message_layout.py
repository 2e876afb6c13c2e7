"""How a message of Protocol Buffers is shown: its values, including those of nested messages at their places, and its lists."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Union

from badlog._wpilog.scalar_type import ScalarType
from badlog._wpilog.wire_format import SIZED, WireField, fields_in, packed_in


@dataclass(frozen=True)
class MessageValue:
    """A single value."""

    index: int
    """Its index in the layout, from 0."""
    path: str
    """The part of the topic's name after the message's."""
    type: ScalarType
    part: int
    """The index of the message that it is in."""
    has_presence: bool
    """Whether it may be missing although its message is present."""
    names: Mapping[int, bytes]
    """For an enumeration, the names of its numbers."""


@dataclass(frozen=True)
class MessagePart:
    """A message, or one nested in it."""

    index: int
    """Its index in the layout, from 0."""
    members: Mapping[int, MessageMember]
    """The members by their field numbers."""


@dataclass(frozen=True)
class MessageList:
    """Any number of values or messages."""

    index: int
    """Its index in the layout, from 0."""
    path: str
    element: MessageLayout
    type: ScalarType | None
    """The type of its elements; None if they are messages."""

    def elements(self, field: WireField, data: bytes) -> list[WireField] | None:
        """The elements in one field; several if it is packed, and None if it cannot belong to this list."""
        wire = SIZED if self.type is None else self.type.wire
        if field.wire == wire:
            return [field] if self.type is not None or self.element.fits(data, field.start, field.end) else None
        # Packed numbers follow each other without the field's number before each.
        return packed_in(data, wire, field.start, field.end) if field.wire == SIZED else None


MessageMember = Union[MessageValue, MessagePart, MessageList]


@dataclass(frozen=True)
class MessageLayout:
    """A layout of one type of messages."""

    values: tuple[MessageValue, ...]
    """The single values."""
    lists: tuple[MessageList, ...]
    """The repeated ones."""
    part_count: int
    """The number of messages, including the outermost and the nested ones."""
    outermost: MessagePart

    @property
    def size(self) -> int:
        """The number of values and messages, counting lists with one element."""
        return len(self.values) + self.part_count + sum(one.element.size for one in self.lists)

    def fits(self, data: bytes, start: int, until: int) -> bool:
        """Whether the bytes are such a message."""
        return _fits(self.outermost, data, start, until)


def _fits(part: MessagePart, data: bytes, start: int, until: int) -> bool:
    fields, is_whole = fields_in(data, start, until)
    for field in fields:
        member = part.members.get(field.number)
        if isinstance(member, MessageValue):
            is_fitting = field.wire == member.type.wire
        elif isinstance(member, MessagePart):
            is_fitting = field.wire == SIZED and _fits(member, data, field.start, field.end)
        else:
            is_fitting = member is None or member.elements(field, data) is not None
        if not is_fitting:
            return False
    return is_whole

"""The form in which a message of Protocol Buffers is shown. It has values, with nested messages' values at their places, and lists."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
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

    def fits(self, field: WireField, data: bytes) -> bool:
        """Whether the field may belong to this list."""
        if self.type is None:
            return field.wire == SIZED and self.element.fits(data, field.start, field.end)
        if field.wire == self.type.wire:
            return True
        return field.wire == SIZED and all(number is not None for number in packed_in(data, self.type.wire, field.start, field.end))

    def elements(self, field: WireField, data: bytes) -> Iterator[WireField]:
        """The elements in one field, which fits: one, or several if it is packed."""
        if self.type is None or field.wire == self.type.wire:
            yield field
            return
        # Packed numbers follow each other without the field's number before each.
        for number in packed_in(data, self.type.wire, field.start, field.end):
            if number is not None:
                yield number


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
    for field in fields_in(data, start, until):
        if field is None:
            return False
        member = part.members.get(field.number)
        if isinstance(member, MessageValue):
            is_fitting = field.wire == member.type.wire
        elif isinstance(member, MessagePart):
            is_fitting = field.wire == SIZED and _fits(member, data, field.start, field.end)
        else:
            is_fitting = member is None or member.fits(field, data)
        if not is_fitting:
            return False
    return True

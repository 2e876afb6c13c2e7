"""Reads messages of one layout."""

from __future__ import annotations

from badlog._wpilog.blocks import MAX_ELEMENTS
from badlog._wpilog.message_layout import MessageLayout, MessagePart, MessageValue
from badlog._wpilog.wire_format import WireField, fields_in


class ReadMessage:
    """The content of one message.

    If a field occurs twice, the last value counts, and messages that occur in pieces are merged, as the encoding requires; unknown fields are
    skipped.
    """

    def __init__(self, layout: MessageLayout) -> None:
        self._values: dict[int, WireField] = {}
        self._parts: set[int] = set()
        self.lists: list[list[WireField]] = [[] for _ in layout.lists]
        """The first elements of each of the layout's lists, as many as are shown."""
        self.counts = [0] * len(layout.lists)
        """The number of all elements of each list."""

    @staticmethod
    def of(layout: MessageLayout, data: bytes, start: int, until: int) -> ReadMessage:
        """The message in these bytes, which the layout fits."""
        message = ReadMessage(layout)
        message._read(layout.outermost, data, start, until)
        return message

    @staticmethod
    def of_single(layout: MessageLayout, element: WireField) -> ReadMessage:
        """An element of a list that is a single value, as if it were the whole message."""
        message = ReadMessage(layout)
        message._parts.add(0)
        message._values[0] = element
        return message

    def field_of(self, value: MessageValue) -> WireField | None:
        """The field with `value`, or one with its default; None if there is none."""
        field = self._values.get(value.index)
        if field is None and value.part in self._parts and not value.has_presence:
            return _DEFAULT
        return field

    def _read(self, part: MessagePart, data: bytes, start: int, until: int) -> None:
        self._parts.add(part.index)
        for field in fields_in(data, start, until):
            member = None if field is None else part.members.get(field.number)
            if field is None or member is None:
                continue
            if isinstance(member, MessageValue):
                self._values[member.index] = field
            elif isinstance(member, MessagePart):
                self._read(member, data, field.start, field.end)
            else:
                known = self.lists[member.index]
                for element in member.elements(field, data):
                    self.counts[member.index] += 1
                    if len(known) < MAX_ELEMENTS:
                        known.append(element)


_DEFAULT = WireField(0, 0, 0, 0, 0)

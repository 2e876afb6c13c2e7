"""The content of line 1 of a bag."""

from __future__ import annotations

from dataclasses import dataclass

from badlog._json import JsonValue, read_object
from badlog.recording import UNITLESS, Value

_Members = list[tuple[str, JsonValue]]


@dataclass(frozen=True)
class BagTopic:
    """A topic as line 1 describes it."""

    name: str
    unit: str = UNITLESS
    attributes: tuple[str, ...] = ()


@dataclass(frozen=True)
class BagHeader:
    """The topics and the values, in the order of the line."""

    topics: list[BagTopic]
    values: list[Value]


def read_header(line: str) -> BagHeader | None:
    """The header, or None if the line is not one whole JSON object.

    Missing keys are read as empty, values of an unexpected type as their JSON; of two equal keys the last counts.
    """
    members = read_object(line)
    if members is None:
        return None
    return BagHeader(
        topics=[_topic(topic) for topic in _objects(members, "topics")],
        values=[Value(_text(value, "name") or "", _text(value, "value") or "") for value in _objects(members, "values")],
    )


def _topic(members: _Members) -> BagTopic:
    attributes = _value(members, "attrs")
    items = attributes.items if attributes is not None and attributes.items is not None else []
    unit = _text(members, "unit")
    return BagTopic(
        name=_text(members, "name") or "",
        unit=UNITLESS if unit is None else unit,
        attributes=tuple(item.json if item.text is None else item.text for item in items),
    )


def _value(members: _Members, key: str) -> JsonValue | None:
    return next((value for name, value in reversed(members) if name == key), None)


def _objects(members: _Members, key: str) -> list[_Members]:
    value = _value(members, key)
    return [item.members for item in (value.items if value is not None and value.items else []) if item.members is not None]


def _text(members: _Members, key: str) -> str | None:
    value = _value(members, key)
    if value is None:
        return None
    if value.text is not None:
        return value.text
    return None if value.json == "null" else value.json

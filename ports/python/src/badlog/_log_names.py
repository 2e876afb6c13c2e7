"""Recognizes logs by their file names, and pairs of files that are one log. Only the content shows the real format of a file."""

from __future__ import annotations

from pathlib import Path

_TABLE = ".csv"
_DSLOG, _DSEVENTS = ".dslog", ".dsevents"
_BINARY = (".wpilog", ".wpilogxz", _DSLOG, _DSEVENTS)
_ENDINGS = (".bag", ".badbag", _TABLE, *_BINARY)


def ending_of(name: str) -> str:
    """The ending of a log that `name` has before any `.gz`, in lower case; empty if it has none."""
    inner = name.lower().removesuffix(".gz")
    return next((ending for ending in _ENDINGS if inner.endswith(ending) and len(inner) > len(ending)), "")


def may_be_log(name: str) -> bool:
    """Whether a file of a folder is read as a log."""
    return ending_of(name) != "" and not name.startswith(".")


def is_only_of_logs(name: str) -> bool:
    """Whether only logs have such names; tables of all kinds end in `.csv`."""
    return ending_of(name) not in ("", _TABLE)


def is_of_binary_log(name: str) -> bool:
    """Whether it is the name of a log that is not text."""
    return ending_of(name) in _BINARY


def second_file_of(path: Path) -> Path | None:
    """The `.dsevents` beside a `.dslog` that belongs to it; None if there is none."""
    return _sibling(path, _DSLOG, _DSEVENTS)


def is_second_file(path: Path) -> bool:
    """Whether it is a `.dsevents` with the `.dslog` that it belongs to beside it."""
    return _sibling(path, _DSEVENTS, _DSLOG) is not None


def _sibling(path: Path, start: str, other: str) -> Path | None:
    name = path.name
    if ending_of(name) != start:
        return None
    suffix = name[-3:] if name.lower().endswith(".gz") else ""
    stem, ending = name[: len(name) - len(suffix) - len(start)], name[len(name) - len(suffix) - len(start) : len(name) - len(suffix)]
    sibling = path.with_name(stem + (other.upper() if ending == start.upper() else other) + suffix)
    return sibling if sibling.is_file() else None

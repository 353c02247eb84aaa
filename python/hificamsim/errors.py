"""What can go wrong, and what values are checked for."""

from __future__ import annotations

import math
import operator
import os
from typing import Any

MOST_SHOWN = 80
PART = 400


class Error(Exception):
    """Anything that this package says."""


class InputError(Error, ValueError):
    """A setting, file or action is wrong; the message is one line, in which a setting is a keyword, such as ``steps=``."""


class JavaError(Error, RuntimeError):
    """There is no Java to run on, or it cannot be used as things are."""


class WorkerDied(Error, RuntimeError):
    """The Java process of an environment ended, or was killed."""


class NoEpisode(Error, RuntimeError):
    """A step before the first reset, or after the end of an episode."""


class InUse(Error, RuntimeError):
    """Another thread is in a call of the environment."""


class Closed(Error, RuntimeError):
    """The environment was closed, or belongs to another process."""


def shown(value: object) -> str:
    """A value as it stands in an error: in one line, and cut where it is long."""
    text = " ".join(repr(value).split())
    return text if len(text) <= MOST_SHOWN else text[:MOST_SHOWN] + "..."


def line(text: str) -> str:
    """What the simulator says, in one line; where it is long, its ends, as on the command line."""
    text = " ".join(text.split())
    return text if len(text) <= 2 * PART else text[:PART] + "..." + text[-PART:]


def path(value: Any, what: str) -> str:
    """A path or name as text."""
    try:
        text = os.fsdecode(value)
    except TypeError:
        raise InputError(f"{what} is {shown(value)}, expected a name or a file") from None
    if "\0" in text:
        raise InputError(f"{what} is {shown(value)}, expected no NUL in it")
    return text


def whole(value: Any, what: str, least: int = -(2**63), most: int = 2**63 - 1) -> int:
    """A whole number from ``least`` to ``most``."""
    try:
        number = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        number = None
    if number is None or not least <= number <= most:
        raise InputError(f"{what} is {shown(value)}, expected a whole number from {least} to {most}")
    return number


def plain(value: Any, what: str) -> object:
    """A setting as JSON has it; NumPy's numbers are numbers."""
    if hasattr(value, "item") and getattr(value, "shape", None) == ():
        value = value.item()
    if not isinstance(value, (str, int, float)) or (isinstance(value, float) and not math.isfinite(value)):
        raise InputError(f"{what} is {shown(value)}, expected a finite number, a text, True or False")
    return value

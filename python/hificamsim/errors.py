"""The exceptions of this package, and checks of values."""

from __future__ import annotations

import math
import operator
import os
from typing import Any

import numpy as np

MAX_SHOWN = 80
MAX_HALF = 400


class Error(Exception):
    """The base of all exceptions of this package."""


class InputError(Error, ValueError):
    """A setting, file or action is wrong; the message is one line, in which a setting is a keyword, such as ``steps=``."""


class JavaError(Error, RuntimeError):
    """Java is missing, or cannot be used."""


class WorkerDied(Error, RuntimeError):
    """The Java process of an environment ended, or was killed."""


class NoEpisode(Error, RuntimeError):
    """A step before the first reset, or after the end of an episode."""


class InUse(Error, RuntimeError):
    """Another thread is in a call of the environment."""


class Closed(Error, RuntimeError):
    """The environment was closed, or belongs to another process."""


def shown(value: object) -> str:
    """Formats a value for an error, in one line; a long one is cut."""
    text = " ".join(repr(value).split())
    return text if len(text) <= MAX_SHOWN else text[:MAX_SHOWN] + "..."


def line(text: str) -> str:
    """Writes a message of the simulator in one line, and cuts the middle of a long one, as the command line does."""
    text = " ".join(text.split())
    return text if len(text) <= 2 * MAX_HALF else text[:MAX_HALF] + "..." + text[-MAX_HALF:]


def path(value: Any, name: str) -> str:
    """Returns a path or name as text."""
    try:
        text = os.fsdecode(value)
    except TypeError:
        raise InputError(f"{name} is {shown(value)}, expected a name or a file") from None
    if "\0" in text:
        raise InputError(f"{name} is {shown(value)}, expected no NUL in it")
    return text


def whole(value: Any, name: str, least: int = -(2**63), most: int = 2**63 - 1) -> int:
    """Returns a whole number after checking that it is from ``least`` to ``most``."""
    try:
        number = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        number = None
    if number is None or not least <= number <= most:
        raise InputError(f"{name} is {shown(value)}, expected a whole number from {least} to {most}")
    return number


def flag(value: Any, name: str) -> bool:
    """Returns a value after checking that it is True or False; those of NumPy become Python's."""
    if not isinstance(value, (bool, np.bool_)):
        raise InputError(f"{name} is {shown(value)}, expected True or False")
    return bool(value)


def plain(value: Any, name: str) -> object:
    """Returns a setting as a value for JSON; numbers of NumPy become plain numbers."""
    if hasattr(value, "item") and getattr(value, "shape", None) == ():
        value = value.item()
    if not isinstance(value, (str, int, float)) or (isinstance(value, float) and not math.isfinite(value)):
        raise InputError(f"{name} is {shown(value)}, expected a finite number, a text, True or False")
    return value

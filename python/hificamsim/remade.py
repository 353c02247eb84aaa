"""Environments that can be pickled, copied, saved and restored."""

from __future__ import annotations

import dataclasses
from typing import Any

from .errors import InputError


class Remade:
    """Pickle and copy make a new object of the same arguments, which begins as this one did; see ``save`` for the rest."""

    _arguments: tuple[tuple[Any, ...], dict[str, Any]]

    def __new__(cls, *args: Any, **kwargs: Any) -> Any:
        made = super().__new__(cls)
        made._arguments = args, kwargs
        return made

    def __reduce__(self) -> Any:
        args, kwargs = self._arguments
        return _remake, (type(self), args, kwargs)


def _remake(cls: type, args: tuple[Any, ...], kwargs: dict[str, Any]) -> Any:
    return cls(*args, **kwargs)


@dataclasses.dataclass(frozen=True)
class State:
    """An environment at one moment, as ``save`` returns it. It can be pickled, and restored in any environment of the
    same settings.

    Saving copies the actions of the episode and the arrays; restoring replays the episode, so it takes as long as its
    steps did.

    :param worlds: what the simulator needs
    :param settings: what was asked for
    :param own: what the environment itself keeps of its episode
    """

    worlds: bytes
    settings: dict[str, Any]
    own: Any = None

    def check(self, settings: dict[str, Any]) -> None:
        """Rejects a state of other settings."""
        for name in self.settings.keys() | settings.keys():
            saved, present = self.settings.get(name), settings.get(name)
            if saved != present:
                raise InputError(f"the state is of {name}={saved!r}, expected {present!r}")

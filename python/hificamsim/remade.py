"""Environments that can be pickled, copied, saved and restored."""

from __future__ import annotations

import dataclasses
from typing import Any

from .errors import InputError


class Remade:
    """Lets pickle and copy make a new object with the same arguments, in its initial state; ``save`` keeps the present one."""

    _arguments: tuple[tuple[Any, ...], dict[str, Any]]

    def __new__(cls, *args: Any, **kwargs: Any) -> Any:
        instance = super().__new__(cls)
        instance._arguments = args, kwargs
        return instance

    def __reduce__(self) -> Any:
        args, kwargs = self._arguments
        return _remake, (type(self), args, kwargs)


def _remake(cls: type, args: tuple[Any, ...], kwargs: dict[str, Any]) -> Any:
    return cls(*args, **kwargs)


@dataclasses.dataclass(frozen=True)
class State:
    """The state of an environment, as ``save`` returns it. It can be pickled, and restored in any environment with the
    same settings.
    Saving copies the actions of the episode and the arrays; restoring replays the episode, so it takes as long as its
    steps did.
    :param worlds: the state of the simulator
    :param settings: the settings of the environment
    :param own: the state of the Python object
    """

    worlds: bytes
    settings: dict[str, Any]
    own: Any = None

    def check(self, settings: dict[str, Any], own: type) -> None:
        """Rejects a state of an environment with other settings, or of another kind."""
        if not isinstance(self.own, own):
            raise InputError("the state is of another kind of environment, expected one that this kind saved")
        for name in self.settings.keys() | settings.keys():
            saved, present = self.settings.get(name), settings.get(name)
            if saved != present:
                raise InputError(f"the state is of {name}={saved!r}, expected {present!r}")

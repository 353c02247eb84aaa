"""Environments by id: every scenario that comes with the package, as ``campus-v0``."""

from __future__ import annotations

from typing import Any

from .errors import InputError, path, shown
from .parallel import CameraEnv
from .worlds import scenarios

VERSION = "-v0"


def ids() -> list[str]:
    """All ids."""
    return [name + VERSION for name in scenarios()]


def make(id: str, **settings: Any) -> CameraEnv:
    """The parallel environment of an id."""
    if path(id, "id") not in ids():
        raise InputError(f"id is {shown(id)}, expected one of {', '.join(ids())}")
    return CameraEnv(id.removesuffix(VERSION), **settings)


def register() -> None:
    """Makes the ids known to Gymnasium, as ``hificamsim/campus-v0``."""
    import gymnasium

    for name in scenarios():
        full = "hificamsim/" + name + VERSION
        if full not in gymnasium.registry:
            gymnasium.register(
                full,
                entry_point="hificamsim.vector:NetworkEnv",
                vector_entry_point="hificamsim.vector:CameraVectorEnv",
                kwargs={"scenario": name},
            )

"""Environments by id: shipped scenarios, as ``campus-v1``, and tasks, as ``bench/campus-v1``."""

from __future__ import annotations

from typing import Any

from .errors import InputError, path, shown
from .parallel import CameraEnv
from .worlds import scenarios, tasks

VERSION = "-v1"
OLD_VERSION = "-v0"


def ids() -> list[str]:
    """Returns all ids."""
    return [name + VERSION for name in scenarios()] + tasks()


def _scenarios() -> dict[str, str]:
    named = {name + version: name for name in scenarios() for version in (VERSION, OLD_VERSION)}
    return named | {name: name for name in tasks()}


def make(id: str, **settings: Any) -> CameraEnv:
    """Makes the parallel environment of an id."""
    scenario = _scenarios().get(path(id, "id"))
    if scenario is None:
        raise InputError(f"id is {shown(id)}, expected one of {', '.join(ids())}")
    return CameraEnv(scenario, **settings)


def register() -> None:
    """Registers the ids with Gymnasium, as ``hificamsim/campus-v1`` and ``bench/campus-v1``."""
    import gymnasium

    for id, scenario in _scenarios().items():
        full = id if "/" in id else "hificamsim/" + id
        if full not in gymnasium.registry:
            gymnasium.register(
                full,
                entry_point="hificamsim.vector:NetworkEnv",
                vector_entry_point="hificamsim.vector:CameraVectorEnv",
                kwargs={"scenario": scenario},
            )

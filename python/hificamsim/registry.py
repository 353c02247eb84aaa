"""Environments by id: every scenario that comes with the package, as ``campus-v1``, and every task, as ``bench/campus-v1``."""

from __future__ import annotations

from typing import Any

from .errors import InputError, path, shown
from .parallel import CameraEnv
from .worlds import scenarios, tasks

VERSION = "-v1"
ALIAS = "-v0"  # what ids ended in at first


def ids() -> list[str]:
    """All ids."""
    return [name + VERSION for name in scenarios()] + tasks()


def _scenarios() -> dict[str, str]:
    named = {name + version: name for name in scenarios() for version in (VERSION, ALIAS)}
    return named | {name: name for name in tasks()}


def make(id: str, **settings: Any) -> CameraEnv:
    """The parallel environment of an id."""
    scenario = _scenarios().get(path(id, "id"))
    if scenario is None:
        raise InputError(f"id is {shown(id)}, expected one of {', '.join(ids())}")
    return CameraEnv(scenario, **settings)


def register() -> None:
    """Makes the ids known to Gymnasium, as ``hificamsim/campus-v1`` and ``bench/campus-v1``."""
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

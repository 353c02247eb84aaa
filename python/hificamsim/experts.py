"""The decisions of an expert, for imitation."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from .errors import InputError, flag, whole
from .worlds import Array, Worlds


def dataset(
    scenario: str | os.PathLike[str], expert: str = "cooperative", episodes: int = 1, *, idle: bool = False, **settings: Any
) -> dict[str, Array]:
    """Plays an expert, and returns its decisions, one for each camera and step, without those of moving cameras.
    The arrays are ``observations`` float32 (N, F), ``masks`` uint8 (N, M) and ``actions`` int32 (N,), the chosen views;
    what followed, ``rewards`` float32 (N,), ``next_observations`` (N, F), ``next_masks`` (N, M) and ``ends`` bool (N,), True
    in the last step of an episode, which ends by a time limit; and the ``episode``, ``step`` and ``camera`` of each decision.
    Episode i is the run of the seed plus i.
    :param expert: the name of a policy, perhaps with options
    :param idle: whether moving and offline cameras have rows as well, with the first action that their mask allows;
        ``to_minari`` needs these rows
    :param settings: settings of ``Worlds`` except ``actions`` and ``auto_reset``
    """
    for name in ("actions", "auto_reset"):
        if name in settings:
            raise InputError(f"unknown setting {name!r}: experts choose views, an episode at a time")
    idle = flag(idle, "idle")
    parts: dict[str, list[Array]] = {}
    with Worlds(scenario, whole(episodes, "episodes", 1), expert=expert, auto_reset=False, **settings) as worlds:
        worlds.begin(None)
        worlds.actions[...] = -1
        step = 0
        while not worlds.ends.any():
            seen = {"observations": worlds.observations.copy(), "masks": worlds.masks.copy()}
            worlds.step()
            chosen = np.where(worlds.advice < 0, seen["masks"].argmax(-1), worlds.advice) if idle else worlds.advice
            episode, camera = np.nonzero(chosen >= 0)
            rows = {name: array[episode, camera] for name, array in seen.items()}
            rows["actions"] = chosen[episode, camera].astype(np.int32)
            followed = {
                "rewards": worlds.rewards,
                "next_observations": worlds.observations,
                "next_masks": worlds.masks,
            }
            rows |= {name: array[episode, camera] for name, array in followed.items()}
            rows["ends"] = worlds.ends[episode].astype(bool)
            rows |= {"episode": episode, "step": np.full(len(episode), step), "camera": camera}
            for name, array in rows.items():
                parts.setdefault(name, []).append(array)
            step += 1
    return {name: np.concatenate(arrays) for name, arrays in parts.items()}

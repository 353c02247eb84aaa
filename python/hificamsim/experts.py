"""What an expert sees and does, for those who imitate it."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from .errors import InputError
from .worlds import Array, Worlds


def dataset(
    scenario: str | os.PathLike[str], expert: str = "cooperative", episodes: int = 1, *, idle: bool = False, **settings: Any
) -> dict[str, Array]:
    """The decisions of an expert that plays, one for each camera and step, but for cameras on their way.

    ``observations`` float32 (N, F), ``actions`` int32 (N,), the view that it chose, ``masks`` uint8 (N, M), what came of
    it: ``rewards`` float32 (N,), ``next_observations`` (N, F), ``next_masks`` (N, M) and ``ends`` bool (N,), True in the
    last step of an episode, which time ends; and of each the ``episode``, ``step`` and ``camera``. Episode i is the run
    of the seed plus i.

    :param expert: a policy, perhaps with options
    :param idle: whether cameras on their way and offline ones have rows as well, with the first action that their mask
        allows; ``to_minari`` needs these
    :param settings: of ``Worlds``, but for ``actions`` and ``auto_reset``
    """
    for name in ("actions", "auto_reset"):
        if name in settings:
            raise InputError(f"unknown setting {name!r}: experts choose views, an episode at a time")
    parts: dict[str, list[Array]] = {}
    with Worlds(scenario, episodes, expert=expert, auto_reset=False, **settings) as worlds:
        worlds.begin(None)
        worlds.actions[...] = -1
        step = 0
        while not worlds.ends.any():
            seen = {"observations": worlds.observations.copy(), "masks": worlds.masks.copy()}
            worlds.step()
            chosen = np.where(worlds.advice < 0, seen["masks"].argmax(-1), worlds.advice) if idle else worlds.advice
            episode, camera = np.nonzero(chosen >= 0)
            told = {name: array[episode, camera] for name, array in seen.items()}
            told["actions"] = chosen[episode, camera].astype(np.int32)
            followed = {
                "rewards": worlds.rewards,
                "next_observations": worlds.observations,
                "next_masks": worlds.masks,
            }
            told |= {name: array[episode, camera] for name, array in followed.items()}
            told["ends"] = worlds.ends[episode].astype(bool)
            told |= {"episode": episode, "step": np.full(len(episode), step), "camera": camera}
            for name, array in told.items():
                parts.setdefault(name, []).append(array)
            step += 1
    return {name: np.concatenate(arrays) for name, arrays in parts.items()}

"""Writes the decisions of an expert as a Minari dataset, and reads them back."""

from __future__ import annotations

from typing import Any

import numpy as np

from .errors import InputError
from .worlds import Array

ORDER = ("episode", "camera", "step")


def to_minari(decisions: dict[str, Array], name: str, **metadata: Any) -> Any:
    """Writes the decisions of ``dataset(..., idle=True)`` as a Minari dataset, an episode for each camera and episode.

    Observations are Box (F,), actions Discrete (M), all episodes truncated; ``infos`` have ``action_mask``, (M,), and
    ``episode`` and ``camera``, (1,). Needs Minari (``pip install 'hificamsim[minari]'``).

    :param name: the name of the dataset, such as ``cameras/campus-cooperative-v0``
    :param metadata: other arguments of ``minari.create_dataset_from_buffers``, such as ``author`` or ``description``
    :returns: the ``MinariDataset``
    """
    import gymnasium
    import minari

    rows = np.lexsort([decisions[key] for key in reversed(ORDER)])
    sorted_rows = {key: array[rows] for key, array in decisions.items()}
    starts = np.flatnonzero(sorted_rows["step"] == 0)
    buffers = [_episode(part) for part in _parts(sorted_rows, starts)]
    size = decisions["observations"].shape[1]
    return minari.create_dataset_from_buffers(
        name,
        buffers,
        observation_space=gymnasium.spaces.Box(-1, 1, (size,), np.float32),
        action_space=gymnasium.spaces.Discrete(decisions["masks"].shape[1]),
        **metadata,
    )


def from_minari(dataset: Any) -> dict[str, Array]:
    """Reads a Minari dataset that ``to_minari`` wrote, and returns its decisions in the order of ``dataset``.

    :param dataset: a ``MinariDataset``, or the name of one
    """
    import minari

    if isinstance(dataset, str):
        dataset = minari.load_dataset(dataset)
    parts: dict[str, list[Array]] = {}
    for episode in dataset.iterate_episodes():
        for key, array in _decisions(episode).items():
            parts.setdefault(key, []).append(array)
    joined = {key: np.concatenate(arrays) for key, arrays in parts.items()}
    rows = np.lexsort([joined[key] for key in ("camera", "episode", "step")])
    return {key: array[rows] for key, array in joined.items()}


def _parts(rows: dict[str, Array], starts: Array) -> list[dict[str, Array]]:
    """Splits rows into those of each episode of each camera."""
    bounds = [*starts.tolist(), len(rows["step"])]
    return [{key: array[first:end] for key, array in rows.items()} for first, end in zip(bounds, bounds[1:])]


def _episode(part: dict[str, Array]) -> Any:
    from minari.data_collector import EpisodeBuffer

    steps = len(part["step"])
    if (part["step"] != np.arange(steps)).any():
        raise InputError("decisions lack steps, expected those of dataset(..., idle=True)")
    infos = {key: np.resize(part[key], (steps + 1, 1)) for key in ("episode", "camera")}
    infos["action_mask"] = np.concatenate([part["masks"], part["next_masks"][-1:]])
    return EpisodeBuffer(
        observations=np.concatenate([part["observations"], part["next_observations"][-1:]]),
        actions=part["actions"],
        rewards=part["rewards"],
        terminations=[False] * steps,
        truncations=part["ends"].tolist(),
        infos=infos,
    )


def _decisions(episode: Any) -> dict[str, Array]:
    infos = episode.infos or {}
    for key in ("action_mask", "episode", "camera"):
        if key not in infos:
            raise InputError(f"episode {episode.id} has no {key}, expected a dataset of to_minari")
    masks, steps = infos["action_mask"], len(episode.actions)
    return {
        "observations": episode.observations[:-1],
        "masks": masks[:-1],
        "actions": np.asarray(episode.actions, np.int32),
        "rewards": np.asarray(episode.rewards, np.float32),
        "next_observations": episode.observations[1:],
        "next_masks": masks[1:],
        "ends": episode.truncations,
        "episode": infos["episode"][:-1, 0],
        "step": np.arange(steps),
        "camera": infos["camera"][:-1, 0],
    }

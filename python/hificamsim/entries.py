"""Enters policies written in Python in the benchmark."""

from __future__ import annotations

import json
import os
import pathlib
import tempfile
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from . import spaces
from .errors import InputError, flag, path, shown
from .results import execute
from .worlds import TASKS, TESTING, Array, Worlds, tasks

Policy = Callable[[Array, Array], Any]


def benchmark(
    policy: Policy | Callable[[str], Policy] | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    name: str,
    only: Iterable[str] | None = None,
    per_task: bool = False,
    **settings: Any,
) -> dict[str, Array]:
    """Plays the testing episodes of the tasks, and writes the folder of ``hificamsim benchmark run``.

    :param policy: takes observations float32 (C, F) and masks uint8 (C, M), and returns an action for each camera;
        if it has a method ``begin``, that is called before each episode. Or a Python file with such a ``policy``,
        which can be verified on fresh seeds: it plays in a process of its own, from the file alone
    :param name: the name of the entry
    :param only: the names of the tasks to play, all by default
    :param per_task: whether ``policy`` takes a task's name, and returns the policy for it
    :param settings: settings of observations and actions, as for ``Worlds``: targets, neighbours, actions; for a Python file
        ``weights`` as well, a file that the entry gets a copy of, and whose path the policy finds in ``WEIGHTS``
    :returns: for each task the scores of its episodes, each the mean score of a step
    """
    known = tasks()
    chosen = [task if task.startswith(TASKS) else TASKS + task for task in (known if only is None else only)]
    for task in chosen:
        if task not in known:
            raise InputError(f"task is {shown(task)}, expected one of {', '.join(known)}")
    per_task = flag(per_task, "per_task")
    if isinstance(policy, (str, os.PathLike)):
        return _enter(path(policy, "policy"), out, name, chosen, settings)
    scores = {}
    with tempfile.TemporaryDirectory() as scratch:
        for task in chosen:
            plays: Any = policy(task) if per_task else policy  # type: ignore[call-arg, arg-type]
            scores[task] = _play(plays, task, pathlib.Path(scratch), settings)
        played = f"played:actions={settings.get('actions', 'view')},file={scratch}/{{task}}-{{seed}}"
        names = ",".join(chosen)
        execute("benchmark", "run", "--policy", played, "--name", name, "--tasks", names, "--out", os.fspath(out))
    return scores


def _enter(file: str, out: str | os.PathLike[str], name: str, chosen: list[str], settings: dict[str, Any]) -> dict[str, Array]:
    """Enters a policy in a file."""
    words = {"file": os.path.abspath(file)} | {key: _word(value) for key, value in settings.items()}
    if "weights" in settings:
        words["weights"] = os.path.abspath(path(settings["weights"], "weights"))
    policy = "python:" + ",".join(f"{key}={word}" for key, word in words.items())
    out = os.fspath(out)
    execute("benchmark", "run", "--policy", policy, "--name", name, "--tasks", ",".join(chosen), "--out", out)
    entry = json.loads(pathlib.Path(out, "entry.json").read_text(encoding="utf-8"))
    return {TASKS + task: np.array(scored["scores"]) for task, scored in entry["tasks"].items()}


def _word(value: Any) -> str:
    return ("yes" if value else "no") if isinstance(value, bool) else str(value)


def _play(policy: Any, task: str, folder: pathlib.Path, settings: dict[str, Any]) -> Array:
    scores = []
    with Worlds(task, 1, auto_reset=False, testing=True, **settings) as worlds:
        counts = spaces.counts(spaces.joint_action(worlds)).reshape(worlds.actions.shape[1:])
        for seed in TESTING:
            worlds.reset(seed)
            if hasattr(policy, "begin"):
                policy.begin()
            score = 0.0
            for _ in range(worlds.episode_steps):
                actions = np.asarray(policy(worlds.observations[0].copy(), worlds.masks[0].copy())).reshape(counts.shape)
                worlds.actions[0] = spaces.checked(actions, counts, lambda index: f"camera {worlds.cameras[index[0]]}")
                worlds.step()
                score += float(worlds.measures[0, 2])
            (folder / f"{task.removeprefix(TASKS)}-{seed}").write_bytes(worlds.played().astype("<i4").tobytes())
            scores.append(score / worlds.episode_steps)
    return np.array(scores)

"""Simulates smart-camera networks for training agents.

``parallel_env`` is PettingZoo's, ``vector_env`` and ``single_env`` are Gymnasium's, ``sb3_vec_env`` is that of
Stable-Baselines3; ``Worlds`` is what they stand on. ``run``, ``compare`` and ``read_results`` give pandas frames.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from .errors import Closed, Error, InputError, InUse, JavaError, NoEpisode, WorkerDied
from .remade import State
from .worlds import Worlds, scenarios, tasks

if TYPE_CHECKING:
    from .entries import benchmark
    from .experts import dataset
    from .offline import from_minari, to_minari
    from .parallel import CameraEnv, env, parallel_env
    from .registry import ids, make, register
    from .results import Plan, Results, compare, execute, place, read_results, run
    from .torch_envs import torchrl_env
    from .vector import CameraVectorEnv, NetworkEnv, single_env, vector_env

__version__ = "0.2.0.dev0"

_LATER = {
    "CameraEnv": "parallel",
    "benchmark": "entries",
    "dataset": "experts",
    "env": "parallel",
    "from_minari": "offline",
    "to_minari": "offline",
    "parallel_env": "parallel",
    "ids": "registry",
    "make": "registry",
    "register": "registry",
    "Plan": "results",
    "Results": "results",
    "compare": "results",
    "execute": "results",
    "place": "results",
    "read_results": "results",
    "run": "results",
    "torchrl_env": "torch_envs",
    "CameraVectorEnv": "vector",
    "NetworkEnv": "vector",
    "single_env": "vector",
    "vector_env": "vector",
}

__all__ = [
    "Closed",
    "Error",
    "InUse",
    "InputError",
    "JavaError",
    "NoEpisode",
    "State",
    "WorkerDied",
    "Worlds",
    "scenarios",
    "tasks",
    "sb3_vec_env",
    "CameraEnv",
    "CameraVectorEnv",
    "NetworkEnv",
    "Plan",
    "Results",
    "benchmark",
    "benchmarl_task",
    "compare",
    "dataset",
    "env",
    "execute",
    "from_minari",
    "ids",
    "make",
    "parallel_env",
    "place",
    "read_results",
    "register",
    "run",
    "single_env",
    "to_minari",
    "torchrl_env",
    "vector_env",
]


def sb3_vec_env(scenario: str | os.PathLike[str], num_envs: int = 1, **settings: Any) -> Any:
    """Makes a Stable-Baselines3 ``VecEnv`` with an environment for each camera of each of ``num_envs`` networks."""
    from .sb3 import CameraVecEnv

    return CameraVecEnv(scenario, num_envs, **settings)


def benchmarl_task(scenario: str | os.PathLike[str], **settings: Any) -> Any:
    """Makes a task for BenchMARL's ``Experiment(task=...)``: the TorchRL environment with its masks and its state."""
    from .tasks import CameraTask

    return CameraTask(scenario, settings)


def __getattr__(name: str) -> Any:
    """Loads modules that need more than NumPy on first use."""
    if name not in _LATER:
        raise AttributeError(f"module 'hificamsim' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module("." + _LATER[name], __name__), name)

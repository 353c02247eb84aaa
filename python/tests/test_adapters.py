"""Tests the adapter for Stable-Baselines3 against the interface of its vector environments.
The library itself needs torch; tests/torch has tests with it.
"""

from __future__ import annotations

import sys
import types
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import hificamsim


class VecEnv:
    """A stand-in for the class of this name in Stable-Baselines3."""

    def __init__(self, num_envs: int, observation_space: Any, action_space: Any) -> None:
        self.num_envs = num_envs
        self.observation_space = observation_space
        self.action_space = action_space
        self.reset_infos: list[dict[str, Any]] = [{} for _ in range(num_envs)]

    def step(self, actions: Any) -> Any:
        self.step_async(actions)  # type: ignore[attr-defined]
        return self.step_wait()  # type: ignore[attr-defined]

    def _get_indices(self, indices: Any) -> Any:
        return range(self.num_envs) if indices is None else [indices] if isinstance(indices, int) else indices


@pytest.fixture
def library(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Replaces the module of the library."""
    module = types.ModuleType("stable_baselines3.common.vec_env")
    module.VecEnv = VecEnv  # type: ignore[attr-defined]
    for name in ("stable_baselines3", "stable_baselines3.common"):
        monkeypatch.setitem(sys.modules, name, types.ModuleType(name))
    monkeypatch.setitem(sys.modules, module.__name__, module)
    monkeypatch.delitem(sys.modules, "hificamsim.sb3", raising=False)
    yield
    sys.modules.pop("hificamsim.sb3", None)


def test_every_camera_is_an_environment_with_autoreset(library: None) -> None:
    env = hificamsim.sb3_vec_env("campus", 2, steps=20, reward="difference")
    cameras = len(env.vector.worlds.cameras)
    assert env.num_envs == 2 * cameras
    env.seed(3)
    observations = env.reset()
    random = np.random.default_rng(1)
    for step in range(1, 41):
        assert observations.shape == (env.num_envs, *env.observation_space.shape)
        actions = random.integers(0, env.action_space.n, env.num_envs)
        observations, rewards, dones, infos = env.step(actions)
        assert rewards.dtype == np.float32 and dones.dtype == np.bool_
        assert dones.all() == dones.any() == (step % 20 == 0)
        for done, info in zip(dones, infos):
            assert ("terminal_observation" in info) == done
            assert info.get("TimeLimit.truncated", False) == done
    masks = env.env_method("action_masks")
    assert len(masks) == env.num_envs and masks[0].shape == (env.action_space.n,)
    assert len(env.env_method("action_masks", indices=[1])) == 1
    assert env.env_is_wrapped(object) == [False] * env.num_envs
    assert env.get_attr("render_mode") == [None] * env.num_envs
    env.close()


def test_seed_of_vector_environment_has_effect(library: None) -> None:
    first = []
    for seed in (5, 5, 6):
        env = hificamsim.sb3_vec_env("campus", 1, steps=100)
        env.seed(seed)
        env.reset()
        for _ in range(60):
            env.step(np.zeros(env.num_envs, int))
        first.append(env.vector.state())
        env.close()
    assert (first[0] == first[1]).all()
    assert (first[0] != first[2]).any()

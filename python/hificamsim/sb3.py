"""The environment for Stable-Baselines3: every camera of every network is one, for a shared policy."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from stable_baselines3.common.vec_env import VecEnv

from .remade import Remade
from .vector import CameraVectorEnv


class CameraVecEnv(Remade, VecEnv):  # type: ignore[misc]
    """Adapts ``CameraVectorEnv`` with ``per="camera"`` to the interface of Stable-Baselines3.

    ``env_method("action_masks")`` gives MaskablePPO its masks.
    """

    def __init__(self, scenario: str | os.PathLike[str], num_envs: int = 1, **settings: Any) -> None:
        self.vector = CameraVectorEnv(scenario, num_envs, per="camera", **settings)
        self.render_mode = self.vector.render_mode
        super().__init__(
            self.vector.num_envs, self.vector.single_observation_space, self.vector.single_action_space
        )
        self._actions: Any = None
        self._seed: int | None = None

    def seed(self, seed: int | None = None) -> Sequence[int | None]:
        self._seed = seed
        return [seed] * self.num_envs

    def reset(self) -> Any:
        observations, _ = self.vector.reset(seed=self._seed)
        self._seed = None
        self.reset_infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        return observations

    def step_async(self, actions: Any) -> None:
        self._actions = actions

    def step_wait(self) -> Any:
        observations, rewards, _, ends, batch = self.vector.step(self._actions)
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for i in np.flatnonzero(ends):
            infos[i] = {"terminal_observation": batch["final_obs"][i], "TimeLimit.truncated": True}
        return observations, rewards.copy(), ends, infos

    def close(self) -> None:
        self.vector.close()

    def render(self, mode: str | None = None) -> Any:
        pictures = self.vector.render()
        return None if pictures is None else pictures[0]

    def get_images(self) -> Sequence[Any]:
        return list(self.vector.render() or ())

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        return [getattr(self.vector, attr_name)] * len(self._numbers(indices))

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        setattr(self.vector, attr_name, value)

    def env_method(self, method_name: str, *args: Any, indices: Any = None, **kwargs: Any) -> list[Any]:
        if method_name == "action_masks":
            masks = self.vector.action_masks()
            return [masks[i] for i in self._numbers(indices)]
        return [getattr(self.vector, method_name)(*args, **kwargs)] * len(self._numbers(indices))

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> list[bool]:
        return [False] * len(self._numbers(indices))

    def _numbers(self, indices: Any) -> Sequence[int]:
        return list(self._get_indices(indices))

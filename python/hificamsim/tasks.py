"""The TorchRL environment as a task of BenchMARL, in a module of its own, since experiments are pickled."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Callable
from typing import Any

from benchmarl.environments.common import TaskClass
from torchrl.data import Composite

from .torch_envs import GROUP, torchrl_env
from .worlds import Worlds


class CameraTask(TaskClass):  # type: ignore[misc]
    """A network of cameras as a task, named after its scenario, since folders of results get its name."""

    def __init__(self, scenario: str | os.PathLike[str], settings: dict[str, Any]) -> None:
        super().__init__(pathlib.Path(scenario).stem, settings)
        self.scenario = os.fspath(scenario)

    def get_env_fun(
        self, num_envs: int, continuous_actions: bool, seed: int | None, device: Any
    ) -> Callable[[], Any]:
        seeded = {} if seed is None else {"seed": seed}
        return lambda: torchrl_env(self.scenario, device=device, **{**self.config, **seeded})

    def supports_continuous_actions(self) -> bool:
        return False

    def supports_discrete_actions(self) -> bool:
        return True

    def max_steps(self, env: Any) -> int:
        if "steps" in self.config:
            return int(self.config["steps"])
        worlds = Worlds(self.scenario)
        worlds.close()
        return worlds.episode_steps

    def has_render(self, env: Any) -> bool:
        return False

    def group_map(self, env: Any) -> Any:
        return env.group_map

    def state_spec(self, env: Any) -> Any:
        return Composite({"state": env.observation_spec["state"].clone()}, device=env.device)

    def action_mask_spec(self, env: Any) -> Any:
        return _only(env, "action_mask")

    def observation_spec(self, env: Any) -> Any:
        return _only(env, "observation")

    def info_spec(self, env: Any) -> Any:
        return _only(env, "info")

    def action_spec(self, env: Any) -> Any:
        return env.full_action_spec

    @staticmethod
    def env_name() -> str:
        return "hificamsim"


def _only(env: Any, part: str) -> Any:
    """Returns the specification of one part of an environment's observations."""
    spec = env.observation_spec.clone()
    del spec["state"]
    for key in list(spec[GROUP].keys()):
        if key != part:
            del spec[GROUP, key]
    return spec

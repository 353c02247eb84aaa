"""TorchRL, and BenchMARL on it: the PettingZoo environment in their wrapper, all cameras in one group."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from .parallel import parallel_env

GROUP = "cameras"


def torchrl_env(scenario: str | os.PathLike[str], *, device: Any = "cpu", **settings: Any) -> Any:
    """A TorchRL environment: observations, actions and rewards are under the group ``cameras``."""
    from torchrl.envs import PettingZooWrapper

    made = parallel_env(scenario, **settings)
    return PettingZooWrapper(
        env=made,
        group_map={GROUP: made.possible_agents},
        return_state=True,
        use_mask=False,
        categorical_actions=True,
        device=device,
    )


def benchmarl_task(scenario: str | os.PathLike[str], **settings: Any) -> Any:
    """A task for BenchMARL's ``Experiment(task=...)``."""
    from benchmarl.environments.common import TaskClass

    class CameraTask(TaskClass):  # type: ignore[misc]
        """A network of cameras."""

        def get_env_fun(
            self, num_envs: int, continuous_actions: bool, seed: int | None, device: Any
        ) -> Callable[[], Any]:
            chosen = {**settings, **self.config}
            if seed is not None:
                chosen["seed"] = seed
            return lambda: torchrl_env(scenario, device=device, **chosen)

        def supports_continuous_actions(self) -> bool:
            return False

        def supports_discrete_actions(self) -> bool:
            return True

        def max_steps(self, env: Any) -> int:
            return int({**settings, **self.config}.get("steps", 1000))

        def has_render(self, env: Any) -> bool:
            return False

        def group_map(self, env: Any) -> Any:
            return env.group_map

        def state_spec(self, env: Any) -> Any:
            from torchrl.data import Composite

            return Composite({"state": env.observation_spec["state"].clone()}, device=env.device)

        def action_mask_spec(self, env: Any) -> Any:
            return None

        def observation_spec(self, env: Any) -> Any:
            spec = env.observation_spec.clone()
            for key in list(spec.keys(True, True)):
                if not (isinstance(key, tuple) and key[-1] == "observation"):
                    del spec[key]
            return spec

        def info_spec(self, env: Any) -> Any:
            return None

        def action_spec(self, env: Any) -> Any:
            return env.full_action_spec

        @staticmethod
        def env_name() -> str:
            return "hificamsim"

    return CameraTask(name=os.fspath(scenario), config={})

"""TorchRL: the PettingZoo environment in its wrapper, all cameras in one group."""

from __future__ import annotations

import os
from typing import Any

from . import spaces
from .parallel import CameraEnv
from .worlds import Array

GROUP = "cameras"


class StackedCameraEnv(CameraEnv):
    """Cameras that all have the choices of the one with the most views, as arrays of one shape; masks tell them apart."""

    def _space(self, camera: int) -> Any:
        return spaces.action(self.worlds)

    def _mask(self, camera: int, of: Array) -> Any:
        return of if len(self.worlds.choices) == 1 else super()._mask(camera, of)


def torchrl_env(scenario: str | os.PathLike[str], *, device: Any = "cpu", **settings: Any) -> Any:
    """A TorchRL environment: observations, actions, masks and rewards are under the group ``cameras``."""
    from torchrl.envs import PettingZooWrapper

    made = StackedCameraEnv(scenario, **settings)
    return PettingZooWrapper(
        env=made,
        group_map={GROUP: made.possible_agents},
        return_state=True,
        use_mask=False,
        categorical_actions=True,
        device=device,
    )

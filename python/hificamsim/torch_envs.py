"""The PettingZoo environment in the wrapper of TorchRL, with all cameras in one group."""

from __future__ import annotations

import os
from typing import Any

from . import spaces
from .parallel import CameraEnv
from .worlds import Array

GROUP = "cameras"


class StackedCameraEnv(CameraEnv):
    """Cameras that all have the choices of the camera with the most views, so that arrays have one shape; masks differ."""

    def _space(self, camera: int) -> Any:
        return spaces.action(self.worlds)

    def _mask(self, camera: int, mask: Array) -> Any:
        return mask if len(self.worlds.choices) == 1 else super()._mask(camera, mask)


def torchrl_env(scenario: str | os.PathLike[str], *, device: Any = "cpu", **settings: Any) -> Any:
    """Makes a TorchRL environment: observations, actions, masks and rewards are under the group ``cameras``."""
    from torchrl.envs import PettingZooWrapper

    stacked = StackedCameraEnv(scenario, **settings)
    return PettingZooWrapper(
        env=stacked,
        group_map={GROUP: stacked.possible_agents},
        return_state=True,
        use_mask=False,
        categorical_actions=True,
        device=device,
    )

"""Gymnasium's environments, with one agent for a whole network, or for each of its cameras."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from . import spaces
from .errors import InputError, flag, shown, whole
from .remade import Remade, State
from .worlds import DETAILS, MEASURES, Array, rendered, require_episode


class CameraVectorEnv(Remade, VectorEnv[Any, Any, Any]):
    """Many networks that are stepped together, for one policy.
    :param num_envs: the number of networks
    :param per: ``world``: an environment is a network, with the actions of all its cameras, and the mean of their
        rewards. ``camera``: an environment is a camera. The cameras of a network follow one another, and the attribute
        ``num_envs`` is the number of networks times that of cameras
    :param copy: whether each step returns new arrays; if not, the arrays change with the next step
    :param autoreset_mode: Gymnasium's time of the next episode. ``SAME_STEP``: it begins in the step that ends an episode,
        whose last observation is in ``infos["final_obs"]``. ``NEXT_STEP``: it begins in the following step, whose actions
        have no effect. ``DISABLED``: it begins by ``reset(options={"reset_mask": ...})``
    :param settings: the settings of ``Worlds``
    Episodes are never terminated, but truncated after ``steps``. With B networks, C cameras, F numbers of an observation, A
    of an action and M choices of a camera, the shapes for ``world`` and ``camera`` are:

    - observations: float32 (B, C, F), and (B x C, F)
    - actions: (B, C x A), and (B x C,) or (B x C, 2); float32 in [-1, 1] with ``actions="rates"``
    - rewards: (B,), and (B x C,)
    - ``infos``: ``action_mask``, (B, C x M) and (B x C, M), except for rates; ``coverage``, ``k_min`` and ``score`` of each
      environment; with ``details=True`` also ``seen``, ``added`` and ``sent`` of each camera, (B, C) and (B x C,);
      ``final_obs`` and ``final_info`` if episodes ended, with ``_final_obs`` and ``_final_info``
    """

    metadata: dict[str, Any] = {
        "autoreset_mode": AutoresetMode.SAME_STEP,
        "render_modes": ["rgb_array"],
        "render_fps": 10,
    }

    def __init__(
        self,
        scenario: str | os.PathLike[str],
        num_envs: int = 1,
        *,
        per: str = "world",
        copy: bool = True,
        render_mode: str | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.SAME_STEP,
        **settings: Any,
    ) -> None:
        try:
            mode = AutoresetMode(autoreset_mode)
        except ValueError:
            expected = ", ".join(mode.value for mode in AutoresetMode)
            raise InputError(f"autoreset_mode is {shown(autoreset_mode)}, expected one of {expected}") from None
        self.metadata = {**self.metadata, "autoreset_mode": mode}
        if not isinstance(per, str) or per not in ("world", "camera"):
            raise InputError(f"per is {shown(per)}, expected 'world' or 'camera'")
        self.copy = flag(copy, "copy")
        self.worlds = rendered(
            scenario, render_mode, self.metadata["render_modes"], settings, num_envs=num_envs,
            auto_reset=mode.name.lower().replace("_", "-"),
        )
        self.render_mode = render_mode
        self.per = per
        self._cameras_per_world = len(self.worlds.cameras)
        self.num_envs = num_envs * (self._cameras_per_world if per == "camera" else 1)
        if per == "camera":
            self.single_observation_space = spaces.observation(self.worlds)
            self.single_action_space = spaces.action(self.worlds)
        else:
            self.single_observation_space = spaces.observation(self.worlds, self._cameras_per_world)
            self.single_action_space = spaces.joint_action(self.worlds)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self._take_arrays()
        self._counts = np.broadcast_to(spaces.counts(self.single_action_space), self.action_space.shape or ())
        self._never = np.zeros(self.num_envs, np.bool_)
        self._begun = False

    def _take_arrays(self) -> None:
        self._observations = self.worlds.observations.reshape(self.observation_space.shape)
        self._finals = self.worlds.finals.reshape(self.observation_space.shape)
        self._masks = self.worlds.masks.reshape(self.num_envs, -1)
        self._final_masks = self.worlds.final_masks.reshape(self.num_envs, -1)

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Begins an episode of every network: that of ``seed + i`` in network i, of the i-th seed in a list, or the next one.
        :param options: ``reset_mask``, a bool for each environment, selects the environments that begin
        """
        mask = (options or {}).get("reset_mask")
        if mask is None and not _is_list(seed):
            self.worlds.begin(seed)  # type: ignore[arg-type]
        else:
            is_selected = self._values_of_worlds(True if mask is None else mask, "reset_mask")
            listed = _is_list(seed)
            seeds = self._values_of_worlds(seed if listed else None, "seed")
            for i in range(self.worlds.num_envs):
                if is_selected[i]:
                    world_seed = seeds[i] if listed or seed is None else whole(seed, "seed") + i
                    self.worlds.reset_world(i, world_seed)
        self._begun = True
        return self._returned(self._observations), self._infos()

    def step(self, actions: Any) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """Carries out the actions in every network, and simulates a step."""
        worlds = self.worlds
        require_episode(worlds, self._begun)
        checked = spaces.checked(actions, self._counts, self._camera_at, worlds.least_action)
        worlds.actions[...] = checked.reshape(worlds.actions.shape)
        worlds.step()
        ends = self._spread(worlds.ends).astype(np.bool_)
        infos = self._infos()
        if ends.any() and self.metadata["autoreset_mode"] == AutoresetMode.SAME_STEP:
            self._add_finals(infos, ends)
        never = self._never.copy() if self.copy else self._never
        return self._returned(self._observations), self._rewards(), never, ends, infos

    def _camera_at(self, index: tuple[int, ...]) -> str:
        numbers = self.worlds.actions.shape[2]
        camera = int(np.ravel_multi_index(index, self._counts.shape)) // numbers
        per_world = self._cameras_per_world
        return f"camera {self.worlds.cameras[camera % per_world]} in world {camera // per_world}"

    def _values_of_worlds(self, values: Any, name: str) -> list[Any]:
        """Returns a value for each network, given a value for each environment, or one for all."""
        listed = list(values) if _is_list(values) else [values] * self.num_envs
        each = self.num_envs // self.worlds.num_envs
        of_worlds = listed[::each]
        if len(listed) != self.num_envs or any(value != of_worlds[i // each] for i, value in enumerate(listed)):
            raise InputError(
                f"{name} is {shown(values)}, expected {self.num_envs} values, the same for all cameras of a network"
            )
        return of_worlds

    def _rewards(self) -> Array:
        if self.per == "camera":
            return self._returned(self.worlds.rewards.reshape(-1))
        return np.asarray(self.worlds.rewards.mean(axis=1))

    def _returned(self, array: Array) -> Array:
        return array.copy() if self.copy else array

    def _spread(self, of_worlds: Array) -> Array:
        """Returns a number for each environment, given one for each world."""
        return np.repeat(of_worlds, self._cameras_per_world) if self.per == "camera" else of_worlds

    def _infos(self) -> dict[str, Any]:
        return self._measured(self._masks)

    def _measured(self, masks: Array) -> dict[str, Any]:
        infos: dict[str, Any] = {} if self.worlds.kind == "rates" else {"action_mask": self._returned(masks)}
        for name, values in zip(MEASURES, self.worlds.measures.T):
            infos[name] = self._returned(self._spread(values))
        if self.worlds.detailed:
            details = self.worlds.details.reshape(-1, len(DETAILS)) if self.per == "camera" else self.worlds.details
            infos |= {name: self._returned(details[..., i]) for i, name in enumerate(DETAILS)}
        return infos

    def _add_finals(self, infos: dict[str, Any], ends: Array) -> None:
        finals = np.empty(self.num_envs, dtype=object)
        for i in np.flatnonzero(ends):
            finals[i] = self._finals[i].copy()
        infos["final_obs"] = finals
        infos["_final_obs"] = ends
        final_info = self._measured(self._final_masks)
        infos["final_info"] = final_info | {"_" + name: ends for name in final_info}
        infos["_final_info"] = ends

    def save(self) -> State:
        """Returns the present state of all networks, with their random streams."""
        return self.worlds.save(self._begun)

    def restore(self, state: State) -> tuple[Array, dict[str, Any]]:
        """Continues from a state; returns observations and infos as they were."""
        self.worlds.restore(state, bool)
        self._begun = state.own
        return self._returned(self._observations), self._infos()

    def action_masks(self) -> Array:
        """Returns the choices that are allowed now, bool (num_envs, choices)."""
        return self._masks.astype(np.bool_)

    def state(self) -> Array:
        """Returns the whole state of every network, float32 (networks, numbers)."""
        return np.array(self.worlds.state())

    def render(self) -> tuple[Array, ...] | None:
        """Returns the picture of its network for each environment."""
        if self.render_mode is None:
            return None
        pictures = [self.worlds.picture(world=i) for i in range(self.worlds.num_envs)]
        return tuple(pictures[i * len(pictures) // self.num_envs] for i in range(self.num_envs))

    def close_extras(self, **kwargs: Any) -> None:
        self.worlds.close()
        self._take_arrays()


class NetworkEnv(Remade, gymnasium.Env[Any, Any]):
    """A network for one agent, which moves all cameras and gets the mean of their rewards.

    Infos are those of ``CameraVectorEnv``; with ``details=True`` ``seen``, ``added`` and ``sent`` are arrays (C,).
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 10}

    def __init__(
        self,
        scenario: str | os.PathLike[str],
        *,
        render_mode: str | None = None,
        width: int = 800,
        **settings: Any,
    ) -> None:
        modes = self.metadata["render_modes"]
        self.worlds = rendered(scenario, render_mode, modes, settings, num_envs=1, auto_reset=False)
        self.render_mode = render_mode
        self.width = width
        self.observation_space = spaces.observation(self.worlds, len(self.worlds.cameras))
        self.action_space = spaces.joint_action(self.worlds)
        self._counts = spaces.counts(self.action_space)
        self._playing = False

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Begins the episode of a seed, or the next episode."""
        super().reset(seed=None if seed is None else whole(seed, "seed", least=0))
        self.worlds.begin(seed)
        self._playing = True
        return self.worlds.observations[0].copy(), self._info()

    def step(self, action: Any) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Carries out the actions of all cameras, and simulates a step."""
        worlds = self.worlds
        require_episode(worlds, self._playing)
        checked = spaces.checked(action, self._counts, self._camera_at, worlds.least_action)
        worlds.actions[0] = checked.reshape(worlds.actions.shape[1:])
        worlds.step()
        reward = float(worlds.rewards[0].mean())
        over = bool(worlds.ends[0])
        self._playing = not over
        return worlds.observations[0].copy(), reward, False, over, self._info()

    def save(self) -> State:
        """Returns the present state of the environment, with its random streams."""
        return self.worlds.save((self._playing, self.np_random.bit_generator.state))

    def restore(self, state: State) -> tuple[Array, dict[str, Any]]:
        """Continues from a state; returns observations and infos as they were."""
        self.worlds.restore(state, tuple)
        self._playing, self.np_random.bit_generator.state = state.own
        return self.worlds.observations[0].copy(), self._info()

    def _camera_at(self, index: tuple[int, ...]) -> str:
        return f"camera {self.worlds.cameras[index[0] // self.worlds.actions.shape[2]]}"

    def _info(self) -> dict[str, Any]:
        worlds = self.worlds
        info: dict[str, Any] = {} if worlds.kind == "rates" else {"action_mask": worlds.masks[0].copy()}
        info |= zip(MEASURES, worlds.measures[0].tolist())
        if worlds.detailed:
            info |= zip(DETAILS, worlds.details[0].T.copy())
        return info

    def render(self) -> Any:
        """Returns a picture of the last step, uint8 (height, width, 3)."""
        return None if self.render_mode is None else self.worlds.picture(self.width)

    def close(self) -> None:
        self.worlds.close()


def _is_list(value: Any) -> bool:
    return isinstance(value, Sequence) or (isinstance(value, np.ndarray) and value.ndim == 1)


def vector_env(scenario: str | os.PathLike[str], num_envs: int = 1, **settings: Any) -> CameraVectorEnv:
    """Makes networks that are stepped together as a Gymnasium ``VectorEnv``."""
    return CameraVectorEnv(scenario, num_envs, **settings)


def single_env(scenario: str | os.PathLike[str], **settings: Any) -> NetworkEnv:
    """Makes a network as a Gymnasium ``Env``."""
    return NetworkEnv(scenario, **settings)

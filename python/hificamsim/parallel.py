"""The PettingZoo environment, in which every camera is an agent."""

from __future__ import annotations

import os
import pathlib
import tempfile
from typing import Any

import numpy as np
from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from . import spaces
from .errors import InputError, flag, shown
from .remade import Remade, State
from .screen import Screen
from .worlds import DETAILS, MEASURES, Array, rendered, require_episode


class CameraEnv(Remade, ParallelEnv):  # type: ignore[misc]
    """A network of cameras as a PettingZoo environment; the agents are the cameras, by name.

    All agents end together after ``steps``: none is terminated, all are truncated. A camera that is switched off, or that an
    event adds later, stays an agent, observes zeros, and does nothing. ``infos[camera]["action_mask"]`` has the allowed
    actions; a forbidden action has no effect. Every camera needs an action: an int from 0 on, or two with
    ``actions="steps"``, or two rates in [-1, 1], which have no mask, with ``actions="rates"``. ``infos`` also have ``coverage``
    in [0, 1], ``k_min`` and ``score``; with ``details=True`` also ``seen``, ``added`` and ``sent``: the number of targets that
    the camera detected, the number that only this camera detected, and the bits that it sent.
    :param max_cycles: another name of ``steps``, usual in PettingZoo
    :param equal_spaces: whether all cameras get the action space and the masks of the camera with most views, as libraries
        with a shared policy expect; an action that a camera does not have has no effect
    """

    metadata: dict[str, Any] = {
        "name": "hificamsim_v0",
        "render_modes": ["human", "rgb_array"],
        "is_parallelizable": True,
        "render_fps": 10,
    }

    def __init__(
        self,
        scenario: str | os.PathLike[str],
        *,
        render_mode: str | None = None,
        width: int = 800,
        max_cycles: int | None = None,
        equal_spaces: bool = False,
        **settings: Any,
    ) -> None:
        if max_cycles is not None:
            if "steps" in settings:
                raise InputError(f"max_cycles is {shown(max_cycles)} beside steps, expected one of them")
            settings["steps"] = max_cycles
        self._equal = flag(equal_spaces, "equal_spaces")
        modes = self.metadata["render_modes"]
        self.worlds = rendered(scenario, render_mode, modes, settings, num_envs=1, auto_reset=False)
        self.render_mode = render_mode
        self._screen = Screen(self.worlds.name) if render_mode == "human" else None
        self.width = width
        self.possible_agents = list(self.worlds.cameras)
        self.agents: list[str] = []
        self.observation_spaces = {
            agent: spaces.observation(self.worlds) for agent in self.possible_agents
        }
        self.action_spaces = {agent: self._space(i) for i, agent in enumerate(self.possible_agents)}
        self._counts = np.array([spaces.counts(self.action_spaces[agent]) for agent in self.possible_agents])
        self.state_space = spaces.state(self.worlds)
        self._false = dict.fromkeys(self.possible_agents, False)
        self._true = dict.fromkeys(self.possible_agents, True)
        #: For wrappers that draw random numbers, such as SuperSuit's.
        self.np_random, _ = seeding.np_random()

    def observation_space(self, agent: str) -> Any:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Any:
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Array], dict[str, dict[str, Any]]]:
        """Begins the episode of a seed, or the next episode."""
        self.worlds.begin(seed)
        self.agents = self.possible_agents[:]
        if seed is not None:
            self.np_random, _ = seeding.np_random(int(seed) % 2**64)
        return self._observations(), self._infos()

    def step(
        self, actions: dict[str, Any]
    ) -> tuple[
        dict[str, Array], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]
    ]:
        """Carries out the actions of all cameras, and simulates a step."""
        worlds = self.worlds
        require_episode(worlds, bool(self.agents))
        checked = spaces.checked(self._listed(actions), self._counts, self._camera_at, worlds.least_action)
        worlds.actions[0] = checked.reshape(worlds.actions.shape[1:])
        worlds.step()
        rewards = dict(zip(self.agents, worlds.rewards[0].tolist()))
        over = bool(worlds.ends[0])
        truncations = (self._true if over else self._false).copy()
        result = self._observations(), rewards, self._false.copy(), truncations, self._infos()
        if over:
            self.agents = []
        return result

    def _listed(self, actions: dict[str, Any]) -> list[Any]:
        if not isinstance(actions, dict):
            raise InputError(f"actions are {shown(actions)}, expected a dict with one for every agent")
        try:
            listed = [actions[agent] for agent in self.agents]
        except KeyError as e:
            raise InputError(f"no action for camera {e.args[0]}, expected one for every agent") from None
        if len(actions) > len(listed):
            other = next(agent for agent in actions if agent not in self.agents)
            raise InputError(f"an action for {shown(other)}, expected none but for {', '.join(self.agents)}")
        return listed

    def _camera_at(self, index: tuple[int, ...]) -> str:
        return f"camera {self.possible_agents[index[0]]}"

    def _observations(self) -> dict[str, Array]:
        return dict(zip(self.possible_agents, self.worlds.observations[0].copy()))

    def _infos(self) -> dict[str, dict[str, Any]]:
        masks = self.worlds.masks[0].astype(np.int8)
        measured = dict(zip(MEASURES, self.worlds.measures[0].tolist()))
        infos: dict[str, dict[str, Any]] = {
            agent: {**({} if self.worlds.kind == "rates" else {"action_mask": self._mask(i, masks[i])}), **measured}
            for i, agent in enumerate(self.possible_agents)
        }
        if self.worlds.detailed:
            for info, contributed in zip(infos.values(), self.worlds.details[0].tolist()):
                info |= zip(DETAILS, contributed)
        return infos

    def _space(self, camera: int) -> Any:
        return spaces.action(self.worlds, None if self._equal else camera)

    def _mask(self, camera: int, mask: Array) -> Any:
        is_unchanged = self._equal and len(self.worlds.choices) == 1
        return mask if is_unchanged else spaces.mask(self.worlds, camera, mask)

    def state(self) -> Array:
        """Returns the whole state of the world, float32 in [-1, 1]."""
        return np.array(self.worlds.state()[0])

    def save(self) -> State:
        """Returns the present state of the environment, with its random streams."""
        return self.worlds.save((bool(self.agents), self.np_random.bit_generator.state))

    def restore(self, state: State) -> tuple[dict[str, Array], dict[str, dict[str, Any]]]:
        """Continues from a state; returns observations and infos as they were."""
        self.worlds.restore(state, tuple)
        playing, self.np_random.bit_generator.state = state.own
        self.agents = self.possible_agents[:] if playing else []
        return self._observations(), self._infos()

    def render(self) -> Array | None:
        """Shows the last step as ``render_mode`` says: as a picture, uint8 (height, width, 3), or in a window."""
        if self.render_mode is None:
            return None
        picture = self.worlds.picture(self.width)
        if self._screen is None:
            return picture
        self._screen.show(picture)
        return None

    def report(self, folder: str | os.PathLike[str]) -> pathlib.Path:
        """Writes the episode so far into a folder, as ``run --record`` does, and returns its page."""
        from .results import record

        played = self.worlds.played()
        if not len(played):
            raise InputError("the episode has no step yet, expected one or more")
        with tempfile.TemporaryDirectory() as scratch:
            file = pathlib.Path(scratch, "actions")
            file.write_bytes(played.astype("<i4").tobytes())
            return record(self.worlds, file, len(played), folder)

    def close(self) -> None:
        """Ends the environment."""
        self.agents = []
        if self._screen is not None:
            self._screen.close()
        self.worlds.close()


def parallel_env(scenario: str | os.PathLike[str], **settings: Any) -> CameraEnv:
    """Makes a network of cameras as a PettingZoo ``ParallelEnv``; the settings are those of ``Worlds``."""
    return CameraEnv(scenario, **settings)


def env(scenario: str | os.PathLike[str], **settings: Any) -> Any:
    """Makes a network of cameras as an ``AECEnv``, by PettingZoo's own conversion."""
    from pettingzoo.utils.conversions import parallel_to_aec

    return parallel_to_aec(parallel_env(scenario, **settings))

"""Simulations that are stepped by one call; the arrays are shared with the simulator."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from .backends import open_backend
from .errors import Closed, InputError, NoEpisode, flag, path, plain, shown, whole
from .remade import Remade, State

Array = npt.NDArray[Any]

DETAILS = ("seen", "added", "sent")  # the names of the numbers in ``details``
MEASURES = ("coverage", "k_min", "score")  # the names of the numbers in ``measures``

SCENARIOS = pathlib.Path(__file__).resolve().parent / "scenarios"


def scenarios() -> list[str]:
    """Returns the names of the scenarios that come with the package."""
    return sorted(file.stem for file in shipped().glob("*.xml"))


def shipped() -> pathlib.Path:
    """Returns the folder of the scenarios."""
    return pathlib.Path(os.environ.get("HIFICAMSIM_SCENARIOS") or SCENARIOS)


TASKS = "bench/"  # the prefix of tasks' names
TESTING = tuple(range(1_000_001, 1_000_011))  # the seeds of the testing episodes of tasks


def tasks() -> list[str]:
    """Returns the names of the benchmark's tasks, as ``bench/campus-v1``."""
    file = shipped() / "benchmark.json"
    return [TASKS + name for name in json.loads(file.read_text(encoding="utf-8"))] if file.exists() else []


def scenario_file(scenario: str | os.PathLike[str]) -> str:
    """Returns the file of a scenario, given a file or the name of a scenario of the package."""
    text = path(scenario, "scenario")
    named = shipped() / f"{text}.xml"
    if not os.path.isfile(text) and os.path.exists(named):
        return str(named)
    if not os.path.isfile(text):
        raise InputError(
            f"scenario {shown(text)} is no file, and none of those that come with the package: "
            + ", ".join(tasks() if text.startswith(TASKS) else scenarios())
        )
    return os.path.abspath(text)


class Worlds(Remade):
    """``num_envs`` worlds of one scenario.
    World i begins with ``seed + i``; its first episode equals that of ``hificamsim run --seed``. Results depend on
    seeds and actions alone, not on the number of worlds or threads, or on the backend.
    The arrays belong to the simulator and change with every call; copy those that you keep. B is the number of
    worlds, C of cameras, F of numbers of an observation, A of numbers of an action.

    - ``actions`` int32 (B, C, A): written before ``step``
    - ``observations`` float32 (B, C, F), see ``features``
    - ``finals`` float32 (B, C, F): the last observations of episodes that ended in this step
    - ``rewards`` float32 (B, C)
    - ``masks`` uint8 (B, C, M): 1 for the allowed choices of a camera; ``final_masks``: those of ``finals``
    - ``ends`` uint8 (B,): 1 where the episode ended in this step
    - ``measures`` float32 (B, 3): the share of targets covered, k_min, and the score by the objective
    - ``advice`` int32 (B, C): with an ``expert``, the view that it chose at the last decision; -1 for a camera that
      did not decide, since it was offline or moving
    - ``details`` float32 (B, C, 3): with the setting of that name, the number of targets that a camera detected in the
      last step, the number that only this camera detected, and the bits that it sent; 0 without the setting
    - ``states`` float32 (B, S): written by ``state``

    Settings are given by name. The simulator checks them, and has their defaults:
    - settings of a run: detection, threshold, detect, objective, channel, order, headings, steps (of an episode) and seed
      (of the first world), like the options of ``hificamsim run``
    - reward: coverage, kmin, score, difference or thesis
    - actions: view (the number of a view), steps (pan and zoom, each down, stay or up) or rates (the speeds of turning and
      zooming; in ``actions`` from 0, to the left or narrower, over 1000, which stops, to 2000)
    - targets, neighbours: the number of nearest seen targets, and of nearest cameras, in an observation
    - belief: whether observations end with what each view of a camera promises by the belief that the cameras share;
      see ``of_views``
    - auto_reset: True or ``same-step``: the next episode begins in the call that ends one; ``next-step``: in the
      following call, whose actions have no effect; False or ``disabled``: after a ``reset``
    - expert: a policy, such as ``cooperative``, whose choices of each step are in ``advice``; an action of -1 adopts
      them
    - details: whether ``details`` are measured; environments have them in ``infos``
    - paints: whether ``picture`` may be called
    - saves: whether ``save`` may be called; by default yes with at most 1,000 worlds
    :param scenario: a name of ``scenarios()`` or ``tasks()``, or a file
    :param testing: whether the testing seeds of a task are allowed, for checking entries
    :param threads: the number of threads that share the worlds; by default that of the processors for 16 or more worlds
    :param backend: jvm (in this process) or process; by default jvm if JPype is installed
    """

    def __init__(
        self,
        scenario: str | os.PathLike[str],
        num_envs: int = 1,
        *,
        threads: int | None = None,
        backend: str | None = None,
        testing: bool = False,
        **settings: Any,
    ) -> None:
        task = str(scenario) if str(scenario) in tasks() else None
        self.file = scenario_file(scenario) if task is None else str(shipped() / "benchmark.json")
        self.num_envs = num_envs = whole(num_envs, "num_envs")
        self._testing = testing = flag(testing, "testing")
        self._refused_seeds = () if testing or task is None else TESTING
        self._check_seed(whole(settings.get("seed") or 0, "seed"), num_envs)
        if threads is None:
            threads = (os.cpu_count() or 1) if num_envs >= 16 else 1
        #: The settings by name, without those that have their defaults.
        self.settings = {key: plain(value, key) for key, value in settings.items() if value is not None}
        for name, expected in (("worlds", "num_envs"), ("task", "a task's name as scenario")):
            if name in settings:
                raise InputError(f"unknown setting {name!r}, expected {expected}")
        own = {"scenario": self.file, "worlds": num_envs, "threads": whole(threads, "threads")}
        if task is not None:
            own["task"] = task
        self._backend = open_backend(backend, {**self.settings, **own})
        self._begun = False
        self._closed = False
        description = self._backend.description
        self.name: str = description["scenario"]
        self.cameras: list[str] = description["cameras"]
        self.views: list[int] = description["views"]
        self.num_targets: int = description["targets"]
        #: The number of steps of an episode: that of the settings, or else the scenario's, or else 1000.
        self.episode_steps: int = description["steps"]
        self.run_settings: list[str] = description["settings"]
        self.choices: list[int] = description["choices"]
        #: The kind of actions: view, steps or rates.
        self.kind: str = str(self.settings.get("actions", "view"))
        #: The least value in an action: -1, which adopts the expert's choice, or 0.
        self.least_action = -1 if "expert" in self.settings and self.kind != "rates" else 0
        self.features: list[dict[str, Any]] = description["features"]
        arrays = {part["name"]: self._array(part) for part in description["sections"]}
        self._arrays = list(arrays)
        self.actions = arrays["actions"]
        self.observations = arrays["observations"]
        self.finals = arrays["finals"]
        self.rewards = arrays["rewards"]
        self.masks = arrays["masks"]
        self.final_masks = arrays["final_masks"]
        self.ends = arrays["ends"]
        self.measures = arrays["measures"]
        self.advice = arrays["advice"]
        self.details = arrays["details"]
        #: Whether ``details`` are measured.
        self.detailed = bool(self.settings.get("details"))
        self.states = arrays["states"]
        #: Steps every world by one: reads ``actions`` and writes all but ``states``.
        self.step: Callable[[], None] = self._backend.step

    def _array(self, section: dict[str, Any]) -> Array:
        count = int(np.prod(section["shape"]))
        flat = np.frombuffer(self._backend.memory, section["type"], count, section["offset"])
        shaped: Array = flat.reshape(section["shape"])
        return shaped

    def bounds(self) -> tuple[Array, Array]:
        """Returns the lowest and the highest value of each number of an observation, (F,) each."""
        low = np.array([feature["low"] for feature in self.features], np.float32)
        return low, np.array([feature["high"] for feature in self.features], np.float32)

    def of_views(self, observations: Array) -> Array:
        """Returns the belief in observations (..., F): float32 (..., V, 10), a row for each view with numbers as in
        ``features``. V is the greatest number of views of a camera; rows of views that a camera does not have are 0.
        """
        names = [feature["name"] for feature in self.features]
        first = names.index("view0_exists") if "view0_exists" in names else len(names)
        size = sum(name.startswith("view0_") for name in names)
        if not size:
            raise InputError("observations have no belief, expected belief=True")
        belief: Array = observations[..., first:].reshape(*observations.shape[:-1], -1, size)
        return belief

    def reset(self, seed: int | None = None) -> None:
        """Begins an episode in every world: that of ``seed + i`` in world i, or the next one."""
        self.reset_world(-1, seed)

    def reset_world(self, world: int, seed: int | None = None) -> None:
        """Begins an episode in one world, that of a seed or the next one; other worlds are unchanged."""
        number = 0 if seed is None else whole(seed, "seed")
        world = whole(world, "world", -1, self.num_envs - 1)
        if seed is not None:
            self._check_seed(number, self.num_envs if world < 0 else 1)
        self._backend.reset(world, number, seed is not None)

    def _check_seed(self, seed: int, count: int) -> None:
        """Rejects seeds that are kept for testing."""
        for refused in self._refused_seeds:
            if seed <= refused < seed + count:
                raise InputError(f"seed {refused} is for testing, expected one below {TESTING[0] - 1}")

    def begin(self, seed: int | None) -> None:
        """Begins an episode like ``reset``, but the first call without a seed uses that of the settings."""
        if seed is None and not self._begun:
            seed = self.episode_seed()
        self.reset(seed)
        self._begun = True

    def state(self) -> Array:
        """Writes and returns the state of every world, (B, S), without copying it."""
        self._backend.state()
        return self.states

    def save(self, own: Any = None) -> State:
        """Returns the state of all worlds, from which ``restore`` continues exactly, together with ``own``."""
        return State(self._backend.save(), self._identity(), own)

    def restore(self, state: State, own: type = object) -> None:
        """Continues from a state of these worlds, or of others with the same settings.

        :param own: the type of what must have been saved together with the state
        """
        if not isinstance(state, State):
            raise InputError(f"state is {shown(state)}, expected what save() returned")
        state.check(self._identity(), own)
        self._backend.restore(state.worlds)
        self._begun = True

    def _identity(self) -> dict[str, Any]:
        """Returns the settings that the worlds of a state must share."""
        settings = {name: value for name, value in self.settings.items() if name not in ("seed", "paints", "saves")}
        return {"scenario": self.name, "num_envs": self.num_envs, "testing": self._testing, **settings}

    def played(self) -> Array:
        """Returns the actions of the first world's episode so far, int32 (steps, C, A)."""
        data = self._backend.save()
        start = self._backend.description["bytes"] + 16  # after the memory, and the seed and number of the episode
        count = int.from_bytes(data[start : start + 4], "big")
        return np.frombuffer(data, ">i2", count, start + 4).astype(np.int32).reshape(-1, *self.actions.shape[1:])

    def episode_seed(self) -> int:
        """Returns the seed of the present episode of the first world."""
        return self._backend.seed()

    def picture(self, width: int = 800, world: int = 0) -> Array:
        """Returns a picture of a world, uint8 (height, width, 3); ``width`` is from 1 to 10,000."""
        pixels = whole(width, "width", -(2**31), 2**31 - 1)  # the simulator checks the range
        data = self._backend.picture(whole(world, "world", 0, self.num_envs - 1), pixels)
        wide, high = np.frombuffer(data, ">i4", 2)
        picture: Array = np.frombuffer(data, np.uint8, offset=8).reshape(high, wide, 3).copy()
        return picture

    def close(self) -> None:
        """Ends the worlds. A JVM in this process continues, since it can be started only once.

        The arrays become copies, so that the shared memory is freed.
        """
        self._backend.close()
        self._closed = True
        for name in self._arrays:
            setattr(self, name, getattr(self, name).copy())

    def __enter__(self) -> Worlds:
        return self

    def __exit__(self, *fault: object) -> None:
        self.close()


def require_episode(worlds: Worlds, playing: bool) -> None:
    """Rejects a step of an environment that was closed or has no episode."""
    if worlds._closed:
        raise Closed("the environment was closed, expected a new one")
    if not playing:
        raise NoEpisode("the environment has no episode, or its episode is over: expected reset()")


def rendered(
    scenario: str | os.PathLike[str], mode: str | None, modes: list[str], settings: dict[str, Any], **own: Any
) -> Worlds:
    """Makes worlds of an environment, which are painted unless its ``render_mode`` is None.
    :param mode: the ``render_mode``, None or one of ``modes``
    :param own: settings that the environment makes and its user cannot choose
    """
    for name in ("paints", *own):
        if name in settings:
            raise InputError(f"unknown setting {name!r}: the environment has its own, expected another or Worlds")
    if mode is not None and not (isinstance(mode, str) and mode in modes):
        raise InputError(f"render_mode is {shown(mode)}, expected None or {' or '.join(map(repr, modes))}")
    return Worlds(scenario, paints=mode is not None, **own, **settings)

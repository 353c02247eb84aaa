"""Simulations side by side, stepped by one call; the arrays are shared with the simulator."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from .backends import open_backend
from .errors import Closed, InputError, NoEpisode, path, plain, shown, whole
from .remade import Remade, State

Array = npt.NDArray[Any]

DETAILS = ("seen", "added", "sent")  # what ``details`` has, by name
MEASURES = ("coverage", "k_min", "score")  # what ``measures`` has, by name

SCENARIOS = pathlib.Path(__file__).resolve().parent / "scenarios"


def scenarios() -> list[str]:
    """The names of the scenarios that come with the package."""
    return sorted(file.stem for file in shipped().glob("*.xml"))


def shipped() -> pathlib.Path:
    """The folder of the scenarios."""
    return pathlib.Path(os.environ.get("HIFICAMSIM_SCENARIOS") or SCENARIOS)


TASKS = "bench/"  # what names of tasks begin with
TESTING = tuple(range(1_000_001, 1_000_011))  # the seeds of their testing episodes


def tasks() -> list[str]:
    """The names of the benchmark's tasks, as ``bench/campus-v1``."""
    file = shipped() / "benchmark.json"
    return [TASKS + name for name in json.loads(file.read_text(encoding="utf-8"))] if file.exists() else []


def scenario_file(scenario: str | os.PathLike[str]) -> str:
    """The file of a scenario: one of the package's by its name, or any file."""
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

    World i begins with ``seed + i``: its first episode is the run of ``hificamsim run --seed``. What comes out
    depends on seeds and actions alone, not on the number of worlds or threads, or on the backend.

    The arrays belong to the simulator and change with every call; copy what is to stay. B is the number of
    worlds, C of cameras, F of numbers of an observation, A of numbers of an action.

    - ``actions`` int32 (B, C, A): written before ``step``
    - ``observations`` float32 (B, C, F), see ``features``
    - ``finals`` float32 (B, C, F): the last observations of episodes that ended in this step
    - ``rewards`` float32 (B, C)
    - ``masks`` uint8 (B, C, M): 1 for what a camera may do; ``final_masks``, of ``finals``
    - ``ends`` uint8 (B,): 1 where the episode ended in this step
    - ``measures`` float32 (B, 3): share of targets covered, k_min, score by the objective
    - ``advice`` int32 (B, C): with an ``expert``, the view that it chose at the decision before; -1 for a camera that
      was offline or on its way, and did not decide
    - ``details`` float32 (B, C, 3), with the setting of that name, else 0: of the last step how many targets a camera
      detected, how many of them no other one did, and how many bits it sent
    - ``states`` float32 (B, S): written by ``state``

    Settings are given by name; the simulator checks them and has their defaults:

    - those of a run: detection, threshold, detect, objective, channel, order, headings, steps (of an episode) and seed (of the
      first world), as the options of ``hificamsim run``
    - reward: coverage, kmin, score, difference or thesis
    - actions: view (the number of a view), steps (pan and zoom, each down, stay or up) or rates (how fast it turns and
      zooms; in ``actions`` from 0, to the left or narrower, over 1000, not at all, to 2000)
    - targets, neighbours: how many of the nearest seen targets and of the nearest cameras are observed
    - belief: whether observations end with what each view of a camera promises by the belief that the cameras share;
      see ``of_views``
    - auto_reset: True or ``same-step``: the next episode begins within the call that ends one; ``next-step``: in the
      call that follows, whose actions do not count; False or ``disabled``: after a ``reset``
    - expert: a policy, as ``cooperative``, that is asked in each step what it would do: ``advice``; an action of -1
      does it
    - details: whether ``details`` are measured; environments have them in ``infos``
    - paints: whether ``picture`` will be asked for
    - saves: whether ``save`` will be asked for; by default, with at most 1,000 worlds

    :param scenario: a name of ``scenarios()`` or ``tasks()``, or a file
    :param testing: whether the testing seeds of a task are allowed, for those who check entries
    :param threads: that share the worlds; by default as many as there are processors, from 16 worlds on
    :param backend: jvm (in this process) or process; by default jvm where JPype is installed
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
        self._testing = testing
        self._refused_seeds = () if testing or task is None else TESTING
        self._check_seed(whole(settings.get("seed") or 0, "seed"), num_envs)
        if threads is None:
            threads = (os.cpu_count() or 1) if num_envs >= 16 else 1
        #: What was asked for, by name.
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
        said = self._backend.description
        self.name: str = said["scenario"]
        self.cameras: list[str] = said["cameras"]
        self.views: list[int] = said["views"]
        self.num_targets: int = said["targets"]
        #: How many steps an episode has: those asked for, else the scenario's, else 1000.
        self.episode_steps: int = said["steps"]
        self.run_settings: list[str] = said["settings"]
        self.choices: list[int] = said["choices"]
        #: What an action is.
        self.kind: str = str(self.settings.get("actions", "view"))
        #: The least that a number of an action may be: -1, which does what the expert advises, or 0.
        self.least_action = -1 if "expert" in self.settings and self.kind != "rates" else 0
        self.features: list[dict[str, Any]] = said["features"]
        arrays = {part["name"]: self._array(part) for part in said["sections"]}
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
        """The least and the most that each number of an observation can be, (F,) each."""
        low = np.array([feature["low"] for feature in self.features], np.float32)
        return low, np.array([feature["high"] for feature in self.features], np.float32)

    def of_views(self, observations: Array) -> Array:
        """The belief in observations (..., F): float32 (..., V, 10), a row for each view, the numbers as in ``features``.

        V is the number of views of the camera that has most; the rows of views that a camera has not are 0.
        """
        names = [feature["name"] for feature in self.features]
        first = names.index("view0_exists") if "view0_exists" in names else len(names)
        size = sum(name.startswith("view0_") for name in names)
        if not size:
            raise InputError("observations have no belief, expected belief=True")
        belief: Array = observations[..., first:].reshape(*observations.shape[:-1], -1, size)
        return belief

    def reset(self, seed: int | None = None) -> None:
        """Begins an episode in every world: of new seeds from this one on, or each its next one."""
        self.reset_world(-1, seed)

    def reset_world(self, world: int, seed: int | None = None) -> None:
        """Begins an episode in one world, of this seed or its next one; the others stay as they are."""
        number = 0 if seed is None else whole(seed, "seed")
        world = whole(world, "world", -1, self.num_envs - 1)
        if seed is not None:
            self._check_seed(number, self.num_envs if world < 0 else 1)
        self._backend.reset(world, number, seed is not None)

    def _check_seed(self, seed: int, count: int) -> None:
        """Refuses seeds that are kept for testing."""
        for refused in self._refused_seeds:
            if seed <= refused < seed + count:
                raise InputError(f"seed {refused} is for testing, expected one below {TESTING[0] - 1}")

    def begin(self, seed: int | None) -> None:
        """As ``reset``; but the first time, no seed means that of the settings."""
        if seed is None and not self._begun:
            seed = self.episode_seed()
        self.reset(seed)
        self._begun = True

    def state(self) -> Array:
        """The state of every world, (B, S); a view."""
        self._backend.state()
        return self.states

    def save(self, own: Any = None) -> State:
        """The state of all worlds, from which ``restore`` goes on exactly; ``own`` is kept with it."""
        return State(self._backend.save(), self._identity(), own)

    def restore(self, state: State) -> None:
        """Goes on from a state of these worlds, or of others with the same settings."""
        if not isinstance(state, State):
            raise InputError(f"state is {shown(state)}, expected what save() returned")
        state.check(self._identity())
        self._backend.restore(state.worlds)
        self._begun = True

    def _identity(self) -> dict[str, Any]:
        """The settings that the worlds of a state must have."""
        asked = {name: value for name, value in self.settings.items() if name not in ("seed", "paints", "saves")}
        return {"scenario": self.name, "num_envs": self.num_envs, "testing": self._testing, **asked}

    def played(self) -> Array:
        """The actions of the first world's episode so far, int32 (steps, C, A)."""
        data = self._backend.save()
        at = self._backend.description["bytes"] + 16  # after the memory, and the seed and number of the episode
        count = int.from_bytes(data[at : at + 4], "big")
        return np.frombuffer(data, ">i2", count, at + 4).astype(np.int32).reshape(-1, *self.actions.shape[1:])

    def episode_seed(self) -> int:
        """The seed of the episode that the first world is in."""
        return self._backend.seed()

    def picture(self, width: int = 800, world: int = 0) -> Array:
        """A world as it is now, uint8 (height, width, 3); ``width`` from 1 to 10,000."""
        pixels = whole(width, "width", -(2**31), 2**31 - 1)  # the simulator knows how wide a picture may be
        data = self._backend.picture(whole(world, "world", 0, self.num_envs - 1), pixels)
        wide, high = np.frombuffer(data, ">i4", 2)
        picture: Array = np.frombuffer(data, np.uint8, offset=8).reshape(high, wide, 3).copy()
        return picture

    def close(self) -> None:
        """Ends the worlds. A JVM in this process goes on: it can be started only once.

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
    """Worlds that are painted where an environment's ``render_mode`` says so, which is None or one of ``modes``.

    :param own: settings of the environment, which its user does not choose
    """
    for name in ("paints", *own):
        if name in settings:
            raise InputError(f"unknown setting {name!r}: the environment has its own, expected another or Worlds")
    if mode is not None and not (isinstance(mode, str) and mode in modes):
        raise InputError(f"render_mode is {shown(mode)}, expected None or {' or '.join(map(repr, modes))}")
    return Worlds(scenario, paints=mode is not None, **own, **settings)

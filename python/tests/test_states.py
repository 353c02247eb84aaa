"""Tests pickling, copying, saving and restoring environments, and using them in threads."""

from __future__ import annotations

import contextlib
import copy
import dataclasses
import os
import pathlib
import pickle
import signal
import threading
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode

import hificamsim
from test_faults import python

MAKERS: dict[str, Callable[..., Any]] = {
    "parallel": lambda **settings: hificamsim.parallel_env("corridor", steps=40, **settings),
    "single": lambda **settings: hificamsim.single_env("corridor", steps=40, **settings),
    "same step": lambda **settings: hificamsim.vector_env("corridor", 3, steps=15, per="camera", **settings),
    "next step": lambda **settings: hificamsim.vector_env(
        "corridor", 3, steps=15, autoreset_mode=AutoresetMode.NEXT_STEP, **settings
    ),
    "expert": lambda **settings: hificamsim.parallel_env("corridor", steps=40, expert="cooperative", **settings),
    "task": lambda **settings: hificamsim.parallel_env("bench/passage-v1", **settings),
}


def played(env: Any, steps: int, seed: int) -> list[str]:
    """Plays steps of random actions, and returns all their results as text."""
    random = np.random.default_rng(seed)
    results = []
    with np.printoptions(threshold=10**9, precision=17):
        for _ in range(steps):
            if isinstance(env, hificamsim.CameraEnv):
                actions: Any = {agent: int(random.integers(0, 3)) for agent in env.agents}
            else:
                actions = random.integers(0, 3, env.action_space.shape)
            results.append(repr(env.step(actions)))
    return results


@pytest.mark.parametrize("kind", MAKERS)
def test_restored_environment_continues_with_same_bytes(kind: str, backend: str) -> None:
    with contextlib.closing(MAKERS[kind](backend=backend)) as env, contextlib.closing(MAKERS[kind]()) as other:
        env.reset(seed=7)
        played(env, 20, seed=1)
        state = pickle.loads(pickle.dumps(env.save()))
        arrays = {name: getattr(env.worlds, name).tobytes() for name in ("observations", "rewards", "masks", "ends")}
        expected = played(env, 12, seed=2)
        for fresh in (env, other):
            fresh.restore(state)
            assert {name: getattr(fresh.worlds, name).tobytes() for name in arrays} == arrays
            assert played(fresh, 12, seed=2) == expected


def test_state_has_random_streams_of_environment() -> None:
    env = hificamsim.parallel_env("corridor")
    env.reset(seed=3)
    state = env.save()
    drawn = env.np_random.random(4)
    env.restore(state)
    assert (env.np_random.random(4) == drawn).all()
    env.close()


def test_rejects_state_that_does_not_fit() -> None:
    env = hificamsim.parallel_env("corridor", steps=40)
    env.reset(seed=3)
    state = env.save()
    with pytest.raises(hificamsim.InputError, match="state is of steps=40, expected 9"):
        hificamsim.parallel_env("corridor", steps=9).restore(state)
    with pytest.raises(hificamsim.InputError, match="state is of scenario='corridor', expected 'campus'"):
        hificamsim.parallel_env("campus", steps=40).restore(state)
    with pytest.raises(hificamsim.InputError, match="state is damaged"):
        env.restore(dataclasses.replace(state, worlds=state.worlds[:-3]))
    with pytest.raises(hificamsim.InputError, match="state is 5, expected what save"):
        env.restore(5)
    with pytest.raises(hificamsim.InputError, match="state is of another kind of environment"):
        env.restore(env.worlds.save())
    with hificamsim.Worlds("corridor", saves=False) as worlds:
        with pytest.raises(hificamsim.InputError, match="expected saves= to save a state"):
            worlds.save()


@pytest.mark.parametrize("kind", MAKERS)
@pytest.mark.parametrize("copied", [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))], ids=["copy", "pickle"])
def test_copy_is_new_environment_with_same_settings(kind: str, copied: Callable[[Any], Any]) -> None:
    env = MAKERS[kind]()
    env.reset(seed=5)
    played(env, 3, seed=1)
    other = copied(env)
    assert type(other) is type(env)
    assert other.worlds.settings == env.worlds.settings
    env.reset(seed=9)
    other.reset(seed=9)
    assert played(env, 10, seed=4) == played(other, 10, seed=4)
    env.close()
    played(other, 1, seed=1)
    other.close()


def test_supersuit_makes_vector_environments_and_skips_frames() -> None:
    supersuit = pytest.importorskip("supersuit")
    padded = supersuit.pad_action_space_v0(hificamsim.parallel_env("lattice-random", steps=5))
    envs = supersuit.concat_vec_envs_v1(
        supersuit.pettingzoo_env_to_vec_env_v1(padded), 2, num_cpus=1, base_class="gymnasium"
    )
    observations, _ = envs.reset(seed=1)
    assert len(observations) == 2 * len(padded.possible_agents)
    envs.step(np.array([envs.action_space.sample() for _ in observations]))
    envs.close()
    skipping = supersuit.frame_skip_v0(hificamsim.parallel_env("corridor"), 3)
    skipping.reset(seed=1)
    skipping.step({agent: 0 for agent in skipping.agents})
    skipping.close()


def test_gymnasium_makes_vectors_in_processes() -> None:
    hificamsim.register()
    envs = gymnasium.make_vec("hificamsim/corridor-v1", num_envs=2, vectorization_mode="async")
    envs.reset(seed=1)
    envs.step(envs.action_space.sample())
    envs.close()


@pytest.mark.parametrize("make", ["parallel", "single", "same step"])
def test_step_needs_episode(make: str, backend: str) -> None:
    env = MAKERS[make](backend=backend)
    with pytest.raises(RuntimeError, match=r"expected reset\(\)"):
        env.step("nonsense")
    env.reset(seed=1)
    if make != "same step":
        played(env, 40, seed=1)
        with pytest.raises(RuntimeError, match=r"expected reset\(\)"):
            env.step("nonsense")
        env.reset()
        played(env, 1, seed=1)
    env.close()
    with pytest.raises(hificamsim.Closed):
        env.step("nonsense")


def test_worlds_that_wait_for_a_reset_have_no_episode(backend: str) -> None:
    with hificamsim.Worlds("corridor", steps=1, auto_reset=False, backend=backend) as worlds:
        worlds.step()
        with pytest.raises(hificamsim.NoEpisode, match="the episode of 1 steps is over, expected a reset"):
            worlds.step()
        worlds.reset()
        worlds.step()


def test_max_cycles_is_steps() -> None:
    env = hificamsim.parallel_env("corridor", max_cycles=7)
    assert env.worlds.episode_steps == 7
    env.close()
    with pytest.raises(hificamsim.InputError, match="max_cycles is 7 beside steps, expected one of them"):
        hificamsim.parallel_env("corridor", max_cycles=7, steps=8)


def test_final_infos_are_those_of_last_step() -> None:
    envs = hificamsim.vector_env("campus", 2, steps=3)
    ending = hificamsim.vector_env("campus", 2, steps=3, autoreset_mode=AutoresetMode.DISABLED)
    for env in (envs, ending):
        env.reset(seed=1)
        env.action_space.seed(4)
    for _ in range(3):
        infos = envs.step(envs.action_space.sample())[-1]
        expected = ending.step(ending.action_space.sample())[-1]
    final = infos["final_info"]
    assert infos["_final_info"].all() and final["_coverage"].all()
    for name, values in expected.items():
        assert (final[name] == values).all(), name
    assert (final["action_mask"] != infos["action_mask"]).any()
    envs.close()
    ending.close()


def test_policy_of_benchmark_may_keep_observations(tmp_path: pathlib.Path) -> None:
    class Keeping:
        """Counts the steps in which a kept observation is unchanged."""

        kept: Any = None
        equal = 0

        def __call__(self, observations: Any, masks: Any) -> Any:
            if self.kept is not None:
                self.equal += int((self.kept == self.copied).all())
            self.kept, self.copied = observations, observations.copy()
            return [np.flatnonzero(mask)[0] for mask in masks]

    policy = Keeping()
    hificamsim.benchmark(policy, tmp_path / "entry", name="keeping", only=["passage-v1"])
    assert policy.equal == 10 * 100 - 1


def test_rejects_testing_seeds_of_tasks() -> None:
    with pytest.raises(hificamsim.InputError, match="seed 1000001 is for testing, expected one below 1000000"):
        hificamsim.dataset("bench/passage-v1", "cooperative", episodes=5, seed=999_998)
    with pytest.raises(hificamsim.InputError, match="seed 1000004 is for testing"):
        hificamsim.make("bench/passage-v1").reset(seed=1_000_004)
    with pytest.raises(hificamsim.InputError, match="seed 1000001 is for testing"):
        hificamsim.vector_env("bench/passage-v1", 2, seed=1_000_000)
    with hificamsim.Worlds("bench/passage-v1", 2, seed=1_000_000, testing=True) as checked:
        assert checked.episode_seed() == 1_000_000
        state = checked.save()
    with hificamsim.Worlds("bench/passage-v1", 2) as training:
        with pytest.raises(hificamsim.InputError, match="the state is of testing=True, expected False"):
            training.restore(state)
    with pytest.raises(hificamsim.InputError, match="unknown setting 'task', expected a task's name as scenario"):
        hificamsim.Worlds(f"{hificamsim.worlds.shipped()}/benchmark.json", task="passage-v1", seed=1_000_001)
    with hificamsim.Worlds("passage", seed=1_000_001) as scenario:
        assert scenario.episode_seed() == 1_000_001


def test_rejects_two_threads_in_one_environment(backend: str) -> None:
    env = hificamsim.vector_env("corridor", 4, steps=50, backend=backend)
    env.reset(seed=1)
    actions = env.action_space.sample()
    faults: list[BaseException] = []

    def play() -> None:
        for _ in range(300):
            try:
                env.step(actions)
            except hificamsim.InUse as fault:
                faults.append(fault)

    threads = [threading.Thread(target=play) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all("one environment for each thread" in str(fault) for fault in faults)
    assert faults
    env.step(actions)
    env.close()


def test_environment_in_use_can_be_closed_afterwards() -> None:
    worlds = hificamsim.Worlds("corridor", backend="jvm")
    backend = worlds._backend
    with backend._call._busy:  # as while another thread steps
        with pytest.raises(hificamsim.InUse):
            worlds.close()
        assert backend._closer.alive
    worlds.close()
    assert not backend._closer.alive
    with pytest.raises(hificamsim.Closed):
        worlds.step()


@pytest.mark.parametrize("ending", ["before", "after"])
def test_python_exits_if_thread_made_first_environment(ending: str) -> None:
    done = python(
        f"""
        import threading, hificamsim
        def play():
            env = hificamsim.parallel_env("corridor", steps=300)
            env.reset(seed=1)
            while env.agents:
                env.step(dict.fromkeys(env.agents, 0))
        threads = [threading.Thread(target=play) for _ in range(3)]
        for thread in threads: thread.start()
        if {ending == "before"}:
            for thread in threads: thread.join()
        print("main is done")
        """
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout == "main is done\n"


@pytest.mark.parametrize("call", ["first.step()", 'hificamsim.Worlds("corridor", 4)'])
@pytest.mark.parametrize("ending", ["time.sleep(.5)", "os.kill(os.getpid(), signal.SIGINT), thread.join()"])
def test_python_exits_while_daemon_thread_calls_java(call: str, ending: str) -> None:
    done = python(
        f"""
        import os, signal, threading, time, hificamsim
        first = hificamsim.Worlds("corridor", 4, backend="jvm")
        def play():
            while True: {call}
        thread = threading.Thread(target=play, daemon=True)
        thread.start()
        {ending}
        """
    )
    assert done.returncode in (0, -signal.SIGINT), done.stderr
    assert "java" not in done.stderr.lower()


@pytest.mark.parametrize("options", ["-Xnonsense", "-Xmx1k", "-XX:+UseNonsenseGC"])
def test_reports_options_that_java_does_not_know(options: str, backend: str) -> None:
    done = python(
        f"""
        import hificamsim
        try: hificamsim.parallel_env("corridor", backend={backend!r})
        except hificamsim.JavaError as fault: print(fault)
        """,
        HIFICAMSIM_OPTS=options,
    )
    assert "Java does not start" in done.stdout, done.stderr
    assert f"(HIFICAMSIM_OPTS is '{options}')" in done.stdout
    assert len(done.stdout.splitlines()) == 1


def test_garbage_collector_of_user_replaces_default(backend: str) -> None:
    done = python(
        f"import hificamsim; hificamsim.parallel_env('corridor', backend={backend!r})",
        HIFICAMSIM_OPTS="-XX:+UseParallelGC",
    )
    assert done.returncode == 0, done.stderr


def test_closed_worker_leaves_no_file_open() -> None:
    if not os.path.isdir("/proc/self/fd"):
        pytest.skip("this system does not list the files that are open")
    before = len(os.listdir("/proc/self/fd"))
    envs = [hificamsim.vector_env("corridor", 2, backend="process") for _ in range(3)]
    for env in envs:
        env.reset(seed=1)
        env.close()
    assert len(os.listdir("/proc/self/fd")) == before
    assert envs[0].worlds.observations.shape[0] == 2


def test_rejects_setting_that_is_not_finite() -> None:
    with pytest.raises(hificamsim.InputError, match="threshold is nan, expected a finite number"):
        hificamsim.Worlds("corridor", threshold=float("nan"))


def test_every_environment_accepts_advice_of_expert() -> None:
    for make in ("parallel", "single", "same step"):
        env = MAKERS[make](expert="cooperative")
        env.reset(seed=1)
        minus = dict.fromkeys(env.agents, -1) if make == "parallel" else np.full(env.action_space.shape, -1)
        env.step(minus)
        env.close()
    env = hificamsim.parallel_env("corridor")
    env.reset(seed=1)
    with pytest.raises(hificamsim.InputError, match="action -1 of camera"):
        env.step(dict.fromkeys(env.agents, -1))
    env.close()

"""Tests that the same seeds and actions give the same bytes for any backend, and any number of worlds and threads."""

from __future__ import annotations

import hashlib

import numpy as np
import pytest

import hificamsim

STEPS = 3_000
SHARED = ("observations", "rewards", "masks", "ends", "measures")
ACTIONS = np.random.default_rng(7).integers(0, 1 << 30, size=(STEPS, 4, 64), dtype=np.int64)


def hashes(num_envs: int, first: int = 0, scenario: str = "campus", **settings: object) -> list[list[str]]:
    """Plays 3,000 steps in episodes of 700, and returns a hash of each world for every 300 steps."""
    with hificamsim.Worlds(scenario, num_envs, seed=11 + first, steps=700, **settings) as worlds:
        shape = worlds.actions.shape[1:]
        count = int(np.prod(shape))
        choices = np.resize(worlds.choices, count)
        digests = [hashlib.sha256() for _ in range(num_envs)]
        hashes_of_worlds: list[list[str]] = [[] for _ in range(num_envs)]
        for step in range(STEPS):
            actions = ACTIONS[step, first : first + num_envs, :count] % choices
            worlds.actions[...] = actions.reshape(num_envs, *shape)
            worlds.step()
            for i, digest in enumerate(digests):
                for name in SHARED:
                    digest.update(getattr(worlds, name)[i].tobytes())
                if step % 300 == 299:
                    hashes_of_worlds[i].append(digest.hexdigest())
        return hashes_of_worlds


@pytest.fixture(scope="module")
def expected() -> list[list[str]]:
    """Four worlds in this process, on one thread."""
    hashes_of_worlds = hashes(4, threads=1, backend="jvm")
    assert len({tuple(world) for world in hashes_of_worlds}) == 4, "worlds differ"
    assert all(len(set(world)) == STEPS // 300 for world in hashes_of_worlds)
    return hashes_of_worlds


def test_same_with_other_backend_and_more_threads(expected: list[list[str]]) -> None:
    assert hashes(4, threads=3, backend="process") == expected


@pytest.mark.parametrize(("backend", "first"), [("jvm", 0), ("process", 2)])
def test_same_for_a_single_world(expected: list[list[str]], backend: str, first: int) -> None:
    assert hashes(1, first, threads=1, backend=backend) == [expected[first]]


def test_reset_with_same_seed_repeats_episode(backend: str) -> None:
    with hificamsim.Worlds("campus", 2, steps=100, backend=backend) as worlds:
        first = worlds.observations.copy()
        for _ in range(150):
            worlds.step()
        worlds.reset(0)
        assert (worlds.observations == first).all()
        worlds.reset()
        for _ in range(90):
            worlds.step()
        later = worlds.state().copy()
        worlds.reset(0)
        for _ in range(90):
            worlds.step()
        assert (worlds.state() != later).any(), "the next episode has another seed"


def test_parallel_environment_equals_worlds(backend: str) -> None:
    env = hificamsim.parallel_env("campus", steps=300, backend=backend)
    observations, _ = env.reset(seed=5)
    with hificamsim.Worlds("campus", steps=300, seed=5) as worlds:
        for step in range(300):
            actions = ACTIONS[step, 0, : len(env.agents)] % worlds.views
            worlds.actions[0, :, 0] = actions
            worlds.step()
            observations, rewards, _, truncations, _ = env.step(dict(zip(env.agents, actions)))
            assert list(rewards.values()) == worlds.rewards[0].tolist()
            if step < 299:
                assert (np.stack(list(observations.values())) == worlds.observations[0]).all()
    assert all(truncations.values())
    assert (np.stack(list(observations.values())) == worlds.finals[0]).all()
    env.close()


def test_replayed_run_has_same_score() -> None:
    run = hificamsim.run("cluster-random", policy="random", steps=300, seed=9, record=True)
    env = hificamsim.single_env("cluster-random", steps=300)
    env.reset(seed=9)
    views = run["zooms"].pivot(index="step", columns="camera", values="level")[env.worlds.cameras]
    k_min = [env.step(views.loc[step].to_numpy())[4]["k_min"] for step in range(300)]
    assert k_min == run["steps"]["k_min"].tolist()
    assert sum(k_min) > 0
    env.close()

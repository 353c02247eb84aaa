"""Tests the part of observations that describes each view by the shared belief."""

from __future__ import annotations

import numpy as np
import pytest

import hificamsim

SETTINGS = {"steps": 80, "seed": 5}


def test_belief_is_appended_to_unchanged_observations(backend: str) -> None:
    with (
        hificamsim.Worlds("campus", 2, backend=backend, **SETTINGS) as plain,
        hificamsim.Worlds("campus", 2, backend=backend, belief=True, **SETTINGS) as with_belief,
    ):
        size = plain.observations.shape[-1]
        random = np.random.default_rng(1)
        for _ in range(90):
            plain.actions[..., 0] = with_belief.actions[..., 0] = random.integers(0, plain.views, plain.actions.shape[:2])
            plain.step()
            with_belief.step()
            assert (with_belief.observations[..., :size] == plain.observations).all()
            assert (with_belief.rewards == plain.rewards).all()
            views = with_belief.of_views(with_belief.observations)
            assert views.shape == (2, len(with_belief.cameras), max(with_belief.views), 10)
            low, high = with_belief.bounds()
            assert ((with_belief.observations >= low) & (with_belief.observations <= high)).all()
        assert views[..., 0].sum() == 2 * sum(with_belief.views)


def test_belief_is_the_same_in_every_environment() -> None:
    env = hificamsim.parallel_env("junction", belief=True, **SETTINGS)
    envs = hificamsim.vector_env("junction", 1, belief=True, **SETTINGS)
    one, _ = env.reset(seed=5)
    many, _ = envs.reset(seed=5)
    for _ in range(30):
        assert np.array_equal(np.stack(list(one.values())), many[0])
        assert all(env.observation_space(camera).contains(one[camera]) for camera in one)
        choice = env.worlds.of_views(many[0])[..., 9].argmax(-1)
        one, *_ = env.step({camera: int(view) for camera, view in zip(env.agents, choice)})
        many, *_ = envs.step(choice[None])
    pairs = hificamsim.dataset("junction", belief=True, **SETTINGS)
    assert pairs["observations"].shape[1] == many.shape[-1]


def test_view_of_greatest_gain_scores_almost_like_cooperative() -> None:
    for scenario in ("junction", "corridor"):
        with hificamsim.Worlds(scenario, 4, belief=True, auto_reset=False, **SETTINGS) as worlds:
            worlds.begin(None)
            score = 0.0
            while not worlds.ends.any():
                views = worlds.of_views(worlds.observations)
                gains = views[..., 9] + 0.02 * views[..., 1]
                worlds.actions[..., 0] = np.where(worlds.masks, gains, -1).argmax(-1)
                worlds.step()
                score += worlds.measures[:, 2].mean() / worlds.episode_steps
        policy = "cooperative:search=0.15,further=0.5"  # as the observation counts
        expert = hificamsim.run(scenario, policy=policy, repeat=4, **SETTINGS)["steps"].score.mean()
        assert score > 0.9 * expert


def test_restored_belief_continues_with_same_bytes() -> None:
    with hificamsim.Worlds("hall", 1, belief=True, channel="loss=0.2,delay=2", **SETTINGS) as worlds:
        def play(count: int) -> list[bytes]:
            seen = []
            for step in range(count):
                worlds.actions[..., 0] = step % min(worlds.views)
                worlds.step()
                seen.append(worlds.observations.tobytes())
            return seen

        play(20)
        state = worlds.save()
        after = play(20)
        worlds.restore(state)
        assert play(20) == after


def test_rejects_views_of_observations_without_belief() -> None:
    with hificamsim.Worlds("junction", **SETTINGS) as worlds:
        with pytest.raises(hificamsim.InputError, match="expected belief=True"):
            worlds.of_views(worlds.observations)

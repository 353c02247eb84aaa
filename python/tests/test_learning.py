"""Tests that cameras learn to turn and zoom by rates."""

from __future__ import annotations

import contextlib

import numpy as np

import hificamsim
from hificamsim.worlds import Array


def test_cameras_learn_to_turn_and_zoom_by_rates() -> None:
    """Trains a linear policy by evolution strategies (Salimans and others, 2017)."""
    pairs, size = 16, 0.1
    random = np.random.default_rng(1)
    with contextlib.closing(
        hificamsim.vector_env("mate-4v8-9", 2 * pairs, per="camera", actions="rates", steps=100)
    ) as envs:
        numbers = envs.single_observation_space.shape[0]

        def scores(weights: Array) -> Array:
            observations, _ = envs.reset(seed=5)
            total = np.zeros(2 * pairs)
            for _ in range(100):
                known = observations.reshape(2 * pairs, -1, numbers)
                actions = np.clip(np.einsum("wcn,wna->wca", known, weights), -1, 1)
                observations, rewards, *_ = envs.step(actions.reshape(-1, 2).astype(np.float32))
                total += rewards.reshape(2 * pairs, -1).mean(axis=1)
            return total / 100

        learned = np.zeros((numbers, 2))
        before = scores(np.broadcast_to(learned, (2 * pairs, numbers, 2))).mean()
        for _ in range(20):
            noise = random.normal(size=(pairs, numbers, 2))
            found = scores(learned + size * np.concatenate([noise, -noise]))
            better = found[:pairs] - found[pairs:]
            learned += 2 * size * np.tensordot(better / (better.std() + 1e-8), noise, 1) / pairs
        after = scores(np.broadcast_to(learned, (2 * pairs, numbers, 2))).mean()
    assert after > 1.1 * before, (before, after)

"""Tests the example of training: scores rise, and the exported policy chooses like NumPy."""

from __future__ import annotations

import contextlib
import pathlib
import sys
from typing import Any

import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
sys.path.append(str(EXAMPLES))

import ppo  # noqa: E402

import hificamsim  # noqa: E402
from hificamsim.worlds import Array  # noqa: E402


def trained(*words: str) -> tuple[list[float], Any]:
    scores = []
    for *_, score, learner in ppo.train(ppo.parser().parse_args([*words])):
        scores.append(score)
    return scores, learner


CAR_PARK = ["car-park", "--detection", "oodpcvs-2025:level=characterise", "--worlds", "16", "--steps", "150"]


def test_short_training_raises_score_by_half() -> None:
    scores, _ = trained(*CAR_PARK, "--updates", "14", "--seed", "3")
    assert np.mean(scores[-3:]) > 1.5 * scores[0], scores


def test_same_seed_gives_same_training() -> None:
    one, first = trained(*CAR_PARK, "--updates", "2", "--seed", "5")
    other, second = trained(*CAR_PARK, "--updates", "2", "--seed", "5")
    assert one == other
    assert all((a == b).all() for a, b in zip(first.actor.weights, second.actor.weights))


def test_gradients_match_loss() -> None:
    random = np.random.default_rng(1)
    network = ppo.Network([3, 5, 2], 1.0, random)
    network.weights = [weight.astype(np.float64) for weight in network.weights]
    inputs, wanted = random.standard_normal((7, 3)), random.standard_normal((7, 2))

    def loss() -> float:
        return float(((network(inputs) - wanted) ** 2).sum() / 2)

    layers = network.layers(inputs)
    slopes = network.slopes(layers, layers[-1] - wanted)
    for weight, slope in zip(network.weights, slopes):
        for index in np.ndindex(weight.shape):
            original = weight[index]
            weight[index] = original + 1e-6
            more = loss()
            weight[index] = original - 1e-6
            less = loss()
            weight[index] = original
            assert (more - less) / 2e-6 == pytest.approx(slope[index], abs=1e-5)


def test_shipped_policy_chooses_like_its_file() -> None:
    pytest.importorskip("onnx")
    import greedy

    views = greedy.choices(
        EXAMPLES / "trained" / "border.onnx", "border", "ttpf:task=recognise", seed=100, steps=100
    )
    lines = (EXAMPLES / "trained" / "choices.csv").read_text().splitlines()
    assert [",".join(map(str, row)) for row in views] == lines


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

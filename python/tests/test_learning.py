"""The example that trains: it learns, and what it exports decides as NumPy does."""

from __future__ import annotations

import pathlib
import sys
from typing import Any

import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
sys.path.append(str(EXAMPLES))

import ppo  # noqa: E402


def trained(*words: str) -> tuple[list[float], Any]:
    scores = []
    for *_, score, learner in ppo.train(ppo.parser().parse_args([*words])):
        scores.append(score)
    return scores, learner


CAR_PARK = ["car-park", "--detection", "oodpcvs-2025:level=characterise", "--worlds", "16", "--steps", "150"]


def test_a_short_training_raises_the_score_by_half() -> None:
    scores, _ = trained(*CAR_PARK, "--updates", "14", "--seed", "3")
    assert np.mean(scores[-3:]) > 1.5 * scores[0], scores


def test_the_same_seed_learns_the_same() -> None:
    one, first = trained(*CAR_PARK, "--updates", "2", "--seed", "5")
    other, second = trained(*CAR_PARK, "--updates", "2", "--seed", "5")
    assert one == other
    assert all((a == b).all() for a, b in zip(first.actor.weights, second.actor.weights))


def test_the_slopes_are_those_of_the_loss() -> None:
    random = np.random.default_rng(1)
    network = ppo.Network([3, 5, 2], 1.0, random)
    network.weights = [one.astype(np.float64) for one in network.weights]
    inputs, wanted = random.standard_normal((7, 3)), random.standard_normal((7, 2))

    def loss() -> float:
        return float(((network(inputs) - wanted) ** 2).sum() / 2)

    layers = network.layers(inputs)
    slopes = network.slopes(layers, layers[-1] - wanted)
    for weight, slope in zip(network.weights, slopes):
        for at in np.ndindex(weight.shape):
            kept = weight[at]
            weight[at] = kept + 1e-6
            more = loss()
            weight[at] = kept - 1e-6
            less = loss()
            weight[at] = kept
            assert (more - less) / 2e-6 == pytest.approx(slope[at], abs=1e-5)


def test_choices_of_the_shipped_policy_are_those_of_the_file() -> None:
    pytest.importorskip("onnx")
    import greedy

    made = greedy.choices(
        EXAMPLES / "trained" / "border.onnx", "border", "ttpf:task=recognise", seed=100, steps=100
    )
    lines = (EXAMPLES / "trained" / "choices.csv").read_text().splitlines()
    assert [",".join(map(str, row)) for row in made] == lines

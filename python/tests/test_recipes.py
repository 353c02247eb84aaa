"""Tests that the recipes learn, resume, and write policies that play any site."""

from __future__ import annotations

import csv
import importlib
import json
import pathlib
import sys
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import onnx
import optax
import pytest

import hificamsim
from hificamsim.worlds import TESTING

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
sys.path.append(str(EXAMPLES))

import imitate  # noqa: E402
import improve  # noqa: E402
import learners  # noqa: E402
import measure  # noqa: E402
import qmix  # noqa: E402

TASK = "bench/passage-v1"


def train(recipe: str, out: pathlib.Path, *words: object, rounds: int = 1) -> list[dict[str, str]]:
    """Trains as the command line does, and returns the curve."""
    with pytest.MonkeyPatch.context() as patch:
        words_of_call = [recipe, *words, "--tasks", TASK, "--rounds", rounds, "--out", out]
        patch.setattr(sys, "argv", [str(word) for word in words_of_call])
        importlib.import_module(recipe).main()
    with (out / "curve.csv").open() as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def imitation(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    out = tmp_path_factory.mktemp("imitation")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(imitate, "STEPS", 100)
        train("imitate", out, rounds=2)
    return out


def test_imitation_chooses_like_its_expert(imitation: pathlib.Path) -> None:
    curve = list(csv.DictReader((imitation / "curve.csv").open()))
    assert 0.4 < float(curve[1]["passage-v1"]) <= 1 and curve[1]["score"] == curve[1]["passage-v1"]
    assert float(curve[1]["agreement"]) > 0.75 and float(curve[1]["loss"]) < 0.7 * float(curve[0]["loss"])
    graph = onnx.load(imitation / "policy.onnx").graph
    assert [dim.dim_param or dim.dim_value for dim in graph.input[0].type.tensor_type.shape.dim] == ["cameras", "views", 10]


def test_imitation_enters_the_benchmark_and_is_verified(
    imitation: pathlib.Path, tmp_path: pathlib.Path, onnx_runtime: None
) -> None:
    entry, out = str(tmp_path / "entry"), tmp_path / "verified"
    words = ["--policy", f"onnx:{imitation}/policy.onnx", "--name", "imitation", "--tasks", TASK, "--out", entry]
    hificamsim.execute("benchmark", "run", *words)
    hificamsim.execute("benchmark", "verify", entry, "--secret", "correct horse", "--out", str(out))
    found = json.loads((out / "verified.json").read_text())["all"]
    assert found["reproduced"] and found["claimed"] > 0.5
    board = ["benchmark", "leaderboard", entry, "--verified", str(out), "--out", str(tmp_path / "board")]
    assert "imitation" in hificamsim.execute(*board)
    assert "fresh seeds" in (tmp_path / "board" / "leaderboard.csv").read_text()


def test_measured_scores_equal_those_of_benchmark(imitation: pathlib.Path, tmp_path: pathlib.Path) -> None:
    choose = learners.best(learners.actor_of(imitation))

    def policy(observations: learners.Array, masks: learners.Array) -> learners.Array:
        return choose(learners.views_of(observations, masks), masks.astype(bool))

    settings = {name: value for name, value in learners.SETTINGS.items() if name != "threads"}
    played = hificamsim.benchmark(policy, tmp_path / "entry", name="imitation", only=[TASK], **settings)[TASK]
    least, most = learners.scale(TASK)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["measure", str(imitation), "--tasks", TASK, "--out", str(tmp_path / "scores.csv")])
        measure.main()
    with (tmp_path / "scores.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [int(row["seed"]) for row in rows] == list(TESTING)
    scores = np.array([float(row["score"]) for row in rows])
    assert np.allclose(scores, (played - least) / (most - least), atol=1e-4)
    assert scores.mean() > 0.5, "cameras that zoom out have 0, the optimum has 1"


@pytest.mark.parametrize("recipe, method", [("improve", "ippo"), ("improve", "mappo"), ("qmix", "vdn"), ("qmix", "qmix")])
def test_reinforcement_starts_from_imitation(
    recipe: str, method: str, imitation: pathlib.Path, tmp_path: pathlib.Path
) -> None:
    curve = train(recipe, tmp_path, method, "--start", imitation, rounds=2)
    assert 0.1 < float(curve[0]["passage-v1"]) < 1
    before, after = learners.actor_of(imitation), learners.actor_of(tmp_path)
    assert any((old != new).any() for old, new in zip(before, after))
    assert onnx.load(tmp_path / "policy.onnx").graph.output[0].name == "values"


def test_resumed_training_gives_same_network(imitation: pathlib.Path, tmp_path: pathlib.Path) -> None:
    train("improve", tmp_path / "whole", "mappo", rounds=2)
    train("improve", tmp_path / "parts", "mappo", rounds=1)
    train("improve", tmp_path / "parts", "mappo", rounds=2)
    with np.load(tmp_path / "whole" / "checkpoint.npz") as whole, np.load(tmp_path / "parts" / "checkpoint.npz") as parts:
        assert all((whole[name] == parts[name]).all() for name in whole.files if name != "minutes")


@pytest.mark.parametrize("method", ["vdn", "qmix"])
def test_value_of_team_rises_with_each_view(method: str) -> None:
    random = np.random.default_rng(2)
    nets = qmix.networks(method, 32, None, random)
    views = random.random((8, 5, 7, learners.NUMBERS)).astype(np.float32)
    chosen = random.normal(size=(8, 5)).astype(np.float32)
    before = np.asarray(qmix.team(nets, views, chosen))
    for camera in range(5):
        better = chosen.copy()
        better[:, camera] += 1
        after = np.asarray(qmix.team(nets, views, better))
        assert (after >= before).all() and (after > before).any()


def test_q_learning_finds_rewarded_view() -> None:
    """In a world of one step, the reward of the team is the mean of a number of the chosen views."""
    random = np.random.default_rng(3)
    nets = qmix.networks("vdn", 16, None, random)
    nothing = jax.tree.map(jnp.zeros_like, nets)  # the value after the step
    optimizer = optax.adam(1e-2)

    @jax.jit
    def step(nets: Any, memory: Any, batch: Any) -> Any:
        changes, memory = optimizer.update(jax.grad(qmix.error)(nets, nothing, batch), memory)
        return optax.apply_updates(nets, changes), memory

    memory = optimizer.init(nets)
    for _ in range(300):
        views = random.random((64, 3, 4, learners.NUMBERS)).astype(np.float32)
        masks, actions = np.ones((64, 3, 4), bool), random.integers(0, 4, (64, 3))
        paid = 10 * np.take_along_axis(views[..., 6], actions[..., None], -1).mean((1, 2))
        batch = {"views": views, "masks": masks, "actions": actions, "returns": paid}
        nets, memory = step(nets, memory, {**batch, "next_views": views, "next_masks": masks})
    found = np.asarray(learners.values(nets["actor"], views, masks)).argmax(-1)
    assert (found == views[..., 6].argmax(-1)).mean() > 0.8

"""The parts that the recipes share: one network that values views one by one, for any site.

Cameras observe what each of their views promises by the belief that they share (``belief=True``); a small network, with
the same weights for every view, camera and site, values each of them, and a camera takes the best allowed view. Needs
``pip install jax optax onnx``, and runs on the processor.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import pathlib
import time
from collections.abc import Callable
from typing import Any

os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")
os.environ.setdefault("OMP_NUM_THREADS", "1")  # the worlds and the network take turns

import jax
import jax.numpy as jnp
import numpy as np
import onnx_file

import hificamsim
from hificamsim.worlds import TASKS, shipped

Array = Any
Weights = list[Array]

NUMBERS = 10  # what the belief says about a view
SEEDS = 890_000  # training uses the seeds below
SETTINGS: dict[str, Any] = {"belief": True, "targets": 0, "neighbours": 0, "threads": 1}


def network(sizes: list[int], random: np.random.Generator, last: float = 1.0) -> Weights:
    """Draws the weights of a multilayer perceptron: a matrix and a vector for each layer."""
    weights: Weights = []
    for inputs, outputs in zip(sizes, sizes[1:]):
        scale = np.sqrt(2 / inputs) if len(weights) < 2 * len(sizes) - 4 else last / np.sqrt(inputs)
        weights.append(jnp.asarray(random.standard_normal((inputs, outputs)) * scale, jnp.float32))
        weights.append(jnp.zeros(outputs, jnp.float32))
    return weights


def apply(weights: Weights, inputs: Array) -> Array:
    """Applies a network with ReLU to inputs (..., numbers)."""
    for i in range(0, len(weights), 2):
        inputs = inputs @ weights[i] + weights[i + 1]
        inputs = jax.nn.relu(inputs) if i + 2 < len(weights) else inputs
    return inputs


@jax.jit
def values(weights: Weights, views: Array, masks: Array) -> Array:
    """Computes the value of each view (..., V), which is very low if the view is not allowed."""
    return jnp.where(masks, apply(weights, views)[..., 0], -1e9)


def summary(views: Array) -> Array:
    """Summarises a camera's views, (..., 2 x 10): the mean and the maximum of each number over its views."""
    there = views[..., :1]
    mean = (views * there).sum(-2) / jnp.maximum(there.sum(-2), 1)
    return jnp.concatenate([mean, views.max(-2)], -1)


def views_of(observations: Array, masks: Array) -> Array:
    """Extracts the belief at the end of observations, (..., V, 10)."""
    count = masks.shape[-1]
    return observations[..., -count * NUMBERS :].reshape(*observations.shape[:-1], count, NUMBERS)


def episode(worlds: hificamsim.Worlds, choose: Callable[[Array, Array], Array]) -> dict[str, Array]:
    """Plays an episode of every world, and returns arrays (steps, B, C, ...).
    :param choose: chooses a view for each camera, given views (B, C, V, 10) and masks (B, C, V)
    """
    parts: dict[str, list[Array]] = {}
    for _ in range(worlds.episode_steps):
        masks = worlds.masks.astype(bool)
        views = views_of(worlds.observations, masks).copy()
        actions = np.asarray(choose(views, masks))
        worlds.actions[..., 0] = actions
        worlds.step()
        seen = {"views": views, "masks": masks, "actions": actions, "advice": worlds.advice.copy()}
        seen |= {"rewards": worlds.rewards.copy(), "scores": worlds.measures[:, 2].copy()}
        for name, array in seen.items():
            parts.setdefault(name, []).append(array)
    return {name: np.stack(arrays) for name, arrays in parts.items()}


def scale(task: str) -> tuple[Array, Array]:
    """Returns the scores of a task's testing episodes that are 0 on the scale (cameras zoom out) and 1 (the optimum)."""
    declared = json.loads((shipped() / "benchmark.json").read_text(encoding="utf-8"))[task.removeprefix(TASKS)]
    return np.array(declared["zoomOut"]), np.array(declared["best"])


def row_of(scores: dict[str, Array]) -> dict[str, float]:
    """Returns a row of a curve: the score of each task's episodes, on the mean scale of its testing episodes."""
    row = {}
    for task, found in scores.items():
        least, most = (array.mean() for array in scale(task))
        row[task.removeprefix(TASKS)] = round(float((found.mean() - least) / (most - least)), 4)
    return {"score": round(float(np.mean(list(row.values()))), 4), **row}


def best(weights: Weights) -> Callable[[Array, Array], Array]:
    """Returns a function that chooses the view of the greatest value."""
    return lambda views, masks: np.asarray(values(weights, views, masks)).argmax(-1)


def drawing(weights: Weights, random: np.random.Generator) -> Callable[[Array, Array], Array]:
    """Returns a function that draws views, with their values as logits."""

    def choose(views: Array, masks: Array) -> Array:
        valued = np.asarray(values(weights, views, masks))
        return (valued + random.gumbel(size=valued.shape)).argmax(-1)

    return choose


class Keeper:
    """Keeps a training in a folder: its checkpoint, its curve, and the network as ONNX."""

    def __init__(self, folder: pathlib.Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.folder = folder
        self.begun = time.process_time()
        self.before = 0.0
        self.rounds = 0

    def minutes(self) -> float:
        """The minutes of processor time, including those before a checkpoint."""
        return self.before + (time.process_time() - self.begun) / 60

    def keep(self, learned: dict[str, Any], **row: Any) -> None:
        """Ends a round: writes the checkpoint, ``actor`` as ``policy.onnx``, and a row of ``curve.csv``."""
        self.rounds += 1
        arrays = {jax.tree_util.keystr(path): np.asarray(leaf) for path, leaf in jax.tree_util.tree_leaves_with_path(learned)}
        np.savez(self.folder / "checkpoint.npz", minutes=self.minutes(), rounds=self.rounds, **arrays)
        onnx_file.write_views(self.folder / "policy.onnx", [np.asarray(w) for w in learned["actor"]])
        row = {"round": self.rounds, "minutes": round(self.minutes(), 2), **row}
        file = self.folder / "curve.csv"
        new = not file.exists()
        with file.open("a", newline="", encoding="utf-8") as out:
            writer = csv.DictWriter(out, row)
            if new:
                writer.writeheader()
            writer.writerow(row)
        print(", ".join(f"{name} {value}" for name, value in row.items()), flush=True)

    def resume(self, learned: dict[str, Any]) -> dict[str, Any]:
        """Reads the state of the training from its checkpoint; returns the given state if there is none."""
        file = self.folder / "checkpoint.npz"
        if not file.exists():
            return learned
        with np.load(file) as kept:
            self.before, self.rounds = float(kept["minutes"]), int(kept["rounds"])
            found: dict[str, Any] = jax.tree_util.tree_map_with_path(
                lambda path, leaf: jnp.asarray(kept[jax.tree_util.keystr(path)]), learned
            )
        return found


def actor_of(folder: pathlib.Path) -> Weights:
    """Reads the actor of another training."""
    with np.load(folder / "checkpoint.npz") as kept:
        count = sum(name.startswith("['actor']") for name in kept.files)
        return [jnp.asarray(kept[f"['actor'][{i}]"]) for i in range(count)]


def reads(description: str, rounds: int) -> argparse.ArgumentParser:
    """Makes a parser with the options that all recipes have."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tasks", nargs="+", default=hificamsim.tasks(), help="the tasks that the network learns")
    parser.add_argument("--rounds", type=int, default=rounds, help="number of rounds, including those of earlier calls")
    parser.add_argument("--seed", type=int, default=0, help="seed of the training")
    parser.add_argument("--hidden", type=int, default=32, help="units of each of two layers")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("nets"), help="folder of the training")
    return parser

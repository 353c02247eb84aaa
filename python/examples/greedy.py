"""What a trained policy does, computed in NumPy: choices of the highest value, step by step.

    python greedy.py trained/border.onnx border --detection ttpf:task=recognise > choices.csv

``hificamsim run --policy onnx:FILE`` makes the same ones.
"""

from __future__ import annotations

import argparse
import csv
import os
import sys
from typing import Any

import numpy as np
import onnx
from onnx import numpy_helper

import hificamsim


def weights(file: str | os.PathLike[str]) -> list[Any]:
    """What ``onnx_file.write`` was given."""
    kept = {one.name: numpy_helper.to_array(one) for one in onnx.load(os.fspath(file)).graph.initializer}
    return [kept[f"{kind}{i}"] for i in range(len(kept) // 2) for kind in ("weights", "offsets")]


def values(layers: list[Any], observations: Any) -> Any:
    """The value of each choice."""
    found = observations
    for i in range(0, len(layers), 2):
        found = found @ layers[i] + layers[i + 1]
        found = np.maximum(found, 0) if i + 2 < len(layers) else found
    return found


def choices(file: str | os.PathLike[str], scenario: str, detection: str, *, seed: int, steps: int) -> list[list[int]]:
    """The view of each camera, for each step of the run of a seed."""
    layers = weights(file)
    env = hificamsim.vector_env(scenario, per="camera", detection=detection, steps=steps)
    try:
        observations, infos = env.reset(seed=seed)
        made = []
        for _ in range(steps):
            allowed = np.where(infos["action_mask"] == 1, values(layers, observations), -np.inf)
            made.append(allowed.argmax(-1).tolist())
            observations, _, _, _, infos = env.step(made[-1])
        return made
    finally:
        env.close()


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("file")
    options.add_argument("scenario")
    options.add_argument("--detection", default="hifi:orb-lin")
    options.add_argument("--seed", type=int, default=100)
    options.add_argument("--steps", type=int, default=100)
    told = options.parse_args()
    made = choices(told.file, told.scenario, told.detection, seed=told.seed, steps=told.steps)
    csv.writer(sys.stdout, lineterminator="\n").writerows(made)


if __name__ == "__main__":
    main()

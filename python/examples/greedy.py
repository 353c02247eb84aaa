"""Computes the choices of a trained policy in NumPy: the views of the highest value, step by step.

    python greedy.py trained/border.onnx border --detection ttpf:task=recognise > choices.csv

``hificamsim run --policy onnx:FILE`` makes the same choices.
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
    """Reads the weights that ``onnx_file.write`` has written."""
    arrays = {array.name: numpy_helper.to_array(array) for array in onnx.load(os.fspath(file)).graph.initializer}
    return [arrays[f"{kind}{i}"] for i in range(len(arrays) // 2) for kind in ("weights", "offsets")]


def values(layers: list[Any], observations: Any) -> Any:
    """Computes the value of each choice."""
    outputs = observations
    for i in range(0, len(layers), 2):
        outputs = outputs @ layers[i] + layers[i + 1]
        outputs = np.maximum(outputs, 0) if i + 2 < len(layers) else outputs
    return outputs


def choices(file: str | os.PathLike[str], scenario: str, detection: str, *, seed: int, steps: int) -> list[list[int]]:
    """Plays the run of a seed, and returns the view of each camera in each step."""
    layers = weights(file)
    env = hificamsim.vector_env(scenario, per="camera", detection=detection, steps=steps)
    try:
        observations, infos = env.reset(seed=seed)
        views = []
        for _ in range(steps):
            allowed = np.where(infos["action_mask"] == 1, values(layers, observations), -np.inf)
            views.append(allowed.argmax(-1).tolist())
            observations, _, _, _, infos = env.step(views[-1])
        return views
    finally:
        env.close()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("scenario")
    parser.add_argument("--detection", default="hifi:orb-lin")
    parser.add_argument("--seed", type=int, default=100)
    parser.add_argument("--steps", type=int, default=100)
    options = parser.parse_args()
    views = choices(options.file, options.scenario, options.detection, seed=options.seed, steps=options.steps)
    csv.writer(sys.stdout, lineterminator="\n").writerows(views)


if __name__ == "__main__":
    main()

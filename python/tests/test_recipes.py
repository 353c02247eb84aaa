"""The recipes learn, keep what they learned, and write policies that play any site; they need JAX."""

from __future__ import annotations

import csv
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import hificamsim

pytest.importorskip("jax")
pytest.importorskip("optax")
onnx = pytest.importorskip("onnx")

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
TASK = "bench/street-v1"


def recipe(*words: object) -> None:
    path = os.pathsep.join([str(EXAMPLES), str(EXAMPLES.parent), os.environ.get("PYTHONPATH", "")])
    command = [sys.executable, EXAMPLES / words[0], *words[1:], "--tasks", TASK]
    subprocess.run([str(word) for word in command], env={**os.environ, "PYTHONPATH": path}, check=True)


def curve(folder: pathlib.Path) -> list[dict[str, str]]:
    with (folder / "curve.csv").open() as file:
        return list(csv.DictReader(file))


def test_imitation_learns_and_goes_on_from_its_checkpoint(tmp_path: pathlib.Path) -> None:
    out = tmp_path / "imitation"
    recipe("imitate.py", "--minutes", 0.3, "--out", out)
    first = curve(out)
    assert float(first[-1]["agreement"]) > 0.7 > float(first[0]["agreement"])
    recipe("imitate.py", "--minutes", 0.5, "--out", out)
    assert float(curve(out)[len(first)]["agreement"]) > 0.7
    graph = onnx.load(out / "policy.onnx").graph
    assert [dim.dim_param or dim.dim_value for dim in graph.input[0].type.tensor_type.shape.dim] == ["cameras", "views", 10]


@pytest.mark.parametrize("method", ["ippo", "mappo"])
def test_improvement_goes_on_from_imitation(method: str, tmp_path: pathlib.Path) -> None:
    recipe("imitate.py", "--minutes", 0.3, "--out", tmp_path / "imitation")
    out = tmp_path / method
    recipe("improve.py", method, "--start", tmp_path / "imitation", "--minutes", 0.3, "--out", out)
    with np.load(tmp_path / "imitation" / "checkpoint.npz") as before, np.load(out / "checkpoint.npz") as after:
        assert any((before[name] != after[name]).any() for name in before.files if name.startswith("actor"))
    with hificamsim.Worlds(TASK) as worlds:
        least = float(curve(out)[-1]["street-v1"])
        assert 0 < least <= worlds.num_targets

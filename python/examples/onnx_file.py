"""Writes a policy as an ONNX file, for ``hificamsim compare --policies onnx:FILE``."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

OPSET = 13
IR_VERSION = 8  # what ONNX Runtime of 2022 and later reads


def write(
    file: str | os.PathLike[str], weights: list[Any], *, targets: int = 4, neighbours: int = 2, actions: str = "view"
) -> None:
    """Writes a multilayer perceptron with ReLU.

    :param weights: of each layer a matrix (inputs, outputs) and a vector (outputs)
    :param targets: that an observation has room for, as the policy was trained
    :param neighbours: the same of neighbours
    :param actions: view or steps, as the policy was trained
    """
    layers = len(weights) // 2
    nodes = []
    name = "observations"
    for i in range(layers):
        out = "values" if i + 1 == layers else f"sums{i}"
        nodes.append(helper.make_node("Gemm", [name, f"weights{i}", f"offsets{i}"], [out]))
        if i + 1 < layers:
            nodes.append(helper.make_node("Relu", [out], [f"hidden{i}"]))
            name = f"hidden{i}"
    kept = [numpy_helper.from_array(np.asarray(w, np.float32), _name(i)) for i, w in enumerate(weights)]
    inputs = helper.make_tensor_value_info("observations", TensorProto.FLOAT, ["cameras", len(weights[0])])
    outputs = helper.make_tensor_value_info("values", TensorProto.FLOAT, ["cameras", len(weights[-1])])
    graph = helper.make_graph(nodes, "policy", [inputs], [outputs], kept)
    model = helper.make_model(
        graph, opset_imports=[helper.make_opsetid("", OPSET)], producer_name="hificamsim", ir_version=IR_VERSION
    )
    told = {"targets": str(targets), "neighbours": str(neighbours), "actions": actions}
    helper.set_model_props(model, told)
    onnx.checker.check_model(model)
    onnx.save(model, os.fspath(file))


def _name(i: int) -> str:
    return f"{'offsets' if i % 2 else 'weights'}{i // 2}"

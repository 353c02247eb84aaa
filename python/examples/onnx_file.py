"""Writes a policy as an ONNX file, for ``hificamsim compare --policies onnx:FILE``."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

OPSET = 13
IR_VERSION = 8  # ONNX Runtime of 2022 and later reads it


def write(
    file: str | os.PathLike[str], weights: list[Any], *, targets: int = 4, neighbours: int = 2, actions: str = "view"
) -> None:
    """Writes a multilayer perceptron with ReLU.

    :param weights: a matrix (inputs, outputs) and a vector (outputs) for each layer
    :param targets: the number of targets in an observation, as in the training
    :param neighbours: the number of neighbours in an observation, as in the training
    :param actions: view or steps, as in the training
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
    inputs = helper.make_tensor_value_info("observations", TensorProto.FLOAT, ["cameras", len(weights[0])])
    outputs = helper.make_tensor_value_info("values", TensorProto.FLOAT, ["cameras", len(weights[-1])])
    save(file, nodes, [inputs], [outputs], _constants(weights), targets=targets, neighbours=neighbours, actions=actions)


def write_views(file: str | os.PathLike[str], weights: list[Any]) -> None:
    """Writes a multilayer perceptron that values views by the belief, on any site.
    :param weights: a matrix and a vector for each layer; the first has 10 inputs, the last one output
    """
    layers = len(weights) // 2
    nodes = []
    name = "views"
    for i in range(layers):
        nodes.append(helper.make_node("MatMul", [name, f"weights{i}"], [f"products{i}"]))
        nodes.append(helper.make_node("Add", [f"products{i}", f"offsets{i}"], [f"sums{i}"]))
        if i + 1 < layers:
            nodes.append(helper.make_node("Relu", [f"sums{i}"], [f"hidden{i}"]))
            name = f"hidden{i}"
    nodes.append(helper.make_node("Squeeze", [f"sums{layers - 1}", "last"], ["values"]))
    constants = [*_constants(weights), numpy_helper.from_array(np.array([-1]), "last")]
    inputs = helper.make_tensor_value_info("views", TensorProto.FLOAT, ["cameras", "views", len(weights[0])])
    outputs = helper.make_tensor_value_info("values", TensorProto.FLOAT, ["cameras", "views"])
    save(file, nodes, [inputs], [outputs], constants)


def save(
    file: str | os.PathLike[str], nodes: list[Any], inputs: list[Any], outputs: list[Any], constants: list[Any], **metadata: Any
) -> None:
    """Writes a graph with metadata."""
    graph = helper.make_graph(nodes, "policy", inputs, outputs, constants)
    model = helper.make_model(
        graph, opset_imports=[helper.make_opsetid("", OPSET)], producer_name="hificamsim", ir_version=IR_VERSION
    )
    helper.set_model_props(model, {name: str(value) for name, value in metadata.items()})
    onnx.checker.check_model(model)
    onnx.save(model, os.fspath(file))


def _constants(weights: list[Any]) -> list[Any]:
    return [numpy_helper.from_array(np.asarray(w, np.float32), _name(i)) for i, w in enumerate(weights)]


def _name(i: int) -> str:
    return f"{'offsets' if i % 2 else 'weights'}{i // 2}"

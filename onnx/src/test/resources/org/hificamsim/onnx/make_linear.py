"""Makes the networks of the tests: pip install onnx numpy, then python make_linear.py in this folder."""

import pathlib
import sys

import numpy as np
import onnx

sys.path.append(str(pathlib.Path(__file__).resolve().parents[7] / "python" / "examples"))
from onnx_file import save, write, write_views  # noqa: E402


def linear(inputs: int, outputs: int) -> list[np.ndarray]:
    """The layer that OnnxPolicyTest computes by hand; all weights are exact in binary."""
    i, j = np.arange(inputs)[:, None], np.arange(outputs)[None, :]
    return [((i * 7 + j * 13) % 31 - 15) / 16, (np.arange(outputs) * 5 % 7 - 3) / 8]


write("linear.onnx", linear(44, 65))
write("steps.onnx", linear(35, 6), targets=3, neighbours=1, actions="steps")
write("narrow.onnx", linear(44, 5))
write("short.onnx", linear(10, 65))
write("odd.onnx", linear(44, 65), actions="jump")
not_a_number = linear(44, 65)
not_a_number[1][:] = np.nan
write("nan.onnx", not_a_number)
two = onnx.load("linear.onnx")
two.graph.output.append(onnx.helper.make_tensor_value_info("observations", onnx.TensorProto.FLOAT, ["cameras", 44]))
onnx.save(two, "two.onnx")

# The greatest gain, and a little for the view that was chosen last.
write_views("views.onnx", [np.array([[0, 1 / 64, 0, 0, 0, 0, 0, 0, 0, 1]]).T, np.zeros(1)])


def node(kind: str, inputs: list[str], output: str) -> onnx.NodeProto:
    return onnx.helper.make_node(kind, inputs, [output])


def numbers(name: str, width: int) -> onnx.ValueInfoProto:
    return onnx.helper.make_tensor_value_info(name, onnx.TensorProto.FLOAT, ["cameras", width])


def counting(file: str, next_state: str = "next_state") -> None:
    """Counts decisions in its state, and likes the view most that has their number."""
    arrays = {"zeros": np.zeros((44, 65)), "views": np.arange(65), "one": np.ones(1)}
    kept = [onnx.numpy_helper.from_array(array.astype(np.float32), name) for name, array in arrays.items()]
    nodes = [
        node("MatMul", ["observations", "zeros"], "nothing"),
        node("Sub", ["views", "state"], "off"),
        node("Mul", ["off", "off"], "square"),
        node("Sub", ["nothing", "square"], "values"),
        node("Add", ["state", "one"], next_state),
    ]
    save(file, nodes, [numbers("observations", 44), numbers("state", 1)], [numbers("values", 65), numbers(next_state, 1)], kept)


counting("memory.onnx")
counting("forgetful.onnx", "later")

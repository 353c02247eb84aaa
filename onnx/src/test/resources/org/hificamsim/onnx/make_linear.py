"""Makes the networks of the tests: pip install onnx numpy, then python make_linear.py in this folder."""

import pathlib
import sys

import numpy as np
import onnx

sys.path.append(str(pathlib.Path(__file__).resolve().parents[7] / "python" / "examples"))
from onnx_file import write  # noqa: E402


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

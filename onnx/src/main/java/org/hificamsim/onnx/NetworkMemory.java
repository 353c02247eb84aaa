package org.hificamsim.onnx;

import ai.onnxruntime.NodeInfo;
import ai.onnxruntime.OnnxJavaType;
import ai.onnxruntime.TensorInfo;
import java.util.Map;
import org.hificamsim.core.InputException;

/**
 * The memory of a network: an input {@value #STATE} and an output {@value #NEXT_STATE}, float32 of
 * cameras x size. An episode begins with zeros.
 *
 * @param size the size of a camera's state, 1 or more
 */
record NetworkMemory(int size) {
  static final String STATE = "state";
  static final String NEXT_STATE = "next_state";

  /**
   * Returns the memory of a network; null if it has none.
   *
   * @throws InputException if it has only one of the two, or they differ
   */
  static NetworkMemory of(Map<String, NodeInfo> inputs, Map<String, NodeInfo> outputs) {
    boolean reads = inputs.containsKey(STATE);
    if (reads != outputs.containsKey(NEXT_STATE)) {
      throw InputException.of(
          "it has an %s, expected input '%s' and output '%s', or neither",
          reads ? "input '" + STATE + "' alone" : "output '" + NEXT_STATE + "' alone",
          STATE,
          NEXT_STATE);
    }
    if (!reads) {
      return null;
    }
    long size = size(inputs.get(STATE));
    if (size != size(outputs.get(NEXT_STATE))) {
      throw InputException.of(
          "its '%s' and '%s' differ, expected float32 of cameras x one size", STATE, NEXT_STATE);
    }
    return new NetworkMemory((int) size);
  }

  private static long size(NodeInfo node) {
    if (node.getInfo() instanceof TensorInfo tensor
        && tensor.type == OnnxJavaType.FLOAT
        && tensor.getShape().length == 2
        && tensor.getShape()[1] > 0) {
      return tensor.getShape()[1];
    }
    throw InputException.of(
        "its '%s' is another tensor, expected float32 of cameras x a fixed size", node.getName());
  }
}

package org.hificamsim.onnx;

import ai.onnxruntime.NodeInfo;
import ai.onnxruntime.OnnxJavaType;
import ai.onnxruntime.OnnxTensor;
import ai.onnxruntime.OrtEnvironment;
import ai.onnxruntime.OrtException;
import ai.onnxruntime.OrtLoggingLevel;
import ai.onnxruntime.OrtSession;
import ai.onnxruntime.TensorInfo;
import java.io.IOException;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.core.policy.NetworkView;

/**
 * A network in an ONNX file, which maps what each camera observes (one row each) to a value for
 * each choice. It may also map a state of each camera to the next one. All runs of a process share
 * it; thread-safe.
 */
final class TrainedNetwork {
  private static final Map<Path, TrainedNetwork> OPENED = new HashMap<>();

  private final Path file;
  private final byte[] content;
  private final OrtSession session;
  private final Conventions conventions;
  private final NodeInfo input;
  private final NodeInfo output;

  /** The names of state and next state; null in a network without memory. */
  private final NetworkMemory memory;

  /**
   * Returns the network of a file, which is opened again if its content has changed.
   *
   * @throws InputException when the file cannot be read or is not such a network
   */
  static TrainedNetwork of(Path file) {
    byte[] content = read(file);
    synchronized (OPENED) {
      TrainedNetwork opened = OPENED.get(file);
      if (opened == null || !Arrays.equals(opened.content, content)) {
        opened = new TrainedNetwork(file, content);
        OPENED.put(file, opened);
      }
      return opened;
    }
  }

  static void requireReadable(Path file) {
    if (!Files.isRegularFile(file) || !Files.isReadable(file)) {
      throw new InputException(file + " cannot be read, expected a trained network in ONNX format");
    }
  }

  private static byte[] read(Path file) {
    requireReadable(file);
    try {
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw new InputException(
          file + " cannot be read (" + e.getMessage() + "), expected a trained network", e);
    }
  }

  private TrainedNetwork(Path file, byte[] content) {
    this.file = file;
    this.content = content;
    try {
      session = environment().createSession(content, oneThread());
      memory = NetworkMemory.of(session.getInputInfo(), session.getOutputInfo());
      input = only("input", session.getInputInfo().values(), NetworkMemory.STATE);
      conventions = Conventions.of(session.getMetadata().getCustomMetadata(), input);
      output = only("output", session.getOutputInfo().values(), NetworkMemory.NEXT_STATE);
    } catch (OrtException e) {
      throw InputException.of(
              "%s is no network that ONNX Runtime knows, expected a trained one: %s",
              file, reason(e))
          .because(e);
    } catch (InputException e) {
      throw new InputException(file + ": " + e.getMessage(), e);
    }
  }

  /** Returns the environment with logging turned off, since callers report errors themselves. */
  private static OrtEnvironment environment() {
    return OrtEnvironment.getEnvironment(OrtLoggingLevel.ORT_LOGGING_LEVEL_FATAL, "hificamsim");
  }

  /**
   * Returns options for one thread, so that sums are added in the same order everywhere. Runs, not
   * networks, are computed in parallel.
   */
  private static OrtSession.SessionOptions oneThread() throws OrtException {
    OrtSession.SessionOptions options = new OrtSession.SessionOptions();
    options.setIntraOpNumThreads(1);
    options.setInterOpNumThreads(1);
    options.setSessionLogLevel(OrtLoggingLevel.ORT_LOGGING_LEVEL_FATAL);
    return options;
  }

  /** Returns the first line of a message without its place in the source of ONNX Runtime. */
  private static String reason(OrtException e) {
    String line = e.getMessage().lines().findFirst().orElse("");
    return line.replaceFirst(".*(message|initialization|\\.cc:\\d+):? ", "");
  }

  private static NodeInfo only(String kind, Collection<NodeInfo> nodes, String optional) {
    List<NodeInfo> others =
        nodes.stream().filter(node -> !node.getName().equals(optional)).toList();
    if (others.size() != 1) {
      throw InputException.of(
          "it has %s %ss, expected one (and perhaps '%s')", others.size(), kind, optional);
    }
    return others.get(0);
  }

  /** The layout of the observations that the network needs of a network of cameras. */
  ObservationLayout layout(NetworkView network) {
    boolean flat = input.getInfo() instanceof TensorInfo tensor && tensor.getShape().length == 2;
    return conventions.layout(network, flat ? ((TensorInfo) input.getInfo()).getShape()[1] : -1);
  }

  Conventions conventions() {
    return conventions;
  }

  /** The length of the state of a camera; 0 for a network without memory. */
  int stateSize() {
    return memory == null ? 0 : memory.size();
  }

  /**
   * Checks that the network fits these cameras.
   *
   * @param layout the layout of the cameras' observations
   * @param width the number of values needed for each camera
   * @throws InputException when the network has other shapes
   */
  void requireShapes(int cameras, ObservationLayout layout, int width) {
    if (conventions.seesViewsAlone()) {
      long[] shape = {cameras, layout.views(), ObservationLayout.viewSize()};
      require("input", input, shape, "cameras x views x what each promises");
    } else {
      String numbers =
          Texts.format(
              "cameras x the numbers of an observation of %s targets and %s neighbours",
              layout.targets(), layout.neighbours());
      require("input", input, new long[] {cameras, layout.size()}, numbers);
    }
    String values =
        "cameras x values for the choices of a camera (actions="
            + Spelling.of(conventions.actions())
            + ")";
    require("output", output, new long[] {cameras, width}, values);
  }

  private void require(String kind, NodeInfo node, long[] required, String meaning) {
    boolean fits =
        node.getInfo() instanceof TensorInfo tensor
            && tensor.type == OnnxJavaType.FLOAT
            && tensor.getShape().length == required.length
            && IntStream.range(0, required.length)
                .allMatch(i -> fits(tensor.getShape()[i], required[i]));
    if (!fits) {
      throw new InputException(
          file
              + ": %s '%s' is %s".formatted(kind, node.getName(), text(node))
              + ", expected float32 of "
              + shape(required)
              + ": "
              + meaning);
    }
  }

  /** Whether a dimension has the required length, or is open, which a negative length means. */
  private static boolean fits(long length, long required) {
    return length == required || length < 0;
  }

  private static String text(NodeInfo node) {
    return node.getInfo() instanceof TensorInfo tensor
        ? tensor.type + " of " + shape(tensor.getShape())
        : "no tensor";
  }

  private static String shape(long[] lengths) {
    return Arrays.stream(lengths)
        .mapToObj(length -> length < 0 ? "any" : Long.toString(length))
        .collect(Collectors.joining(" x "));
  }

  /**
   * Computes the value of each choice of each camera.
   *
   * @param observations the observations, a row for each camera
   * @param state the state, a row for each camera; replaced by the next state
   * @param values receives the values, a row for each camera
   * @throws InputException when the network fails or a value is NaN
   */
  void value(int cameras, float[] observations, float[] state, float[] values) {
    Map<String, OnnxTensor> inputs = new HashMap<>();
    try {
      inputs.put(input.getName(), tensor(observations, inputShape(cameras, observations.length)));
      if (memory != null) {
        inputs.put(NetworkMemory.STATE, tensor(state, new long[] {cameras, memory.size()}));
      }
      try (OrtSession.Result result = session.run(inputs)) {
        copy(result, output.getName(), values);
        if (memory != null) {
          copy(result, NetworkMemory.NEXT_STATE, state);
        }
      }
    } catch (OrtException e) {
      throw new InputException(file + " fails: " + reason(e), e);
    } finally {
      inputs.values().forEach(OnnxTensor::close);
    }
  }

  private static OnnxTensor tensor(float[] numbers, long[] shape) throws OrtException {
    return OnnxTensor.createTensor(environment(), FloatBuffer.wrap(numbers), shape);
  }

  private long[] inputShape(int cameras, int numbers) {
    int perCamera = numbers / cameras;
    int perView = ObservationLayout.viewSize();
    return conventions.seesViewsAlone()
        ? new long[] {cameras, perCamera / perView, perView}
        : new long[] {cameras, perCamera};
  }

  private void copy(OrtSession.Result result, String name, float[] numbers) {
    copy(((OnnxTensor) result.get(name).orElseThrow()).getFloatBuffer(), numbers);
  }

  private void copy(FloatBuffer output, float[] values) {
    if (output.remaining() != values.length) {
      throw InputException.of(
          "%s gives %s values, expected %s", file, output.remaining(), values.length);
    }
    output.get(values);
    for (float value : values) {
      if (Float.isNaN(value)) {
        throw new InputException(file + " gives NaN, expected numbers");
      }
    }
  }
}

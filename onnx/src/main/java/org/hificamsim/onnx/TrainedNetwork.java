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
import java.util.Map;
import java.util.stream.Collectors;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.worlds.ActionKind;

/**
 * A network in an ONNX file, which maps the observation of each camera (one row each) to a value
 * for each choice. All runs of a process share it; thread-safe.
 */
final class TrainedNetwork {
  private static final Map<Path, TrainedNetwork> OPENED = new HashMap<>();

  /**
   * The observations and actions that a network was trained with. They are in the metadata of the
   * file as {@code targets}, {@code neighbours} and {@code actions}; missing entries have the
   * defaults of the environments. The width of the input tells whether observations contain
   * heights.
   */
  record Conventions(ObservationLayout layout, ActionKind actions) {
    static Conventions of(Map<String, String> metadata, NodeInfo input) {
      ObservationLayout defaults = ObservationLayout.DEFAULT;
      int targets = number(metadata, "targets", defaults.targets());
      int neighbours = number(metadata, "neighbours", defaults.neighbours());
      ObservationLayout withHeights = new ObservationLayout(targets, neighbours, true);
      boolean heights =
          input.getInfo() instanceof TensorInfo tensor
              && tensor.getShape().length == 2
              && tensor.getShape()[1] == withHeights.size();
      return new Conventions(
          heights ? withHeights : new ObservationLayout(targets, neighbours, false),
          Spelling.require(
              ActionKind.class,
              "its metadata actions",
              metadata.getOrDefault("actions", Spelling.of(ActionKind.VIEW))));
    }

    private static int number(Map<String, String> metadata, String key, int defaultValue) {
      String text = metadata.get(key);
      try {
        return text == null ? defaultValue : Integer.parseInt(text);
      } catch (NumberFormatException e) {
        throw new InputException(
            "its metadata " + key + " is '" + text + "', expected a whole number", e);
      }
    }
  }

  private final Path file;
  private final byte[] content;
  private final OrtSession session;
  private final Conventions conventions;
  private final NodeInfo input;
  private final NodeInfo output;

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
      input = only("input", session.getInputInfo().values());
      conventions = Conventions.of(session.getMetadata().getCustomMetadata(), input);
      output = only("output", session.getOutputInfo().values());
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

  private static NodeInfo only(String what, Collection<NodeInfo> nodes) {
    if (nodes.size() != 1) {
      throw new InputException("it has " + nodes.size() + " " + what + "s, expected one");
    }
    return nodes.iterator().next();
  }

  Conventions conventions() {
    return conventions;
  }

  /**
   * Checks that the network fits these cameras.
   *
   * @param width the number of values needed for each camera
   * @throws InputException when the network has other shapes
   */
  void requireShapes(int cameras, int width) {
    int numbers = conventions.layout().size();
    require("input", input, cameras, numbers, "the numbers of an observation of " + layoutText());
    String what = "values for the choices of a camera (actions=" + actions() + ")";
    require("output", output, cameras, width, what);
  }

  private String layoutText() {
    return Texts.format(
        "%s targets and %s neighbours",
        conventions.layout().targets(), conventions.layout().neighbours());
  }

  private String actions() {
    return Spelling.of(conventions.actions());
  }

  private void require(String what, NodeInfo node, int cameras, int width, String meaning) {
    boolean fits =
        node.getInfo() instanceof TensorInfo tensor
            && tensor.type == OnnxJavaType.FLOAT
            && tensor.getShape().length == 2
            && fits(tensor.getShape()[0], cameras)
            && fits(tensor.getShape()[1], width);
    if (!fits) {
      throw new InputException(
          file
              + ": %s '%s' is %s".formatted(what, node.getName(), text(node))
              + ", expected float32 of "
              + shape(new long[] {cameras, width})
              + ": cameras x "
              + meaning);
    }
  }

  /** Whether a dimension has the wanted length or, if negative, any. */
  private static boolean fits(long length, int wanted) {
    return length == wanted || length < 0;
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
   * @param observations one row for each camera
   * @param values receives one row for each camera
   * @throws InputException when the network fails or a value is NaN
   */
  void value(int cameras, float[] observations, float[] values) {
    long[] shape = {cameras, observations.length / cameras};
    try (OnnxTensor input =
            OnnxTensor.createTensor(environment(), FloatBuffer.wrap(observations), shape);
        OrtSession.Result result = session.run(Map.of(this.input.getName(), input))) {
      copy(((OnnxTensor) result.get(0)).getFloatBuffer(), values);
    } catch (OrtException e) {
      throw new InputException(file + " fails: " + reason(e), e);
    }
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

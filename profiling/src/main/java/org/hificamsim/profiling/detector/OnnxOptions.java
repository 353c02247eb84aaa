package org.hificamsim.profiling.detector;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;

/**
 * A network and what is asked of it: {@code FILE[:class=N][:size=N][:threshold=X]}.
 *
 * @param category which of its classes, from 0
 * @param size of its input, pixels a side
 * @param threshold the least score that counts, [0, 1]
 */
record OnnxOptions(Path file, int category, int size, double threshold) {
  /** What the names of such detectors begin with. */
  static final String PREFIX = "onnx:";

  private static final String EXPECTED =
      "', expected onnx:FILE[:class=N][:size=N][:threshold=X], a class from 0, a size from 8 to"
          + " 8192 and a threshold from 0 to 1";

  /**
   * Reads what stands after {@code onnx:}.
   *
   * @throws InputException in one line, when it is none
   */
  static OnnxOptions of(String text) {
    List<String> parts = Arrays.asList(text.split(":", -1));
    Map<String, String> options = new LinkedHashMap<>();
    for (String part : parts.subList(1, parts.size())) {
      String[] pair = part.split("=", 2);
      options.put(pair[0], pair.length == 2 ? pair[1] : "");
    }
    OnnxOptions read =
        new OnnxOptions(
            Path.of(parts.get(0)),
            (int) number(text, options.remove("class"), 0, 0, 1e6),
            (int) number(text, options.remove("size"), 640, 8, 8192),
            number(text, options.remove("threshold"), 0.25, 0, 1));
    if (!options.isEmpty()) {
      throw wrong(text);
    }
    if (!Files.isRegularFile(read.file)) {
      throw new InputException(read.file + ": no such file, expected an ONNX network");
    }
    return read;
  }

  /** The name of its column. */
  String column() {
    String stem = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    return "onnx-" + stem.replaceAll("[^A-Za-z0-9_]", "-") + "-" + category;
  }

  private static double number(String all, String text, double absent, double least, double most) {
    try {
      double value = text == null ? absent : Double.parseDouble(text);
      if (value >= least && value <= most) {
        return value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw wrong(all);
  }

  private static InputException wrong(String text) {
    return new InputException("--detectors has '" + PREFIX + text + EXPECTED);
  }
}

package org.hificamsim.profiling.detector;

import java.nio.file.Path;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;

/**
 * A detector of boxes as it is asked for: {@code hog}, {@code haar:FILE}, {@code onnx:FILE}.
 *
 * @param column its name in tables
 * @param need the memory that it takes
 * @param maker makes a new one
 */
record BoxSpec(String column, MemoryNeed need, Supplier<BoxDetector> maker) {
  /**
   * Reads a name.
   *
   * @throws InputException when there is no such detector, or its file is not there
   */
  static BoxSpec of(String name) {
    int colon = name.indexOf(':');
    String kind = colon < 0 ? name : name.substring(0, colon);
    String what = colon < 0 ? "" : name.substring(colon + 1);
    return switch (kind) {
      case "hog" -> new BoxSpec("hog", new MemoryNeed(60, 0), HogDetector::new);
      case "haar" -> haar(HaarDetector.file(what));
      case "onnx" -> onnx(OnnxOptions.of(what));
      default ->
          throw new InputException(
              "--detectors has '"
                  + name
                  + "', expected some of orb, sift, surf, each also with -located or -ransac, hog,"
                  + " haar:CASCADE, onnx:FILE");
    };
  }

  ConfidenceSource create() {
    return new BoxSource(column, maker.get());
  }

  private static BoxSpec haar(Path file) {
    String stem = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    String known = stem.replaceFirst("^(haar|lbp)cascade_", "").replaceAll("[^A-Za-z0-9_]", "-");
    return new BoxSpec("haar-" + known, new MemoryNeed(40, 0), () -> new HaarDetector(file));
  }

  private static BoxSpec onnx(OnnxOptions options) {
    return new BoxSpec(options.column(), new MemoryNeed(10, 0), () -> new OnnxDetector(options));
  }
}

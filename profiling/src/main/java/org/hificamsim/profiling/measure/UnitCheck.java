package org.hificamsim.profiling.measure;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.dataset.PhotoCamera;

/**
 * Checks that objects are about as large as a pinhole camera would show them. Centimetres in place
 * of metres give a factor of 100; an inexact focal length or a loose patch gives far less than
 * {@value #MAX_FACTOR}.
 */
record UnitCheck(PhotoCamera camera) {
  private static final double MAX_FACTOR = 4;
  private static final int MAX_LINES = 5;

  /**
   * Returns one line if most photos are suspicious, otherwise a line for each of the first ones.
   */
  List<String> warnings(List<Measurement> rows) {
    List<Measurement> suspicious =
        rows.stream().filter(row -> isSuspicious(enlargement(row))).toList();
    if (2 * suspicious.size() > rows.size()) {
      double median =
          rows.stream()
              .mapToDouble(this::enlargement)
              .sorted()
              .skip(rows.size() / 2)
              .findFirst()
              .orElse(1);
      return List.of(
          "%s of %s photos show their object %s size_m, distance_m, focal_length_m and camera.json say, expected metres everywhere"
              .formatted(suspicious.size(), rows.size(), words(median)));
    }
    List<String> lines = new ArrayList<>();
    suspicious.stream().limit(MAX_LINES).forEach(row -> lines.add(line(row)));
    if (suspicious.size() > MAX_LINES) {
      lines.add("as do %s more".formatted(suspicious.size() - MAX_LINES));
    }
    return lines;
  }

  private String line(Measurement row) {
    return "%s shows '%s' %s its size_m, distance_m and focal_length_m say, expected metres"
        .formatted(row.image(), row.object(), words(enlargement(row)));
  }

  /** Returns the ratio between the length of the object in the picture and the expected one. */
  private double enlargement(Measurement row) {
    return Math.sqrt(row.pip() / camera.pinholePip(row.size(), row.distance(), row.focalLength()));
  }

  private static boolean isSuspicious(double enlargement) {
    return enlargement > MAX_FACTOR || enlargement < 1 / MAX_FACTOR;
  }

  private static String words(double enlargement) {
    return Texts.format(
        enlargement > 1 ? "%.3g times larger than" : "%.3g times smaller than",
        enlargement > 1 ? enlargement : 1 / enlargement);
  }
}

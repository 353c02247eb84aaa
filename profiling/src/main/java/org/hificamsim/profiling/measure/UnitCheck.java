package org.hificamsim.profiling.measure;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.dataset.PhotoCamera;

/**
 * Whether objects look as large as a pinhole camera would show them. Centimetres among metres are
 * off by a factor of 100; a lens that shows less than it says, or a loose patch, by far less than
 * 4.
 */
record UnitCheck(PhotoCamera camera) {
  private static final double FACTOR = 4;
  private static final int SHOWN = 5;

  /** A line for all photos where most are off, else one for each of the first that are. */
  List<String> warnings(List<Measurement> rows) {
    List<Measurement> off = rows.stream().filter(row -> isOff(larger(row))).toList();
    if (2 * off.size() > rows.size()) {
      double median =
          rows.stream()
              .mapToDouble(this::larger)
              .sorted()
              .skip(rows.size() / 2)
              .findFirst()
              .orElse(1);
      return List.of(
          "%s of %s photos show their object %s size_m, distance_m, focal_length_m and camera.json say, expected metres everywhere"
              .formatted(off.size(), rows.size(), words(median)));
    }
    List<String> lines = new ArrayList<>();
    off.stream().limit(SHOWN).forEach(row -> lines.add(line(row)));
    if (off.size() > SHOWN) {
      lines.add("as do %s more".formatted(off.size() - SHOWN));
    }
    return lines;
  }

  private String line(Measurement row) {
    return "%s shows '%s' %s its size_m, distance_m and focal_length_m say, expected metres"
        .formatted(row.image(), row.object(), words(larger(row)));
  }

  /** How many times longer than expected the object is in the picture. */
  private double larger(Measurement row) {
    return Math.sqrt(row.pip() / camera.pinholePip(row.size(), row.distance(), row.focalLength()));
  }

  private static boolean isOff(double larger) {
    return larger > FACTOR || larger < 1 / FACTOR;
  }

  private static String words(double larger) {
    return Texts.format(
        larger > 1 ? "%.3g times larger than" : "%.3g times smaller than",
        larger > 1 ? larger : 1 / larger);
  }
}

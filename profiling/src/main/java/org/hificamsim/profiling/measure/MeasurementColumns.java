package org.hificamsim.profiling.measure;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.profiling.dataset.TableLayout;

/**
 * The columns of a table of measurements.
 *
 * @param detectors a column of confidences each
 */
record MeasurementColumns(PipReading pip, List<String> detectors) {
  static final List<String> PHYSICAL =
      List.of("image", "object", "size_m", "distance_m", "focal_length_m");

  /** The columns that these rows fill. */
  static MeasurementColumns of(PipReading pip, List<Measurement> rows) {
    return new MeasurementColumns(pip, List.copyOf(rows.get(0).confidences().keySet()));
  }

  /** What every table of measurements has. */
  static List<String> required(PipReading pip) {
    return Stream.concat(PHYSICAL.stream(), Stream.of(pip.column())).toList();
  }

  /** The table. */
  TableLayout<Measurement> layout() {
    TableLayout<Measurement> layout =
        new TableLayout<Measurement>()
            .with("image", row -> TableLayout.quoted(row.image()))
            .with("object", row -> TableLayout.quoted(row.object()))
            .with("size_m", Measurement::size)
            .with("distance_m", Measurement::distance)
            .with("focal_length_m", Measurement::focalLength)
            .with(pip.column(), Measurement::pip);
    detectors.forEach(detector -> layout.with(detector, row -> row.confidence(detector)));
    return layout;
  }

  /** A row's confidences in the order of the columns. */
  Map<String, Double> ordered(Map<String, Double> confidences) {
    return detectors.stream()
        .collect(
            Collectors.toMap(
                detector -> detector, confidences::get, (a, b) -> a, LinkedHashMap::new));
  }
}

package org.hificamsim.profiling.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.dataset.CsvRows;

/**
 * The columns of a table of measurements.
 *
 * @param covariates those that at least one photo has
 * @param detectors a column of confidences each
 */
record Columns(PipReading pip, List<Covariate> covariates, List<String> detectors) {
  static final List<String> PHYSICAL =
      List.of("image", "object", "size_m", "distance_m", "focal_length_m");

  /** The columns that these rows fill. */
  static Columns of(PipReading pip, List<Measurement> rows) {
    List<Covariate> covariates =
        Arrays.stream(Covariate.values())
            .filter(covariate -> rows.stream().anyMatch(r -> r.covariates().containsKey(covariate)))
            .toList();
    return new Columns(pip, covariates, List.copyOf(rows.get(0).confidences().keySet()));
  }

  /** What every table of measurements has. */
  static List<String> required(PipReading pip) {
    return Stream.concat(PHYSICAL.stream(), Stream.of(pip.column())).toList();
  }

  String header() {
    List<String> names = new ArrayList<>(required(pip));
    covariates.forEach(covariate -> names.add(covariate.column()));
    names.addAll(detectors);
    return String.join(",", names) + "\n";
  }

  String line(Measurement row) {
    List<String> cells =
        new ArrayList<>(
            List.of(
                CsvRows.quoted(row.image()),
                CsvRows.quoted(row.object()),
                String.valueOf(row.size()),
                String.valueOf(row.distance()),
                String.valueOf(row.focalLength()),
                String.valueOf(row.pip())));
    covariates.forEach(covariate -> cells.add(cell(row.covariates().get(covariate))));
    row.confidences().values().forEach(confidence -> cells.add(String.valueOf(confidence)));
    return String.join(",", cells) + "\n";
  }

  /** A row's confidences in the order of the columns. */
  Map<String, Double> ordered(Map<String, Double> confidences) {
    return detectors.stream()
        .collect(
            Collectors.toMap(
                detector -> detector, confidences::get, (a, b) -> a, LinkedHashMap::new));
  }

  private static String cell(Double value) {
    return value == null ? "" : value.toString();
  }
}

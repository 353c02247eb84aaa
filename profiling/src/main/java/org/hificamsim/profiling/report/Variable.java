package org.hificamsim.profiling.report;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.measure.Measurement;

/** One variable of Table 4.1, with its values in all photos. */
record Variable(String id, String name, String unit, double[] values) {
  static List<Variable> of(FitResult result) {
    return List.of(
        of(result, "zoom_m", "Zoom", "(m)", Measurement::focalLength),
        of(result, "object_size_m", "Object size", "(m)", Measurement::size),
        of(result, "distance_m", "Distance", "(m)", Measurement::distance),
        of(result, "pip", "PIP", "", Measurement::pip));
  }

  private static Variable of(
      FitResult result,
      String id,
      String name,
      String unit,
      ToDoubleFunction<Measurement> variable) {
    return new Variable(
        id, name, unit, result.measurements().stream().mapToDouble(variable).toArray());
  }
}

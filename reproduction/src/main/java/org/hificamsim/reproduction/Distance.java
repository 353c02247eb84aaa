package org.hificamsim.reproduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.reproduction.Table81.Cell;

/**
 * The distance of the nine cells of a detection model from the published ones, under our defaults
 * or under another reading of the thesis.
 *
 * @param reading the other reading; empty for our defaults
 * @param hifi whether these are the cells of the hi-fi model, not CamSim's
 * @param mean mean of the nine distances
 * @param nearCells number of cells at most 0.05 away
 */
public record Distance(
    Optional<Reading> reading, boolean hifi, double mean, long nearCells, int steps, int seeds) {
  /**
   * Returns the distances of our defaults, then of each other reading; the hi-fi column comes
   * before CamSim's.
   */
  static List<Distance> of(List<Cell> cells, int steps, int seeds) {
    List<Distance> distances = new ArrayList<>();
    List<Optional<Reading>> readings = new ArrayList<>(List.of(Optional.empty()));
    Arrays.stream(Reading.values()).map(Optional::of).forEach(readings::add);
    for (Optional<Reading> reading : readings) {
      for (boolean hifi : new boolean[] {true, false}) {
        double[] column =
            cells.stream()
                .filter(cell -> cell.published().hifi() == hifi)
                .mapToDouble(
                    cell -> Math.abs(cell.proportion(reading) - cell.published().proportion()))
                .toArray();
        long nearCells = Arrays.stream(column).filter(Verdict::isNear).count();
        distances.add(new Distance(reading, hifi, StatUtils.mean(column), nearCells, steps, seeds));
      }
    }
    return distances;
  }

  /** The name in files. */
  public String label() {
    return reading.map(Reading::label).orElse("default");
  }
}

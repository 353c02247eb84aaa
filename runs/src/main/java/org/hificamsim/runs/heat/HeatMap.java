package org.hificamsim.runs.heat;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.Texts;
import org.hificamsim.runs.cells.FieldCells;

/**
 * The coverage of each cell of a field over the steps of one or more runs.
 *
 * @param places the coverage of each cell, in the order of {@link FieldCells}
 */
public record HeatMap(FieldCells cells, List<Place> places) {
  /**
   * The coverage of a cell.
   *
   * @param meanK the number of cameras that would detect a target of the usual size in the centre,
   *     the mean over the steps; by chance, the expected number. NaN inside a solid obstacle
   * @param covered0 the share of steps in which no camera would detect it; by chance, the mean
   *     probability
   * @param covered1 the share of steps in which exactly one camera would detect it
   * @param coveredK the share of steps in which two or more cameras would detect it
   * @param visits the number of targets in the cell, summed over the steps
   * @param visitsMeanK the mean number of cameras that detected these targets; NaN without visits
   * @param visitsCovered0 the share of visits that no camera detected; NaN without visits
   */
  public record Place(
      double meanK,
      double covered0,
      double covered1,
      double coveredK,
      long visits,
      double visitsMeanK,
      double visitsCovered0) {
    /** Whether a target could stand in the centre of the cell. */
    public boolean isFree() {
      return !Double.isNaN(meanK);
    }
  }

  /** The share of free area and steps in which one or more cameras would detect a target. */
  public double covered() {
    return mean(place -> 1 - place.covered0);
  }

  /** The share of free area and steps in which two or more cameras would detect a target. */
  public double coveredK() {
    return mean(Place::coveredK);
  }

  /** The share of the free area in which no camera would ever detect a target. */
  public double blind() {
    return mean(place -> place.meanK == 0 ? 1 : 0);
  }

  /** Describes the shares that are covered once, covered twice and never covered. */
  public String shares() {
    return Texts.format(
        "of area and steps %.1f %% covered by 1 or more cameras, %.1f %% by 2 or more;"
            + " of the area %.1f %% never",
        100 * covered(), 100 * coveredK(), 100 * blind());
  }

  /** The mean over the free cells; NaN if there are none. */
  private double mean(ToDoubleFunction<Place> figure) {
    return places.stream().filter(Place::isFree).mapToDouble(figure).average().orElse(Double.NaN);
  }
}

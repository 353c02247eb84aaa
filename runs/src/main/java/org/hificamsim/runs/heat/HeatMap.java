package org.hificamsim.runs.heat;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.Texts;
import org.hificamsim.runs.cells.FieldCells;

/**
 * The coverage of each cell of a field over the steps of one or more runs.
 *
 * @param places one for each cell, in the order of {@link FieldCells}
 */
public record HeatMap(FieldCells cells, List<Place> places) {
  /**
   * The coverage of a cell.
   *
   * @param meanK the number of cameras that would detect a target of the usual size in the centre,
   *     the mean over the steps; by chance, the expected number. NaN inside a solid obstacle
   * @param covered0 the share of steps in which no camera would; by chance, the mean probability
   * @param covered1 the same for exactly one camera
   * @param coveredK the same for two or more cameras
   * @param visits the number of targets in the cell, summed over the steps
   * @param visitsMeanK the mean number of cameras that detected them; NaN without visits
   * @param visitsCovered0 the share of them that no camera detected; NaN without visits
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

  /** The share of the free area and the steps in which one or more cameras would detect. */
  public double covered() {
    return mean(place -> 1 - place.covered0);
  }

  /** The same for two or more cameras. */
  public double coveredK() {
    return mean(Place::coveredK);
  }

  /** The share of the free area in which no camera would ever detect. */
  public double blind() {
    return mean(place -> place.meanK == 0 ? 1 : 0);
  }

  /** The three shares in words. */
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

package org.hificamsim.runs.heat;

import java.util.Arrays;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;

/**
 * The cells in whose middle a camera would detect a target, in one view.
 *
 * @param cells their numbers, rising
 * @param chances to detect it, above 0, one for each of the cells
 */
record SeenCells(int[] cells, double[] chances) {
  /** A camera that sees nothing. */
  static final SeenCells NONE = new SeenCells(new int[0], new double[0]);

  /**
   * Asks the pipeline that cameras see through about each cell in reach.
   *
   * @param region what obstacles leave in sight; null where there are none
   * @param size of the target, metres
   */
  static SeenCells of(
      FieldCells cells,
      Visibility visibility,
      Pose pose,
      ZoomLevel zoom,
      VisibleRegion region,
      double size) {
    LevelSight sight = visibility.at(zoom, size);
    double reach = sight.reach();
    int left = cells.column(pose.x() - reach);
    int right = cells.column(pose.x() + reach);
    int top = cells.row(pose.y() + reach);
    int[] seen = new int[cells.count()];
    double[] chances = new double[seen.length];
    int count = 0;
    for (int row = cells.row(pose.y() - reach); row <= top; row++) {
      for (int column = left; column <= right; column++) {
        int cell = row * cells.columns() + column;
        double x = cells.x(cell);
        double y = cells.y(cell);
        double through = region == null ? 1 : region.transmittance(x, y);
        double chance = through == 0 ? 0 : sight.chance(pose, x, y, through);
        seen[count] = cell;
        chances[count] = chance;
        count += chance > 0 ? 1 : 0;
      }
    }
    return new SeenCells(Arrays.copyOf(seen, count), Arrays.copyOf(chances, count));
  }
}

package org.hificamsim.core.obstacle;

/**
 * Targets that hide targets. A target is hidden by a disc that its line of sight, a closed segment
 * from the camera to its centre, {@linkplain Obstacle#touches touches}. Left out are the target's
 * own disc, discs that the camera is inside or on the border of, and discs whose centres are not
 * nearer to the camera than the target: of two targets that overlap, the nearer hides the other.
 */
public final class TargetOcclusion {
  private TargetOcclusion() {}

  /**
   * Whether a disc hides a target from a camera. In space a disc is upright, from the ground to its
   * height: whether one hides any of what is between two heights of the target.
   *
   * @param cameraZ metres; NaN in a flat world
   * @param target its number among the discs
   * @param x the discs' centres, metres
   * @param y the discs' centres, metres
   * @param radius metres; a disc of radius 0 or less hides nothing
   * @param height of each disc, metres
   * @param low the least height of what is looked at, metres
   * @param high the greatest, metres
   */
  public static boolean hidden(
      double cameraX,
      double cameraY,
      double cameraZ,
      int target,
      double[] x,
      double[] y,
      double[] radius,
      double[] height,
      double low,
      double high) {
    return hidden(
        cameraX, cameraY, cameraZ, target, x, y, radius, height, low, high, radius.length);
  }

  /**
   * The same in a flat world.
   *
   * @param count of the discs, the first of the arrays
   */
  public static boolean hidden(
      double cameraX,
      double cameraY,
      int target,
      double[] x,
      double[] y,
      double[] radius,
      int count) {
    return hidden(cameraX, cameraY, Double.NaN, target, x, y, radius, radius, 0, 0, count);
  }

  private static boolean hidden(
      double cameraX,
      double cameraY,
      double cameraZ,
      int target,
      double[] x,
      double[] y,
      double[] radius,
      double[] height,
      double low,
      double high,
      int count) {
    boolean flat = Double.isNaN(cameraZ);
    double distance = square(x[target] - cameraX, y[target] - cameraY);
    for (int i = 0; i < count; i++) {
      if (square(x[i] - cameraX, y[i] - cameraY) < distance && i != target && radius[i] > 0) {
        double start = flat ? 0 : Slab.start(cameraZ, low, high, 0, height[i]);
        double end = flat ? 1 : Slab.end(cameraZ, low, high, 0, height[i]);
        double fromX = Slab.at(cameraX, x[target], start);
        double fromY = Slab.at(cameraY, y[target], start);
        double toX = Slab.at(cameraX, x[target], end);
        double toY = Slab.at(cameraY, y[target], end);
        if (start <= end
            && Discs.touch(x[i], y[i], radius[i], fromX, fromY, toX, toY)
            && !(start == 0 && Discs.contains(x[i], y[i], radius[i], cameraX, cameraY))) {
          return true;
        }
      }
    }
    return false;
  }

  private static double square(double dx, double dy) {
    return dx * dx + dy * dy;
  }
}

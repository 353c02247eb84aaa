package org.hificamsim.core.obstacle;

/**
 * Decides whether targets hide each other. A target is hidden if its line of sight, the closed
 * segment from the camera to its centre, {@linkplain Obstacle#touches touches} the disc of another
 * target. A disc that contains the camera hides nothing, nor does one whose centre is not nearer to
 * the camera than the target: of two overlapping targets, the nearer one hides the other.
 */
public final class TargetOcclusion {
  private TargetOcclusion() {}

  /**
   * Whether any disc hides a target from a camera. In space a disc is a cylinder on the ground, and
   * the target is hidden if any part of it between two heights is.
   *
   * @param cameraZ the height of the camera, in metres; NaN in a flat world
   * @param target the number of the target among the discs
   * @param x the x coordinates of the discs' centres, in metres
   * @param y the y coordinates of the discs' centres, in metres
   * @param radius the radii of the discs, in metres; a disc of radius 0 or less hides nothing
   * @param height the heights of the discs, in metres
   * @param low the lowest height of the target to be seen, in metres
   * @param high the greatest height of the target to be seen, in metres
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
   * Whether any disc hides a target from a camera in a flat world.
   *
   * @param count the number of discs, from the start of the arrays
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

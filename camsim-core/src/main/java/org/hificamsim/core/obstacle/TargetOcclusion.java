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
   * Whether a disc hides a target from a camera.
   *
   * @param target its number among the discs
   * @param x the discs' centres, metres
   * @param y the discs' centres, metres
   * @param radius metres; a disc of radius 0 or less hides nothing
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
    double distance = square(x[target] - cameraX, y[target] - cameraY);
    for (int i = 0; i < count; i++) {
      if (square(x[i] - cameraX, y[i] - cameraY) < distance
          && i != target
          && hides(cameraX, cameraY, x[target], y[target], x[i], y[i], radius[i], true)) {
        return true;
      }
    }
    return false;
  }

  /**
   * The same in space, where a target reaches from the ground to its height: whether one that is as
   * near hides any of what is between two heights of the target.
   *
   * @param cameraZ metres
   * @param height of each target, metres
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
    double distance = square(x[target] - cameraX, y[target] - cameraY);
    for (int i = 0; i < x.length; i++) {
      double start = Slab.start(cameraZ, low, high, 0, height[i]);
      double end = Slab.end(cameraZ, low, high, 0, height[i]);
      if (start <= end
          && square(x[i] - cameraX, y[i] - cameraY) < distance
          && i != target
          && hides(
              Slab.at(cameraX, x[target], start),
              Slab.at(cameraY, y[target], start),
              Slab.at(cameraX, x[target], end),
              Slab.at(cameraY, y[target], end),
              x[i],
              y[i],
              radius[i],
              start == 0)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a disc is between two points, the farther of which is farther away than its centre.
   *
   * @param atCamera whether the first point is the camera's, which may be in the disc
   */
  private static boolean hides(
      double fromX,
      double fromY,
      double toX,
      double toY,
      double atX,
      double atY,
      double radius,
      boolean atCamera) {
    return radius > 0
        && Discs.touch(atX, atY, radius, fromX, fromY, toX, toY)
        && !(atCamera && Discs.contains(atX, atY, radius, fromX, fromY));
  }

  private static double square(double dx, double dy) {
    return dx * dx + dy * dy;
  }
}

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
          && hides(cameraX, cameraY, x[target], y[target], x[i], y[i], radius[i])) {
        return true;
      }
    }
    return false;
  }

  /** Whether one disc hides a point that is farther away than the disc's centre. */
  private static boolean hides(
      double cameraX, double cameraY, double x, double y, double atX, double atY, double radius) {
    return radius > 0
        && Discs.touch(atX, atY, radius, cameraX, cameraY, x, y)
        && !Discs.contains(atX, atY, radius, cameraX, cameraY);
  }

  private static double square(double dx, double dy) {
    return dx * dx + dy * dy;
  }
}

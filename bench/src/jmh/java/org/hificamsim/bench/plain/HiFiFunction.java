package org.hificamsim.bench.plain;

/** Detects as {@code hifi:orb-lin}, by g of Table 6.1 over f of Eq 4.4 of the thesis. */
final class HiFiFunction implements DetectionFunction {
  private static final double MAX_FOCAL_LENGTH = 0.085;
  private static final double THRESHOLD = 0.0441;

  @Override
  public boolean detects(Camera camera, Target target) {
    double distance = camera.distanceTo(target);
    return distance <= camera.radius()
        && confidence(target.size(), distance, focalLength(camera)) >= THRESHOLD;
  }

  private static double focalLength(Camera camera) {
    return MAX_FOCAL_LENGTH * camera.narrowestRadius() / camera.radius();
  }

  private static double confidence(double size, double distance, double focalLength) {
    return g(f(size, distance, focalLength));
  }

  private static double f(double size, double distance, double focalLength) {
    double negativeLogPip = -18.82 * focalLength - 2.0 * size + 0.2 * distance + 2.47;
    return Math.min(1, Math.pow(10, -negativeLogPip));
  }

  private static double g(double pip) {
    return 0.571 * pip + 0.026;
  }
}

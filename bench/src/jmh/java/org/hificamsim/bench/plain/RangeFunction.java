package org.hificamsim.bench.plain;

/**
 * Detects by the rule of the coverage study, which falls with radius and distance (behaviour 3.8).
 */
final class RangeFunction implements DetectionFunction {
  private static final double THRESHOLD = 0.3;

  @Override
  public boolean detects(Camera camera, Target target) {
    double distance = camera.distanceTo(target);
    return distance <= camera.radius() && confidence(camera.radius(), distance) >= THRESHOLD;
  }

  private static double confidence(double radius, double distance) {
    return Math.max(0, 0.95 * (15 / (radius * distance)) - 0.15);
  }
}

package org.hificamsim.bench.plain;

import java.util.ArrayList;
import java.util.List;

/** A camera with zoom levels, and a policy of its own that chooses among them. */
final class Camera {
  private final double x;
  private final double y;
  private final List<Double> radii;
  private final LevelPolicy policy;
  private int level;
  private List<Target> detected = new ArrayList<>();

  /**
   * @param radii the radii in metres, rising
   */
  Camera(double x, double y, List<Double> radii, LevelPolicy policy) {
    this.x = x;
    this.y = y;
    this.radii = radii;
    this.policy = policy;
    this.level = radii.size() - 1;
  }

  void zoom() {
    level = policy.choose(level, detected.size());
  }

  void observe(List<Target> targets, DetectionFunction detection) {
    detected = new ArrayList<>();
    for (Target target : targets) {
      if (detection.detects(this, target)) {
        detected.add(target);
        target.cover();
      }
    }
    policy.learn(level, detected.size());
  }

  double distanceTo(Target target) {
    double dx = target.x() - x;
    double dy = target.y() - y;
    return Math.sqrt(dx * dx + dy * dy);
  }

  double radius() {
    return radii.get(level);
  }

  double narrowestRadius() {
    return radii.get(0);
  }
}

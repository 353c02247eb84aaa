package org.hificamsim.bench.plain;

import java.util.Random;
import org.hificamsim.core.scenario.spec.Field;

/** A target that goes straight and turns round at the border of the field. */
final class Target {
  private final double size;
  private final double speed;
  private double x;
  private double y;
  private double heading;
  private int coverage;

  /**
   * @param heading the heading in radians, 0 is +y
   */
  Target(double x, double y, double heading, double speed, double size) {
    this.x = x;
    this.y = y;
    this.heading = heading;
    this.speed = speed;
    this.size = size;
  }

  void move(Field field, Random random) {
    double dx = Math.sin(heading) * speed;
    double dy = Math.cos(heading) * speed;
    x += dx;
    y += dy;
    if (!field.contains(x, y)) {
      x -= dx;
      y -= dy;
      heading += Math.PI + (random.nextDouble() * 2 - 1) * Math.PI / 6;
    }
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }

  double size() {
    return size;
  }

  /** The number of cameras that detect this target. */
  int coverage() {
    return coverage;
  }

  void uncover() {
    coverage = 0;
  }

  void cover() {
    coverage++;
  }
}

package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.visibility.Body;

/**
 * Computes how targets hide each other from cameras in one step, from their estimated positions. A
 * target hides what lies behind its disc, as with {@code occlusion="targets"}. Since positions are
 * uncertain, the edge of the disc is blurred.
 */
final class Hiding {
  /** The blur of a disc's edge, as a part of its radius. */
  private static final double BLUR = 0.2;

  /** The blur that each step adds, as a part of the distance that targets move in a step. */
  private static final double BLUR_OF_STEP = 0.3;

  private double radius;
  private double blur;
  private int count;
  private double[] xs = {};
  private double[] ys = {};
  private double[] weights = {};

  /**
   * Removes all targets.
   *
   * @param width width of targets, in metres; 0 if they hide nothing
   * @param movedDistance how far targets move between their sightings and this step, in metres
   */
  void clear(double width, double movedDistance) {
    radius = width / 2;
    blur = BLUR * radius + BLUR_OF_STEP * movedDistance;
    count = 0;
  }

  /** Adds the next target: its estimated position, and the probability that it is there. */
  void add(double x, double y, double weight) {
    if (radius == 0) {
      return;
    }
    if (xs.length == count) {
      xs = Arrays.copyOf(xs, 2 * count + 1);
      ys = Arrays.copyOf(ys, 2 * count + 1);
      weights = Arrays.copyOf(weights, 2 * count + 1);
    }
    xs[count] = x;
    ys[count] = y;
    weights[count++] = weight;
  }

  /** The chance that no other target hides a target, the i-th one added, from a camera. */
  double visibleShare(NetworkView network, int camera, int target, double size) {
    if (radius == 0) {
      return 1;
    }
    double fromX = network.cameraX(camera);
    double fromY = network.cameraY(camera);
    double x = xs[target] - fromX;
    double y = ys[target] - fromY;
    double square = x * x + y * y;
    double start = startOfHiding(network, camera, size);
    double visible = 1;
    for (int other = 0; other < count; other++) {
      double discX = xs[other] - fromX;
      double discY = ys[other] - fromY;
      if (discX * discX + discY * discY < square) {
        double nearest = Math.max(start, (discX * x + discY * y) / square);
        double distance = Math.hypot(discX - nearest * x, discY - nearest * y);
        visible *= 1 - weights[other] * chanceToTouch(distance);
      }
    }
    return visible;
  }

  /**
   * The part of a line of sight after which it is low enough to meet targets; 0 in a flat world.
   */
  private static double startOfHiding(NetworkView network, int camera, double size) {
    double z = network.zoom(camera, 0).vertical().z();
    Body body = network.body(size);
    return z > body.high() ? (z - body.high()) / (z - body.low()) : 0;
  }

  private double chanceToTouch(double distance) {
    return Math.max(0, Math.min(1, (radius + blur - distance) / (2 * blur)));
  }
}

package org.hificamsim.tracks.mate;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * The greedy cameras of MATE's arena. Each turns to the nearest target that any of them saw in the
 * last {@value #MEMORY} steps, and zooms so that it reaches {@value #REACH_MARGIN} farther, both by
 * any angle within its speed. A camera that knows no target turns to the right. {@code MEMORY} and
 * {@code REACH_MARGIN} are estimates from MATE's recordings.
 */
final class GreedyCameras implements AimingZoomPolicy {
  private static final double TURN_SPEED = Math.toRadians(5);
  private static final double ZOOM_SPEED = 2.5;
  private static final int MEMORY = 25;
  private static final double REACH_MARGIN = 340;
  private static final double REACH = 1500;

  private final SeenPairs pairs = new SeenPairs();
  private double[] pan = {};

  /** The angle of view of each camera, in degrees. */
  private double[] angle = {};

  // The position where each target was last seen, and the number of steps since then.
  private double[] x = {};
  private double[] y = {};
  private int[] age = {};

  @Override
  public String name() {
    return "greedy";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    pan = random.doubles(network.cameras(), -Math.PI, Math.PI).toArray();
    angle =
        random
            .doubles(network.cameras(), ArenaLayout.NARROWEST_ANGLE, ArenaLayout.WIDEST_ANGLE)
            .toArray();
    x = new double[network.targets()];
    y = new double[network.targets()];
    age = new int[network.targets()];
    Arrays.fill(age, MEMORY + 1);
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    for (int camera = 0; camera < views.length; camera++) {
      move(network, camera);
      views[camera] =
          (int) Math.round((angle[camera] - ArenaLayout.NARROWEST_ANGLE) / ArenaLayout.ANGLE_STEP);
    }
  }

  private void move(NetworkView network, int camera) {
    double nearest = Double.POSITIVE_INFINITY;
    double turn = TURN_SPEED;
    for (int target = 0; target < age.length; target++) {
      double dx = x[target] - network.cameraX(camera);
      double dy = y[target] - network.cameraY(camera);
      double distance = Math.hypot(dx, dy);
      if (age[target] <= MEMORY && distance < nearest) {
        nearest = distance;
        double axis = network.cameraHeading(camera) + pan[camera];
        turn = Math.IEEEremainder(Math.atan2(dx, dy) - axis, 2 * Math.PI);
      }
    }
    pan[camera] += limited(turn, TURN_SPEED);
    if (nearest < Double.POSITIVE_INFINITY) {
      double factor = Math.max(1, REACH / (nearest + REACH_MARGIN));
      double wanted =
          Math.min(ArenaLayout.WIDEST_ANGLE, ArenaLayout.NARROWEST_ANGLE * factor * factor);
      angle[camera] += limited(wanted - angle[camera], ZOOM_SPEED);
    }
  }

  /** Returns the nearest number from -limit to limit. */
  static double limited(double number, double limit) {
    return Math.max(-limit, Math.min(limit, number));
  }

  @Override
  public double pan(int camera) {
    return pan[camera];
  }

  @Override
  public void learn(NetworkView network) {
    for (int target = 0; target < age.length; target++) {
      age[target]++;
    }
    network.findSeen(pairs);
    for (int i = 0; i < pairs.count(); i++) {
      double axis = network.cameraHeading(pairs.camera(i)) + pan[pairs.camera(i)];
      double sin = Math.sin(axis);
      double cos = Math.cos(axis);
      int target = pairs.target(i);
      x[target] = network.cameraX(pairs.camera(i)) + pairs.ahead(i) * sin + pairs.right(i) * cos;
      y[target] = network.cameraY(pairs.camera(i)) + pairs.ahead(i) * cos - pairs.right(i) * sin;
      age[target] = 0;
    }
  }
}

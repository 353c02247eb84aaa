package org.hificamsim.tracks.mate;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * The greedy cameras of MATE's arena: each turns to the nearest target that any of them saw in the
 * last {@value #MEMORY} steps, and zooms so as to reach {@value #BEYOND} farther; both at their
 * speed, by any amount. One that knows of no target turns on, to the right. How long they remember,
 * and how far beyond they reach, is read off MATE's recordings.
 */
final class GreedyCameras implements AimingZoomPolicy {
  private static final double TURN = Math.toRadians(5);
  private static final double ZOOM = 2.5;
  private static final int MEMORY = 25;
  private static final double BEYOND = 340;
  private static final double REACH = 1500;

  private final SeenPairs pairs = new SeenPairs();
  private double[] pan = {};
  private double[] angle = {}; // of view, degrees
  private double[] x = {}; // of each target, where it was seen last
  private double[] y = {};
  private int[] age = {};

  @Override
  public String name() {
    return "greedy";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    pan = random.doubles(network.cameras(), -Math.PI, Math.PI).toArray();
    angle = random.doubles(network.cameras(), ArenaLayout.NARROWEST, ArenaLayout.WIDEST).toArray();
    x = new double[network.targets()];
    y = new double[network.targets()];
    age = new int[network.targets()];
    Arrays.fill(age, MEMORY + 1);
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    for (int camera = 0; camera < views.length; camera++) {
      move(network, camera);
      views[camera] = (int) Math.round((angle[camera] - ArenaLayout.NARROWEST) / ArenaLayout.LEVEL);
    }
  }

  private void move(NetworkView network, int camera) {
    double nearest = Double.POSITIVE_INFINITY;
    double turn = TURN;
    for (int target = 0; target < age.length; target++) {
      double dx = x[target] - network.cameraX(camera);
      double dy = y[target] - network.cameraY(camera);
      double away = Math.hypot(dx, dy);
      if (age[target] <= MEMORY && away < nearest) {
        nearest = away;
        double axis = network.cameraHeading(camera) + pan[camera];
        turn = Math.IEEEremainder(Math.atan2(dx, dy) - axis, 2 * Math.PI);
      }
    }
    pan[camera] += within(turn, TURN);
    if (nearest < Double.POSITIVE_INFINITY) {
      double part = Math.max(1, REACH / (nearest + BEYOND));
      double wanted = Math.min(ArenaLayout.WIDEST, ArenaLayout.NARROWEST * part * part);
      angle[camera] += within(wanted - angle[camera], ZOOM);
    }
  }

  static double within(double by, double most) {
    return Math.max(-most, Math.min(most, by));
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

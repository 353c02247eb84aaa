package org.hificamsim.runs;

import java.util.stream.DoubleStream;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.World;

/**
 * How far targets are from the camera nearest to them, in the first steps of a scenario.
 *
 * @param steps how many
 * @param sorted metres, one for each target and step, the least first
 */
public record NearestDistances(int steps, double[] sorted) {
  private static final int STEPS = 100;

  /** Distances that are computed at most, so that a large scenario takes a moment too. */
  private static final int ENOUGH = 1_000_000;

  /** Those of a scenario; none where there are no cameras or targets. */
  public static NearestDistances of(Scenario scenario, Registry<Movement> movements) {
    World world = new World(scenario, movements, 0);
    int cameras = Math.max(1, world.cameras().count());
    int targets = Math.min(world.targets().count(), Math.max(1, ENOUGH / cameras));
    int steps = Math.max(1, Math.min(STEPS, ENOUGH / Math.max(1, cameras * targets)));
    DoubleStream.Builder all = DoubleStream.builder();
    for (int step = 0; step < steps; step++) {
      world.fireEvents(step);
      for (int target = 0; target < targets; target++) {
        all.add(world.targets().present(target) ? nearest(world, target) : Double.NaN);
      }
      world.moveTargets();
    }
    return new NearestDistances(steps, all.build().filter(Double::isFinite).sorted().toArray());
  }

  private static double nearest(World world, int target) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      double dx = world.targets().x(target) - world.cameras().x(camera);
      double dy = world.targets().y(target) - world.cameras().y(camera);
      nearest = world.cameras().online(camera) ? Math.min(nearest, dx * dx + dy * dy) : nearest;
    }
    return Math.sqrt(nearest);
  }

  /** The share within a distance; NaN where there are none. */
  public double within(double distance) {
    return DoubleStream.of(sorted).filter(one -> one <= distance).count() / (double) sorted.length;
  }

  /** The median; NaN where there are none. */
  public double median() {
    return sorted.length == 0 ? Double.NaN : sorted[sorted.length / 2];
  }
}

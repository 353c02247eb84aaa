package org.hificamsim.runs.hints;

import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.Reach;
import org.hificamsim.runs.ShortNumber;

/**
 * Warns if hardly any target comes near enough to a camera to be detected, and proposes a model
 * that would detect them.
 */
final class ReachHint {
  /** The least share of targets within reach for which no warning is given. */
  private static final double ENOUGH_TARGETS = 0.1;

  /** Models that the warning may propose, in this order. */
  private static final List<String> ALTERNATIVES =
      List.of("hifi:orb-lin", "hifi:orb-pinhole", "oodpcvs-2025:level=overview", "geometric");

  private static final int MAX_STEPS = 100;

  /** The most distances that are computed, so that large scenarios do not take longer. */
  private static final int MAX_DISTANCES = 1_000_000;

  private ReachHint() {}

  static Optional<String> of(Scenario scenario, Detection detection, Catalogue catalogue) {
    World world = new World(scenario, catalogue.movements(), 0);
    int cameras = Math.max(1, world.cameras().count());
    int targets = Math.min(world.targets().count(), Math.max(1, MAX_DISTANCES / cameras));
    int steps = Math.max(1, Math.min(MAX_STEPS, MAX_DISTANCES / Math.max(1, cameras * targets)));
    double reach = Reach.farthest(scenario, detection);
    double[] distances = distances(world, targets, steps);
    long within = DoubleStream.of(distances).filter(distance -> distance <= reach).count();
    if (distances.length == 0 || (double) within / distances.length >= ENOUGH_TARGETS) {
      return Optional.empty();
    }
    double median = distances[distances.length / 2];
    return Optional.of(
        Texts.format(
            "'%s' detects%s up to %s, and %s of the targets come so near to a camera in %s steps"
                + " (half of them no nearer than %s m): hardly anything is covered; expected %s",
            detection.name(),
            detection.certain() ? "" : " half of the time",
            Reach.describe(scenario, detection),
            within == 0 ? "none" : "under " + ShortNumber.of(100 * ENOUGH_TARGETS) + " %",
            steps,
            ShortNumber.of(median),
            remedy(scenario, median, catalogue)));
  }

  /** The distances of targets from the camera nearest to them, in metres, in ascending order. */
  private static double[] distances(World world, int targets, int steps) {
    DoubleStream.Builder distances = DoubleStream.builder();
    for (int step = 0; step < steps; step++) {
      world.fireEvents(step);
      for (int target = 0; target < targets; target++) {
        distances.add(world.targets().present(target) ? distance(world, target) : Double.NaN);
      }
      world.moveTargets();
    }
    return distances.build().filter(Double::isFinite).sorted().toArray();
  }

  private static double distance(World world, int target) {
    double leastSquare = Double.POSITIVE_INFINITY;
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      if (world.cameras().online(camera)) {
        double dx = world.targets().x(target) - world.cameras().x(camera);
        double dy = world.targets().y(target) - world.cameras().y(camera);
        leastSquare = Math.min(leastSquare, dx * dx + dy * dy);
      }
    }
    return Math.sqrt(leastSquare);
  }

  /** Proposes the first model that reaches half of the targets. */
  private static String remedy(Scenario scenario, double distance, Catalogue catalogue) {
    for (String name : ALTERNATIVES) {
      Detection alternative = Detection.of(catalogue.detection(name));
      double reach = Reach.farthest(scenario, alternative);
      if (reach >= distance) {
        return "another model, such as %s, which reaches %s m"
            .formatted(alternative.name(), ShortNumber.of(reach));
      }
    }
    return "longer focal lengths, larger radii or more cameras";
  }
}

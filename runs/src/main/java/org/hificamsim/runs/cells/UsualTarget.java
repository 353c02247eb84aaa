package org.hificamsim.runs.cells;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Foreshortening;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.world.World;

/** The target that stands for all targets of a scenario where its area is measured. */
public final class UsualTarget {
  private UsualTarget() {}

  /** Returns a target of the most frequent size; a person if the scenario has no targets. */
  public static TargetSpec of(Scenario scenario) {
    return mostFrequent(scenario.everyTarget().toList())
        .orElseGet(() -> new TargetSpec(0, 0, 0).withExtent(Extent.PERSON));
  }

  /**
   * The size of the first target of the most frequent size in a world, or its height if the
   * detection model works by height; metres.
   */
  public static double size(World world, DetectionModel model) {
    return mostFrequent(
            IntStream.range(0, world.targets().count()).mapToObj(world::targetSpec).toList())
        .map(target -> size(target, model))
        .orElse(TargetSpec.DEFAULT_SIZE);
  }

  private static double size(TargetSpec target, DetectionModel model) {
    return model.byHeight() ? target.height() : target.size();
  }

  /** The first target of the most frequent size. */
  private static Optional<TargetSpec> mostFrequent(List<TargetSpec> targets) {
    Map<Double, Long> counts =
        targets.stream().collect(Collectors.groupingBy(TargetSpec::size, Collectors.counting()));
    return targets.stream().max(Comparator.comparingLong(target -> counts.get(target.size())));
  }

  /**
   * Returns the part of the target that a detection must see in a zone: by the rule of the zone, or
   * else of the target, the scenario or the detection model.
   */
  static Body body(Scenario scenario, Zone zone, Detection detection) {
    TargetSpec target = of(scenario);
    if (!scenario.hasHeights()) {
      return Body.flat(size(target, detection.model()));
    }
    Seen seen =
        zone.seen()
            .or(target::seen)
            .or(() -> scenario.find(Scenario.SEEN))
            .orElse(detection.model().seen());
    boolean foreshortened = scenario.get(Scenario.FORESHORTENING) == Foreshortening.COSINE;
    double height = target.height();
    double size = size(target, detection.model());
    return new Body(size, seen.low(height), seen.high(height), foreshortened);
  }
}

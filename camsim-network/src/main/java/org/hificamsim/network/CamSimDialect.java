package org.hificamsim.network;

import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.TargetSpec;

/** Reads a scenario the way CamSim does, with the quirks that are asked for. */
public final class CamSimDialect {
  private CamSimDialect() {}

  /** The scenario as CamSim would run it. */
  public static Scenario read(Scenario scenario, NetworkSettings settings) {
    Scenario read = scenario;
    if (!settings.has(Quirk.Q17)) {
      read = read.withTargets(CamSimDialect::withAlias);
    }
    return settings.has(Quirk.Q3)
        ? read.withTargets(target -> withSwap(target, scenario.headings()))
        : read;
  }

  /** Q17 mended: {@code move} names an event's movement where {@code fqName} does not. */
  private static TargetSpec withAlias(TargetSpec target) {
    String alias = target.extras().getOrDefault("move", "");
    return target.origin() == TargetSpec.Origin.EVENT && target.movement().name().isEmpty()
        ? target.withMovement(alias)
        : target;
  }

  /** Q3: speed becomes the heading in radians where a class name leads to waypoints. */
  private static TargetSpec withSwap(TargetSpec target, Headings headings) {
    boolean throughClassName = !target.movement().name().isEmpty();
    return throughClassName && target.movement().shortName().equals("Waypoints")
        ? target.withSpeed(headings.radians(target.heading()))
        : target;
  }
}

package org.hificamsim.runs.compare;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.RunPlan;

/**
 * The policies that a comparison runs in addition to those asked for, to score all others by; the
 * best fixed one where it can be found in memory.
 */
public record ReferencePolicies(Set<Yardstick> yardsticks) {
  /** The exact optimum of every scenario and detection. */
  public static final ReferencePolicies OPTIMUM =
      new ReferencePolicies(EnumSet.of(Yardstick.OPTIMAL));

  /** That, and the best configuration that never changes. */
  public static final ReferencePolicies OPTIMUM_AND_BEST_FIXED =
      new ReferencePolicies(EnumSet.of(Yardstick.OPTIMAL, Yardstick.BEST_FIXED));

  private static final String NONE = "none";

  /** Bits that the search for the best fixed configuration may keep of a run: 12 MB. */
  private static final double MAX_BITS = 1e8;

  /** Copies what could change. */
  public ReferencePolicies {
    yardsticks = Set.copyOf(yardsticks);
  }

  /** What runs are scored by: the same for all policies. */
  record Group(Scenario scenario, Detection detection, int steps) {
    static Group of(RunPlan plan) {
      return new Group(plan.scenario(), plan.detection(), plan.steps());
    }
  }

  /**
   * The yardsticks of a text: their names with commas between, or {@code none}.
   *
   * @param option that an error names
   * @throws InputException when one is unknown or there twice
   */
  public static ReferencePolicies parse(String option, String text) {
    Set<Yardstick> asked = EnumSet.noneOf(Yardstick.class);
    for (String name : text.equals(NONE) ? new String[0] : text.split(",", -1)) {
      boolean added =
          Arrays.stream(Yardstick.values())
              .filter(one -> one.policy().equals(name.strip()))
              .anyMatch(asked::add);
      if (!added) {
        throw new InputException(
            "%s is '%s', expected optimal, bound or best-fixed, each once with commas between, or"
                    .formatted(option, text)
                + " none");
      }
    }
    return new ReferencePolicies(asked);
  }

  /** The plans asked for, the optima that they lack, and then the other yardsticks. */
  public List<RunPlan> with(List<RunPlan> plans) {
    List<RunPlan> all = new ArrayList<>(withOptimum(plans));
    if (yardsticks.contains(Yardstick.BEST_FIXED)) {
      all.addAll(
          missing(plans, Yardstick.BEST_FIXED).stream().filter(ReferencePolicies::fits).toList());
    }
    if (yardsticks.contains(Yardstick.BOUND)) {
      all.addAll(missing(plans, Yardstick.BOUND));
    }
    return all;
  }

  /** The plans asked for and the optima that they lack: those whose results are shown. */
  List<RunPlan> withOptimum(List<RunPlan> plans) {
    List<RunPlan> all = new ArrayList<>(plans);
    if (yardsticks.contains(Yardstick.OPTIMAL)) {
      all.addAll(missing(plans, Yardstick.OPTIMAL));
    }
    return all;
  }

  private static List<RunPlan> missing(List<RunPlan> plans, Yardstick yardstick) {
    String policy = yardstick.policy();
    Map<Group, RunPlan> missing = new LinkedHashMap<>();
    plans.forEach(plan -> missing.putIfAbsent(Group.of(plan), plan.withPolicy(policy)));
    plans.stream()
        .filter(plan -> plan.policy().equals(policy))
        .forEach(plan -> missing.remove(Group.of(plan)));
    return List.copyOf(missing.values());
  }

  /** It keeps a bit for each step, target, camera and view. */
  private static boolean fits(RunPlan plan) {
    Scenario scenario = plan.scenario();
    double views = scenario.everyCamera().mapToDouble(one -> views(scenario, one)).sum();
    return views * scenario.targets().size() * plan.steps() <= MAX_BITS;
  }

  private static double views(Scenario scenario, CameraSpec camera) {
    int pans = camera.optics().map(optics -> optics.pans().size()).orElse(1);
    return (double) pans * World.zoomLevels(scenario, camera).size();
  }
}

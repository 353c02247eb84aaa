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
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.RunPlan;

/**
 * The yardsticks that a comparison runs in addition to its plans. The best fixed configuration is
 * left out of plans for which its search would take too much memory.
 *
 * @param yardsticks the yardsticks to run
 * @param reachable the policy of {@link Yardstick#REACHABLE} with its options
 */
public record ReferencePolicies(Set<Yardstick> yardsticks, String reachable) {
  /** The exact optimum of every scenario and detection. */
  public static final ReferencePolicies OPTIMUM =
      new ReferencePolicies(EnumSet.of(Yardstick.OPTIMAL), Yardstick.REACHABLE.policy());

  /** The exact optimum, and the best configuration that never changes. */
  public static final ReferencePolicies OPTIMUM_AND_BEST_FIXED =
      new ReferencePolicies(
          EnumSet.of(Yardstick.OPTIMAL, Yardstick.BEST_FIXED), Yardstick.REACHABLE.policy());

  private static final String NONE = "none";

  /** The most bits that the search for the best fixed configuration may keep: 12 MB. */
  private static final double MAX_BITS = 1e8;

  /** Copies the set. */
  public ReferencePolicies {
    yardsticks = Set.copyOf(yardsticks);
  }

  /** The cases that share their yardsticks: those of all policies in one world. */
  record Group(Scenario scenario, Detection detection, int steps) {
    static Group of(RunPlan plan) {
      return new Group(plan.scenario(), plan.detection(), plan.steps());
    }
  }

  /**
   * Reads names of yardsticks with commas between them, or {@code none}.
   *
   * @param option the option that an error names
   * @throws InputException when a name is unknown or occurs twice
   */
  public static ReferencePolicies parse(String option, String text) {
    Set<Yardstick> named = EnumSet.noneOf(Yardstick.class);
    String reachable = Yardstick.REACHABLE.policy();
    for (String name :
        text.equals(NONE) ? List.<String>of() : Options.splitNames(text, part -> false)) {
      boolean added =
          Arrays.stream(Yardstick.values())
              .filter(yardstick -> yardstick.isRunBy(name))
              .anyMatch(named::add);
      if (!added) {
        throw new InputException(
            "%s is '%s', expected optimal, bound, best-fixed or reachable, each once with commas"
                    .formatted(option, text)
                + " between, or none");
      }
      reachable = Yardstick.REACHABLE.isRunBy(name) ? name : reachable;
    }
    return new ReferencePolicies(named, reachable);
  }

  /** Returns the plans, then the optima that they lack, then the other yardsticks. */
  public List<RunPlan> with(List<RunPlan> plans) {
    List<RunPlan> all = new ArrayList<>(withOptimum(plans));
    if (yardsticks.contains(Yardstick.BEST_FIXED)) {
      all.addAll(
          missing(plans, Yardstick.BEST_FIXED).stream().filter(ReferencePolicies::fits).toList());
    }
    if (yardsticks.contains(Yardstick.BOUND)) {
      all.addAll(missing(plans, Yardstick.BOUND));
    }
    if (yardsticks.contains(Yardstick.REACHABLE)) {
      all.addAll(missing(plans, Yardstick.REACHABLE));
    }
    return all;
  }

  /** Returns the plans and the optima that they lack, which are the plans that results show. */
  List<RunPlan> withOptimum(List<RunPlan> plans) {
    List<RunPlan> all = new ArrayList<>(plans);
    if (yardsticks.contains(Yardstick.OPTIMAL)) {
      all.addAll(missing(plans, Yardstick.OPTIMAL));
    }
    return all;
  }

  private List<RunPlan> missing(List<RunPlan> plans, Yardstick yardstick) {
    String policy = yardstick == Yardstick.REACHABLE ? reachable : yardstick.policy();
    Map<Group, RunPlan> missing = new LinkedHashMap<>();
    plans.forEach(plan -> missing.putIfAbsent(Group.of(plan), plan.withPolicy(policy)));
    plans.stream()
        .filter(plan -> yardstick.isRunBy(plan.policy()))
        .forEach(plan -> missing.remove(Group.of(plan)));
    return List.copyOf(missing.values());
  }

  /** Whether the search has the memory to keep a bit for each step, target, camera and view. */
  private static boolean fits(RunPlan plan) {
    Scenario scenario = plan.scenario();
    double views = scenario.everyCamera().mapToDouble(camera -> views(scenario, camera)).sum();
    return views * scenario.targets().size() * plan.steps() <= MAX_BITS;
  }

  private static double views(Scenario scenario, CameraSpec camera) {
    int pans = camera.optics().map(optics -> optics.pans().size()).orElse(1);
    return (double) pans * World.zoomLevels(scenario, camera).size();
  }
}

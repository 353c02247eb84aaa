package org.hificamsim.runs.compare;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.RunPlan;

/** The policies that a comparison runs beside those asked for, to score all others by. */
public enum ReferencePolicies {
  /** The exact optimum of every scenario and detection. */
  OPTIMUM(false),
  /** That, and the best configuration that never changes, where it can be found in memory. */
  OPTIMUM_AND_BEST_FIXED(true);

  static final String OPTIMAL = "optimal";
  static final String BEST_FIXED = "best-fixed";

  /** Bits that the search for the best fixed configuration may keep of a run: 12 MB. */
  private static final double MAX_BITS = 1e8;

  private final boolean bestFixed;

  ReferencePolicies(boolean bestFixed) {
    this.bestFixed = bestFixed;
  }

  /** What runs are scored by: the same for all policies. */
  record Group(Scenario scenario, Detection detection, int steps) {
    static Group of(RunPlan plan) {
      return new Group(plan.scenario(), plan.detection(), plan.steps());
    }
  }

  /** The plans asked for, the optima that they lack, and then the best fixed ones. */
  public List<RunPlan> with(List<RunPlan> plans) {
    List<RunPlan> all = new ArrayList<>(withOptimum(plans));
    if (bestFixed) {
      all.addAll(missing(plans, BEST_FIXED).stream().filter(ReferencePolicies::fits).toList());
    }
    return all;
  }

  /** The plans asked for and the optima that they lack: those whose results are shown. */
  static List<RunPlan> withOptimum(List<RunPlan> plans) {
    List<RunPlan> all = new ArrayList<>(plans);
    all.addAll(missing(plans, OPTIMAL));
    return all;
  }

  private static List<RunPlan> missing(List<RunPlan> plans, String policy) {
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

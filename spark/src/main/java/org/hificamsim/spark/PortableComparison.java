package org.hificamsim.spark;

import java.io.Serializable;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.FinishedRun;
import org.hificamsim.runs.compare.RunTask;

/** The plans of a comparison as text. An executor reads each plan once. */
final class PortableComparison implements Serializable {
  private static final long serialVersionUID = 1L;

  private final List<PortablePlan> plans;
  private transient Catalogue catalogue;
  private transient Map<Integer, RunPlan> readPlans;

  private PortableComparison(List<PortablePlan> plans) {
    this.plans = plans;
  }

  /** Writes plans as text, after checking that it gives the same plans. */
  static PortableComparison of(List<RunPlan> plans, Catalogue catalogue) {
    return new PortableComparison(
        plans.stream().map(plan -> PortablePlan.of(plan, catalogue)).toList());
  }

  /** Computes one run. */
  FinishedRun run(RunTask task) {
    return FinishedRun.of(new RunExecutor(catalogue()), plan(task.plan()), task.repeat());
  }

  private synchronized RunPlan plan(int index) {
    if (readPlans == null) {
      readPlans = new HashMap<>();
    }
    return readPlans.computeIfAbsent(index, key -> plans.get(key).plan(catalogue()));
  }

  private synchronized Catalogue catalogue() {
    if (catalogue == null) {
      catalogue = Catalogue.load();
    }
    return catalogue;
  }
}

package org.hificamsim.runs;

import java.util.Arrays;

/** A policy, model, movement or listener failed: in which run, at which step, how and where. */
public final class RunFault extends RuntimeException {
  private static final long serialVersionUID = 1L;

  RunFault(RunPlan plan, long seed, long step, RuntimeException cause) {
    super(
        "scenario %s, detection %s, policy %s, seed %s, step %s: %s"
            .formatted(
                plan.scenario().name(),
                plan.detection().name(),
                plan.policy(),
                seed,
                step,
                describe(cause)),
        cause);
  }

  /** What failed and where, in one line: the first place that is not in Java's own library. */
  public static String describe(Throwable fault) {
    String what = fault.getClass().getSimpleName() + ": " + fault.getMessage();
    return Arrays.stream(fault.getStackTrace())
        .filter(frame -> !frame.getClassName().matches("(java|jdk|sun)\\..*"))
        .findFirst()
        .map(frame -> what + " at " + frame)
        .orElse(what);
  }
}

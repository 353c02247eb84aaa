package org.hificamsim.runs;

import java.util.Arrays;

/** The failure of a policy, model, movement or listener, with the run, the step and the place. */
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

  /** The failure in one line, with the first place that is not in the JDK. */
  public static String describe(Throwable fault) {
    String message = fault.getClass().getSimpleName() + ": " + fault.getMessage();
    return Arrays.stream(fault.getStackTrace())
        .filter(frame -> !frame.getClassName().matches("(java|jdk|sun)\\..*"))
        .findFirst()
        .map(frame -> message + " at " + frame)
        .orElse(message);
  }
}

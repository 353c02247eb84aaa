package org.hificamsim.cli;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.compare.Yardstick;

/** Says before a comparison how long its optima will take, where that is long. */
final class OptimumTime {
  private static final double ENOUGH = 1; // seconds of a trial
  private static final int MOST_STEPS = 16;
  private static final double LONG = 600; // seconds
  private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

  private final RunExecutor executor;
  private final int threads;

  OptimumTime(Catalogue catalogue, int threads) {
    this.executor = new RunExecutor(catalogue);
    this.threads = threads;
  }

  /** How long the runs of an optimum take, by its first steps; seconds. */
  private record Slow(RunPlan plan, double perStep) {
    double all() {
      return perStep * plan.steps() * plan.repeats();
    }
  }

  /** One line where the optima that are run beside what was asked for take long. */
  void tell(List<RunPlan> asked, ReferencePolicies references, PrintWriter err) {
    List<RunPlan> all = references.with(asked);
    List<Slow> optima =
        all.subList(asked.size(), all.size()).stream()
            .filter(plan -> plan.policy().equals(Yardstick.OPTIMAL.policy()))
            .map(plan -> new Slow(plan, perStep(plan)))
            .toList();
    double seconds = optima.stream().mapToDouble(Slow::all).sum() / threads;
    Optional<Slow> slowest = optima.stream().max(Comparator.comparingDouble(Slow::all));
    if (seconds > LONG) {
      err.println(line(slowest.orElseThrow(), Duration.ofSeconds((long) seconds)));
    }
  }

  private static String line(Slow slowest, Duration all) {
    return String.format(
        Locale.ROOT,
        "the optimum of %s takes about %.2g s a step, all optima about %d:%02d hours;"
            + " --yardsticks bound takes a small part of it",
        slowest.plan.scenario().name(),
        slowest.perStep,
        all.toHours(),
        all.toMinutesPart());
  }

  /** Of ever more steps, until a trial is long enough: the first ones are not yet compiled. */
  private double perStep(RunPlan plan) {
    double perStep = 0;
    double took = 0;
    for (int steps = 1; took < ENOUGH && steps <= MOST_STEPS && steps <= plan.steps(); steps *= 4) {
      long start = System.nanoTime();
      executor.repeat(plan.withSteps(steps), 0, List.of());
      took = (System.nanoTime() - start) / NANOS;
      perStep = took / steps;
    }
    return perStep;
  }
}

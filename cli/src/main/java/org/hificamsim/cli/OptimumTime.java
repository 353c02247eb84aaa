package org.hificamsim.cli;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.compare.Yardstick;

/**
 * Says before a comparison how long its optima will take, where that is long. Some steps of a run
 * take a hundred times as long as others, so it tries steps of the whole run, each with few search
 * nodes.
 */
final class OptimumTime {
  private static final double ENOUGH = 1; // seconds of a trial
  private static final double MOST = 4; // seconds of a trial
  private static final int MOST_SAMPLES = 64;
  private static final int FIRST_STEPS = 1024; // of those, where a run has more
  private static final int NODES = 2_000; // of a step that is tried
  private static final double FULL = 500; // times as many has a step of the optimum
  private static final double LONG = 120; // seconds
  private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

  private final Catalogue catalogue;
  private final int threads;

  OptimumTime(Catalogue catalogue, int threads) {
    this.catalogue = catalogue;
    this.threads = threads;
  }

  /** Seconds that a step of an optimum takes; the same twice where the trial had nodes enough. */
  private record Slow(RunPlan plan, double least, double most) {
    double all(double perStep) {
      return perStep * plan.steps() * plan.repeats();
    }
  }

  /** One line where the optima that are run beside what was asked for take long. */
  void tell(List<RunPlan> asked, ReferencePolicies references, PrintWriter err) {
    List<RunPlan> all = references.with(asked);
    List<Slow> optima =
        all.subList(asked.size(), all.size()).stream()
            .filter(plan -> plan.policy().equals(Yardstick.OPTIMAL.policy()))
            .map(this::slow)
            .toList();
    double least = optima.stream().mapToDouble(one -> one.all(one.least)).sum() / threads;
    double most = optima.stream().mapToDouble(one -> one.all(one.most)).sum() / threads;
    Optional<Slow> slowest =
        optima.stream().max(Comparator.comparingDouble(one -> one.all(one.most)));
    if (most > LONG) {
      err.println(line(slowest.orElseThrow(), least, most));
    }
  }

  private static String line(Slow slowest, double least, double most) {
    return String.format(
        Locale.ROOT,
        "the optimum of %s takes %s s a step, all optima %s hours;"
            + " --yardsticks bound takes a small part of it",
        slowest.plan.scenario().name(),
        range(seconds(slowest.least), seconds(slowest.most)),
        range(hours(least), hours(most)));
  }

  private static String range(String least, String most) {
    return least.equals(most) ? "about " + most : least + " to " + most;
  }

  private static String seconds(double seconds) {
    return String.format(Locale.ROOT, "%.2g", seconds);
  }

  private static String hours(double seconds) {
    Duration time = Duration.ofSeconds((long) seconds);
    return String.format(Locale.ROOT, "%d:%02d", time.toHours(), time.toMinutesPart());
  }

  /** By ever more steps, until a trial is long enough: the first ones are not yet compiled. */
  private Slow slow(RunPlan plan) {
    Trial trial;
    int samples = 1;
    do {
      samples *= 4;
      trial = new Trial(plan.steps(), samples);
      trial.run(plan);
    } while (trial.least < ENOUGH && samples < MOST_SAMPLES);
    return new Slow(plan, trial.least / trial.tried, trial.most / trial.tried);
  }

  /** Cameras that stay, and an optimum that is searched now and then. */
  private final class Trial implements ZoomPolicy {
    private final ProvingZoomPolicy optimal =
        (ProvingZoomPolicy)
            catalogue.policies().create(Yardstick.OPTIMAL.policy() + ":nodes=" + NODES);
    private final int steps;
    private final int every;
    private int tried;
    private double least;
    private double most;

    Trial(int steps, int samples) {
      this.steps = Math.min(steps, FIRST_STEPS);
      this.every = Math.max(1, this.steps / samples);
    }

    void run(RunPlan plan) {
      World world = new World(plan.scenario(), catalogue.movements(), plan.seed());
      Simulation run = new Simulation(world, plan.detection(), this, plan.seed(), List.of());
      long start = System.nanoTime();
      for (int step = 0; step < steps && since(start) < MOST; step++) {
        run.step();
      }
    }

    @Override
    public String name() {
      return optimal.name();
    }

    @Override
    public void begin(NetworkView network, SplittableRandom random) {
      optimal.begin(network, random);
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      if (network.step() % every == 0) {
        long start = System.nanoTime();
        long unproven = optimal.unprovenSteps();
        optimal.decide(network, views.clone());
        double took = since(start);
        tried++;
        least += took;
        most += optimal.unprovenSteps() > unproven ? FULL * took : took;
      }
    }
  }

  private static double since(long start) {
    return (System.nanoTime() - start) / NANOS;
  }
}

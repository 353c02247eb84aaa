package org.hificamsim.cli;

import static java.util.Comparator.comparingDouble;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
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
  private static final int NODES = 10_000; // of a step that is tried
  private static final double FULL = 100; // times as many has a step of the optimum
  private static final double LONG = 120; // seconds
  private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

  private final Catalogue catalogue;
  private final int threads;

  OptimumTime(Catalogue catalogue, int threads) {
    this.catalogue = catalogue;
    this.threads = threads;
  }

  /** One line where the optima that are run in addition take long. */
  void tell(List<RunPlan> asked, ReferencePolicies references, PrintWriter err) {
    List<RunPlan> all = references.with(asked);
    List<Trial> trials =
        all.subList(asked.size(), all.size()).stream()
            .filter(plan -> plan.policy().equals(Yardstick.OPTIMAL.policy()))
            .map(this::trial)
            .toList();
    double least = trials.stream().mapToDouble(one -> one.all(one.least)).sum() / threads;
    double most = trials.stream().mapToDouble(one -> one.all(one.most)).sum() / threads;
    if (most > LONG) {
      Trial slowest = Collections.max(trials, comparingDouble(one -> one.all(one.most)));
      err.println(
          "the optimum of %s takes %s s a step, all optima %s hours;"
                  .formatted(
                      slowest.plan.scenario().name(),
                      range(
                          seconds(slowest.least / slowest.tried),
                          seconds(slowest.most / slowest.tried)),
                      range(hours(least), hours(most)))
              + " --yardsticks bound takes a small part of it");
    }
  }

  private static String range(String least, String most) {
    return least.equals(most) ? "about " + most : least + " to " + most;
  }

  private static String seconds(double seconds) {
    return Texts.format(seconds < 10 ? "%.2g" : "%.0f", seconds);
  }

  private static String hours(double seconds) {
    Duration time = Duration.ofSeconds((long) seconds);
    return Texts.format("%d:%02d", time.toHours(), time.toMinutesPart());
  }

  /** By ever more steps, until a trial is long enough: the first ones are not yet compiled. */
  private Trial trial(RunPlan plan) {
    Trial trial = new Trial(plan, 4);
    for (int samples = 16; trial.least < ENOUGH && samples <= MOST_SAMPLES; samples *= 4) {
      trial = new Trial(plan, samples);
    }
    return trial;
  }

  /**
   * Cameras that stay, and an optimum that is searched now and then: between {@code least} seconds,
   * which that took, and {@code most}, what it would have taken where it gave up its proof.
   */
  private final class Trial implements ZoomPolicy {
    private final ProvingZoomPolicy optimal =
        (ProvingZoomPolicy)
            catalogue.policies().create(Yardstick.OPTIMAL.policy() + ":nodes=" + NODES);
    private final RunPlan plan;
    private final int every;
    private int tried;
    private double least;
    private double most;

    Trial(RunPlan plan, int samples) {
      this.plan = plan;
      int steps = Math.min(plan.steps(), FIRST_STEPS);
      every = Math.max(1, steps / samples);
      World world = new World(plan.scenario(), catalogue.movements(), plan.seed());
      Simulation run = new Simulation(world, plan.detection(), this, plan.seed(), List.of());
      long start = System.nanoTime();
      for (int step = 0; step < steps && since(start) < MOST; step++) {
        run.step();
      }
    }

    /** Seconds of all runs of the plan, from those of the steps that were tried. */
    double all(double seconds) {
      return seconds / tried * plan.steps() * plan.repeats();
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

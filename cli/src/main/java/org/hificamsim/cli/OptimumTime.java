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
  private static final int FEW = 4; // steps that are tried
  private static final int MANY = 64;
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
    double seconds = trials.stream().mapToDouble(Trial::seconds).sum() / threads;
    if (seconds > LONG) {
      Trial slowest = Collections.max(trials, comparingDouble(Trial::seconds));
      double step = slowest.most / slowest.tried;
      Duration time = Duration.ofSeconds((long) seconds);
      err.println(
          Texts.format(
              "the optimum of %s takes up to "
                  + (step < 10 ? "%.2g" : "%.0f")
                  + " s a step, all optima up to %d:%02d hours; --yardsticks bound takes a small"
                  + " part of it",
              slowest.plan.scenario().name(),
              step,
              time.toHours(),
              time.toMinutesPart()));
    }
  }

  /** Of more steps where the first few took little: they are not yet compiled. */
  private Trial trial(RunPlan plan) {
    Trial trial = new Trial(plan, FEW);
    return trial.took < ENOUGH ? new Trial(plan, MANY) : trial;
  }

  /**
   * Cameras that stay, and an optimum that is searched now and then; {@code most} is what that
   * would have taken where it gave up its proof.
   */
  private final class Trial implements ZoomPolicy {
    private final ProvingZoomPolicy optimal =
        (ProvingZoomPolicy)
            catalogue.policies().create(Yardstick.OPTIMAL.policy() + ":nodes=" + NODES);
    private final RunPlan plan;
    private final int every;
    private int tried;
    private double took;
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
    double seconds() {
      return most / tried * plan.work();
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
        double seconds = since(start);
        tried++;
        took += seconds;
        most += optimal.unprovenSteps() > unproven ? FULL * seconds : seconds;
      }
    }
  }

  private static double since(long start) {
    return (System.nanoTime() - start) / NANOS;
  }
}

package org.hificamsim.runs.hints;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.compare.Yardstick;

/**
 * Estimates before a comparison how long its exact optima will take. A few steps of a run take a
 * hundred times as long as others, so steps from all over the run are tried, each with a limited
 * search.
 */
public final class OptimumTime {
  private static final double ENOUGH_TRIAL_SECONDS = 1;
  private static final double MAX_TRIAL_SECONDS = 4;
  private static final int FEW_STEPS = 4;
  private static final int MANY_STEPS = 64;

  /** The number of first steps of a run among which steps are tried. */
  private static final int FIRST_STEPS = 1024;

  /** The limit of search nodes in a step that is tried; a real step may use 100 times as many. */
  private static final int NODES = 10_000;

  private static final double NODES_FACTOR = 100;

  private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

  private final Catalogue catalogue;
  private final int threads;

  /** Creates estimates for a comparison that is computed by a number of threads. */
  public OptimumTime(Catalogue catalogue, int threads) {
    this.catalogue = catalogue;
    this.threads = threads;
  }

  /**
   * An upper estimate of times.
   *
   * @param slowest the scenario whose optimum takes longest
   * @param secondsPerStep the seconds per step of that scenario
   * @param total the total of all optima
   */
  public record Forecast(String slowest, double secondsPerStep, Duration total) {}

  /**
   * Estimates the time of the optima that a comparison computes in addition to its plans; empty if
   * there are none. Estimating takes up to four seconds for each scenario and detection.
   */
  public Optional<Forecast> forecast(List<RunPlan> plans, ReferencePolicies references) {
    List<RunPlan> withReferences = references.with(plans);
    List<Trial> trials =
        withReferences.subList(plans.size(), withReferences.size()).stream()
            .filter(plan -> plan.policy().equals(Yardstick.OPTIMAL.policy()))
            .map(this::trial)
            .toList();
    double seconds = trials.stream().mapToDouble(Trial::planSeconds).sum() / threads;
    return trials.stream()
        .max(Comparator.comparingDouble(Trial::planSeconds))
        .map(
            slowest ->
                new Forecast(
                    slowest.plan.scenario().name(),
                    slowest.secondsPerStep(),
                    Duration.ofSeconds((long) seconds)));
  }

  /**
   * Tries more steps if the first few were quick, since these ran before Java compiled the code.
   */
  private Trial trial(RunPlan plan) {
    Trial trial = new Trial(plan, FEW_STEPS);
    return trial.triedSeconds < ENOUGH_TRIAL_SECONDS ? new Trial(plan, MANY_STEPS) : trial;
  }

  /**
   * A run whose cameras never change, while the optimum of every n-th step is searched and timed.
   */
  private final class Trial implements OraclePolicy {
    private final ProvingZoomPolicy optimal =
        (ProvingZoomPolicy)
            catalogue.policies().create(Yardstick.OPTIMAL.policy() + ":nodes=" + NODES);
    private final RunPlan plan;
    private final int interval;
    private int tried;
    private double triedSeconds;

    /** The seconds if each search that gave up its proof had used all nodes of a real run. */
    private double mostSeconds;

    Trial(RunPlan plan, int stepsToTry) {
      this.plan = plan;
      int steps = Math.min(plan.steps(), FIRST_STEPS);
      interval = Math.max(1, steps / stepsToTry);
      World world = new World(plan.scenario(), catalogue.movements(), plan.seed());
      Simulation run = new Simulation(world, plan.detection(), this, plan.seed(), List.of());
      long start = System.nanoTime();
      for (int step = 0; step < steps && secondsSince(start) < MAX_TRIAL_SECONDS; step++) {
        run.step();
      }
    }

    double secondsPerStep() {
      return mostSeconds / tried;
    }

    /** The seconds of all runs of the plan. */
    double planSeconds() {
      return secondsPerStep() * plan.work();
    }

    @Override
    public String name() {
      return optimal.name();
    }

    @Override
    public void begin(OracleView network, SplittableRandom random) {
      optimal.begin(network, random);
    }

    @Override
    public void decide(OracleView network, int[] views) {
      if (network.step() % interval == 0) {
        long start = System.nanoTime();
        long unproven = optimal.unprovenSteps();
        optimal.decide(network, views.clone());
        double took = secondsSince(start);
        tried++;
        triedSeconds += took;
        mostSeconds += optimal.unprovenSteps() > unproven ? NODES_FACTOR * took : took;
      }
    }
  }

  private static double secondsSince(long start) {
    return (System.nanoTime() - start) / NANOS;
  }
}

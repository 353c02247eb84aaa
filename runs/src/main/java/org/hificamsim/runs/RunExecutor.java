package org.hificamsim.runs;

import java.io.Closeable;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.engine.Behaviour;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.world.World;

/** Runs the repeats of a plan one after the other. */
public final class RunExecutor {
  private final Catalogue catalogue;

  /** Creates an executor that finds the parts that plans name in a catalogue. */
  public RunExecutor(Catalogue catalogue) {
    this.catalogue = catalogue;
  }

  /**
   * Runs every repeat.
   *
   * @param listeners makes the listeners of a repeat, given its number
   * @return one result for each repeat, in order
   */
  public List<RunResult> execute(RunPlan plan, IntFunction<List<StepListener>> listeners) {
    List<RunResult> results = new ArrayList<>();
    for (int run = 0; run < plan.repeats(); run++) {
      results.add(repeat(plan, run, listeners.apply(run)));
    }
    return results;
  }

  /**
   * Runs one repeat.
   *
   * @throws RunFault when a policy, model, movement or listener fails
   */
  public RunResult repeat(RunPlan plan, int run, List<StepListener> listeners) {
    return repeat(plan, run, catalogue.policies().create(plan.policy()), listeners);
  }

  /** Runs one repeat with a policy that the catalogue need not know. */
  public RunResult repeat(RunPlan plan, int run, ZoomPolicy policy, List<StepListener> listeners) {
    RunMeters meters = RunMeters.of(plan, catalogue);
    if (policy instanceof HindsightZoomPolicy hindsight) {
      rehearse(plan, run, hindsight);
    }
    Simulation simulation = simulation(plan, run, policy, meters.with(listeners));
    try {
      run(simulation, plan, run);
      Measured measured = Measured.of(meters, plan, policy, simulation);
      return RunResult.of(run, plan.seed(run), measured);
    } finally {
      close(policy);
    }
  }

  /** Closes what a policy keeps open, such as a program of its own. */
  private static void close(ZoomPolicy policy) {
    if (policy instanceof Closeable closeable) {
      Io.run(closeable::close);
    }
  }

  /**
   * Checks that a plan can start: that its movements exist and its policy suits its cameras.
   *
   * @throws org.hificamsim.core.InputException when the plan cannot start
   */
  public void check(RunPlan plan) {
    simulation(plan, 0, catalogue.policies().create(plan.policy()), List.of());
  }

  private void rehearse(RunPlan plan, int run, HindsightZoomPolicy policy) {
    StepListener rehearsal = (network, coverage) -> policy.rehearse(network);
    ZoomPolicy widest = catalogue.policies().create("zoom-out");
    run(simulation(plan, run, widest, List.of(rehearsal)), plan, run);
  }

  private static void run(Simulation simulation, RunPlan plan, int run) {
    try {
      simulation.run(plan.steps());
    } catch (InputException | UncheckedIOException e) {
      throw e;
    } catch (RuntimeException e) {
      throw new RunFault(plan, plan.seed(run), simulation.network().step(), e);
    }
  }

  private Simulation simulation(
      RunPlan plan, int run, ZoomPolicy policy, List<StepListener> listeners) {
    long seed = plan.seed(run);
    World world = new World(plan.scenario(), catalogue.movements(), seed);
    Cooperation cooperation =
        plan.network().isEmpty()
            ? Cooperation.NONE
            : catalogue.networks().create(plan.network()).begin(world, plan.detection(), seed);
    Behaviour behaviour = new Behaviour(policy, cooperation);
    return new Simulation(world, plan.detection(), behaviour, seed, listeners);
  }
}

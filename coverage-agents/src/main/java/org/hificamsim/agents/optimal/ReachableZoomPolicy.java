package org.hificamsim.agents.optimal;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.BoundedZoomPolicy;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;
import org.hificamsim.solver.way.TravelTimes;
import org.hificamsim.solver.way.WaySolver;

/**
 * The best that the cameras could have scored, given how long their moves take, if everything had
 * been known in advance. It plays a plan of all ways ({@link WaySolver}), and bounds what any
 * policy could have scored. If no move takes time, it plays as {@link OptimalZoomPolicy}.
 */
public final class ReachableZoomPolicy implements HindsightZoomPolicy, BoundedZoomPolicy {
  private static final int DEFAULT_ITERATIONS = 150;

  private final int iterations;
  private final RunDetections run = new RunDetections();
  private final OptimalZoomPolicy optimal =
      new OptimalZoomPolicy(AbstractExactZoomPolicy.DEFAULT_NODES);
  private List<BitSet> online;
  private boolean takesTime;
  private WaySolver solver;
  private int step;

  /** Reads the option {@code iterations}. */
  public ReachableZoomPolicy(Options options) {
    iterations =
        options.integer(
            "iterations", DEFAULT_ITERATIONS, 0, Integer.MAX_VALUE, "of the search for a bound");
  }

  @Override
  public String name() {
    return "reachable";
  }

  @Override
  public void rehearse(OracleView network) {
    run.add(network);
  }

  @Override
  public void begin(OracleView network, SplittableRandom random) {
    optimal.begin(network, random);
    online = run.online();
  }

  @Override
  public void decide(OracleView network, int[] views) {
    if (step == 0) {
      prepare(network);
    }
    if (!takesTime) {
      optimal.decide(network, views);
    } else {
      for (int camera = 0; camera < network.cameras(); camera++) {
        checkOnline(network, camera);
        views[camera] = network.online(camera) ? solver.goals(camera)[step] : views[camera];
      }
    }
    step++;
  }

  private void prepare(OracleView network) {
    List<TravelTimes> times = new ArrayList<>();
    for (int camera = 0; camera < network.cameras(); camera++) {
      times.add(times(network, camera));
      takesTime |= times.get(camera).takesTime();
    }
    if (takesTime) {
      solver = new WaySolver(run.ways(times));
      solver.solve(iterations);
    }
  }

  private static TravelTimes times(OracleView network, int camera) {
    TravelTimes times = TravelTimes.of(network, camera);
    if (times.takesTime() && !network.movesBlindly(camera)) {
      throw InputException.of(
          "camera %s sees while it moves, expected moving=\"blind\" with policy reachable, whose"
              + " bound does not count what is seen on the way",
          network.cameraName(camera));
    }
    return times;
  }

  /**
   * Checks that a camera is on as in the rehearsal: a battery that is empty sooner or later would
   * make the bound wrong.
   */
  private void checkOnline(OracleView network, int camera) {
    if (online.get(camera).get(step) != network.online(camera)) {
      throw InputException.of(
          "camera %s is on or off in step %s as its moves decide, expected cameras without"
              + " batteries with policy reachable",
          network.cameraName(camera), step);
    }
  }

  @Override
  public double reachableGap() {
    return takesTime ? solver.bound() - solver.score() : optimal.gap();
  }

  /** The score of the plan, which the run reaches; NaN if it is the optimum of each step. */
  public double planScore() {
    return takesTime ? solver.score() : Double.NaN;
  }
}

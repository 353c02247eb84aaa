package org.hificamsim.agents.optimal;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.search.StepSolver;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.NetworkView;

/**
 * The best configuration of all if cameras may turn to any angle between their outermost pan
 * angles, found exactly at each step: {@code optimal:pan=continuous}. It is a bound for cameras
 * with any list of angles between.
 *
 * <p>Only {@linkplain PanSweep maximal detection sets} are searched. Among configurations with the
 * best score it is the one in which camera 0 has its first set, then camera 1, and so on; sets are
 * in the order of the zoom levels, the narrowest first.
 */
final class AimedOptimalZoomPolicy extends AbstractExactZoomPolicy implements AimingZoomPolicy {
  private final int nodes;
  private AimedSets sets;
  private double[] pans = {};

  /**
   * @param nodes search nodes after which a step's proof is given up, 0 or more
   */
  AimedOptimalZoomPolicy(int nodes) {
    this.nodes = nodes;
  }

  @Override
  public String name() {
    return "optimal";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    if (network.objective().ofCoverableAlone()) {
      throw InputException.of(
          "objective is %s, which counts what listed pan angles can cover: expected"
              + " another with policy optimal:pan=continuous",
          network.objective().text());
    }
    sets = new AimedSets(network);
    search(sets, new StepSolver(network.objective(), sets.problem(), nodes));
    pans = new double[network.cameras()];
    Arrays.fill(pans, Double.NaN);
  }

  @Override
  void chose(int camera, int set) {
    pans[camera] = sets.panOf(set);
  }

  @Override
  public double pan(int camera) {
    return pans[camera];
  }
}

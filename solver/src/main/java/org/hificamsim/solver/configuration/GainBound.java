package org.hificamsim.solver.configuration;

import org.hificamsim.solver.BitMatrix;

/**
 * Bounds a sum of worths by what each camera can add to the coverage that is certain: the set with
 * the greatest gain. A target's gain is the slope of its worth's concave majorant. This is the
 * bound of the greedy algorithm for submodular functions (Nemhauser, Wolsey and Fisher 1978),
 * extended to worths that are not concave.
 *
 * <p>Gains are those of the last {@link #update}.
 */
final class GainBound {
  private final CoverageProblem problem;
  private final BitMatrix masks;
  private final RemainingSets remaining;
  private final TargetWorth worth;

  /** The undecided targets of the camera whose sets are updated. */
  private final BitMatrix undecided;

  private final long[] targetGains;
  private final long[] setGains;
  private final long[] cameraGains;

  GainBound(CoverageProblem problem, RemainingSets remaining, TargetWorth worth) {
    this.problem = problem;
    masks = problem.masks();
    this.remaining = remaining;
    this.worth = worth;
    undecided = new BitMatrix(1, problem.maxTargets());
    targetGains = new long[problem.maxTargets()];
    setGains = new long[problem.maxSets()];
    cameraGains = new long[problem.maxCameras()];
  }

  /**
   * Computes the greatest gain of each set that remains now.
   *
   * @return the sum of all cameras' greatest gains
   */
  long update() {
    for (int target = 0; target < problem.targets(); target++) {
      targetGains[target] =
          worth.slope(remaining.minCoverage(target), remaining.maxCoverage(target));
    }
    long sum = 0;
    for (int i = 0; i < remaining.choosingCameras(); i++) {
      int camera = remaining.choosingCamera(i);
      cameraGains[camera] = remaining.isOpen(camera) ? updateSets(camera) : 0;
      sum += cameraGains[camera];
    }
    return sum;
  }

  private long updateSets(int camera) {
    remaining.copyUndecided(camera, undecided);
    long greatest = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set)) {
        setGains[set] = masks.sumCommon(set, undecided, 0, targetGains);
        greatest = Math.max(greatest, setGains[set]);
      }
    }
    return greatest;
  }

  /**
   * Removes the sets with which the sum cannot reach what is required.
   *
   * @param surplus how far the bound exceeds the sum required
   * @return whether every camera still has a set
   */
  boolean removeSetsBelow(long surplus) {
    return remaining.removeBelow(setGains, cameraGains, surplus);
  }

  /** The greatest gain of a set of an open camera. */
  long gain(int set) {
    return setGains[set];
  }

  /** The greatest gain of all sets of an open camera. */
  long greatestGain(int camera) {
    return cameraGains[camera];
  }
}

package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * Weights of the targets, and the bound that they give: coverage k is possible only if the heaviest
 * remaining sets of all cameras together weigh at least k times all targets. That holds for any
 * weights; they are integers, so that the bound is exact.
 */
final class Weights {
  private final CoverageProblem problem;
  private final Remaining remaining;
  private final long[] ones;
  private final long[] weights;
  private final long[] heaviest;
  private long heaviestTotal;
  private long targetTotal;

  Weights(CoverageProblem problem, Remaining remaining) {
    this.problem = problem;
    this.remaining = remaining;
    ones = new long[problem.maxTargets()];
    Arrays.fill(ones, 1);
    weights = new long[problem.maxSets()];
    heaviest = new long[problem.maxCameras()];
  }

  /** Gives every target the same weight. */
  void reset() {
    weigh(ones);
  }

  /** Gives each target a weight of 0 or more. */
  void weigh(long[] targetWeights) {
    targetTotal = 0;
    for (int target = 0; target < problem.targets(); target++) {
      targetTotal += targetWeights[target];
    }
    for (int set = 0; set < problem.sets(); set++) {
      weights[set] = 0;
      for (int word = 0; word < problem.words(); word++) {
        for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
          weights[set] += targetWeights[(word << 6) + Long.numberOfTrailingZeros(bits)];
        }
      }
    }
    heaviestTotal = 0;
    for (int camera = 0; camera < problem.cameras(); camera++) {
      heaviest[camera] = findHeaviest(camera);
      heaviestTotal += heaviest[camera];
    }
  }

  /** The largest coverage that the weights do not rule out; all cameras when nothing weighs. */
  int bound() {
    return targetTotal == 0 ? problem.cameras() : (int) (heaviestTotal / targetTotal);
  }

  /** By how much the heaviest sets outweigh what coverage k takes; below 0 it is impossible. */
  long surplus(int k) {
    return heaviestTotal - k * targetTotal;
  }

  /** By how much a set is lighter than its camera's heaviest one. */
  long loss(int set) {
    return heaviest[problem.cameraOf(set)] - weights[set];
  }

  /** Updates the bound after a removal that left its camera another set. */
  void removed(int set) {
    int camera = problem.cameraOf(set);
    if (weights[set] == heaviest[camera]) {
      long next = findHeaviest(camera);
      heaviestTotal += next - heaviest[camera];
      heaviest[camera] = next;
    }
  }

  /** Updates the bound after a removal was undone. */
  void restored(int set) {
    int camera = problem.cameraOf(set);
    if (weights[set] > heaviest[camera]) {
      heaviestTotal += weights[set] - heaviest[camera];
      heaviest[camera] = weights[set];
    }
  }

  private long findHeaviest(int camera) {
    long most = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set)) {
        most = Math.max(most, weights[set]);
      }
    }
    return most;
  }
}

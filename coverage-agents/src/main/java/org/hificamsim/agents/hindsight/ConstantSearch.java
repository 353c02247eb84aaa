package org.hificamsim.agents.hindsight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;

/**
 * The search for the constant configuration with the best performance over a run that has been
 * seen: branch and bound over the cameras, from what coordinate ascent finds.
 *
 * <p>A level whose detections another level of the camera includes is left out; where each camera
 * has one level left, there is nothing to search. The bound of a partial configuration lets every
 * undecided camera detect at all its levels at once.
 */
final class ConstantSearch {
  private record Option(int level, long bound) {}

  private final RunDetections run;
  private final List<int[]> candidates = new ArrayList<>();
  private final BitSet[] anyLevel;
  private final int[] k;
  private final int[] trial;
  private int[] best;
  private long bestPerformance;
  private long nodesLeft;
  private boolean complete = true;

  /**
   * @param nodes how many partial configurations may be looked at
   */
  ConstantSearch(RunDetections run, long nodes) {
    this.run = run;
    this.nodesLeft = nodes;
    this.anyLevel = new BitSet[run.cameras()];
    this.k = new int[run.moments()];
    this.trial = new int[run.cameras()];
    for (int camera = 0; camera < run.cameras(); camera++) {
      candidates.add(candidates(camera));
      anyLevel[camera] = new BitSet();
      for (int level : candidates.get(camera)) {
        anyLevel[camera].or(run.detected(camera, level));
      }
      trial[camera] = candidates.get(camera)[candidates.get(camera).length - 1];
    }
    ascend();
    Arrays.fill(k, 0);
    for (int camera = 0; camera < run.cameras(); camera++) {
      count(anyLevel[camera], 1);
    }
    branch(0);
  }

  /** One level per camera. */
  int[] levels() {
    return best.clone();
  }

  /** The performance of {@link #levels} over the run. */
  long performance() {
    return bestPerformance;
  }

  /** Whether no constant configuration is better. */
  boolean proven() {
    return complete;
  }

  /** The camera's levels without those that another includes; of equal ones the narrowest stays. */
  private int[] candidates(int camera) {
    List<Integer> kept = new ArrayList<>();
    for (int level = 0; level < run.levels(camera); level++) {
      if (!superfluous(camera, level)) {
        kept.add(level);
      }
    }
    return kept.stream().mapToInt(Integer::intValue).toArray();
  }

  private boolean superfluous(int camera, int level) {
    for (int other = 0; other < run.levels(camera); other++) {
      boolean within = other != level && minus(camera, level, camera, other).isEmpty();
      if (within && (other < level || !minus(camera, other, camera, level).isEmpty())) {
        return true;
      }
    }
    return false;
  }

  private BitSet minus(int camera, int level, int otherCamera, int otherLevel) {
    BitSet rest = (BitSet) run.detected(camera, level).clone();
    rest.andNot(run.detected(otherCamera, otherLevel));
    return rest;
  }

  /** Changes one camera after the other to its best level, until none gets better. */
  private void ascend() {
    for (int camera = 0; camera < trial.length; camera++) {
      count(run.detected(camera, trial[camera]), 1);
    }
    best = trial.clone();
    bestPerformance = run.performance(k);
    boolean better = true;
    while (better) {
      better = false;
      for (int camera = 0; camera < trial.length; camera++) {
        better |= improve(camera);
      }
    }
  }

  private boolean improve(int camera) {
    boolean better = false;
    for (int level : candidates.get(camera)) {
      int before = trial[camera];
      exchange(camera, level);
      long performance = run.performance(k);
      if (performance > bestPerformance) {
        bestPerformance = performance;
        best = trial.clone();
        better = true;
      } else {
        exchange(camera, before);
      }
    }
    return better;
  }

  private void exchange(int camera, int level) {
    count(run.detected(camera, trial[camera]), -1);
    count(run.detected(camera, level), 1);
    trial[camera] = level;
  }

  private void branch(int camera) {
    if (camera == trial.length) {
      best = trial.clone();
      bestPerformance = run.performance(k);
      return;
    }
    for (Option option : options(camera)) {
      if (option.bound() <= bestPerformance) {
        return;
      }
      if (nodesLeft-- <= 0) {
        complete = false;
        return;
      }
      BitSet lost = lost(camera, option.level());
      count(lost, -1);
      trial[camera] = option.level();
      branch(camera + 1);
      count(lost, 1);
    }
  }

  /** The camera's levels with their bounds, the most promising first. */
  private List<Option> options(int camera) {
    List<Option> options = new ArrayList<>();
    for (int level : candidates.get(camera)) {
      BitSet lost = lost(camera, level);
      count(lost, -1);
      options.add(new Option(level, run.performance(k)));
      count(lost, 1);
    }
    options.sort(Comparator.comparingLong(Option::bound).reversed());
    return options;
  }

  /** The moments that the camera detects at some level but not at this one. */
  private BitSet lost(int camera, int level) {
    BitSet lost = (BitSet) anyLevel[camera].clone();
    lost.andNot(run.detected(camera, level));
    return lost;
  }

  private void count(BitSet moments, int change) {
    for (int moment = moments.nextSetBit(0); moment >= 0; moment = moments.nextSetBit(moment + 1)) {
      k[moment] += change;
    }
  }
}

package org.hificamsim.agents.hindsight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;

/**
 * The search for the constant configuration with the best score over a run that has been seen:
 * branch and bound over the cameras, from what coordinate ascent finds from the last views and from
 * {@value #STARTS} random configurations, the same in every run.
 *
 * <p>A view whose detections another view of the camera includes is left out; where each camera has
 * one view left, there is nothing to search. The bound of a partial configuration lets every
 * undecided camera detect at all its views at once.
 */
final class ConstantSearch {
  private static final int STARTS = 16;

  private record Option(int view, double bound) {}

  private final RunDetections run;
  private final List<int[]> candidates = new ArrayList<>();
  private final BitSet[] anyView;
  private final int[] k;
  private final int[] trial;
  private int[] best;
  private double bestScore = -1;
  private double climbed;
  private long nodesLeft;
  private boolean complete = true;

  /**
   * @param nodes how many partial configurations may be looked at
   */
  ConstantSearch(RunDetections run, long nodes) {
    this.run = run;
    this.nodesLeft = nodes;
    this.anyView = new BitSet[run.cameras()];
    this.k = new int[run.moments()];
    this.trial = new int[run.cameras()];
    for (int camera = 0; camera < run.cameras(); camera++) {
      candidates.add(candidates(camera));
      anyView[camera] = new BitSet();
      for (int view : candidates.get(camera)) {
        anyView[camera].or(run.detected(camera, view));
      }
      trial[camera] = candidates.get(camera)[candidates.get(camera).length - 1];
    }
    climb();
    Arrays.fill(k, 0);
    for (int camera = 0; camera < run.cameras(); camera++) {
      count(anyView[camera], 1);
    }
    branch(0);
  }

  /** One view per camera. */
  int[] views() {
    return best.clone();
  }

  /** The score of {@link #views} over the run. */
  double score() {
    return bestScore;
  }

  /** Whether no constant configuration is better. */
  boolean proven() {
    return complete;
  }

  /** The camera's views without those that another includes; of equal ones the narrowest stays. */
  private int[] candidates(int camera) {
    List<Integer> kept = new ArrayList<>();
    for (int view = 0; view < run.views(camera); view++) {
      if (!superfluous(camera, view)) {
        kept.add(view);
      }
    }
    return kept.stream().mapToInt(Integer::intValue).toArray();
  }

  private boolean superfluous(int camera, int view) {
    for (int other = 0; other < run.views(camera); other++) {
      boolean within = other != view && minus(camera, view, camera, other).isEmpty();
      if (within && (other < view || !minus(camera, other, camera, view).isEmpty())) {
        return true;
      }
    }
    return false;
  }

  private BitSet minus(int camera, int view, int otherCamera, int otherLevel) {
    BitSet rest = (BitSet) run.detected(camera, view).clone();
    rest.andNot(run.detected(otherCamera, otherLevel));
    return rest;
  }

  /** One summit may be far below the next where it takes two cameras to gain anything. */
  private void climb() {
    ascend();
    SplittableRandom random = new SplittableRandom(0);
    boolean choice = candidates.stream().anyMatch(views -> views.length > 1);
    for (int start = 0; choice && start < STARTS; start++) {
      Arrays.setAll(
          trial, camera -> candidates.get(camera)[random.nextInt(candidates.get(camera).length)]);
      ascend();
    }
  }

  /** Changes one camera after the other to its best view, until none gets better. */
  private void ascend() {
    Arrays.fill(k, 0);
    for (int camera = 0; camera < trial.length; camera++) {
      count(run.detected(camera, trial[camera]), 1);
    }
    climbed = run.score(k);
    boolean better = true;
    while (better) {
      better = false;
      for (int camera = 0; camera < trial.length; camera++) {
        better |= improve(camera);
      }
    }
    if (climbed > bestScore) {
      bestScore = climbed;
      best = trial.clone();
    }
  }

  private boolean improve(int camera) {
    boolean better = false;
    for (int view : candidates.get(camera)) {
      int before = trial[camera];
      exchange(camera, view);
      double score = run.score(k);
      if (score > climbed) {
        climbed = score;
        better = true;
      } else {
        exchange(camera, before);
      }
    }
    return better;
  }

  private void exchange(int camera, int view) {
    count(run.detected(camera, trial[camera]), -1);
    count(run.detected(camera, view), 1);
    trial[camera] = view;
  }

  private void branch(int camera) {
    if (camera == trial.length) {
      best = trial.clone();
      bestScore = run.score(k);
      return;
    }
    for (Option option : options(camera)) {
      if (option.bound() <= bestScore) {
        return;
      }
      if (nodesLeft-- <= 0) {
        complete = false;
        return;
      }
      BitSet lost = lost(camera, option.view());
      count(lost, -1);
      trial[camera] = option.view();
      branch(camera + 1);
      count(lost, 1);
    }
  }

  /** The camera's views with their bounds, the most promising first. */
  private List<Option> options(int camera) {
    List<Option> options = new ArrayList<>();
    for (int view : candidates.get(camera)) {
      BitSet lost = lost(camera, view);
      count(lost, -1);
      options.add(new Option(view, run.score(k)));
      count(lost, 1);
    }
    options.sort(Comparator.comparingDouble(Option::bound).reversed());
    return options;
  }

  /** The moments that the camera detects at some view but not at this one. */
  private BitSet lost(int camera, int view) {
    BitSet lost = (BitSet) anyView[camera].clone();
    lost.andNot(run.detected(camera, view));
    return lost;
  }

  private void count(BitSet moments, int change) {
    for (int moment = moments.nextSetBit(0); moment >= 0; moment = moments.nextSetBit(moment + 1)) {
      k[moment] += change;
    }
  }
}

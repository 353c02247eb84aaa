package org.hificamsim.solver.way;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.metrics.Objective;

/**
 * The possible detections of a run in which moves take time: for each camera and step the different
 * sets of targets that its views detect, and how long it is on its way between views.
 *
 * <p>A moment is a target in a step; moments are numbered step after step. Sets are numbered from
 * 1, step after step and camera after camera; {@link #NOTHING} is the empty set of all of them.
 */
public final class WayProblem {
  /** The set of a view that detects nothing, and of a camera that is on its way. */
  static final int NOTHING = 0;

  private static final int[] EMPTY = {};

  private final Objective objective;
  private final int[] ends;
  private final List<TravelTimes> times;
  private final List<int[]> onlineSteps = new ArrayList<>();

  /** The set that is detected, by camera and then by step and view. */
  private final int[][] setOf;

  /** The number of a camera's first set, by step and camera. */
  private final int[] firstSet;

  /** The moments of each set. */
  private final List<int[]> moments = new ArrayList<>(List.of(EMPTY));

  /**
   * @param ends for each step, the end of its moments, exclusive
   * @param times the times by camera
   * @param online for each camera, the steps in which it is online
   * @param detected for each camera and view, the moments that it detects
   */
  public WayProblem(
      Objective objective,
      int[] ends,
      List<TravelTimes> times,
      List<BitSet> online,
      List<BitSet[]> detected) {
    this.objective = objective;
    this.ends = ends;
    this.times = times;
    online.forEach(steps -> onlineSteps.add(steps.stream().toArray()));
    setOf = times.stream().map(time -> new int[ends.length * time.views()]).toArray(int[][]::new);
    firstSet = new int[ends.length * times.size() + 1];
    for (int step = 0; step < ends.length; step++) {
      for (int camera = 0; camera < times.size(); camera++) {
        firstSet[step * times.size() + camera] = moments.size();
        addSets(step, camera, detected.get(camera));
      }
    }
    firstSet[firstSet.length - 1] = moments.size();
  }

  private void addSets(int step, int camera, BitSet[] views) {
    Map<BitSet, Integer> numbers = new HashMap<>();
    for (int view = 0; view < views.length; view++) {
      BitSet seen = views[view].get(start(step), ends[step]);
      if (!seen.isEmpty()) {
        int set = numbers.computeIfAbsent(seen, newSet -> add(step, newSet));
        setOf[camera][step * views.length + view] = set;
      }
    }
  }

  private int add(int step, BitSet seen) {
    moments.add(seen.stream().map(moment -> moment + start(step)).toArray());
    return moments.size() - 1;
  }

  Objective objective() {
    return objective;
  }

  int cameras() {
    return times.size();
  }

  int steps() {
    return ends.length;
  }

  /** The first moment of a step. */
  int start(int step) {
    return step == 0 ? 0 : ends[step - 1];
  }

  /** Returns the end of a step's range of moments, exclusive. */
  int end(int step) {
    return ends[step];
  }

  /** The number of all moments. */
  int momentCount() {
    return ends.length == 0 ? 0 : ends[ends.length - 1];
  }

  TravelTimes times(int camera) {
    return times.get(camera);
  }

  /** The steps in which a camera is online; it moves only in these. */
  int[] onlineSteps(int camera) {
    return onlineSteps.get(camera);
  }

  /** The set that a camera detects through a view. */
  int set(int camera, int step, int view) {
    return setOf[camera][step * times.get(camera).views() + view];
  }

  /** The number of all sets, {@link #NOTHING} included. */
  int sets() {
    return moments.size();
  }

  /** The first set of a camera in a step. */
  int firstSet(int step, int camera) {
    return firstSet[step * times.size() + camera];
  }

  /** Returns the end of a camera's range of sets in a step, exclusive. */
  int endSet(int step, int camera) {
    return firstSet[step * times.size() + camera + 1];
  }

  /** The moments of a set; not to be changed. */
  int[] moments(int set) {
    return moments.get(set);
  }

  /** The sum of the scores of all steps, as a run adds them up. */
  double score(int[] coverage) {
    double sum = 0;
    for (int step = 0; step < ends.length; step++) {
      sum += objective.score(coverage, start(step), ends[step]);
    }
    return sum;
  }

  /** The greatest number of moments of a step. */
  int maxMoments() {
    int most = 0;
    for (int step = 0; step < ends.length; step++) {
      most = Math.max(most, ends[step] - start(step));
    }
    return most;
  }

  /** Returns for each moment the number of cameras that could detect it. */
  int[] coverable() {
    int[] cameras = new int[momentCount()];
    int[] last = new int[momentCount()];
    Arrays.fill(last, -1);
    for (int slot = 0; slot + 1 < firstSet.length; slot++) {
      for (int set = firstSet[slot]; set < firstSet[slot + 1]; set++) {
        for (int moment : moments.get(set)) {
          cameras[moment] += last[moment] == slot ? 0 : 1;
          last[moment] = slot;
        }
      }
    }
    return cameras;
  }
}

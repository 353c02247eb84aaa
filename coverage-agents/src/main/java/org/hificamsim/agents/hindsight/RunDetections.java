package org.hificamsim.agents.hindsight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.NetworkView;

/**
 * What each camera would have detected at each of its views over a whole run.
 *
 * <p>A moment is one target present in one step that counts by the objective; the moments of a step
 * follow each other. Each camera and view has the set of moments that it detects.
 */
final class RunDetections {
  private final List<BitSet[]> seen = new ArrayList<>();
  private int[] ends = new int[16];
  private int steps;
  private int moments;
  private Objective objective = Objective.kMin();

  /** Adds a step, as the network is now. */
  void add(NetworkView network) {
    objective = network.objective();
    for (int camera = seen.size(); camera < network.cameras(); camera++) {
      BitSet[] views = new BitSet[network.views(camera)];
      Arrays.setAll(views, view -> new BitSet());
      seen.add(views);
    }
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        boolean seen = look(network, target, moments);
        moments += seen || !objective.ofCoverableAlone() ? 1 : 0;
      }
    }
    ends = steps == ends.length ? Arrays.copyOf(ends, 2 * steps) : ends;
    ends[steps++] = moments;
  }

  /** Returns whether any camera detects the target at any view. */
  private boolean look(NetworkView network, int target, int moment) {
    boolean any = false;
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int view = 0; network.online(camera) && view < network.views(camera); view++) {
        boolean detects = network.oracle().detects(camera, view, target);
        seen.get(camera)[view].set(moment, detects);
        any |= detects;
      }
    }
    return any;
  }

  int cameras() {
    return seen.size();
  }

  int moments() {
    return moments;
  }

  int views(int camera) {
    return seen.get(camera).length;
  }

  /** The moments that a camera detects at a view. */
  BitSet detected(int camera, int view) {
    return seen.get(camera)[view];
  }

  /**
   * The sum over the steps of their scores, the performance (Eq 7.2) by default; a step without
   * targets adds 0. It falls with no k that rises.
   *
   * @param k by moment
   */
  double score(int[] k) {
    double sum = 0;
    int moment = 0;
    for (int step = 0; step < steps; step++) {
      sum += objective.score(k, moment, ends[step]);
      moment = ends[step];
    }
    return sum;
  }
}

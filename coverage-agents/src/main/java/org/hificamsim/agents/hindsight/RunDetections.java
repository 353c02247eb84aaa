package org.hificamsim.agents.hindsight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.hificamsim.core.policy.NetworkView;

/**
 * What each camera would have detected at each of its views over a whole run.
 *
 * <p>A moment is one target present in one step; the moments of a step follow each other. Each
 * camera and view has the set of moments that it detects.
 */
final class RunDetections {
  private final List<BitSet[]> seen = new ArrayList<>();
  private int[] ends = new int[16];
  private int steps;
  private int moments;

  /** Adds a step, as the network is now. */
  void add(NetworkView network) {
    for (int camera = seen.size(); camera < network.cameras(); camera++) {
      BitSet[] views = new BitSet[network.views(camera)];
      Arrays.setAll(views, view -> new BitSet());
      seen.add(views);
    }
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        look(network, target, moments++);
      }
    }
    ends = steps == ends.length ? Arrays.copyOf(ends, 2 * steps) : ends;
    ends[steps++] = moments;
  }

  private void look(NetworkView network, int target, int moment) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int view = 0; network.online(camera) && view < network.views(camera); view++) {
        seen.get(camera)[view].set(moment, network.oracle().detects(camera, view, target));
      }
    }
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
   * The sum over the steps of the least k of a moment in each (Eq 7.2); a step without targets adds
   * 0.
   *
   * @param k by moment
   */
  long performance(int[] k) {
    long sum = 0;
    int moment = 0;
    for (int step = 0; step < steps; step++) {
      int least = moment == ends[step] ? 0 : Integer.MAX_VALUE;
      for (; moment < ends[step]; moment++) {
        least = Math.min(least, k[moment]);
      }
      sum += least;
    }
    return sum;
  }
}

package org.hificamsim.agents.optimal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.hificamsim.agents.search.CoverageProblem;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.OracleView;

/**
 * What each camera would have detected at each of its views over a whole run.
 *
 * <p>A moment is one target present in one step that counts by the objective; the moments of a step
 * follow each other. Each camera and view has the set of moments that it detects.
 */
final class RunDetections {
  private final List<BitSet[]> seen = new ArrayList<>();
  private int[] momentOf = {}; // by target, of the step that is added
  private boolean[] coverable = {}; // by target
  private long[] masks = {};
  private int[] ends = new int[16];
  private int steps;
  private int moments;
  private Objective objective = Objective.kMin();

  /** Adds a step, as the network is now. */
  void add(OracleView network) {
    objective = network.objective();
    for (int camera = seen.size(); camera < network.cameras(); camera++) {
      BitSet[] views = new BitSet[network.views(camera)];
      Arrays.setAll(views, view -> new BitSet());
      seen.add(views);
    }
    number(network);
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        look(network, camera);
      }
    }
    ends = steps == ends.length ? Arrays.copyOf(ends, 2 * steps) : ends;
    ends[steps++] = moments;
  }

  /** Gives each target that counts in this step its moment. */
  private void number(OracleView network) {
    if (momentOf.length < network.targets()) {
      momentOf = new int[network.targets()];
      coverable = new boolean[network.targets()];
    }
    boolean all = !objective.countsCoverableOnly();
    if (!all) {
      network.markCoverable(coverable);
    }
    for (int target = 0; target < network.targets(); target++) {
      momentOf[target] = moments;
      moments += network.present(target) && (all || coverable[target]) ? 1 : 0;
    }
  }

  /** Notes what a camera detects at each of its views; what is detected counts. */
  private void look(OracleView network, int camera) {
    BitSet[] views = seen.get(camera);
    int words = (network.targets() + Long.SIZE - 1) / Long.SIZE;
    masks = masks.length < views.length * words ? new long[views.length * words] : masks;
    network.detections(camera, masks, words);
    for (int i = 0; i < views.length * words; i++) {
      for (long bits = masks[i]; bits != 0; bits &= bits - 1) {
        int target = i % words * Long.SIZE + Long.numberOfTrailingZeros(bits);
        views[i / words].set(momentOf[target]);
      }
    }
  }

  /** The moments that each camera has at each of its views, as a set for each view. */
  CoverageProblem problem() {
    int sets = seen.stream().mapToInt(views -> views.length).sum();
    CoverageProblem problem = new CoverageProblem(seen.size(), sets, moments);
    problem.clear(moments);
    for (BitSet[] views : seen) {
      problem.addCamera();
      for (BitSet view : views) {
        problem.addSet(Arrays.copyOf(view.toLongArray(), problem.words()), 0);
      }
    }
    return problem;
  }

  /** For each step one more than the last of its moments. */
  int[] ends() {
    return Arrays.copyOf(ends, steps);
  }

  /** What the steps are scored by. */
  Objective objective() {
    return objective;
  }
}

package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.agents.search.CoverageProblem;
import org.hificamsim.core.policy.NetworkView;

/**
 * The detection sets of each camera's candidate views over the targets that are present, in order
 * of preference, as a coverage problem.
 *
 * <p>A set that is included in a more preferred one of the same camera is left out: it would never
 * be chosen.
 */
final class DetectionSets implements ConfigurationSets {
  private final CandidateViews candidates;
  private final Preference preference;
  private final CoverageProblem problem;
  private final int[] placeOf;
  private final int[] viewOf;
  private final int allWords;
  private final long[] seen;
  private final long[] masks;
  private final int[] order;
  private final int[] sizes;
  private int targets;
  private int words;

  DetectionSets(NetworkView network, CandidateViews candidates, Preference preference) {
    this.candidates = candidates;
    this.preference = preference;
    int most = 0;
    int all = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      most = Math.max(most, network.views(camera));
      all += network.views(camera);
    }
    problem = new CoverageProblem(network.cameras(), all, network.targets());
    placeOf = new int[network.targets()];
    viewOf = new int[all];
    allWords = CoverageProblem.wordsFor(network.targets());
    seen = new long[most * allWords];
    masks = new long[most * allWords];
    order = new int[most];
    sizes = new int[most];
  }

  /** The problem that {@link #fill} fills. */
  CoverageProblem problem() {
    return problem;
  }

  @Override
  public int viewOf(int set) {
    return viewOf[set];
  }

  @Override
  public boolean fill(NetworkView network) {
    findPresent(network);
    if (targets == 0) {
      return false;
    }
    problem.clear(targets);
    words = problem.words();
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        problem.addCamera();
        add(network, camera);
      }
    }
    return true;
  }

  private void findPresent(NetworkView network) {
    targets = 0;
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        placeOf[target] = targets++;
      }
    }
  }

  private void add(NetworkView network, int camera) {
    network.oracle().detections(camera, seen, allWords);
    int count = candidates.count(camera);
    for (int i = 0; i < count; i++) {
      look(camera, i);
      place(i);
    }
    for (int i = 0; i < count; i++) {
      if (!problem.lastCameraHas(masks, order[i] * words)) {
        viewOf[problem.sets()] = candidates.view(camera, order[i]);
        problem.addSet(masks, order[i] * words);
      }
    }
  }

  /** Copies what a camera sees as a candidate, by target, into its row, by target present. */
  private void look(int camera, int row) {
    int from = candidates.view(camera, row) * allWords;
    int to = row * words;
    Arrays.fill(masks, to, to + words, 0);
    sizes[row] = 0;
    for (int word = 0; word < allWords; word++) {
      sizes[row] += Long.bitCount(seen[from + word]);
      for (long bits = seen[from + word]; bits != 0; bits &= bits - 1) {
        int at = placeOf[(word << 6) + Long.numberOfTrailingZeros(bits)];
        masks[to + (at >> 6)] |= 1L << at;
      }
    }
  }

  /** Inserts a row into the order of preference; the candidates come in order of width. */
  private void place(int row) {
    int at = row;
    while (preference.mostTargets() && at > 0 && sizes[order[at - 1]] < sizes[row]) {
      order[at] = order[at - 1];
      at--;
    }
    order[at] = row;
  }
}

package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.agents.search.CoverageProblem;
import org.hificamsim.core.policy.OracleView;

/**
 * The detection sets of each camera's candidate views over the targets that are present, in order
 * of preference, as a coverage problem.
 *
 * <p>Candidates are the views that a camera may take at the next step, widest or narrowest first. A
 * set that is included in a more preferred one of the same camera is left out: it would never be
 * chosen.
 */
final class DetectionSets implements ConfigurationSets {
  private final boolean mostTargets;
  private final int[][] candidates; // by camera
  private final int[] counts; // of candidates, by camera
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

  /**
   * @param mostTargets whether a view that detects more targets is preferred, before its width
   *     counts
   */
  DetectionSets(OracleView network, boolean mostTargets) {
    this.mostTargets = mostTargets;
    candidates = new int[network.cameras()][];
    Arrays.setAll(candidates, camera -> new int[network.views(camera)]);
    int all = Arrays.stream(candidates).mapToInt(views -> views.length).sum();
    int most = Arrays.stream(candidates).mapToInt(views -> views.length).max().orElse(0);
    counts = new int[network.cameras()];
    problem = new CoverageProblem(network.cameras(), all, network.targets());
    placeOf = new int[network.targets()];
    viewOf = new int[all];
    allWords = CoverageProblem.wordsFor(network.targets());
    seen = new long[most * allWords];
    masks = new long[most * allWords];
    order = new int[most];
    sizes = new int[most];
  }

  /** Takes all candidates from a camera. */
  void clear(int camera) {
    counts[camera] = 0;
  }

  /** Adds a candidate after the camera's others. */
  void add(int camera, int view) {
    candidates[camera][counts[camera]] = view;
    counts[camera]++;
  }

  /** How many candidates a camera has. */
  int candidates(int camera) {
    return counts[camera];
  }

  /** The camera's i-th candidate. */
  int candidate(int camera, int i) {
    return candidates[camera][i];
  }

  /**
   * Takes from a camera the candidates that another one dominates; of candidates that dominate each
   * other the first stays.
   */
  void removeDominated(OracleView network, int camera) {
    int[] views = candidates[camera];
    for (int i = counts[camera] - 1; i >= 0; i--) {
      if (dominated(network, camera, i)) {
        counts[camera]--;
        System.arraycopy(views, i + 1, views, i, counts[camera] - i);
      }
    }
  }

  private boolean dominated(OracleView network, int camera, int i) {
    int view = candidate(camera, i);
    for (int other = 0; other < counts[camera]; other++) {
      if (other != i && network.dominates(camera, candidate(camera, other), view)) {
        return true;
      }
    }
    return false;
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
  public boolean fill(OracleView network) {
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

  private void findPresent(OracleView network) {
    targets = 0;
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        placeOf[target] = targets++;
      }
    }
  }

  private void add(OracleView network, int camera) {
    network.detections(camera, seen, allWords);
    for (int i = 0; i < counts[camera]; i++) {
      look(camera, i);
      place(i);
    }
    for (int i = 0; i < counts[camera]; i++) {
      if (!problem.lastCameraIncludes(masks, order[i] * words)) {
        viewOf[problem.sets()] = candidate(camera, order[i]);
        problem.addSet(masks, order[i] * words);
      }
    }
  }

  /** Copies what a camera sees as a candidate, by target, into its row, by target present. */
  private void look(int camera, int row) {
    int from = candidate(camera, row) * allWords;
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
    while (mostTargets && at > 0 && sizes[order[at - 1]] < sizes[row]) {
      order[at] = order[at - 1];
      at--;
    }
    order[at] = row;
  }
}

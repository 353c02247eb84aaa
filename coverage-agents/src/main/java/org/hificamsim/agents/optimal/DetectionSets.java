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
  private final long[] union;
  private final long[] masks;
  private final int[] order;
  private final int[] sizes;
  private final int[] viewOfRow;
  private int targets;
  private boolean everyTarget;
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
    union = new long[allWords];
    masks = new long[most * allWords];
    order = new int[most];
    sizes = new int[most];
    viewOfRow = new int[most];
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
    everyTarget = targets == network.targets();
  }

  private void add(NetworkView network, int camera) {
    network.oracle().detections(camera, seen, allWords);
    int whole = firstThatSeesAll(camera);
    if (whole == 0 || (whole > 0 && preference.mostTargets())) {
      look(camera, whole, 0);
      addSet(0);
    } else {
      addInOrder(camera);
    }
  }

  /** The first candidate that detects all that any of them does; -1 when there is none. */
  private int firstThatSeesAll(int camera) {
    int count = candidates.count(camera);
    Arrays.fill(union, 0);
    for (int i = 0; i < count; i++) {
      int from = candidates.view(camera, i) * allWords;
      for (int word = 0; word < allWords; word++) {
        union[word] |= seen[from + word];
      }
    }
    for (int i = 0; i < count; i++) {
      int from = candidates.view(camera, i) * allWords;
      long missing = 0;
      for (int word = 0; word < allWords; word++) {
        missing |= union[word] & ~seen[from + word];
      }
      if (missing == 0) {
        return i;
      }
    }
    return -1;
  }

  private void addInOrder(int camera) {
    int count = candidates.count(camera);
    for (int i = 0; i < count; i++) {
      look(camera, i, i);
      place(i);
    }
    int first = problem.sets();
    for (int i = 0; i < count; i++) {
      if (!included(order[i], first)) {
        addSet(order[i]);
      }
    }
  }

  private void addSet(int row) {
    viewOf[problem.sets()] = viewOfRow[row];
    problem.addSet(masks, row * words);
  }

  /** Copies what a camera sees as candidate i, by target, into a row, by target present. */
  private void look(int camera, int i, int row) {
    viewOfRow[row] = candidates.view(camera, i);
    int from = viewOfRow[row] * allWords;
    int to = row * words;
    if (everyTarget) {
      System.arraycopy(seen, from, masks, to, words);
    } else {
      Arrays.fill(masks, to, to + words, 0);
      for (int word = 0; word < allWords; word++) {
        for (long bits = seen[from + word]; bits != 0; bits &= bits - 1) {
          int at = placeOf[(word << 6) + Long.numberOfTrailingZeros(bits)];
          masks[to + (at >> 6)] |= 1L << at;
        }
      }
    }
    int size = 0;
    for (int word = to; word < to + words; word++) {
      size += Long.bitCount(masks[word]);
    }
    sizes[row] = size;
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

  private boolean included(int row, int firstSet) {
    for (int set = firstSet; set < problem.sets(); set++) {
      boolean included = true;
      for (int word = 0; word < words; word++) {
        included &= (masks[row * words + word] & ~problem.mask(set, word)) == 0;
      }
      if (included) {
        return true;
      }
    }
    return false;
  }
}

package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.solver.BitMatrix;
import org.hificamsim.solver.configuration.CoverageProblem;

/**
 * The detection sets of each camera's candidate views, in order of preference, as a coverage
 * problem of the targets that are present.
 *
 * <p>Candidates are the views that a camera may take in the next step, widest or narrowest first. A
 * set that a more preferred set of the same camera includes is left out, because it would never be
 * chosen.
 */
final class DetectionSets implements ConfigurationSets {
  private final boolean mostTargets;
  private final int[][] candidates;
  private final int[] candidateCounts;
  private final CoverageProblem problem;

  /** The number of each present target in the problem. */
  private final int[] problemNumber;

  private final int[] viewOf;
  private final int networkWords;

  /** The mask of the network's targets that each view detects. */
  private final long[] viewMasks;

  /** The mask of the problem's targets that each candidate detects. */
  private final long[] candidateMasks;

  private final int[] candidateSizes;

  /** The candidates of a camera in order of preference. */
  private final int[] preferred;

  private int targets;
  private int words;

  /**
   * @param mostTargets whether views that detect more targets are preferred, whatever their width
   */
  DetectionSets(OracleView network, boolean mostTargets) {
    this.mostTargets = mostTargets;
    candidates = new int[network.cameras()][];
    Arrays.setAll(candidates, camera -> new int[network.views(camera)]);
    int allViews = Arrays.stream(candidates).mapToInt(views -> views.length).sum();
    int maxViews = Arrays.stream(candidates).mapToInt(views -> views.length).max().orElse(0);
    candidateCounts = new int[network.cameras()];
    problem = new CoverageProblem(network.cameras(), allViews, network.targets());
    problemNumber = new int[network.targets()];
    viewOf = new int[allViews];
    networkWords = BitMatrix.wordsFor(network.targets());
    viewMasks = new long[maxViews * networkWords];
    candidateMasks = new long[maxViews * networkWords];
    preferred = new int[maxViews];
    candidateSizes = new int[maxViews];
  }

  /** Removes all candidates of a camera. */
  void clear(int camera) {
    candidateCounts[camera] = 0;
  }

  /** Adds a candidate of a camera, after its others. */
  void add(int camera, int view) {
    candidates[camera][candidateCounts[camera]] = view;
    candidateCounts[camera]++;
  }

  /** The number of candidates of a camera. */
  int candidates(int camera) {
    return candidateCounts[camera];
  }

  /** The camera's i-th candidate. */
  int candidate(int camera, int i) {
    return candidates[camera][i];
  }

  /**
   * Removes the candidates of a camera that another one dominates; of candidates that dominate each
   * other the first one stays.
   */
  void removeDominated(OracleView network, int camera) {
    int[] views = candidates[camera];
    for (int i = candidateCounts[camera] - 1; i >= 0; i--) {
      if (isDominated(network, camera, i)) {
        candidateCounts[camera]--;
        System.arraycopy(views, i + 1, views, i, candidateCounts[camera] - i);
      }
    }
  }

  private boolean isDominated(OracleView network, int camera, int i) {
    int view = candidate(camera, i);
    for (int other = 0; other < candidateCounts[camera]; other++) {
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
        addSets(network, camera);
      }
    }
    return true;
  }

  private void findPresent(OracleView network) {
    targets = 0;
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        problemNumber[target] = targets++;
      }
    }
  }

  private void addSets(OracleView network, int camera) {
    network.detections(camera, viewMasks, networkWords);
    for (int i = 0; i < candidateCounts[camera]; i++) {
      fillMask(camera, i);
      insertByPreference(i);
    }
    for (int i = 0; i < candidateCounts[camera]; i++) {
      if (!problem.lastCameraIncludes(candidateMasks, preferred[i] * words)) {
        viewOf[problem.sets()] = candidate(camera, preferred[i]);
        problem.addSet(candidateMasks, preferred[i] * words);
      }
    }
  }

  /** Copies the mask of a candidate's view, with the problem's numbers of targets. */
  private void fillMask(int camera, int candidate) {
    int from = candidate(camera, candidate) * networkWords;
    int to = candidate * words;
    Arrays.fill(candidateMasks, to, to + words, 0);
    candidateSizes[candidate] = 0;
    for (int word = 0; word < networkWords; word++) {
      candidateSizes[candidate] += Long.bitCount(viewMasks[from + word]);
      for (long bits = viewMasks[from + word]; bits != 0; bits &= bits - 1) {
        int number = problemNumber[BitMatrix.firstColumn(word, bits)];
        candidateMasks[to + (number >> 6)] |= 1L << number;
      }
    }
  }

  /** Inserts a candidate into the order of preference; they are inserted in order of width. */
  private void insertByPreference(int candidate) {
    int index = candidate;
    while (mostTargets
        && index > 0
        && candidateSizes[preferred[index - 1]] < candidateSizes[candidate]) {
      preferred[index] = preferred[index - 1];
      index--;
    }
    preferred[index] = candidate;
  }
}

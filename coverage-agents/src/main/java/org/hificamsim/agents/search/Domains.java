package org.hificamsim.agents.search;

/**
 * Which sets each camera may still choose while a search for k-coverage is under way, and what
 * follows from that for each target; every removal can be undone.
 *
 * <p>A target's <em>supply</em> is the number of cameras with some remaining set that holds it, its
 * <em>sure</em> coverage the number of cameras all of whose remaining sets do. Coverage k is out of
 * reach when a supply is below k; when it equals k, each of those cameras must keep the target, so
 * its sets without it go. Moreover, for any weights of the targets, the cameras' best remaining
 * sets must together weigh at least k times all targets: sets that would use up more than that
 * surplus go too. Repeated until nothing changes, this is {@link #require} and {@link #remove}.
 */
final class Domains {
  private final CoverageProblem problem;
  private final boolean[] alive;
  private final int[] aliveSets;
  private final long[] union;
  private final long[] intersection;
  private final int[] supply;
  private final int[] sure;
  private final long[] weight;
  private final long[] best;
  private final int[] open;
  private final int[] trail;
  private final int[] tight;
  private int openCameras;
  private int words;
  private int removed;
  private int tightTargets;
  private int k;
  private long bestTotal;
  private long weightOfAll;

  Domains(CoverageProblem problem) {
    this.problem = problem;
    int cameras = problem.mostCameras();
    int targets = problem.mostTargets();
    int maskWords = cameras * CoverageProblem.wordsFor(targets);
    alive = new boolean[problem.mostSets()];
    aliveSets = new int[cameras];
    union = new long[maskWords];
    intersection = new long[maskWords];
    supply = new int[targets];
    sure = new int[targets];
    weight = new long[problem.mostSets()];
    best = new long[cameras];
    open = new int[cameras];
    trail = new int[problem.mostSets()];
    tight = new int[targets];
  }

  /** Every set of every camera remains, and every target weighs 1. */
  void reset() {
    words = problem.words();
    removed = 0;
    openCameras = 0;
    k = 0;
    bestTotal = 0;
    weightOfAll = problem.targets();
    for (int target = 0; target < problem.targets(); target++) {
      supply[target] = 0;
      sure[target] = 0;
    }
    for (int camera = 0; camera < problem.cameras(); camera++) {
      open(camera);
    }
  }

  private void open(int camera) {
    int first = problem.firstSet(camera);
    int end = problem.endSet(camera);
    aliveSets[camera] = end - first;
    if (end - first > 1) {
      open[openCameras++] = camera;
    }
    best[camera] = 0;
    for (int set = first; set < end; set++) {
      alive[set] = true;
      weight[set] = 0;
      for (int word = 0; word < words; word++) {
        weight[set] += Long.bitCount(problem.mask(set, word));
      }
      best[camera] = Math.max(best[camera], weight[set]);
    }
    bestTotal += best[camera];
    for (int word = 0; word < words; word++) {
      int at = camera * words + word;
      long all = problem.mask(first, word);
      long any = all;
      for (int set = first + 1; set < end; set++) {
        any |= problem.mask(set, word);
        all &= problem.mask(set, word);
      }
      union[at] = any;
      intersection[at] = all;
      add(supply, word, any, 1);
      add(sure, word, all, 1);
    }
  }

  /** Weighs the targets anew, each with 0 or more; only while nothing has been removed. */
  void weigh(long[] targetWeights) {
    weightOfAll = 0;
    for (int target = 0; target < problem.targets(); target++) {
      weightOfAll += targetWeights[target];
    }
    for (int set = 0; set < problem.sets(); set++) {
      weight[set] = 0;
      for (int word = 0; word < words; word++) {
        for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
          weight[set] += targetWeights[(word << 6) + Long.numberOfTrailingZeros(bits)];
        }
      }
    }
    bestTotal = 0;
    for (int camera = 0; camera < problem.cameras(); camera++) {
      best[camera] = bestAlive(camera);
      bestTotal += best[camera];
    }
  }

  /** The largest coverage that neither a supply nor the weights rule out. */
  int bound() {
    int bound = problem.cameras();
    for (int target = 0; target < problem.targets(); target++) {
      bound = Math.min(bound, supply[target]);
    }
    return weightOfAll == 0 ? bound : (int) Math.min(bound, bestTotal / weightOfAll);
  }

  /**
   * Demands that every target be covered by at least {@code coverage} cameras.
   *
   * @return whether that is still possible as far as this can tell
   */
  boolean require(int coverage) {
    k = coverage;
    tightTargets = 0;
    for (int target = 0; target < problem.targets(); target++) {
      if (supply[target] < k) {
        return false;
      }
      if (supply[target] == k) {
        tight[tightTargets++] = target;
      }
    }
    return propagate();
  }

  /** Takes one set from its camera and draws the consequences; false when none remains possible. */
  boolean remove(int set) {
    tightTargets = 0;
    return drop(set) && propagate();
  }

  /** Leaves a camera this one set and draws the consequences; false when that is impossible. */
  boolean choose(int set) {
    tightTargets = 0;
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && alive[other] && !drop(other)) {
        return false;
      }
    }
    return propagate();
  }

  /**
   * Takes from its camera this set and those that hold no unsatisfied target but its own: none of
   * them leads further than it. Then draws the consequences.
   */
  boolean removeWithLesser(int set) {
    tightTargets = 0;
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && alive[other] && isLesser(other, set) && !drop(other)) {
        return false;
      }
    }
    return drop(set) && propagate();
  }

  private boolean isLesser(int set, int than) {
    for (int word = 0; word < words; word++) {
      long more = problem.mask(set, word) & ~problem.mask(than, word);
      for (; more != 0; more &= more - 1) {
        if (sure[(word << 6) + Long.numberOfTrailingZeros(more)] < k) {
          return false;
        }
      }
    }
    return true;
  }

  /** The number of removals so far: what {@link #undo} goes back to. */
  int mark() {
    return removed;
  }

  /** Takes back all removals after {@code mark}. */
  void undo(int mark) {
    while (removed > mark) {
      revive(trail[--removed]);
    }
  }

  private boolean propagate() {
    do {
      while (tightTargets > 0) {
        if (!force(tight[--tightTargets])) {
          return false;
        }
      }
      if (!removeTooLight()) {
        return false;
      }
    } while (tightTargets > 0);
    return true;
  }

  private boolean force(int target) {
    int word = target >> 6;
    long bit = 1L << target;
    for (int i = 0; i < openCameras; i++) {
      int at = open[i] * words + word;
      if ((union[at] & ~intersection[at] & bit) != 0 && !dropWithout(open[i], target)) {
        return false;
      }
    }
    return true;
  }

  private boolean dropWithout(int camera, int target) {
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (alive[set] && !problem.contains(set, target) && !drop(set)) {
        return false;
      }
    }
    return true;
  }

  private boolean removeTooLight() {
    long surplus = bestTotal - k * weightOfAll;
    if (surplus < 0) {
      return false;
    }
    for (int i = 0; i < openCameras; i++) {
      int camera = open[i];
      if (aliveSets[camera] == 1) {
        continue;
      }
      long least = best[camera] - surplus;
      for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
        if (alive[set] && weight[set] < least && !drop(set)) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean drop(int set) {
    int camera = problem.cameraOf(set);
    alive[set] = false;
    aliveSets[camera]--;
    trail[removed++] = set;
    if (aliveSets[camera] == 0) {
      return false;
    }
    if (weight[set] == best[camera]) {
      bestTotal -= best[camera];
      best[camera] = bestAlive(camera);
      bestTotal += best[camera];
    }
    boolean possible = true;
    for (int word = 0; word < words; word++) {
      possible &= narrow(camera, word);
    }
    return possible;
  }

  private boolean narrow(int camera, int word) {
    long any = 0;
    long all = -1;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (alive[set]) {
        any |= problem.mask(set, word);
        all &= problem.mask(set, word);
      }
    }
    int at = camera * words + word;
    add(sure, word, all & ~intersection[at], 1);
    long lost = union[at] & ~any;
    union[at] = any;
    intersection[at] = all;
    boolean possible = true;
    for (; lost != 0; lost &= lost - 1) {
      int target = (word << 6) + Long.numberOfTrailingZeros(lost);
      int left = --supply[target];
      if (left == k) {
        tight[tightTargets++] = target;
      }
      possible &= left >= k;
    }
    return possible;
  }

  private void revive(int set) {
    int camera = problem.cameraOf(set);
    alive[set] = true;
    aliveSets[camera]++;
    if (aliveSets[camera] == 1) {
      return;
    }
    if (weight[set] > best[camera]) {
      bestTotal += weight[set] - best[camera];
      best[camera] = weight[set];
    }
    for (int word = 0; word < words; word++) {
      int at = camera * words + word;
      long mask = problem.mask(set, word);
      add(supply, word, mask & ~union[at], 1);
      add(sure, word, intersection[at] & ~mask, -1);
      union[at] |= mask;
      intersection[at] &= mask;
    }
  }

  private long bestAlive(int camera) {
    long most = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (alive[set]) {
        most = Math.max(most, weight[set]);
      }
    }
    return most;
  }

  private static void add(int[] counts, int word, long targets, int change) {
    for (long bits = targets; bits != 0; bits &= bits - 1) {
      counts[(word << 6) + Long.numberOfTrailingZeros(bits)] += change;
    }
  }

  /** The number of cameras with more than one set at the start. */
  int openCameras() {
    return openCameras;
  }

  /** The i-th camera with more than one set at the start. */
  int openCamera(int i) {
    return open[i];
  }

  boolean alive(int set) {
    return alive[set];
  }

  /** The camera's most preferred remaining set. */
  int firstAlive(int camera) {
    int set = problem.firstSet(camera);
    while (!alive[set]) {
      set++;
    }
    return set;
  }

  /** The targets on which the camera's remaining sets differ, one word of the mask. */
  long undecided(int camera, int word) {
    int at = camera * words + word;
    return union[at] & ~intersection[at];
  }

  /** How many more cameras could cover the target than must. */
  int slack(int target) {
    return supply[target] - k;
  }

  /** How many cameras the target still lacks; 0 or less when it is satisfied. */
  int lack(int target) {
    return k - sure[target];
  }
}

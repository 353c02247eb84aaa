package org.hificamsim.agents.search;

/**
 * A coverage problem: each camera chooses one of its detection sets. How good a choice is depends
 * on how many cameras cover each target; an {@link org.hificamsim.core.metrics.Objective} says how.
 *
 * <p>Cameras, sets and targets are numbered from 0. A camera's sets are listed in its order of
 * preference, which decides between equally good choices; a set may equal, include or be included
 * in another one. Sets are bit masks, target t at bit {@code t % 64} of word {@code t / 64}. The
 * same object is filled again for each problem: {@link #clear}, then {@link #addCamera} and its
 * sets for each camera.
 */
public final class CoverageProblem {
  private final int[] firstSet;
  private final int[] cameraOf;
  private final long[] masks;
  private final int maxTargets;
  private int targets;
  private int words;
  private int cameras;
  private int sets;

  /** A problem without cameras, with room for these numbers of cameras, their sets, and targets. */
  public CoverageProblem(int maxCameras, int maxSets, int maxTargets) {
    firstSet = new int[maxCameras + 1];
    cameraOf = new int[maxSets];
    masks = new long[maxSets * wordsFor(maxTargets)];
    this.maxTargets = maxTargets;
  }

  /** The number of words that a set of targets takes. */
  public static int wordsFor(int targets) {
    return (targets + Long.SIZE - 1) / Long.SIZE;
  }

  /** Forgets all cameras; from now on there are {@code targets} targets. */
  public void clear(int targets) {
    if (targets > maxTargets) {
      throw new IllegalArgumentException(
          "targets is " + targets + ", expected at most " + maxTargets);
    }
    this.targets = targets;
    words = wordsFor(targets);
    cameras = 0;
    sets = 0;
  }

  /** Adds a camera; the sets that follow are its own. It needs at least one. */
  public void addCamera() {
    cameras++;
    firstSet[cameras] = sets;
  }

  /** Adds a set to the last camera: {@code words()} words of {@code source} from {@code from}. */
  public void addSet(long[] source, int from) {
    for (int word = 0; word < words; word++) {
      masks[sets * words + word] = source[from + word];
    }
    cameraOf[sets] = cameras - 1;
    sets++;
    firstSet[cameras] = sets;
  }

  public int cameras() {
    return cameras;
  }

  public int targets() {
    return targets;
  }

  /** The number of words of one set. */
  public int words() {
    return words;
  }

  /** The number of sets of all cameras. */
  public int sets() {
    return sets;
  }

  /** The number of the camera's most preferred set; its others follow up to the next camera's. */
  public int firstSet(int camera) {
    return firstSet[camera];
  }

  /** One more than the number of the camera's least preferred set. */
  public int endSet(int camera) {
    return firstSet[camera + 1];
  }

  /** The camera to which a set belongs. */
  public int cameraOf(int set) {
    return cameraOf[set];
  }

  /** One word of a set's bit mask. */
  public long mask(int set, int word) {
    return masks[set * words + word];
  }

  /** Whether the target is in the set. */
  public boolean contains(int set, int target) {
    return (masks[set * words + (target >> 6)] >>> target & 1) != 0;
  }

  /** Whether any set of any camera has the target. */
  boolean isCoverable(int target) {
    boolean coverable = false;
    for (int set = 0; set < sets; set++) {
      coverable |= contains(set, target);
    }
    return coverable;
  }

  /** Whether a set holds all that another one does. */
  boolean holds(int set, int other) {
    boolean holds = true;
    for (int word = 0; word < words; word++) {
      holds &= (mask(other, word) & ~mask(set, word)) == 0;
    }
    return holds;
  }

  /** Whether a set of the last camera holds all of a mask: {@code source} from {@code from} on. */
  public boolean lastCameraHas(long[] source, int from) {
    boolean has = false;
    for (int set = firstSet[cameras - 1]; set < sets && !has; set++) {
      has = true;
      for (int word = 0; word < words; word++) {
        has &= (source[from + word] & ~mask(set, word)) == 0;
      }
    }
    return has;
  }

  /** A set of the camera that holds all its others; -1 when there is none. */
  int wholeSet(int camera) {
    int whole = firstSet(camera); // whichever set is whole holds the one before it
    for (int set = whole + 1; set < endSet(camera); set++) {
      whole = holds(set, whole) ? set : whole;
    }
    for (int set = firstSet(camera); set < endSet(camera); set++) {
      if (!holds(whole, set)) {
        return -1;
      }
    }
    return whole;
  }

  /** Adds {@code change} to the count of each target in one word of a mask. */
  static void add(int[] counts, int word, long mask, int change) {
    for (long bits = mask; bits != 0; bits &= bits - 1) {
      counts[(word << 6) + Long.numberOfTrailingZeros(bits)] += change;
    }
  }

  int maxCameras() {
    return firstSet.length - 1;
  }

  int maxSets() {
    return cameraOf.length;
  }

  int maxTargets() {
    return maxTargets;
  }
}

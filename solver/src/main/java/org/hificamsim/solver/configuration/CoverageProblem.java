package org.hificamsim.solver.configuration;

/**
 * A coverage problem: each camera chooses one of its detection sets. An {@link
 * org.hificamsim.core.metrics.Objective} scores a choice by how many cameras cover each target.
 *
 * <p>Cameras, sets and targets are numbered from 0. A camera's sets are listed in its order of
 * preference, which decides between equally good choices; a set may equal, include or be included
 * in another one. Sets are bit masks, target t at bit {@code t % 64} of word {@code t / 64}.
 *
 * <p>An object can be used for many problems. To fill it, call {@link #clear}, and for each camera
 * {@link #addCamera} and then {@link #addSet} for each of its sets.
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

  /**
   * Creates a problem without cameras, with space for these numbers of cameras, sets and targets.
   */
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

  /** Removes all cameras, and sets the number of targets. */
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

  /** Adds a camera, which needs at least one set; sets that are added next belong to it. */
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

  /** The number of the camera's most preferred set; the others follow in order of preference. */
  public int firstSet(int camera) {
    return firstSet[camera];
  }

  /** Returns the end of the camera's range of sets, exclusive. */
  public int endSet(int camera) {
    return firstSet[camera + 1];
  }

  /** The camera to which a set belongs. */
  public int cameraOf(int set) {
    return cameraOf[set];
  }

  /** Returns one word of a set's bit mask. */
  public long mask(int set, int word) {
    return masks[set * words + word];
  }

  /** Whether the target is in the set. */
  public boolean contains(int set, int target) {
    return (masks[set * words + (target >> 6)] >>> target & 1) != 0;
  }

  /** Whether any set of any camera holds the target. */
  boolean isCoverable(int target) {
    boolean coverable = false;
    for (int set = 0; set < sets; set++) {
      coverable |= contains(set, target);
    }
    return coverable;
  }

  /** Whether a set holds all targets of another one. */
  boolean includes(int set, int other) {
    boolean includes = true;
    for (int word = 0; word < words; word++) {
      includes &= (mask(other, word) & ~mask(set, word)) == 0;
    }
    return includes;
  }

  /** Whether a set of the last camera includes the mask at {@code from} in {@code source}. */
  public boolean lastCameraIncludes(long[] source, int from) {
    boolean included = false;
    for (int set = firstSet[cameras - 1]; set < sets && !included; set++) {
      included = true;
      for (int word = 0; word < words; word++) {
        included &= (source[from + word] & ~mask(set, word)) == 0;
      }
    }
    return included;
  }

  /** Returns a set of the camera that includes all its others, or -1 when there is none. */
  int largestSet(int camera) {
    // If one set includes all others, this loop ends with it.
    int largest = firstSet(camera);
    for (int set = largest + 1; set < endSet(camera); set++) {
      largest = includes(set, largest) ? set : largest;
    }
    for (int set = firstSet(camera); set < endSet(camera); set++) {
      if (!includes(largest, set)) {
        return -1;
      }
    }
    return largest;
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

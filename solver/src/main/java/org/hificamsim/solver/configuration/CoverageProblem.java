package org.hificamsim.solver.configuration;

import org.hificamsim.solver.BitMatrix;

/**
 * A coverage problem: each camera chooses one of its detection sets. An {@link
 * org.hificamsim.core.metrics.Objective} scores a choice by how many cameras cover each target.
 *
 * <p>Cameras, sets and targets are numbered from 0. A camera's sets are listed in its order of
 * preference, which decides between equally good choices; a set may equal, include or be included
 * in another one. Sets are rows of a {@link BitMatrix}.
 *
 * <p>An object can be used for many problems. To fill it, call {@link #clear}, and for each camera
 * {@link #addCamera} and then {@link #addSet} for each of its sets.
 */
public final class CoverageProblem {
  private final int[] firstSet;
  private final int[] cameraOf;
  private final BitMatrix masks;
  private final int maxTargets;
  private int targets;
  private int cameras;
  private int sets;

  /**
   * Creates a problem without cameras, with space for these numbers of cameras, sets and targets.
   */
  public CoverageProblem(int maxCameras, int maxSets, int maxTargets) {
    firstSet = new int[maxCameras + 1];
    cameraOf = new int[maxSets];
    masks = new BitMatrix(maxSets, maxTargets);
    this.maxTargets = maxTargets;
  }

  /** Removes all cameras, and sets the number of targets. */
  public void clear(int targets) {
    if (targets > maxTargets) {
      throw new IllegalArgumentException(
          "targets is " + targets + ", expected at most " + maxTargets);
    }
    this.targets = targets;
    masks.reshape(targets);
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
    masks.setRow(sets, source, from);
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
    return masks.words();
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
    return masks.word(set, word);
  }

  /** The sets of all cameras, a row for each; not to be changed. */
  BitMatrix masks() {
    return masks;
  }

  /** Whether the target is in the set. */
  public boolean contains(int set, int target) {
    return masks.has(set, target);
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
    return masks.includes(set, other);
  }

  /** Whether a set of the last camera includes the mask at {@code from} in {@code source}. */
  public boolean lastCameraIncludes(long[] source, int from) {
    boolean included = false;
    for (int set = firstSet[cameras - 1]; set < sets && !included; set++) {
      included = masks.includes(set, source, from);
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

package org.hificamsim.network.agent;

import java.util.Arrays;
import org.hificamsim.core.world.Cameras;

/**
 * The targets that each camera searches for, on whose behalf, and in which order the searches began
 * (behaviour 4.6).
 *
 * <p>The entries of all cameras for one target are adjacent in memory, since most messages go to
 * all cameras.
 */
public final class Searches {
  /** The owner of a target that nobody owns, which the first camera that sees it may claim. */
  static final int NOBODY = -1;

  /** The camera does not search for the target. */
  static final int NONE = -2;

  private static final int[] NO_TARGETS = {};

  private final Cameras cameras;

  /** The camera on whose behalf a camera searches, by target, then by searching camera. */
  private final int[][] searcher;

  /** The start of each search, as a number of {@link #begunSearches}. */
  private final long[][] since;

  private long begunSearches;

  /** Creates the state in which no camera searches for any target. */
  public Searches(Cameras cameras, int targets) {
    this.cameras = cameras;
    searcher = new int[targets][cameras.count()];
    since = new long[targets][cameras.count()];
    for (int[] row : searcher) {
      Arrays.fill(row, NONE);
    }
  }

  /**
   * The camera on whose behalf a camera searches for a target, {@link #NOBODY} or {@link #NONE}.
   */
  int searcher(int camera, int target) {
    return searcher[target][camera];
  }

  /** Starts a search of a camera on behalf of a camera or {@link #NOBODY}. */
  void begin(int camera, int target, int forCamera) {
    if (searcher[target][camera] == NONE) {
      since[target][camera] = ++begunSearches;
    }
    searcher[target][camera] = forCamera;
  }

  /** Ends the search of a camera for a target. */
  void end(int camera, int target) {
    searcher[target][camera] = NONE;
  }

  /**
   * Starts or ends the search at every online camera except the sender.
   *
   * @return the number of these cameras
   */
  public int receiveAll(MessageKind kind, int from, int target) {
    int[] searchers = searcher[target];
    int forCamera = kind == MessageKind.START_SEARCH ? from : NONE;
    begunSearches++;
    int count = 0;
    for (int camera = 0; camera < searchers.length; camera++) {
      if (camera != from && cameras.online(camera)) {
        if (searchers[camera] == NONE) {
          since[target][camera] = begunSearches;
        }
        searchers[camera] = forCamera;
        count++;
      }
    }
    return count;
  }

  /**
   * The owned targets for which a camera searches on its own behalf, in the order of the searches.
   */
  int[] ownSearches(int camera, OwnedTargets owned) {
    int count = 0;
    for (int i = 0; i < owned.count(); i++) {
      count += searcher[owned.target(i)][camera] == camera ? 1 : 0;
    }
    return count == 0 ? NO_TARGETS : sortedOwnSearches(camera, owned, count);
  }

  private int[] sortedOwnSearches(int camera, OwnedTargets owned, int count) {
    int[] targets = new int[count];
    int sorted = 0;
    for (int i = 0; i < owned.count(); i++) {
      int target = owned.target(i);
      if (searcher[target][camera] == camera) {
        int index = sorted++;
        for (; index > 0 && since[targets[index - 1]][camera] > since[target][camera]; index--) {
          targets[index] = targets[index - 1];
        }
        targets[index] = target;
      }
    }
    return targets;
  }
}

package org.hificamsim.network.agent;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.world.Cameras;

/**
 * The targets that each camera looks for, for whom, and in which order it began to (behaviour 4.6).
 *
 * <p>What the cameras know of one target lies side by side: most messages go to all of them.
 */
public final class Searches {
  /** Nobody owns the target: the first camera that sees it may have it. */
  static final int NOBODY = -1;

  /** The camera does not look for the target. */
  static final int NONE = -2;

  private final Cameras cameras;
  private final int[][] searcher; // by target, then camera
  private final long[][] since;
  private long searches; // that have begun

  /** No camera looks for any target. */
  public Searches(Cameras cameras, int targets) {
    this.cameras = cameras;
    searcher = new int[targets][cameras.count()];
    since = new long[targets][cameras.count()];
    for (int[] row : searcher) {
      Arrays.fill(row, NONE);
    }
  }

  /** For whom a camera looks for a target: a camera, {@link #NOBODY} or {@link #NONE}. */
  int searcher(int camera, int target) {
    return searcher[target][camera];
  }

  /** A camera looks for a target from now on, for a camera or for {@link #NOBODY}. */
  void begin(int camera, int target, int forCamera) {
    if (searcher[target][camera] == NONE) {
      since[target][camera] = ++searches;
    }
    searcher[target][camera] = forCamera;
  }

  /** A camera looks for a target no longer. */
  void end(int camera, int target) {
    searcher[target][camera] = NONE;
  }

  /**
   * Every camera online but the sender receives that a search begins, or ends.
   *
   * @return how many these are
   */
  public int receiveAll(MessageKind kind, int from, int target) {
    int[] searchers = searcher[target];
    int forCamera = kind == MessageKind.START_SEARCH ? from : NONE;
    searches++;
    int count = 0;
    for (int camera = 0; camera < searchers.length; camera++) {
      if (camera != from && cameras.online(camera)) {
        if (searchers[camera] == NONE) {
          since[target][camera] = searches;
        }
        searchers[camera] = forCamera;
        count++;
      }
    }
    return count;
  }

  /** Of a camera's targets those that it looks for itself, in the order in which it began to. */
  List<Integer> own(int camera, Collection<Integer> owned) {
    if (owned.isEmpty()) {
      return List.of();
    }
    List<Integer> own = new ArrayList<>();
    for (int target : owned) {
      if (searcher[target][camera] == camera) {
        own.add(target);
      }
    }
    if (own.size() > 1) {
      own.sort(Comparator.comparingLong(target -> since[target][camera]));
    }
    return own;
  }
}

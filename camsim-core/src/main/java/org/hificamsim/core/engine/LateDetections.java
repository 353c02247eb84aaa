package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.scenario.spec.ProcessingBudget;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * Gives each camera as many detections as it can process in a step, the nearest targets first, of
 * equally near ones those with lower numbers; the others reach it in the next step, unchanged.
 *
 * <p>Late detections come with the picture of the next step: a camera that sees nothing then,
 * because it is off, asleep or on its way, drops them.
 */
public final class LateDetections {
  /** The unlimited budget, with which no detection is late. */
  public static final LateDetections NONE = new LateDetections();

  /** Detections of one camera, with the positions and confidences of their step. */
  private static final class Backlog {
    private int count;
    private int[] targets = {};
    private double[] x = {};
    private double[] y = {};
    private double[] confidences = {};

    void add(int target, double newX, double newY, double confidence) {
      if (count == targets.length) {
        int length = Math.max(8, 2 * count);
        targets = Arrays.copyOf(targets, length);
        x = Arrays.copyOf(x, length);
        y = Arrays.copyOf(y, length);
        confidences = Arrays.copyOf(confidences, length);
      }
      targets[count] = target;
      x[count] = newX;
      y[count] = newY;
      confidences[count++] = confidence;
    }

    /** Returns the index of a target; -1 if it is not there. */
    int index(int target) {
      int index = count - 1;
      while (index >= 0 && targets[index] != target) {
        index--;
      }
      return index;
    }
  }

  private final int limit;
  private final Cameras cameras;
  private final Targets targets;

  /** The late detections of each camera that are processed in this step. */
  private Backlog[] due;

  /** The late detections of each camera that will be processed in the next step. */
  private Backlog[] waiting;

  private LateDetections() {
    limit = ProcessingBudget.UNLIMITED.detections();
    cameras = null;
    targets = null;
    due = new Backlog[0];
    waiting = new Backlog[0];
  }

  LateDetections(World world, ProcessingBudget budget) {
    limit = budget.detections();
    cameras = world.cameras();
    targets = world.targets();
    due = new Backlog[cameras.count()];
    waiting = new Backlog[cameras.count()];
    Arrays.setAll(due, camera -> new Backlog());
    Arrays.setAll(waiting, camera -> new Backlog());
  }

  /** Whether there is a limit; without one nothing is late. */
  public boolean isLimited() {
    return limit < ProcessingBudget.UNLIMITED.detections();
  }

  /** Begins a step, in which the detections that waited are due. */
  void beginStep() {
    Backlog[] waited = waiting;
    waiting = due;
    due = waited;
    for (Backlog backlog : waiting) {
      backlog.count = 0;
    }
  }

  /**
   * Processes what a camera detects in this step, and keeps the rest for the next one.
   *
   * @param found the targets that the camera detects; receives those of which it knows
   * @param confidences the confidences by index in {@code found}, which are read and written
   * @param count the number of targets found
   * @return the number of targets known
   */
  public int process(int camera, int[] found, double[] confidences, int count) {
    int fresh = bringNearest(camera, found, confidences, count);
    waiting[camera].count = 0;
    for (int i = fresh; i < count; i++) {
      int target = found[i];
      waiting[camera].add(target, targets.x(target), targets.y(target), confidences[i]);
    }
    return addDue(camera, found, confidences, fresh);
  }

  /** Does the same as {@link #process}, but keeps nothing. */
  int preview(int camera, int[] found, double[] confidences, int count) {
    return addDue(camera, found, confidences, bringNearest(camera, found, confidences, count));
  }

  /** The number of targets of a step that are processed at once. */
  int fresh(int count) {
    return Math.min(limit, count);
  }

  /** Sorts the nearest targets to the front; returns how many are processed. */
  private int bringNearest(int camera, int[] found, double[] confidences, int count) {
    int fresh = fresh(count);
    for (int i = 0; i < fresh && fresh < count; i++) {
      int nearest = i;
      for (int j = i + 1; j < count; j++) {
        nearest = isBefore(camera, found[j], found[nearest]) ? j : nearest;
      }
      int target = found[i];
      double confidence = confidences[i];
      found[i] = found[nearest];
      confidences[i] = confidences[nearest];
      found[nearest] = target;
      confidences[nearest] = confidence;
    }
    return fresh;
  }

  private boolean isBefore(int camera, int target, int other) {
    double distance = squaredDistance(camera, target);
    double otherDistance = squaredDistance(camera, other);
    return distance < otherDistance || (distance == otherDistance && target < other);
  }

  private double squaredDistance(int camera, int target) {
    double dx = targets.x(target) - cameras.x(camera);
    double dy = targets.y(target) - cameras.y(camera);
    return dx * dx + dy * dy;
  }

  private int addDue(int camera, int[] found, double[] confidences, int fresh) {
    Backlog late = due[camera];
    int known = fresh;
    for (int i = 0; i < late.count; i++) {
      if (targets.present(late.targets[i]) && !contains(found, fresh, late.targets[i])) {
        found[known] = late.targets[i];
        confidences[known++] = late.confidences[i];
      }
    }
    return known;
  }

  private static boolean contains(int[] found, int count, int target) {
    boolean contained = false;
    for (int i = 0; i < count; i++) {
      contained |= found[i] == target;
    }
    return contained;
  }

  /** The x coordinate of a target when a camera detected it, a step before it is known; metres. */
  double x(int camera, int target) {
    return due[camera].x[due[camera].index(target)];
  }

  /** The y coordinate of a target when a camera detected it, a step before it is known; metres. */
  double y(int camera, int target) {
    return due[camera].y[due[camera].index(target)];
  }
}

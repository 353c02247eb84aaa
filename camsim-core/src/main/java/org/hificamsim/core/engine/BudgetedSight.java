package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** The part of the sight that cameras can process within a step. */
final class BudgetedSight {
  private final Cameras cameras;
  private final Targets targets;
  private final Sight sight;
  private final LateDetections late;

  /** Scratch memory: the targets of one camera, the fresh ones first. */
  private final int[] found;

  private final double[] confidences;
  private final long[] gridPoints;

  /** The number of targets that the camera of the last {@link #preview} knows. */
  private int known;

  BudgetedSight(World world, Sight sight, LateDetections late) {
    cameras = world.cameras();
    targets = world.targets();
    this.sight = sight;
    this.late = late;
    found = new int[targets.count()];
    confidences = new double[targets.count()];
    gridPoints = new long[targets.count() + 1];
  }

  /** Lets all cameras look; receives the numbers of detections by camera and by target. */
  void look(int[] detected, int[] coverage) {
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < detected.length; camera++) {
      int seen = find(camera);
      detected[camera] = seen < 0 ? 0 : late.process(camera, found, confidences, seen);
      for (int i = 0; i < detected[camera]; i++) {
        coverage[found[i]]++;
      }
    }
  }

  /**
   * Finds the targets that a camera detects now; returns their number, or -1 if it sees nothing.
   */
  private int find(int camera) {
    int view = cameras.online(camera) ? cameras.seeing(camera) : Cameras.NO_VIEW;
    int count = sight.find(camera, view, gridPoints);
    for (int i = 0; i < count; i++) {
      found[i] = sight.grid().point((int) gridPoints[i]);
      confidences[i] = sight.confidence(camera, found[i]);
    }
    return view == Cameras.NO_VIEW ? -1 : count;
  }

  /** Finds the targets that a camera knows now; returns the number that it processes at once. */
  private int preview(int camera) {
    int seen = find(camera);
    known = seen < 0 ? 0 : late.preview(camera, found, confidences, seen);
    return seen < 0 ? 0 : late.fresh(seen);
  }

  /**
   * Returns the index of a target among those that a camera knows; -1 if the camera does not know
   * it.
   */
  private int index(int target) {
    int index = known - 1;
    while (index >= 0 && found[index] != target) {
      index--;
    }
    return index;
  }

  boolean sees(int camera, int target) {
    preview(camera);
    return index(target) >= 0;
  }

  /** The x coordinate at which a camera detected a target that it {@link #sees}, in metres. */
  double x(int camera, int target) {
    int fresh = preview(camera);
    return index(target) < fresh ? targets.x(target) : late.x(camera, target);
  }

  double y(int camera, int target) {
    int fresh = preview(camera);
    return index(target) < fresh ? targets.y(target) : late.y(camera, target);
  }

  /** The confidence for a target as the camera knows it; 0 if the detection is late. */
  double confidence(int camera, int target) {
    preview(camera);
    int index = index(target);
    if (index >= 0) {
      return confidences[index];
    }
    return sight.sees(camera, target) ? 0 : sight.confidence(camera, target);
  }

  double seenConfidence(int camera, int target, double distance) {
    int fresh = preview(camera);
    int index = index(target);
    return index < fresh ? sight.seenConfidence(camera, target, distance) : confidences[index];
  }

  void findSeen(SeenPairs pairs) {
    pairs.clear();
    for (int camera = 0; camera < cameras.count(); camera++) {
      int fresh = preview(camera);
      for (int i = 0; i < known; i++) {
        int target = found[i];
        double x = i < fresh ? targets.x(target) : late.x(camera, target);
        double y = i < fresh ? targets.y(target) : late.y(camera, target);
        sight.addPair(camera, target, x, y, pairs);
      }
    }
  }
}

package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;

/**
 * The distances at which each zoom level detects targets, by the level's number ({@link
 * Cameras#zoomNumber}). They are computed when a level is first used, once for each body of
 * targets.
 */
final class LevelTable {
  private final Cameras cameras;
  private final Visibility visibility;
  private final TargetBodies bodies;
  private final boolean open;

  /** The sights of each level, by level number and body. */
  private LevelSight[] levelSights = {};

  private double[] squaredLimit = {};
  private double[] reach = {};
  private boolean[] detectsAllInReach = {};
  private boolean allDetectAllInReach = true;
  private int revision;

  /**
   * @param open whether nothing hides targets
   */
  LevelTable(Cameras cameras, Visibility visibility, TargetBodies bodies, boolean open) {
    this.cameras = cameras;
    this.visibility = visibility;
    this.bodies = bodies;
    this.open = open;
    addNewLevels();
  }

  /** Adds the levels of cameras that changed since the last call. */
  void update() {
    if (revision != cameras.revision()) {
      addNewLevels();
    }
  }

  private void addNewLevels() {
    revision = cameras.revision();
    for (int camera = 0; camera < cameras.count(); camera++) {
      for (int view = 0; view < cameras.views(camera); view++) {
        int number = cameras.zoomNumber(camera, view);
        if (number >= squaredLimit.length || squaredLimit[number] == 0) {
          addLevel(number, camera, view);
        }
      }
    }
  }

  private void addLevel(int number, int camera, int view) {
    if (number >= squaredLimit.length) {
      int length = Math.max(number + 1, 2 * squaredLimit.length);
      levelSights = Arrays.copyOf(levelSights, length * bodies.count());
      squaredLimit = Arrays.copyOf(squaredLimit, length);
      reach = Arrays.copyOf(reach, length);
      detectsAllInReach = Arrays.copyOf(detectsAllInReach, length);
    }
    double farthest = -1;
    for (int body = 0; body < bodies.count(); body++) {
      LevelSight level = visibility.at(cameras.zoom(camera, view), bodies.body(body));
      levelSights[number * bodies.count() + body] = level;
      farthest = Math.max(farthest, level.farthestSquared());
      reach[number] = Math.max(reach[number], level.reach());
      detectsAllInReach[number] =
          bodies.count() == 1 && level.isDisc() && level.byDistance() && open;
    }
    squaredLimit[number] = Math.nextUp(farthest);
    allDetectAllInReach &= detectsAllInReach[number];
  }

  LevelSight level(int number, int body) {
    return levelSights[number * bodies.count() + body];
  }

  /** The squared distance from which nothing is detected, in square metres. */
  double squaredLimit(int number) {
    return squaredLimit[number];
  }

  /** The distance beyond which nothing is detected, in metres; rounded up. */
  double reach(int number) {
    return reach[number];
  }

  /**
   * The mean over the cameras of the distance at which they see, in metres: the geometric mean of
   * the reaches of the narrowest and the widest level of a lens.
   */
  double meanReach() {
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      int last = cameras.views(camera) - 1;
      ZoomLevel widest = cameras.zoom(camera, last);
      sum +=
          widest.hasLens()
              ? Math.sqrt(
                  reach[cameras.zoomNumber(camera, 0)] * reach[cameras.zoomNumber(camera, last)])
              : widest.radius();
    }
    return sum / cameras.count();
  }

  /** Whether every target nearer than the limit is detected. */
  boolean detectsAllInReach(int number) {
    return detectsAllInReach[number];
  }

  /** Whether {@link #detectsAllInReach} holds for all levels. */
  boolean allDetectAllInReach() {
    return allDetectAllInReach;
  }
}

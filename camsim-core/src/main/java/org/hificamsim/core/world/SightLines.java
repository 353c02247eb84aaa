package org.hificamsim.core.world;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Foreshortening;
import org.hificamsim.core.scenario.spec.Occlusion;

/**
 * Finds what stands between cameras and targets: obstacles, and other targets if the scenario lets
 * them hide each other. Between two refreshes, several threads may use it.
 */
public final class SightLines {
  private final ScenarioObstacles obstacles;
  private final Scenario scenario;
  private final boolean flat;
  private final boolean byTargets;
  private final Cameras cameras;
  private final Targets targets;
  private final VisibleRegion[] regions;
  private final boolean partial;
  private int revision = -1;

  /**
   * @param shared the sight lines of another world of the scenario, whose regions are used where
   *     cameras have the same position; null for none
   */
  SightLines(
      ScenarioObstacles obstacles,
      Scenario scenario,
      Cameras cameras,
      Targets targets,
      SightLines shared) {
    this.obstacles = obstacles;
    this.scenario = scenario;
    this.flat = !scenario.hasHeights();
    this.byTargets = scenario.occlusion() == Occlusion.TARGETS;
    this.cameras = cameras;
    this.targets = targets;
    this.partial = !obstacles.glass().isEmpty();
    this.regions =
        shared == null
            ? new VisibleRegion[obstacles.all().isEmpty() ? 0 : cameras.count()]
            : shared.regions.clone();
    refresh();
  }

  /** Computes the visible regions of cameras that moved since the last call. */
  void refresh() {
    if (revision == cameras.revision()) {
      return;
    }
    revision = cameras.revision();
    for (int camera = 0; camera < regions.length; camera++) {
      if (hasMoved(camera)) {
        regions[camera] = VisibleRegion.of(obstacles.all(), cameras.x(camera), cameras.y(camera));
      }
    }
  }

  private boolean hasMoved(int camera) {
    return regions[camera] == null || !regions[camera].isFrom(cameras.x(camera), cameras.y(camera));
  }

  /** The obstacles that cameras believe in. */
  public Obstacles map() {
    return obstacles.map();
  }

  /** The mean width of targets, in metres, if they hide each other; else 0. */
  public double hidingWidth() {
    return byTargets ? targets.meanWidth() : 0;
  }

  /** Whether no camera has a height. */
  public boolean flat() {
    return flat;
  }

  /** Whether no line of sight is ever blocked or dimmed. */
  public boolean open() {
    return regions.length == 0 && !byTargets;
  }

  /** Whether any obstacle lets a part of the light through. */
  public boolean partial() {
    return partial;
  }

  /**
   * The part of a target's light that reaches a camera: 0 if the target is hidden, 1 if nothing is
   * in between.
   */
  public double transmittance(int camera, int target) {
    double z = cameras.z(camera);
    double through =
        regions.length == 0
            ? 1
            : regions[camera].transmittance(
                targets.x(target), targets.y(target), z, targets.low(target), targets.high(target));
    return byTargets
            && through > 0
            && targets.isHidden(target, cameras.x(camera), cameras.y(camera), z)
        ? 0
        : through;
  }

  /** The part of a target's light that passes the obstacles that are not solid. */
  public double throughGlass(int camera, int target) {
    return partial
        ? obstacles
            .glass()
            .transmittance(
                cameras.x(camera),
                cameras.y(camera),
                cameras.z(camera),
                targets.x(target),
                targets.y(target),
                targets.low(target),
                targets.high(target))
        : 1;
  }

  /**
   * Sets which part of a target must be seen, by the scenario or else by the model, and whether its
   * size or its height counts.
   */
  public void applyRuleOf(DetectionModel model) {
    targets.setRule(
        scenario.find(Scenario.SEEN).orElse(model.seen()),
        scenario.get(Scenario.FORESHORTENING) == Foreshortening.COSINE,
        model.byHeight());
  }
}

package org.hificamsim.core.world;

import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Foreshortening;
import org.hificamsim.core.scenario.spec.Occlusion;

/**
 * What stands between cameras and targets: obstacles, seen from where each camera stands, and other
 * targets where the scenario lets them hide each other. Between two refreshes any number of threads
 * may ask.
 */
public final class SightLines {
  private final Obstacles obstacles;
  private final Obstacles map;
  private final Scenario scenario;
  private final boolean flat;
  private final boolean byTargets;
  private final Cameras cameras;
  private final Targets targets;
  private final VisibleRegion[] regions;
  private final boolean partial;
  private int revision = -1;

  SightLines(Obstacles obstacles, Scenario scenario, Cameras cameras, Targets targets) {
    this.obstacles = obstacles;
    this.map = scenario.find(Scenario.MAP).map(Obstacles::new).orElse(obstacles);
    this.scenario = scenario;
    this.flat = !scenario.hasHeights();
    this.byTargets = scenario.occlusion() == Occlusion.TARGETS;
    this.cameras = cameras;
    this.targets = targets;
    this.regions = new VisibleRegion[obstacles.isEmpty() ? 0 : cameras.count()];
    this.partial = obstacles.all().stream().anyMatch(one -> one.transmittance() > 0);
    refresh();
  }

  /** Takes note of cameras that were moved since the last call. */
  void refresh() {
    if (revision == cameras.revision()) {
      return;
    }
    revision = cameras.revision();
    for (int camera = 0; camera < regions.length; camera++) {
      if (hasMoved(camera)) {
        regions[camera] = VisibleRegion.of(obstacles, cameras.x(camera), cameras.y(camera));
      }
    }
  }

  private boolean hasMoved(int camera) {
    return regions[camera] == null || !regions[camera].isFrom(cameras.x(camera), cameras.y(camera));
  }

  /** The map of the obstacles that cameras have. */
  public Obstacles map() {
    return map;
  }

  /** Whether no camera has a height. */
  public boolean flat() {
    return flat;
  }

  /** Whether nothing ever stands in between. */
  public boolean open() {
    return regions.length == 0 && !byTargets;
  }

  /** Whether something lets a part of the light through. */
  public boolean partial() {
    return partial;
  }

  /**
   * How much of a target gets through to a camera: 0 where it is hidden, 1 where nothing is in
   * between.
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

  /** Says what has to be seen of targets where the scenario does not. */
  public void require(Seen usual) {
    targets.require(
        scenario.find(Scenario.SEEN).orElse(usual),
        scenario.get(Scenario.FORESHORTENING) == Foreshortening.COSINE);
  }
}

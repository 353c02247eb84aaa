package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.world.World;

/** The sight of models that depend on the bearing: the model is called in full. */
final class BearingSight implements Sight {
  private final World world;
  private final FieldOfView view;
  private final Detection detection;

  BearingSight(World world, Detection detection) {
    this.world = world;
    this.view = new FieldOfView(world.cameras(), world.targets());
    this.detection = detection;
  }

  @Override
  public void refresh() {}

  @Override
  public boolean detects(int camera, int level, int target) {
    if (!view.contains(camera, level, target)) {
      return false;
    }
    ZoomLevel zoom = world.cameras().zoom(camera, level);
    double distance = Math.sqrt(view.squaredDistance(camera, target));
    double offAxis = view.offAxis(camera, target);
    return detection.model().confidence(world.targets().size(target), distance, offAxis, zoom)
        >= detection.threshold();
  }

  @Override
  public boolean dominates(int camera, int level, int other) {
    return level == other;
  }

  @Override
  public double reach(int camera, int level) {
    return Reach.of(world.cameras().zoom(camera, level).radius());
  }
}

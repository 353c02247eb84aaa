package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** The cameras' observations of a world, and all that policies and listeners may know of it. */
final class ObservedNetwork implements NetworkView {
  private final Cameras cameras;
  private final Targets targets;
  private final Detection detection;
  private final Sight sight;
  private final FieldOfView view;
  private final int[] detected;
  private final int[] coverage;
  private long step;

  ObservedNetwork(World world, Detection detection) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.detection = detection;
    this.sight = Sight.of(world, detection);
    this.view = new FieldOfView(cameras, targets);
    this.detected = new int[cameras.count()];
    this.coverage = new int[targets.count()];
  }

  /** Says which step is under way, and takes note of what its events changed. */
  void beginStep(long newStep) {
    step = newStep;
    sight.refresh();
  }

  /** Every online camera looks at every target, each at its current level. */
  void observe() {
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < detected.length; camera++) {
      detected[camera] = cameras.online(camera) ? look(camera, cameras.level(camera)) : 0;
    }
  }

  private int look(int camera, int level) {
    int count = 0;
    for (int target = 0; target < coverage.length; target++) {
      if (targets.present(target) && sight.detects(camera, level, target)) {
        coverage[target]++;
        count++;
      }
    }
    return count;
  }

  @Override
  public long step() {
    return step;
  }

  @Override
  public int revision() {
    return cameras.revision();
  }

  @Override
  public int cameras() {
    return cameras.count();
  }

  @Override
  public String cameraName(int camera) {
    return cameras.name(camera);
  }

  @Override
  public boolean online(int camera) {
    return cameras.online(camera);
  }

  @Override
  public double cameraX(int camera) {
    return cameras.x(camera);
  }

  @Override
  public double cameraY(int camera) {
    return cameras.y(camera);
  }

  @Override
  public double cameraHeading(int camera) {
    return cameras.heading(camera);
  }

  @Override
  public int levels(int camera) {
    return cameras.levels(camera);
  }

  @Override
  public int level(int camera) {
    return cameras.level(camera);
  }

  @Override
  public ZoomLevel zoom(int camera, int level) {
    return cameras.zoom(camera, level);
  }

  @Override
  public int detected(int camera) {
    return detected[camera];
  }

  @Override
  public int targets() {
    return targets.count();
  }

  @Override
  public String targetName(int target) {
    return targets.name(target);
  }

  @Override
  public boolean present(int target) {
    return targets.present(target);
  }

  @Override
  public double targetX(int target) {
    return targets.x(target);
  }

  @Override
  public double targetY(int target) {
    return targets.y(target);
  }

  @Override
  public int coverage(int target) {
    return coverage[target];
  }

  @Override
  public double confidence(int camera, int target) {
    int level = cameras.level(camera);
    if (!targets.present(target) || !view.contains(camera, level, target)) {
      return 0;
    }
    double distance = Math.sqrt(view.squaredDistance(camera, target));
    return DetectionModel.clamp(
        detection
            .model()
            .confidence(
                targets.size(target),
                distance,
                view.offAxis(camera, target),
                cameras.zoom(camera, level)));
  }

  @Override
  public boolean detects(int camera, int level, int target) {
    return targets.present(target) && sight.detects(camera, level, target);
  }

  @Override
  public boolean dominates(int camera, int level, int other) {
    return sight.dominates(camera, level, other);
  }
}

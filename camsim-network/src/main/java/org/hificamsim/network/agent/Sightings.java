package org.hificamsim.network.agent;

import java.util.Arrays;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.SightLines;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * What each camera saw at its last look, and with what confidence (behaviour 6.1 and 6.2). The
 * targets that a camera sees are kept in the order in which they became visible to it.
 */
public final class Sightings {
  private final Cameras cameras;
  private final Targets targets;
  private final SightLines lines;
  private final Visibility visibility;
  private final double[] confidence;
  private final InsertionOrder[] visible;
  private final Outside[] outsides;

  /** What cameras will see, nothing so far. */
  public Sightings(World world, Visibility visibility) {
    cameras = world.cameras();
    targets = world.targets();
    lines = world.sightLines();
    this.visibility = visibility;
    confidence = new double[cameras.count() * targets.count()];
    visible = new InsertionOrder[cameras.count()];
    outsides = new Outside[cameras.count()];
    Arrays.setAll(outsides, camera -> new Outside());
    for (int camera = 0; camera < visible.length; camera++) {
      visible[camera] = new InsertionOrder(targets.count());
    }
  }

  /**
   * Every online camera looks at every target present.
   *
   * @param step that is under way
   * @param detected one entry per camera, receives how many targets it sees, 0 while offline
   * @param coverage one entry per target, receives how many cameras see it
   */
  public void look(long step, int[] detected, int[] coverage) {
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < detected.length; camera++) {
      detected[camera] = cameras.online(camera) ? look(step, camera, coverage) : 0;
    }
  }

  private int look(long step, int camera, int[] coverage) {
    int view = cameras.seeing(camera);
    return view == Cameras.NO_VIEW
        ? lookAway(camera)
        : look(step, camera, cameras.pose(camera, view), cameras.zoom(camera, view), coverage);
  }

  private int lookAway(int camera) {
    for (int target = 0; target < targets.count(); target++) {
      if (targets.present(target)) {
        forget(camera, target);
      }
    }
    return 0;
  }

  private int look(long step, int camera, Pose pose, ZoomLevel zoom, int[] coverage) {
    Outside outside = outsides[camera];
    outside.of(pose, zoom);
    int seen = 0;
    for (int target = 0; target < coverage.length; target++) {
      if (targets.present(target)) {
        double sure =
            outside.has(targets.x(target), targets.y(target))
                ? 0
                : confidence(step, camera, pose, zoom, target);
        note(camera, target, sure);
        seen += sure > 0 ? 1 : 0;
        coverage[target] += sure > 0 ? 1 : 0;
      }
    }
    return seen;
  }

  private double confidence(long step, int camera, Pose pose, ZoomLevel zoom, int target) {
    return visibility.confidence(
        pose,
        zoom,
        targets.x(target),
        targets.y(target),
        targets.size(target),
        visibility.luck(step, camera, target),
        lines.transmittance(camera, target));
  }

  /** A camera loses sight of a target, whatever its next look brings. */
  public void forget(int camera, int target) {
    note(camera, target, 0);
  }

  private void note(int camera, int target, double sure) {
    confidence[camera * targets.count() + target] = sure;
    if (sure > 0) {
      visible[camera].add(target);
    } else {
      visible[camera].remove(target);
    }
  }

  /** How sure the camera is of the target; 0 where it does not see it. */
  public double confidence(int camera, int target) {
    return confidence[camera * targets.count() + target];
  }

  /** Whether the camera sees the target. */
  public boolean sees(int camera, int target) {
    return visible[camera].contains(target);
  }

  /** The targets that the camera sees. */
  public InsertionOrder visible(int camera) {
    return visible[camera];
  }
}

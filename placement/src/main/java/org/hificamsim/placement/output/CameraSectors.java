package org.hificamsim.placement.output;

import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.placement.site.SitePlan;
import org.hificamsim.presentation.replay.CameraPose;
import org.hificamsim.presentation.replay.Setup;

/**
 * The parts of the plan that cameras see in the views that they are mounted with: as wide as their
 * pictures, as far as the first zone's detection reaches, and cut by walls. Tilts do not count.
 */
final class CameraSectors {
  private final Setup setup;
  private final Cameras cameras;

  CameraSectors(SitePlan plan, Catalogue catalogue) {
    Detection detection = plan.demand().zones().get(0).detection();
    World world = new World(plan.scenario(), catalogue.movements(), 0);
    this.setup = Setup.of(world, detection, "fixed", 0, List.of());
    this.cameras = world.cameras();
  }

  /** The sector of a camera, by its number in the plan; metres. */
  Area sector(int camera) {
    CameraPose pose = setup.cameras().get(camera).pose();
    int view = cameras.view(camera);
    double heading = Math.toDegrees(pose.heading() + cameras.pan(camera, view));
    double width = Math.toDegrees(cameras.zoom(camera, view).viewingAngle());
    double radius = reach(pose.levels().get(view % cameras.zooms(camera)));
    double start = heading - 90 - width / 2; // clockwise from +x, as Arc2D counts where y is up
    Area sector =
        new Area(
            new Arc2D.Double(
                pose.x() - radius,
                pose.y() - radius,
                2 * radius,
                2 * radius,
                start,
                width,
                Arc2D.PIE));
    if (!pose.visible().isEmpty()) {
      sector.intersect(new Area(polygon(pose.visible())));
    }
    return sector;
  }

  private static double reach(CameraPose.Level level) {
    return level.detected().stream().mapToDouble(CameraPose.Interval::to).max().orElse(0);
  }

  private static Path2D polygon(List<Double> corners) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < corners.size(); i += 2) {
      if (i == 0) {
        path.moveTo(corners.get(i), corners.get(i + 1));
      } else {
        path.lineTo(corners.get(i), corners.get(i + 1));
      }
    }
    path.closePath();
    return path;
  }
}

package org.hificamsim.placement.output;

import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.placement.site.CameraPlan;
import org.hificamsim.placement.site.ViewReach;
import org.hificamsim.presentation.replay.CameraPose;
import org.hificamsim.presentation.replay.Setup;

/**
 * What cameras see of the plan in the views that they are mounted with: sectors as wide as their
 * pictures, cut by walls, as far as the zone asks in which a camera covers most. Sectors begin at
 * the camera; in its blind zone people are too near, below the picture.
 */
final class CameraSectors {
  private final List<CameraPose> poses = new ArrayList<>();
  private final List<ViewReach> reaches = new ArrayList<>();
  private final Cameras cameras;

  CameraSectors(CameraPlan plan, Catalogue catalogue) {
    World world = new World(plan.scenario(), catalogue.movements(), 0);
    this.cameras = world.cameras();
    Map<Detection, Setup> setups = new HashMap<>();
    for (int camera = 0; camera < plan.cameras().size(); camera++) {
      Detection detection = detection(plan, camera);
      Setup setup =
          setups.computeIfAbsent(detection, asked -> Setup.of(world, asked, "fixed", 0, List.of()));
      CameraPose pose = setup.cameras().get(camera).pose();
      int view = cameras.view(camera);
      poses.add(pose);
      reaches.add(
          new ViewReach.Axis(
                  plan.cameras().get(camera),
                  pose.heading() + cameras.pan(camera, view),
                  farthest(pose.levels().get(view % cameras.zooms(camera))))
              .reach(plan.demand(), detection, catalogue));
    }
  }

  /** The detection of the zone in which a camera covers most points. */
  private static Detection detection(CameraPlan plan, int camera) {
    int[] counts = new int[plan.demand().zones().size()];
    int most = 0;
    for (int point : plan.cover().covered()[camera]) {
      int zone = plan.demand().points().get(point).zone();
      counts[zone]++;
      most = counts[zone] > counts[most] ? zone : most;
    }
    return plan.demand().zones().get(most).detection();
  }

  /** The sector of a camera, by its number in the plan, with its blind zone; metres. */
  Area sector(int camera) {
    return sector(camera, reaches.get(camera).far());
  }

  /**
   * What a camera sees.
   *
   * @param area from the camera as far as people are seen, metres
   * @param blindZone the part in which people are too near
   */
  record Sector(Area area, Area blindZone) {}

  /** The sectors of all cameras. */
  List<Sector> all() {
    return IntStream.range(0, reaches.size())
        .mapToObj(camera -> new Sector(sector(camera), sector(camera, reaches.get(camera).near())))
        .toList();
  }

  private Area sector(int camera, double radius) {
    CameraPose pose = poses.get(camera);
    int view = cameras.view(camera);
    double heading = Math.toDegrees(pose.heading() + cameras.pan(camera, view));
    double width = Math.toDegrees(cameras.zoom(camera, view).viewingAngle());
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

  private static double farthest(CameraPose.Level level) {
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

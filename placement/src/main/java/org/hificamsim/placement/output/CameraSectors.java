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
 * The parts of a site that cameras see in the views in which they are mounted. Each is a sector as
 * wide as the picture and cut by walls. It reaches as far as people are detected according to the
 * zone in which the camera covers most. A sector begins at the camera; in its blind zone, people
 * are so near that they are below the picture.
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
          setups.computeIfAbsent(detection, key -> Setup.of(world, key, "fixed", 0, List.of()));
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

  /** Returns the detection of the zone in which a camera covers most points. */
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

  /**
   * Returns the sector of a camera, in metres. Its blind zone is a part of it.
   *
   * @param camera number of the camera in the plan
   */
  Area sector(int camera) {
    return sector(camera, reaches.get(camera).far());
  }

  /**
   * The sector of a camera, in metres.
   *
   * @param area the area from the camera to where people are no longer seen
   * @param blindZone the part in which people are too near
   */
  record Sector(Area area, Area blindZone) {}

  /** Returns the sectors of all cameras, in the order of the plan. */
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
    // Arc2D counts angles clockwise from +x if y points upwards
    double start = heading - 90 - width / 2;
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

package org.hificamsim.runs.hints;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.hifi.OpticalDetection;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.runs.ShortNumber;

/** Warns of cameras whose viewing angle contradicts their focal lengths. */
final class LensHint {
  private static final double TOLERANCE = 1.1;
  private static final double FULL_CIRCLE = 360;
  private static final double HALF_CIRCLE = 180;

  private final Scenario scenario;
  private final Optics optics;

  private LensHint(Scenario scenario, Optics optics) {
    this.scenario = scenario;
    this.optics = optics;
  }

  static Optional<String> of(Scenario scenario, Detection detection) {
    return detection.model() instanceof OpticalDetection model
        ? new LensHint(scenario, model.optics()).warning()
        : Optional.empty();
  }

  private Optional<String> warning() {
    List<CameraSpec> contradictory =
        scenario.cameras().stream().filter(this::isContradictory).toList();
    return contradictory.stream()
        .findFirst()
        .map(
            camera ->
                "camera '%s'%s sees %s degrees (viewing_angle), but its focal length gives %s (Eq 3.1); expected a mount_height that makes them agree%s, or viewing_angle 360"
                    .formatted(
                        camera.name(),
                        contradictory.size() == 1 ? "" : " (one of " + contradictory.size() + ")",
                        ShortNumber.of(camera.viewingAngle()),
                        angles(zoomLevels(camera)),
                        proposedHeight(camera)));
  }

  private boolean isContradictory(CameraSpec camera) {
    List<ZoomLevel> zooms = zoomLevels(camera);
    double angle = camera.viewingAngle();
    return angle < FULL_CIRCLE
        && (angle < degrees(zooms.get(0)) / TOLERANCE || angle > degrees(last(zooms)) * TOLERANCE);
  }

  private List<ZoomLevel> zoomLevels(CameraSpec camera) {
    return World.zoomLevels(scenario, camera);
  }

  private static ZoomLevel last(List<ZoomLevel> zooms) {
    return zooms.get(zooms.size() - 1);
  }

  private String angles(List<ZoomLevel> zooms) {
    String narrowest = ShortNumber.of(degrees(zooms.get(0)));
    String widest = ShortNumber.of(degrees(last(zooms)));
    return narrowest.equals(widest) ? narrowest : narrowest + " to " + widest;
  }

  /** The angle of view that the focal length gives at a zoom level (Eq 3.1). */
  private double degrees(ZoomLevel zoom) {
    return Math.toDegrees(optics.angleOfView(optics.focalLength(zoom)));
  }

  /** Proposes a height at which the widest radius has the viewing angle (Eq 3.2), if one exists. */
  private String proposedHeight(CameraSpec camera) {
    double radius = last(zoomLevels(camera)).radius();
    double height = radius / Math.tan(Math.toRadians(camera.viewingAngle()) / 2);
    boolean exists = camera.viewingAngle() < HALF_CIRCLE && radius > 0 && Double.isFinite(height);
    return exists ? ", such as " + ShortNumber.of(height) : "";
  }
}

package org.hificamsim.core.scenario.spec;

import java.util.Collections;
import java.util.List;

/** Common lenses, and draft cameras with them. */
public final class DraftOptics {
  /** The optics of a dome camera that pans, with angles of view from 60 to 6 degrees. */
  public static final OpticsSpec DOME =
      new OpticsSpec("dome")
          .with(OpticsSpec.PIXELS, 1920)
          .with(OpticsSpec.ANGLES_OF_VIEW, List.of(6.0, 11.0, 20.0, 35.0, 60.0))
          .with(OpticsSpec.PANS, List.of(-60.0, -45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0, 60.0))
          .with(OpticsSpec.PAN_SPEED, 100)
          .with(OpticsSpec.ZOOM_TIME, 3);

  /** The optics of a camera that cannot turn, with angles of view from 105 to 33 degrees. */
  public static final OpticsSpec BULLET =
      new OpticsSpec("bullet")
          .with(OpticsSpec.PIXELS, 3840)
          .with(OpticsSpec.ANGLES_OF_VIEW, List.of(33.0, 50.0, 74.0, 105.0))
          .with(OpticsSpec.ZOOM_TIME, 3);

  private DraftOptics() {}

  /** The height of a draft camera if obstacles have heights, in metres. */
  private static final double DEFAULT_HEIGHT = 3;

  /** Tilts relative to the camera's own, in degrees; the first one lets narrow levels see far. */
  private static final List<Double> TILTS = List.of(-16.0, 0.0);

  /**
   * Hangs a camera at the default height, tilted so that the upper edge of its widest picture meets
   * the ground at a distance.
   *
   * @param far the distance, in metres, above 0
   */
  public static CameraSpec hung(CameraSpec camera, double far) {
    OpticsSpec optics = camera.get(CameraSpec.OPTICS).with(OpticsSpec.TILTS, TILTS);
    double horizon = Math.toDegrees(Math.atan2(DEFAULT_HEIGHT, far));
    return camera
        .with(CameraSpec.OPTICS, optics)
        .with(CameraSpec.Z, DEFAULT_HEIGHT)
        .with(CameraSpec.TILT, Math.rint(horizon + Collections.max(optics.verticalAngles()) / 2));
  }

  /** Creates a camera at a position that looks at another one, in metres. */
  public static CameraSpec camera(
      String name, OpticsSpec optics, double x, double y, double targetX, double targetY) {
    return new CameraSpec(name, x, y, 0)
        .with(CameraSpec.HEADING, Math.rint(Math.toDegrees(Math.atan2(targetX - x, targetY - y))))
        .with(CameraSpec.VIEWING_ANGLE, Collections.max(optics.anglesOfView()))
        .with(CameraSpec.OPTICS, optics);
  }
}

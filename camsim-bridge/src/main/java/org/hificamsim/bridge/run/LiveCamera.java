package org.hificamsim.bridge.run;

import java.util.BitSet;
import org.hificamsim.bridge.camsim.Aim;
import org.hificamsim.bridge.camsim.Aiming;
import org.hificamsim.bridge.camsim.CamSim;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.ViewSet;

/**
 * A camera of CamSim with its views, as it was at the last {@link #refresh}.
 *
 * <p>Its mounted heading and its own opening angle are those that CamSim has now, unless {@link
 * #turnTo} caused them; in that case it has the values before the turn.
 */
final class LiveCamera {
  private static final String UNNAMED = "";
  private static final Aim NEVER = new Aim(Double.NaN, Double.NaN, Double.NaN);

  private final Object handle;
  private final CameraViews cameraViews;
  private final BitSet seen = new BitSet();
  private String name = UNNAMED;
  private boolean online;
  private Pose mountPose = Pose.of(0, 0, 0);
  private double angle;
  private final double ownRange;
  private double reach = Double.NaN;
  private ViewSet views;
  private int view;
  private Aim requestedAim = NEVER;

  /** The aim that CamSim reported after {@link #requestedAim} was requested. */
  private Aim resultingAim = NEVER;

  private Aim currentAim = NEVER;

  /**
   * Creates a camera in its home view; it is offline until the first {@link #refresh}.
   *
   * @param ownRange the range that CamSim gave it, in metres
   */
  LiveCamera(Object handle, double ownRange, CameraViews cameraViews) {
    this.handle = handle;
    this.ownRange = ownRange;
    this.cameraViews = cameraViews;
    this.views = cameraViews.of(0, 2 * Math.PI);
    this.view = views.home();
  }

  /**
   * Reads the current position, aim and range of the camera from CamSim.
   *
   * @return whether anything other than the view has changed
   */
  boolean refresh(CamSim camsim) {
    if (camsim.offline(handle)) {
      return switchOff();
    }
    boolean changed = !online;
    online = true;
    if (name.equals(UNNAMED)) {
      // Read only while online: CamSim calls an offline camera "Offline".
      name = camsim.cameraName(handle);
    }
    currentAim = camsim.aim(handle);
    changed |= place(camsim.cameraX(handle), camsim.cameraY(handle), ownHeading());
    changed |= refit(ownAngle(), cameraViews.steered() ? ownRange : currentAim.range());
    return changed;
  }

  private double ownHeading() {
    return currentAim.heading() == resultingAim.heading()
        ? mountPose.heading()
        : currentAim.heading();
  }

  private double ownAngle() {
    return currentAim.angle() == resultingAim.angle() ? angle : currentAim.angle();
  }

  private boolean place(double newX, double newY, double newHeading) {
    if (newX == mountPose.x() && newY == mountPose.y() && newHeading == mountPose.heading()) {
      return false;
    }
    mountPose = Pose.of(newX, newY, newHeading);
    return true;
  }

  private boolean refit(double newAngle, double newReach) {
    if (newAngle == angle && newReach == reach) {
      return false;
    }
    angle = newAngle;
    reach = newReach;
    views = cameraViews.of(reach, angle);
    return true;
  }

  /** Marks a camera that has failed or is gone as offline; returns whether it was online. */
  boolean switchOff() {
    boolean wasOnline = online;
    online = false;
    return wasOnline;
  }

  /** Turns CamSim's camera to a view; without optics, only changes its range. */
  void turnTo(int newView, CamSim camsim, Aiming aiming) {
    view = newView;
    if (cameraViews.optics().isPresent()) {
      aim(new Aim(viewPose().heading(), zoom().viewingAngle(), zoom().radius()), aiming);
    } else {
      changeRange(zoom().radius(), camsim);
    }
  }

  private void aim(Aim wanted, Aiming aiming) {
    if (!wanted.equals(requestedAim) || !currentAim.equals(resultingAim)) {
      resultingAim = aiming.aim(handle, wanted);
      currentAim = resultingAim;
      requestedAim = wanted;
    }
  }

  /** Restores the aim before any policy, with the changes that CamSim has made since. */
  void restore(CamSim camsim, Aiming aiming) {
    if (!requestedAim.equals(NEVER)) {
      currentAim = camsim.aim(handle);
      aiming.aim(handle, new Aim(ownHeading(), ownAngle(), ownRange));
    } else if (cameraViews.optics().isEmpty()) {
      changeRange(ownRange, camsim);
    }
  }

  private void changeRange(double radius, CamSim camsim) {
    if (radius != currentAim.range()) {
      camsim.changeRange(handle, radius);
      currentAim = new Aim(currentAim.heading(), currentAim.angle(), radius);
    }
  }

  /** The position of the camera and its mounted heading. */
  Pose pose() {
    return mountPose;
  }

  /** The position of the camera and the heading of its present view. */
  Pose viewPose() {
    return mountPose.turned(views.pan(view));
  }

  /** The camera as a scenario describes one. */
  CameraSpec spec() {
    return new CameraSpec(name, mountPose.x(), mountPose.y(), currentAim.range())
        .with(CameraSpec.HEADING, Math.toDegrees(mountPose.heading()))
        .with(CameraSpec.VIEWING_ANGLE, Math.toDegrees(angle))
        .with(CameraSpec.OPTICS, cameraViews.optics());
  }

  /** The targets that the camera saw at its last look. */
  BitSet seen() {
    return seen;
  }

  String name() {
    return name;
  }

  boolean online() {
    return online;
  }

  ViewSet views() {
    return views;
  }

  int view() {
    return view;
  }

  ZoomLevel zoom() {
    return views.zoom(view);
  }
}

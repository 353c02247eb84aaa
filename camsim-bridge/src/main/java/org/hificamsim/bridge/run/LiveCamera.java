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
 * A camera of CamSim's as it was at the last {@link #refresh}, with its views.
 *
 * <p>Its mounted heading and its own opening angle are those that CamSim has, unless CamSim has
 * what {@link #turnTo} made of them: then they are those of before.
 */
final class LiveCamera {
  private static final String UNNAMED = "";
  private static final Aim NEVER = new Aim(Double.NaN, Double.NaN, Double.NaN);

  private final Object handle;
  private final CameraViews kind;
  private final BitSet seen = new BitSet();
  private String name = UNNAMED;
  private boolean online;
  private Pose mounted = Pose.of(0, 0, 0);
  private double angle;
  private final double ownRange;
  private double reach = Double.NaN;
  private ViewSet views;
  private int view;
  private Aim asked = NEVER;
  private Aim turned = NEVER; // what CamSim made of it
  private Aim now = NEVER;

  /**
   * A camera at its widest level, ahead; it is offline until the first {@link #refresh}.
   *
   * @param ownRange metres
   */
  LiveCamera(Object handle, double ownRange, CameraViews kind) {
    this.handle = handle;
    this.ownRange = ownRange;
    this.kind = kind;
    this.views = kind.of(0, 2 * Math.PI);
    this.view = views.home();
  }

  /**
   * Looks where the camera is and what it can do now.
   *
   * @return whether anything has changed but the view
   */
  boolean refresh(CamSim camsim) {
    if (camsim.offline(handle)) {
      return switchOff();
    }
    boolean changed = !online;
    online = true;
    if (name.equals(UNNAMED)) {
      name = camsim.cameraName(handle); // while it is offline, CamSim calls it "Offline"
    }
    now = camsim.aim(handle);
    changed |= place(camsim.cameraX(handle), camsim.cameraY(handle), ownHeading());
    changed |= refit(ownAngle(), kind.steered() ? ownRange : now.range());
    return changed;
  }

  private double ownHeading() {
    return now.heading() == turned.heading() ? mounted.heading() : now.heading();
  }

  private double ownAngle() {
    return now.angle() == turned.angle() ? angle : now.angle();
  }

  private boolean place(double newX, double newY, double newHeading) {
    if (newX == mounted.x() && newY == mounted.y() && newHeading == mounted.heading()) {
      return false;
    }
    mounted = Pose.of(newX, newY, newHeading);
    return true;
  }

  private boolean refit(double newAngle, double newReach) {
    if (newAngle == angle && newReach == reach) {
      return false;
    }
    angle = newAngle;
    reach = newReach;
    views = kind.of(reach, angle);
    return true;
  }

  /** The camera takes no part, since it has failed or is gone; returns whether it did. */
  boolean switchOff() {
    boolean was = online;
    online = false;
    return was;
  }

  /** Turns to a view, and CamSim's camera with it; where it has no optics, its range alone. */
  void turnTo(int newView, CamSim camsim, Aiming aiming) {
    view = newView;
    if (kind.optics().isPresent()) {
      aim(new Aim(viewPose().heading(), zoom().viewingAngle(), zoom().radius()), aiming);
    } else {
      changeRange(zoom().radius(), camsim);
    }
  }

  private void aim(Aim wanted, Aiming aiming) {
    if (!wanted.equals(asked) || !now.equals(turned)) {
      turned = aiming.aim(handle, wanted);
      now = turned;
      asked = wanted;
    }
  }

  /** Gives the camera back what it had before any policy, or was given by CamSim since. */
  void restore(CamSim camsim, Aiming aiming) {
    if (!asked.equals(NEVER)) {
      now = camsim.aim(handle);
      aiming.aim(handle, new Aim(ownHeading(), ownAngle(), ownRange));
    } else if (kind.optics().isEmpty()) {
      changeRange(ownRange, camsim);
    }
  }

  private void changeRange(double radius, CamSim camsim) {
    if (radius != now.range()) {
      camsim.changeRange(handle, radius);
      now = new Aim(now.heading(), now.angle(), radius);
    }
  }

  /** Where the camera stands and which way it is mounted. */
  Pose pose() {
    return mounted;
  }

  /** Where the camera stands and which way it looks. */
  Pose viewPose() {
    return mounted.turned(views.pan(view));
  }

  /** The camera as a scenario describes one. */
  CameraSpec spec() {
    return new CameraSpec(name, mounted.x(), mounted.y(), now.range())
        .with(CameraSpec.HEADING, Math.toDegrees(mounted.heading()))
        .with(CameraSpec.VIEWING_ANGLE, Math.toDegrees(angle))
        .with(CameraSpec.OPTICS, kind.optics());
  }

  /** The targets seen at the last look. */
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

package org.hificamsim.bridge.run;

import java.util.BitSet;
import java.util.Map;
import org.hificamsim.bridge.camsim.CamSim;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.AgentSpec;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.visibility.Pose;

/** A camera of CamSim's as it was at the last {@link #refresh}, with its zoom levels. */
final class LiveCamera {
  private static final String UNNAMED = "";

  private final Object handle;
  private final Zooms zooms;
  private final BitSet seen = new BitSet();
  private String name = UNNAMED;
  private boolean online;
  private Pose pose = Pose.of(0, 0, 0);
  private double angle;
  private double range;
  private double ownRange;
  private double reach = Double.NaN;
  private ZoomLevel[] levels;
  private int level;

  /** A camera that is yet to come: offline, with the levels of a range of 0. */
  static LiveCamera toCome(Zooms zooms) {
    return new LiveCamera(null, zooms);
  }

  /** A camera at its widest level; it is offline until the first {@link #refresh}. */
  static LiveCamera of(Object handle, CamSim camsim, Zooms zooms) {
    LiveCamera camera = new LiveCamera(handle, zooms);
    camera.ownRange = camsim.range(handle);
    return camera;
  }

  private LiveCamera(Object handle, Zooms zooms) {
    this.handle = handle;
    this.zooms = zooms;
    this.levels = zooms.of(0, 2 * Math.PI);
    this.level = levels.length - 1;
  }

  /**
   * Looks where the camera is and what it can do now.
   *
   * @return whether anything has changed but the zoom level
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
    changed |= place(camsim.cameraX(handle), camsim.cameraY(handle), camsim.heading(handle));
    range = camsim.range(handle);
    changed |= refit(camsim.angle(handle), zooms.steered() ? ownRange : range);
    return changed;
  }

  private boolean place(double newX, double newY, double newHeading) {
    if (newX == pose.x() && newY == pose.y() && newHeading == pose.heading()) {
      return false;
    }
    pose = Pose.of(newX, newY, newHeading);
    return true;
  }

  private boolean refit(double newAngle, double newReach) {
    if (newAngle == angle && newReach == reach) {
      return false;
    }
    angle = newAngle;
    reach = newReach;
    levels = zooms.of(reach, angle);
    return true;
  }

  /** The camera takes no part, since it has failed or is gone; returns whether it did. */
  boolean switchOff() {
    boolean was = online;
    online = false;
    return was;
  }

  /** Sets the zoom level, and CamSim's range by it. */
  void zoomTo(int newLevel, CamSim camsim) {
    level = newLevel;
    changeRange(levels[level].radius(), camsim);
  }

  /** Gives the camera back the range it had before any policy. */
  void restore(CamSim camsim) {
    changeRange(ownRange, camsim);
  }

  private void changeRange(double radius, CamSim camsim) {
    if (radius != range) {
      camsim.changeRange(handle, radius);
      range = radius;
    }
  }

  /** Where the camera stands and which way it looks. */
  Pose pose() {
    return pose;
  }

  /** The camera as a scenario describes one. */
  CameraSpec spec() {
    return new CameraSpec(
        name,
        pose.x(),
        pose.y(),
        Math.toDegrees(pose.heading()),
        Math.toDegrees(angle),
        range,
        AgentSpec.NONE,
        Map.of());
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

  int level() {
    return level;
  }

  ZoomLevel zoom() {
    return levels[level];
  }

  ZoomLevel zoom(int atLevel) {
    return levels[atLevel];
  }
}

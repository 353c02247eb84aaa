package org.hificamsim.core.world;

import java.util.Arrays;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.Pose;

/**
 * The cameras' state, one array a quantity, sized once for all cameras that will ever be added.
 *
 * <p>A camera keeps its number. It starts at its widest zoom level.
 */
public final class Cameras {
  private final String[] names;
  private final Pose[] poses;
  private final ZoomLevel[][] zooms;
  private final int[] level;
  private final boolean[] online;
  private int revision;

  Cameras(int count) {
    names = new String[count];
    poses = new Pose[count];
    Arrays.fill(poses, Pose.of(0, 0, 0));
    zooms = new ZoomLevel[count][];
    level = new int[count];
    online = new boolean[count];
  }

  void define(int camera, String name, ZoomLevel[] levels) {
    names[camera] = name;
    zooms[camera] = levels;
    level[camera] = levels.length - 1;
  }

  void place(int camera, Pose pose) {
    poses[camera] = pose;
    revision++;
  }

  void refit(int camera, ZoomLevel[] levels) {
    zooms[camera] = levels;
    revision++;
  }

  void switchTo(int camera, boolean on) {
    online[camera] = on;
    revision++;
  }

  /** Sets the zoom level. */
  public void zoomTo(int camera, int newLevel) {
    level[camera] = newLevel;
  }

  /** How many cameras there will ever be. */
  public int count() {
    return poses.length;
  }

  /** The name in the scenario file. */
  public String name(int camera) {
    return names[camera];
  }

  /** Whether the camera has been added and not been switched off. */
  public boolean online(int camera) {
    return online[camera];
  }

  /** Where the camera stands and which way it looks. */
  public Pose pose(int camera) {
    return poses[camera];
  }

  /** Metres. */
  public double x(int camera) {
    return poses[camera].x();
  }

  /** Metres. */
  public double y(int camera) {
    return poses[camera].y();
  }

  /** Radians, 0 is +y and pi/2 is +x; not normalised. */
  public double heading(int camera) {
    return poses[camera].heading();
  }

  /** The number of zoom levels, 1 or more. */
  public int views(int camera) {
    return zooms[camera].length;
  }

  /** The current zoom level, from 0, the narrowest. */
  public int view(int camera) {
    return level[camera];
  }

  /** One of the zoom levels. */
  public ZoomLevel zoom(int camera, int atLevel) {
    return zooms[camera][atLevel];
  }

  /** Changes whenever a camera is added, moved, refitted or switched off. */
  public int revision() {
    return revision;
  }
}

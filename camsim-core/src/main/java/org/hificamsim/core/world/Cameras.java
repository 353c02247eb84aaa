package org.hificamsim.core.world;

import java.util.Arrays;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.spec.Moving;
import org.hificamsim.core.visibility.Pose;

/**
 * The state of the cameras: one array for each quantity, sized for all cameras that the scenario
 * will ever have.
 *
 * <p>A camera keeps its number. Its views are each of its zoom levels at each of its pan angles,
 * numbered from 0: all zoom levels of the first pan angle, from the narrowest, then those of the
 * next. It starts at its widest level, ahead.
 */
public final class Cameras {
  /** The view of a camera that moves blindly and sees nothing. */
  public static final int NO_VIEW = -1;

  private static final Pose NOWHERE = Pose.of(0, 0, 0);

  private final String[] names;
  private final Mount[] mounts;
  private final int[] view;

  /** The pose of each camera that {@link #aim} turned to any angle; null for the others. */
  private final Pose[] aimedPoses;

  private final double[] aimedPans;
  private final boolean[] online;
  private Motion motion;
  private double stepTime = 1;
  private int revision;
  private int viewRevision;

  Cameras(int count) {
    names = new String[count];
    mounts = new Mount[count];
    view = new int[count];
    aimedPoses = new Pose[count];
    aimedPans = new double[count];
    online = new boolean[count];
  }

  /** Defines a camera that is not added yet: it has its views, but no position. */
  void define(int camera, String name, Mount mount) {
    names[camera] = name;
    online[camera] = false;
    mount(camera, mount.withPose(NOWHERE));
    view[camera] = mount.set.home();
  }

  /** Makes moves take time if any camera needs it; called once all cameras are defined. */
  void startMotion(double newStepTime) {
    stepTime = newStepTime;
    ViewSet[] sets = Arrays.stream(mounts).map(mount -> mount.set).toArray(ViewSet[]::new);
    if (Arrays.stream(sets).anyMatch(ViewSet::takesTime)) {
      motion = new Motion(sets, stepTime);
      for (int camera = 0; camera < view.length; camera++) {
        motion.arrive(camera, view[camera]);
      }
    }
  }

  void place(int camera, Mount mount) {
    mount(camera, mount);
    revision++;
  }

  void place(int camera, String name, Mount mount) {
    names[camera] = name;
    place(camera, mount);
  }

  void place(int camera, Pose pose) {
    place(camera, mounts[camera].withPose(pose));
  }

  void switchTo(int camera, boolean on) {
    online[camera] = on;
    revision++;
  }

  private void mount(int camera, Mount mount) {
    mounts[camera] = mount;
    aimedPoses[camera] = null;
    if (motion != null) {
      motion.refit(camera, mount.set);
    }
  }

  /** Sends a camera towards a view. */
  public void turnTo(int camera, int newView) {
    release(camera);
    // Adds 0 for the same view; a branch would be unpredictable.
    viewRevision += newView ^ view[camera];
    view[camera] = newView;
  }

  /** Puts a camera into a view at once, even if the move would take time. */
  public void jumpTo(int camera, int newView) {
    turnTo(camera, newView);
    if (motion != null) {
      motion.arrive(camera, newView);
      viewRevision++;
    }
  }

  /**
   * Puts a camera into a view at once and turns it to any angle.
   *
   * @param pan the pan angle, radians off the mounted heading; holds until the next turn
   */
  public void aim(int camera, int newView, double pan) {
    jumpTo(camera, newView);
    aimedPoses[camera] = mounts[camera].pose.turned(pan);
    aimedPans[camera] = pan;
    viewRevision++;
  }

  /** Restores the angle of a view that was aimed. */
  private void release(int camera) {
    if (aimedPoses[camera] != null) {
      aimedPoses[camera] = null;
      viewRevision++;
    }
  }

  /** Moves the cameras that are on their way by what they manage in one step. */
  public void advance() {
    if (motion != null) {
      motion.advance(view, online);
      viewRevision++;
    }
  }

  /** The number of cameras that there will ever be. */
  public int count() {
    return mounts.length;
  }

  /** The name in the scenario file. */
  public String name(int camera) {
    return names[camera];
  }

  /** Whether the camera has been added and not been switched off. */
  public boolean online(int camera) {
    return online[camera];
  }

  /** Returns the position of the camera and the heading at which it is mounted. */
  public Pose pose(int camera) {
    return mounts[camera].pose;
  }

  /** Returns the position of the camera and the direction in which it looks in one of its views. */
  public Pose pose(int camera, int atView) {
    return aimedPoses[camera] != null && atView == view[camera]
        ? aimedPoses[camera]
        : mounts[camera].poses[atView];
  }

  /** The x coordinate, in metres. */
  public double x(int camera) {
    return mounts[camera].pose.x();
  }

  /** The y coordinate, in metres. */
  public double y(int camera) {
    return mounts[camera].pose.y();
  }

  /** The mounted heading: radians, 0 is +y and pi/2 is +x; not normalised. */
  public double heading(int camera) {
    return mounts[camera].pose.heading();
  }

  /** The number of views, 1 or more. */
  public int views(int camera) {
    return mounts[camera].zooms.length;
  }

  /** The number of zoom levels, 1 or more. */
  public int zooms(int camera) {
    return mounts[camera].set.zooms().size();
  }

  /** The view that was chosen last, from 0. */
  public int view(int camera) {
    return view[camera];
  }

  /** The view through which the camera sees now; {@link #NO_VIEW} while it moves blindly. */
  public int seeing(int camera) {
    return motion == null ? view[camera] : motion.seeing(camera, view[camera]);
  }

  /**
   * Whether the camera could be in a view by the end of a step. Cameras whose moves take no time
   * reach the views that are at most one level and one pan angle away.
   */
  public boolean reaches(int camera, int otherView) {
    return mounts[camera].set.takesTime()
        ? motion.reaches(camera, otherView)
        : mounts[camera].set.isNextTo(view[camera], otherView); // thesis 7.4.1
  }

  /** The number of steps that a camera moves towards a view before the step in which it arrives. */
  public int stepsTo(int camera, int otherView) {
    return motion == null ? 0 : motion.stepsTo(camera, otherView);
  }

  /** Does the same as {@link #stepsTo} for a camera that would rest in the view {@code from}. */
  public int stepsBetween(int camera, int from, int otherView) {
    return motion == null ? 0 : motion.stepsBetween(camera, from, otherView);
  }

  /** Whether the camera sees nothing while it is on its way. */
  public boolean movesBlindly(int camera) {
    return mounts[camera].set.moving() == Moving.BLIND;
  }

  /**
   * Returns the angle by which the camera can turn within a step, in radians; infinite if it turns
   * at once.
   */
  public double turnInStep(int camera) {
    return stepTime * mounts[camera].set.panSpeed();
  }

  /**
   * Returns by how many zoom levels the camera's lens can change within a step; infinite if it
   * changes at once.
   */
  public double zoomInStep(int camera) {
    return stepTime * mounts[camera].set.zoomSpeed();
  }

  /** Returns the present reach of the camera, in metres; 0 while it moves blindly. */
  public double range(int camera) {
    int seenView = seeing(camera);
    return seenView == NO_VIEW ? 0 : mounts[camera].zooms[seenView].radius();
  }

  /** Whether the camera is on its way to the view that was chosen last. */
  public boolean moving(int camera) {
    return motion != null && motion.moving(camera);
  }

  /** The zoom level of one of the views. */
  public ZoomLevel zoom(int camera, int atView) {
    return mounts[camera].zooms[atView];
  }

  /** The number, from 0, that equal zoom levels share in all worlds of a scenario. */
  public int zoomNumber(int camera, int atView) {
    return mounts[camera].zoomNumbers[atView];
  }

  /** The pan angle of one of the views, radians off the mounted heading. */
  public double pan(int camera, int atView) {
    return aimedPoses[camera] != null && atView == view[camera]
        ? aimedPans[camera]
        : mounts[camera].set.pan(atView);
  }

  /** The present angle of the camera's head, radians off its mounted heading. */
  public double presentPan(int camera) {
    return moving(camera) ? motion.pan(camera) : pan(camera, view[camera]);
  }

  /** The present zoom level of the lens, which is no whole number on its way. */
  public double presentZoom(int camera) {
    return moving(camera) ? motion.zoom(camera) : mounts[camera].set.zoomOf(view[camera]);
  }

  /** The tilt of one of the views, radians below the horizon. */
  public double tilt(int camera, int atView) {
    return mounts[camera].set.tilt(atView);
  }

  /** Returns the height of the lens, in metres; NaN in a flat world. */
  public double z(int camera) {
    return mounts[camera].zooms[0].vertical().z();
  }

  /** A number that changes whenever a camera is added, moved, refitted or switched. */
  public int revision() {
    return revision;
  }

  /** A number that changes whenever a camera may look elsewhere or through another zoom level. */
  public int viewRevision() {
    return viewRevision + revision;
  }
}

package org.hificamsim.core.world;

import org.hificamsim.core.scenario.spec.Moving;

/**
 * The moves of cameras from view to view. Turning and zooming begin together; a move that is not
 * finished within a step continues in the next.
 */
final class Motion {
  private final ViewSet[] views;
  private final double stepTime;
  private final double[] pan;
  private final double[] tilt;
  private final double[] zoom;
  private final boolean[] moving;

  /** The view that each camera passes during a move. */
  private final int[] passing;

  /**
   * @param views the views of each camera
   * @param stepTime the step time, in seconds
   */
  Motion(ViewSet[] views, double stepTime) {
    this.views = views;
    this.stepTime = stepTime;
    pan = new double[views.length];
    tilt = new double[views.length];
    zoom = new double[views.length];
    moving = new boolean[views.length];
    passing = new int[views.length];
  }

  void refit(int camera, ViewSet set) {
    views[camera] = set;
  }

  /** Puts a camera into a view at once. */
  void arrive(int camera, int view) {
    pan[camera] = views[camera].pan(view);
    tilt[camera] = views[camera].tilt(view);
    zoom[camera] = views[camera].zoomOf(view);
    moving[camera] = false;
  }

  /** Moves every online camera that is not at its goal by one step. */
  void advance(int[] goals, boolean[] online) {
    for (int camera = 0; camera < goals.length; camera++) {
      if (online[camera]) {
        advance(camera, goals[camera]);
      }
    }
  }

  private void advance(int camera, int goal) {
    if (reaches(camera, goal)) {
      arrive(camera, goal);
      return;
    }
    ViewSet set = views[camera];
    moving[camera] = true;
    pan[camera] = towards(pan[camera], set.pan(goal), set.panSpeed() * stepTime);
    tilt[camera] = towards(tilt[camera], set.tilt(goal), set.panSpeed() * stepTime);
    zoom[camera] = towards(zoom[camera], set.zoomOf(goal), set.zoomSpeed() * stepTime);
    passing[camera] =
        set.moving() == Moving.BLIND
            ? Cameras.NO_VIEW
            : set.nearest(pan[camera], tilt[camera], zoom[camera]);
  }

  private static double towards(double from, double to, double limit) {
    double difference = to - from;
    return Math.abs(difference) <= limit ? to : from + Math.copySign(limit, difference);
  }

  /** Whether a camera arrives in a view within a step. */
  boolean reaches(int camera, int view) {
    ViewSet set = views[camera];
    return isWithin(set.pan(view) - pan[camera], set.panSpeed())
        && isWithin(set.tilt(view) - tilt[camera], set.panSpeed())
        && isWithin(set.zoomOf(view) - zoom[camera], set.zoomSpeed());
  }

  /** The number of steps that a camera moves towards a view before the step in which it arrives. */
  int stepsTo(int camera, int view) {
    return steps(views[camera], view, pan[camera], tilt[camera], zoom[camera]);
  }

  /** The same for a camera that would be at rest in a view. */
  int stepsBetween(int camera, int from, int view) {
    ViewSet set = views[camera];
    return steps(set, view, set.pan(from), set.tilt(from), set.zoomOf(from));
  }

  private int steps(ViewSet set, int view, double fromPan, double fromTilt, double fromZoom) {
    double panning = Math.abs(set.pan(view) - fromPan);
    double turning = Math.max(panning, Math.abs(set.tilt(view) - fromTilt)) / set.panSpeed();
    double zooming = Math.abs(set.zoomOf(view) - fromZoom) / set.zoomSpeed();
    return (int) Math.max(0, Math.ceil(Math.max(turning, zooming) / stepTime / (1 + 1e-6)) - 1);
  }

  /**
   * Whether a difference is covered within a step, allowing for rounding: five steps of a fifth
   * make a whole.
   */
  private boolean isWithin(double difference, double speed) {
    return Math.abs(difference) <= speed * stepTime * (1 + 1e-6);
  }

  /** Whether a camera is on its way. */
  boolean moving(int camera) {
    return moving[camera];
  }

  /** The present angle of a camera's head, radians off its mounted heading. */
  double pan(int camera) {
    return pan[camera];
  }

  /** The present zoom level of a camera's lens. */
  double zoom(int camera) {
    return zoom[camera];
  }

  /** The view through which a camera sees on its way to a goal; -1 while it sees nothing. */
  int seeing(int camera, int goal) {
    return moving[camera] ? passing[camera] : goal;
  }
}

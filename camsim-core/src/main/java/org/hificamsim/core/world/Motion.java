package org.hificamsim.core.world;

import org.hificamsim.core.scenario.spec.Moving;

/**
 * Where cameras are on their way from view to view: turning and zooming begin together and take
 * their time; a move that is not done within a step goes on in the next.
 */
final class Motion {
  private final ViewSet[] views;
  private final double stepTime;
  private final double[] pan;
  private final double[] tilt;
  private final double[] zoom;
  private final boolean[] moving;
  private final int[]
      passing; // the view that a camera on its way passes: asked far more than moved

  /**
   * @param views of each camera
   * @param stepTime seconds
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

  /** Moves every camera that is not at its goal for the time of a step. */
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

  private static double towards(double from, double to, double most) {
    double way = to - from;
    return Math.abs(way) <= most ? to : from + Math.copySign(most, way);
  }

  /** Whether a camera comes to a view within a step. */
  boolean reaches(int camera, int view) {
    ViewSet set = views[camera];
    return isWithin(set.pan(view) - pan[camera], set.panSpeed())
        && isWithin(set.tilt(view) - tilt[camera], set.panSpeed())
        && isWithin(set.zoomOf(view) - zoom[camera], set.zoomSpeed());
  }

  /** How many steps a camera moves towards a view before the one in which it comes to it. */
  int stepsTo(int camera, int view) {
    ViewSet set = views[camera];
    double panning = Math.abs(set.pan(view) - pan[camera]);
    double turning = Math.max(panning, Math.abs(set.tilt(view) - tilt[camera])) / set.panSpeed();
    double zooming = Math.abs(set.zoomOf(view) - zoom[camera]) / set.zoomSpeed();
    return (int) Math.max(0, Math.ceil(Math.max(turning, zooming) / stepTime / (1 + 1e-6)) - 1);
  }

  /** A part in a million more: five steps of a fifth are a whole. */
  private boolean isWithin(double way, double speed) {
    return Math.abs(way) <= speed * stepTime * (1 + 1e-6);
  }

  /** Whether a camera has not arrived. */
  boolean moving(int camera) {
    return moving[camera];
  }

  /** The view through which a camera sees on its way to a goal; -1 while it sees nothing. */
  int seeing(int camera, int goal) {
    return moving[camera] ? passing[camera] : goal;
  }
}

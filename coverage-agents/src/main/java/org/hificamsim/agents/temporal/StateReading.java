package org.hificamsim.agents.temporal;

/**
 * The state of a learning camera; thesis 7.4.4 says only that it is the percept. A state is a
 * number from 0, of the percept alone or of the percept together with the present view.
 */
public enum StateReading {
  /** The present view and the number of targets detected with it. */
  LEVEL_COUNT(true, 0),

  /** The number of targets detected. */
  COUNT(false, 0),

  /** A single state, so that one value is learned for each view. */
  NONE(false, 0),

  /** The thirds of the picture that have a target: left, centre, right. */
  PICTURE(false, PicturePercept.THIRDS),

  /** The same together with the present view. */
  VIEW_PICTURE(true, PicturePercept.THIRDS),

  /** The thirds of the picture that have a near target, and those that have a far one. */
  PICTURE_DEPTH(false, 2 * PicturePercept.THIRDS),

  /** The same together with the present view. */
  VIEW_PICTURE_DEPTH(true, 2 * PicturePercept.THIRDS);

  private final boolean byView;
  private final int parts;

  /**
   * @param parts number of parts of the picture that are distinguished; 0 if targets are counted
   */
  StateReading(boolean byView, int parts) {
    this.byView = byView;
    this.parts = parts;
  }

  /** The number of parts of the picture that are distinguished; 0 if targets are counted. */
  int parts() {
    return parts;
  }

  /** The number of different percepts, for this number of targets. */
  int percepts(int targets) {
    if (parts > 0) {
      return 1 << parts;
    }
    return this == NONE ? 1 : targets + 1;
  }

  /** The number of states with the same percept, for a camera with this number of views. */
  int statesPerPercept(int views) {
    return byView ? views : 1;
  }

  /** The number of a state, from 0; states with lower percepts come first. */
  int state(int view, int percept, int views) {
    if (this == NONE) {
      return 0;
    }
    return byView ? percept * views + view : percept;
  }
}

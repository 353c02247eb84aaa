package org.hificamsim.agents.temporal;

/**
 * What a camera takes as its state; thesis 7.4.4 says only that it is the percept. A state is a
 * percept, a number from 0, alone or with the view that the camera is in.
 */
public enum StateReading {
  /** The current view and the number of targets detected with it. */
  LEVEL_COUNT(true, 0),
  /** The number of targets detected. */
  COUNT(false, 0),
  /** Always the same state: what is learned is one value for each view. */
  NONE(false, 0),
  /** Which thirds of the picture have a target: left, centre, right. */
  PICTURE(false, PicturePercept.THIRDS),
  /** The same, and the current view. */
  VIEW_PICTURE(true, PicturePercept.THIRDS),
  /** Which thirds of the picture have a target that is near, and which have one that is far. */
  PICTURE_DEPTH(false, 2 * PicturePercept.THIRDS),
  /** The same, and the current view. */
  VIEW_PICTURE_DEPTH(true, 2 * PicturePercept.THIRDS);

  private final boolean byView;
  private final int parts;

  /**
   * @param parts of the picture that are distinguished, 0 where targets are counted
   */
  StateReading(boolean byView, int parts) {
    this.byView = byView;
    this.parts = parts;
  }

  /** Parts of the picture that are distinguished; 0 where the percept is a number of targets. */
  int parts() {
    return parts;
  }

  /** How many different percepts there are with this number of targets. */
  int percepts(int targets) {
    if (parts > 0) {
      return 1 << parts;
    }
    return this == NONE ? 1 : targets + 1;
  }

  /** The number of states that share a percept, of a camera with this number of views. */
  int statesPerPercept(int views) {
    return byView ? views : 1;
  }

  /** The number of a state, from 0: those with lower percepts come first. */
  int state(int view, int percept, int views) {
    if (this == NONE) {
      return 0;
    }
    return byView ? percept * views + view : percept;
  }
}

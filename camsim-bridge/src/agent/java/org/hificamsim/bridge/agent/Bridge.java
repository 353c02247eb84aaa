package org.hificamsim.bridge.agent;

/** What CamSim calls, through {@link Hooks}, from the places where the agent has changed it. */
public interface Bridge {
  /** {@code SimCore.update()} begins. */
  void stepBegins(Object core);

  /** {@code SimCore.update()} has returned. */
  void stepEnds(Object core);

  /** {@code SimCore.close_files()} has returned. */
  void runEnds(Object core);

  /**
   * A camera looks at an object, in the place of {@code CameraController.update_visiblity}.
   *
   * @return the confidence, 0 where the object is not visible; NaN when CamSim is to look itself
   */
  double look(Object camera, Object object);

  /**
   * CamSim has looked itself.
   *
   * @param confidence above 0 where the object is visible
   */
  void looked(Object camera, Object object, double confidence);

  /**
   * {@code TraceableObject.getX()} or {@code getY()} is about to return.
   *
   * @param upwards whether it is y
   * @param own what CamSim has, metres
   * @return metres
   */
  double place(Object object, boolean upwards, double own);
}

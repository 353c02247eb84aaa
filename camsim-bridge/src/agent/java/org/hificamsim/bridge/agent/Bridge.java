package org.hificamsim.bridge.agent;

/** Receives the calls that are woven into CamSim's methods, by way of {@link Hooks}. */
public interface Bridge {
  /** Called when {@code SimCore.update()} begins. */
  void stepBegins(Object core);

  /** Called when {@code SimCore.update()} has returned. */
  void stepEnds(Object core);

  /** Called when {@code SimCore.close_files()} has returned. */
  void runEnds(Object core);

  /**
   * Lets a camera look at an object, in place of {@code CameraController.update_visiblity}.
   *
   * @return the confidence, 0 if the object is not visible; NaN if CamSim has to look itself
   */
  double look(Object camera, Object object);

  /**
   * Called after CamSim has looked itself.
   *
   * @param confidence above 0 if the object is visible
   */
  void looked(Object camera, Object object, double confidence);

  /**
   * Called before {@code TraceableObject.getX()} or {@code getY()} returns.
   *
   * @param isY whether the coordinate is y, else x
   * @param camSimValue the coordinate that CamSim has, in metres
   * @return the coordinate to return, in metres
   */
  double coordinate(Object object, boolean isY, double camSimValue);
}

package org.hificamsim.core.policy;

/**
 * A policy that turns cameras to any angle between the outermost of their pan angles, and at once:
 * a bound on what is possible.
 */
public interface AimingZoomPolicy extends ZoomPolicy {
  /**
   * Where a camera is to look, at the zoom level of the view that was decided for it.
   *
   * @return radians off its heading, to the right; NaN for the view's own pan angle
   */
  double pan(int camera);

  @Override
  default boolean jumps() {
    return true;
  }
}

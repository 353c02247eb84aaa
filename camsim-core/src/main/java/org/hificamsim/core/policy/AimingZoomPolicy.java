package org.hificamsim.core.policy;

/** A policy that turns cameras at once to any angle, not only to their pan angles. */
public interface AimingZoomPolicy extends ZoomPolicy {
  /**
   * The angle to which a camera turns, at the zoom level of the view that was decided for it.
   *
   * @return radians off its heading, to the right; NaN for the pan angle of the view
   */
  double pan(int camera);

  @Override
  default boolean jumps() {
    return true;
  }
}

package org.hificamsim.core.policy;

/**
 * A bound in hindsight: a policy that has seen the whole run before it begins.
 *
 * <p>Its runner rehearses first: it runs the same world with the same seed and calls {@link
 * #rehearse} at the end of each step. Then the policy's {@link #begin} and the run itself follow.
 */
public interface HindsightZoomPolicy extends OraclePolicy {
  /**
   * Called at the end of each step of the rehearsal, in which all cameras keep their widest view.
   */
  void rehearse(OracleView network);
}

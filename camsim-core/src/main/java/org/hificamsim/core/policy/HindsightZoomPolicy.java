package org.hificamsim.core.policy;

/**
 * A policy that has seen the run before it begins: a bound on what is possible, in hindsight.
 *
 * <p>Its runner rehearses first: the same world with the same seed, {@link #rehearse} called at the
 * end of each step. The policy's own {@link #begin} follows, with the run itself.
 */
public interface HindsightZoomPolicy extends OraclePolicy {
  /** Looks at one step of the rehearsal, in which all cameras stay at their widest view. */
  void rehearse(OracleView network);
}

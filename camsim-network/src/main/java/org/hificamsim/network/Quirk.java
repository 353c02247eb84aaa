package org.hificamsim.network;

/**
 * Peculiarities of CamSim that are reproduced or not, as asked (behaviour 11). The others are
 * either always kept, because its numbers depend on them, or always mended.
 */
public enum Quirk {
  /** Q3: targets whose waypoints come through a class name take their heading for their speed. */
  Q3,
  /** Q5: what a static vision graph means hangs on the policy, and on that of the camera before. */
  Q5,
  /** Q6: a camera that an event switched off for some steps never comes back. */
  Q6,
  /** Q14: prices are not second prices, and what is paid within a step does not add up. */
  Q14,
  /** Q17: the movement that an event names by {@code move} is ignored. */
  Q17,
  /** Q19: the order of bids, and so who wins a tie, hangs on hash codes. */
  Q19
}

package org.hificamsim.core.policy;

/**
 * A policy whose cameras tell targets apart by tracks of their own, and may confuse them. The truth
 * only counts the mistakes; it must not change a decision.
 */
public interface TrackingZoomPolicy extends ZoomPolicy {
  /**
   * Returns how often a sighting of a target was assigned to another track than its previous
   * sighting (CLEAR MOT; Bernardin and Stiefelhagen 2008), so far; the mean over cameras that keep
   * tracks of their own. NaN if sightings identify their targets.
   */
  double identitySwitches();
}

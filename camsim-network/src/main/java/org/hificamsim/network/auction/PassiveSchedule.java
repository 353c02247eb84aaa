package org.hificamsim.network.auction;

import java.util.Arrays;
import org.hificamsim.network.agent.Agent;

/**
 * Advertises an owned target when it is out of sight, or faint and getting fainter (behaviour 8.3).
 */
public final class PassiveSchedule implements AuctionSchedule {
  private static final double FAINT = 0.1;

  private final double[] last;

  public PassiveSchedule(int targets) {
    last = new double[targets];
  }

  /** Forgets earlier confidences. */
  public void forget() {
    Arrays.fill(last, 0);
  }

  @Override
  public boolean advertises(Agent agent, int target) {
    double now = agent.confidence(target);
    double before = last[target];
    last[target] = now;
    return now < FAINT && (now == 0 || now < before);
  }

  @Override
  public double value(Agent agent, int target) {
    return agent.confidence(target);
  }
}

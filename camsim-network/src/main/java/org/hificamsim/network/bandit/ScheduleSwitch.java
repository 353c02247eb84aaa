package org.hificamsim.network.bandit;

import java.util.Random;
import org.hificamsim.network.auction.ActiveSchedule;
import org.hificamsim.network.auction.AuctionSchedule;
import org.hificamsim.network.auction.Broadcast;
import org.hificamsim.network.auction.CommunicationPolicy;
import org.hificamsim.network.auction.PassiveSchedule;
import org.hificamsim.network.auction.Smooth;
import org.hificamsim.network.auction.Step;
import org.hificamsim.network.auction.Trader;

/**
 * A bandit whose arms are schedules with policies: gives one camera another one step by step
 * (behaviour 9.4). Arms 0 to 2 are active, 3 to 5 passive, each with Broadcast, Smooth and Step.
 */
public final class ScheduleSwitch {
  /** CamSim's number for each arm once it is in force: Smooth and Step change places. */
  private static final int[] IN_FORCE = {0, 2, 1, 3, 5, 4};

  private static final int FIRST_PASSIVE = 3;

  private final BanditSolver solver;
  private final Trader trader;
  private final AuctionSchedule active = new ActiveSchedule();
  private final PassiveSchedule passive;
  private final CommunicationPolicy[] policies;
  private int inForce;
  private boolean isActive;

  /**
   * @param passive keeps the confidences of the camera's last advertisements; may be in use already
   * @param inForce CamSim's number for what the camera starts with, -1 for what is no arm
   * @param isActive whether it starts with an active schedule
   */
  public ScheduleSwitch(
      BanditSolver solver,
      Trader trader,
      PassiveSchedule passive,
      int inForce,
      boolean isActive,
      Random communication) {
    this.solver = solver;
    this.trader = trader;
    this.passive = passive;
    this.inForce = inForce;
    this.isActive = isActive;
    policies =
        new CommunicationPolicy[] {
          Broadcast.COUNTED,
          new Smooth(communication, Broadcast.UNCOUNTED),
          new Step(communication, Broadcast.UNCOUNTED)
        };
  }

  /** Follows the bandit's choice; tells whether CamSim counts that as a change of strategy. */
  public boolean select() {
    int arm = solver.select();
    if (arm == BanditSolver.NONE) {
      return false;
    }
    boolean toActive = arm < FIRST_PASSIVE;
    if (!toActive && isActive) {
      passive.forget();
    }
    trader.agent().links().thaw();
    trader.follow(toActive ? active : passive, policies[arm % FIRST_PASSIVE]);
    isActive = toActive;
    boolean changed = arm != inForce;
    inForce = IN_FORCE[arm];
    return changed;
  }

  /** Whether the schedule in force is an active one. */
  public boolean isActive() {
    return isActive;
  }

  /** Feeds the bandit what the step brought. */
  public void feed(double performance, double communication) {
    solver.feed(performance, communication);
  }
}

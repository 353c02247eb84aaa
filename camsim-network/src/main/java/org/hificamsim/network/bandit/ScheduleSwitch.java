package org.hificamsim.network.bandit;

import java.util.List;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.statistics.CameraFigures;

/**
 * A bandit whose arms are schedules with policies (behaviour 9.4). Arms 0 to 2 are active, 3 to 5
 * passive, each with Broadcast, Smooth and Step.
 */
public final class ScheduleSwitch implements CameraBandit {
  private static final List<CommunicationPolicy> POLICIES =
      List.of(CommunicationPolicy.BROADCAST, CommunicationPolicy.SMOOTH, CommunicationPolicy.STEP);

  /** The policies as CamSim numbers the current one: Smooth and Step are swapped. */
  private static final List<CommunicationPolicy> CURRENT_POLICIES =
      List.of(CommunicationPolicy.BROADCAST, CommunicationPolicy.STEP, CommunicationPolicy.SMOOTH);

  private final BanditSolver solver;
  private final Agent agent;

  /** Creates the bandit of a camera, which starts with the schedule and policy of the agent. */
  public ScheduleSwitch(BanditSolver solver, Agent agent) {
    this.solver = solver;
    this.agent = agent;
  }

  @Override
  public boolean choose() {
    int arm = solver.select();
    if (arm == BanditSolver.NONE) {
      return false;
    }
    boolean changed = arm != currentArm();
    ScheduleKind schedule = arm < POLICIES.size() ? ScheduleKind.ACTIVE : ScheduleKind.PASSIVE;
    agent.switchTo(schedule, POLICIES.get(arm % POLICIES.size()));
    return changed;
  }

  /** Returns CamSim's number of the current schedule and policy; -1 if they are not an arm. */
  private int currentArm() {
    int policy = CURRENT_POLICIES.indexOf(agent.policy());
    if (agent.schedule().isHistorical() || policy < 0) {
      return -1;
    }
    return agent.schedule().isActive() ? policy : policy + POLICIES.size();
  }

  @Override
  public double earned(CameraFigures figures) {
    return figures.utility(agent) + agent.received() - agent.paid();
  }

  @Override
  public void learn(double earned, int attempts, CameraFigures figures) {
    solver.feed(earned, attempts);
  }
}

package org.hificamsim.network;

import java.util.Optional;
import org.hificamsim.core.scenario.AgentCheck.Fault;
import org.hificamsim.core.scenario.AgentSpec;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;

/**
 * Reads what each camera asks for where the settings say nothing for all: the cameras of the file,
 * then those that events add (behaviour 3.2, 3.5). One without a schedule is active, one without a
 * policy broadcasts; CamSim refuses both.
 */
final class RoleReader {
  private final NetworkSettings settings;
  private final boolean zooming;
  private ScheduleKind schedule = ScheduleKind.ACTIVE;

  RoleReader(NetworkSettings settings) {
    this(settings, false);
  }

  /**
   * @param zooming whether cameras choose from a zoom list, and no bandit could set their ranges
   */
  RoleReader(NetworkSettings settings, boolean zooming) {
    this.settings = settings;
    this.zooming = zooming;
  }

  /**
   * The next camera's role.
   *
   * @param optics the camera's; empty for one that has its range alone
   * @param added whether an event adds it: its schedule is that of the last camera of the file
   * @throws org.hificamsim.core.InputException made by {@code fault} when a name is not known, or
   *     something that it needs is missing
   */
  Role read(AgentSpec agent, Optional<OpticsSpec> optics, boolean added, Fault fault) {
    if (!added) {
      schedule = schedule(agent, fault);
    }
    if (schedule == ScheduleKind.BANDIT_ZOOM) {
      requireRange(optics, fault);
    }
    return new Role(schedule, comm(agent, added, fault), agent.limit(), bandit(agent, fault));
  }

  /** A zoom list and a lens have reaches of their own, whatever range a bandit sets. */
  private void requireRange(Optional<OpticsSpec> optics, Fault fault) {
    if (zooming) {
      throw fault.in(
          "zoom", "none, or no --policy, where the schedule is BanditZoom, which sets ranges");
    }
    if (optics.filter(used -> used.law().hasAngles()).isPresent()) {
      throw fault.in(
          "optics", "none, or law=\"round\", where the schedule is BanditZoom, which sets ranges");
    }
  }

  private ScheduleKind schedule(AgentSpec agent, Fault fault) {
    return settings
        .schedule()
        .or(() -> find(ScheduleKind.class, agent.algorithm(), "ai_algorithm", fault))
        .orElse(ScheduleKind.ACTIVE);
  }

  private Comm comm(AgentSpec agent, boolean added, Fault fault) {
    if (!added && settings.comm().isPresent()) {
      return settings.comm().get();
    }
    return Comm.of(agent.comm().orElse(0), agent.customComm())
        .orElseThrow(
            () ->
                fault.in(
                    "customcom", Named.expected(CommunicationPolicy.class) + " where comm is 4"));
  }

  private Optional<BanditAlgorithm> bandit(AgentSpec agent, Fault fault) {
    Optional<BanditAlgorithm> bandit =
        settings.bandit().or(() -> find(BanditAlgorithm.class, agent.bandit(), "bandit", fault));
    if (schedule == ScheduleKind.BANDIT_ZOOM && bandit.isEmpty()) {
      throw fault.in(
          "bandit", Named.expected(BanditAlgorithm.class) + " where the schedule is BanditZoom");
    }
    return bandit;
  }

  private static <E extends Enum<E> & Named> Optional<E> find(
      Class<E> type, Optional<String> name, String attribute, Fault fault) {
    return name.map(
        text ->
            Named.find(type, text).orElseThrow(() -> fault.in(attribute, Named.expected(type))));
  }
}

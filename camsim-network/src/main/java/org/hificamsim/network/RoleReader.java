package org.hificamsim.network;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.Optional;
import org.hificamsim.core.scenario.spec.AgentCheck.Fault;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
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
  /**
   * What one camera is in the network.
   *
   * @param limit number of targets owned from which on it claims no other; 0 for no limit
   */
  record CameraRole(
      ScheduleKind schedule, Comm comm, int limit, Optional<BanditAlgorithm> bandit) {}

  private final NetworkSettings settings;
  private final boolean zooming;
  private ScheduleKind schedule = ScheduleKind.ACTIVE;
  private int ofFile;
  private Optional<Strategy> strategy = Optional.empty();

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
   * @param added whether an event adds it: its schedule is that of the last camera of the file
   * @throws org.hificamsim.core.InputException made by {@code fault} when a name is not known, or
   *     something that it needs is missing
   */
  CameraRole read(CameraSpec camera, boolean added, Fault fault) {
    if (!added) {
      strategy = settings.strategy(ofFile++);
      requireStrategy(fault);
      schedule = schedule(camera, fault);
    }
    if (schedule == ScheduleKind.BANDIT_ZOOM) {
      requireRange(camera.optics(), fault);
    }
    return new CameraRole(
        schedule, comm(camera, added, fault), camera.get(CameraSpec.LIMIT), bandit(camera, fault));
  }

  private void requireStrategy(Fault fault) {
    if (strategy.isEmpty() && !settings.strategies().isEmpty()) {
      throw fault.in(
          "ai_algorithm",
          "a strategy for each camera, or one for all; there are " + settings.strategies().size());
    }
  }

  /** A zoom list and a lens have reaches of their own, whatever range a bandit sets. */
  private void requireRange(Optional<OpticsSpec> optics, Fault fault) {
    if (zooming) {
      throw fault.in(
          "zoom",
          "none, or no "
              + setting("policy")
              + ", where the schedule is BanditZoom, which sets ranges");
    }
    if (optics.filter(used -> used.law().hasAngles()).isPresent()) {
      throw fault.in(
          "optics", "none, or law=\"round\", where the schedule is BanditZoom, which sets ranges");
    }
  }

  private ScheduleKind schedule(CameraSpec camera, Fault fault) {
    return strategy
        .map(Strategy::schedule)
        .or(settings::schedule)
        .or(
            () ->
                find(ScheduleKind.class, camera.find(CameraSpec.ALGORITHM), "ai_algorithm", fault))
        .orElse(ScheduleKind.ACTIVE);
  }

  private Comm comm(CameraSpec camera, boolean added, Fault fault) {
    if (!added && strategy.isPresent()) {
      return Comm.of(strategy.get().comm(), Optional.empty()).orElseThrow();
    }
    if (!added && settings.comm().isPresent()) {
      return settings.comm().get();
    }
    return Comm.of(camera.find(CameraSpec.COMM).orElse(0), camera.find(CameraSpec.CUSTOM_COMM))
        .orElseThrow(
            () ->
                fault.in(
                    "customcom", Named.expected(CommunicationPolicy.class) + " where comm is 4"));
  }

  private Optional<BanditAlgorithm> bandit(CameraSpec camera, Fault fault) {
    Optional<BanditAlgorithm> bandit =
        settings
            .bandit()
            .or(() -> find(BanditAlgorithm.class, camera.find(CameraSpec.BANDIT), "bandit", fault));
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

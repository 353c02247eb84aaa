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
 * Reads the role of each camera from the settings and its attributes: first the cameras of the
 * file, then those that events add (behaviour 3.2, 3.5). A camera without a schedule is active, and
 * one without a policy broadcasts; CamSim rejects both.
 */
final class RoleReader {
  /**
   * The role of one camera in the network.
   *
   * @param limit the number of owned targets at which it claims no more; 0 for no limit
   */
  record CameraRole(
      ScheduleKind schedule,
      CommunicationSetting communication,
      int limit,
      Optional<BanditAlgorithm> bandit) {}

  private final NetworkSettings settings;
  private final boolean hasZoomList;
  private ScheduleKind schedule = ScheduleKind.ACTIVE;
  private int camerasRead;
  private Optional<Strategy> strategy = Optional.empty();

  /**
   * @param hasZoomList whether cameras choose from a zoom list, so that no bandit can set ranges
   */
  RoleReader(NetworkSettings settings, boolean hasZoomList) {
    this.settings = settings;
    this.hasZoomList = hasZoomList;
  }

  /**
   * Reads the role of the next camera.
   *
   * @param added whether an event adds the camera: it gets the schedule of the last camera of the
   *     file
   * @throws org.hificamsim.core.InputException made by {@code fault} if a name is unknown, or a
   *     required attribute is missing
   */
  CameraRole read(CameraSpec camera, boolean added, Fault fault) {
    if (!added) {
      strategy = settings.strategy(camerasRead++);
      requireStrategy(fault);
      schedule = schedule(camera, fault);
    }
    if (schedule == ScheduleKind.BANDIT_ZOOM) {
      requireRange(camera.optics(), fault);
    }
    return new CameraRole(
        schedule,
        communication(camera, added, fault),
        camera.get(CameraSpec.LIMIT),
        bandit(camera, fault));
  }

  private void requireStrategy(Fault fault) {
    if (strategy.isEmpty() && !settings.strategies().isEmpty()) {
      throw fault.in(
          "ai_algorithm",
          "a strategy for each camera, or one for all; there are " + settings.strategies().size());
    }
  }

  /** Rejects a zoom list or a lens, whose reaches ignore the range that a bandit sets. */
  private void requireRange(Optional<OpticsSpec> optics, Fault fault) {
    if (hasZoomList) {
      throw fault.in(
          "zoom",
          "none, or no "
              + setting("policy")
              + ", where the schedule is BanditZoom, which sets ranges");
    }
    if (optics.isPresent() && optics.get().law().hasAngles()) {
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

  private CommunicationSetting communication(CameraSpec camera, boolean added, Fault fault) {
    if (!added && strategy.isPresent()) {
      return CommunicationSetting.of(strategy.get().policyNumber(), Optional.empty()).orElseThrow();
    }
    if (!added && settings.communication().isPresent()) {
      return settings.communication().get();
    }
    return CommunicationSetting.of(
            camera.find(CameraSpec.COMM).orElse(0), camera.find(CameraSpec.CUSTOM_COMM))
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

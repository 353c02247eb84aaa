package org.hificamsim.network;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.AgentSpec;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.VisionGraph;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.bandit.BanditKind;

/** Reads what the cameras of a scenario and the settings ask for (behaviour 3.2, 3.5, 3.6). */
public final class AgentSetups {
  private static final int FIX = 3;
  private static final int CUSTOM = 4;
  private static final String OLD_FIX = "epics.commpolicy.Fix";

  private final NetworkSettings settings;
  private final boolean graphIsStatic;
  private final List<AgentSetup> setups = new ArrayList<>();
  private ScheduleKind lastSchedule = ScheduleKind.ACTIVE;

  private AgentSetups(Scenario scenario, NetworkSettings settings) {
    this.settings = settings;
    this.graphIsStatic =
        settings.graph().isStatic(scenario.visionGraph().map(VisionGraph::isStatic).orElse(false));
  }

  /**
   * One setup per camera that there will ever be. A camera without a schedule is active, one
   * without a policy broadcasts; CamSim refuses both.
   *
   * @throws InputException when a name is not known, or something that it needs is missing
   */
  public static List<AgentSetup> of(World world, NetworkSettings settings) {
    AgentSetups setups = new AgentSetups(world.scenario(), settings);
    int fromFile = world.scenario().cameras().size();
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      setups.add(world.cameraSpec(camera), camera < fromFile);
    }
    return setups.setups;
  }

  private void add(CameraSpec camera, boolean fromFile) {
    AgentSpec agent = camera.agent();
    Optional<String> algorithm = settings.schedule().or(agent::algorithm);
    if (fromFile) {
      lastSchedule =
          algorithm.isEmpty()
              ? ScheduleKind.ACTIVE
              : find(ScheduleKind.class, camera, "ai_algorithm", algorithm.get());
    }
    boolean forAll = fromFile && settings.comm().isPresent();
    int comm = forAll ? settings.comm().getAsInt() : agent.comm().orElse(0);
    Optional<String> custom = forAll ? settings.customComm() : agent.customComm();
    PolicyKind policy = policy(camera, comm, custom);
    Optional<BanditKind> bandit =
        settings
            .bandit()
            .or(agent::bandit)
            .map(name -> find(BanditKind.class, camera, "bandit", name));
    if (lastSchedule == ScheduleKind.BANDIT_ZOOM && bandit.isEmpty()) {
      throw new InputException(
          "camera '%s' has the schedule %s without a bandit, expected one of %s"
              .formatted(camera.name(), lastSchedule.shortName(), Named.all(BanditKind.class)));
    }
    setups.add(
        new AgentSetup(
            lastSchedule,
            policy,
            comm,
            agent.limit(),
            bandit,
            frozen(comm, custom),
            fromFile && reverseLinks()));
  }

  private boolean frozen(int comm, Optional<String> custom) {
    boolean byPolicy = comm == FIX || (comm == CUSTOM && custom.map(OLD_FIX::equals).orElse(false));
    return byPolicy || (!settings.has(Quirk.Q5) && graphIsStatic);
  }

  private boolean reverseLinks() {
    if (!settings.has(Quirk.Q5) || setups.isEmpty()) {
      return graphIsStatic;
    }
    return setups.get(setups.size() - 1).comm() == FIX;
  }

  private static PolicyKind policy(CameraSpec camera, int comm, Optional<String> custom) {
    if (comm != CUSTOM) {
      return PolicyKind.values()[comm];
    }
    return find(
        PolicyKind.class,
        camera,
        "customcom",
        custom.orElseThrow(
            () ->
                new InputException(
                    "camera '%s' has comm 4 without the class of its policy, expected one of %s"
                        .formatted(camera.name(), Named.all(PolicyKind.class)))));
  }

  private static <E extends Enum<E> & Named> E find(
      Class<E> type, CameraSpec camera, String attribute, String text) {
    return Named.find(type, text)
        .orElseThrow(
            () ->
                new InputException(
                    "camera '%s': %s is '%s', expected one of %s or a class name of CamSim's"
                        .formatted(camera.name(), attribute, text, Named.all(type))));
  }
}

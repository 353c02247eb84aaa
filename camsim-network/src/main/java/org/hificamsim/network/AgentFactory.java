package org.hificamsim.network;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.AgentCheck.Fault;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.VisionGraph;
import org.hificamsim.core.world.World;
import org.hificamsim.network.NetworkSettings.GraphUse;
import org.hificamsim.network.RoleReader.CameraRole;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.AuctionSchedule;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.Links;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditSolver;
import org.hificamsim.network.bandit.CameraBandit;
import org.hificamsim.network.bandit.ScheduleSwitch;
import org.hificamsim.network.bandit.ZoomBandit;

/** Creates agents and their bandits from the scenario and the settings. */
final class AgentFactory {
  private final World world;
  private final NetworkSettings settings;
  private final Random random;
  private final int camerasInFile;
  private final List<CameraRole> roles = new ArrayList<>();
  private final InitialLinks initialLinks;
  private final boolean graphIsStatic;

  /**
   * Reads the roles of all cameras, including those that events will add.
   *
   * @param random the source of random numbers for bandits
   * @throws InputException if a name is unknown or a required attribute is missing
   */
  AgentFactory(World world, NetworkSettings settings, Random random) {
    this.world = world;
    this.settings = settings;
    this.random = random;
    camerasInFile = world.scenario().cameras().size();
    readRoles();
    Optional<VisionGraph> visionGraph = world.scenario().visionGraph();
    initialLinks =
        new InitialLinks(
            IntStream.range(0, roles.size()).mapToObj(world.cameras()::name).toList(),
            settings.graph() == GraphUse.IGNORED ? Optional.empty() : visionGraph);
    graphIsStatic = settings.graph().isStatic(visionGraph.map(VisionGraph::isStatic).orElse(false));
  }

  private void readRoles() {
    int strategies = settings.strategies().size();
    if (strategies > Math.max(1, camerasInFile)) {
      throw InputException.of(
          "there are %s strategies, expected one, or one for each of the %s cameras",
          strategies, camerasInFile);
    }
    RoleReader reader = new RoleReader(settings, world.scenario().inCoverageDialect());
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      String name = world.cameras().name(camera);
      Fault fault =
          (attribute, expected) ->
              InputException.of("camera '%s': %s: expected %s", name, attribute, expected);
      CameraSpec spec = world.cameraSpec(camera);
      roles.add(reader.read(spec, camera >= camerasInFile, fault));
    }
  }

  /** Creates the agent of a camera. */
  Agent agent(int camera, Agent.Shared shared) {
    CameraRole role = roles.get(camera);
    AuctionSchedule schedule =
        new AuctionSchedule(role.schedule(), world.targets(), settings.historicalParameters());
    Links links = alwaysAsksAll(role) ? Links.UNREAD : links(camera, role, schedule);
    return new Agent(camera, role.limit(), schedule, role.communication().policy(), links, shared);
  }

  /**
   * Returns whether a camera asks all its neighbours throughout the run, regardless of its links.
   */
  private static boolean alwaysAsksAll(CameraRole role) {
    return role.communication().policy() == CommunicationPolicy.BROADCAST
        && role.bandit().isEmpty();
  }

  private Links links(int camera, CameraRole role, AuctionSchedule schedule) {
    return role.schedule().isHistorical() && settings.historicalParameters().classification()
        ? Links.byCategory(
            initialLinks.names(), settings.historicalParameters().categories(), schedule::category)
        : links(camera, role);
  }

  private Links links(int camera, CameraRole role) {
    List<Integer> initial =
        camera < camerasInFile
            ? initialLinks.links(world.cameras().name(camera), hasReverseLinks(camera))
            : List.of();
    boolean frozenByGraph = graphIsStatic && !settings.has(Quirk.LINKS_FREEZE_BY_POLICY);
    return Links.plain(
        initialLinks.names(), initial, frozenByGraph || role.communication().freezesLinks());
  }

  /** Returns whether a camera is also linked to the cameras that list it as a neighbour. */
  private boolean hasReverseLinks(int camera) {
    boolean decidedByPolicy = camera > 0 && settings.has(Quirk.LINKS_FREEZE_BY_POLICY);
    return decidedByPolicy ? roles.get(camera - 1).communication().isFix() : graphIsStatic;
  }

  /** Creates the bandit of a camera; this draws the first rewards of its arms. */
  CameraBandit bandit(Agent agent) {
    CameraRole role = roles.get(agent.camera());
    if (role.bandit().isEmpty()) {
      return CameraBandit.NONE;
    }
    BanditSolver solver =
        new BanditSolver(role.bandit().get(), settings.banditParameters(), random);
    return role.schedule() == ScheduleKind.BANDIT_ZOOM
        ? new ZoomBandit(solver, agent, world)
        : new ScheduleSwitch(solver, agent);
  }
}

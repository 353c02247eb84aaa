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

/** Makes agents, and their bandits, as scenario and settings ask for them. */
final class AgentFactory {
  private final World world;
  private final NetworkSettings settings;
  private final Random random;
  private final int fromFile;
  private final List<CameraRole> roles = new ArrayList<>();
  private final InitialLinks graph;
  private final boolean graphIsStatic;

  /**
   * Reads the roles of all cameras that there will ever be.
   *
   * @param random draws for bandits
   * @throws InputException when a name is not known, or something that it needs is missing
   */
  AgentFactory(World world, NetworkSettings settings, Random random) {
    this.world = world;
    this.settings = settings;
    this.random = random;
    fromFile = world.scenario().cameras().size();
    readRoles();
    Optional<VisionGraph> inFile = world.scenario().visionGraph();
    graph =
        new InitialLinks(
            IntStream.range(0, roles.size()).mapToObj(world.cameras()::name).toList(),
            inFile.filter(used -> settings.graph() != GraphUse.IGNORED));
    graphIsStatic = settings.graph().isStatic(inFile.map(VisionGraph::isStatic).orElse(false));
  }

  private void readRoles() {
    int strategies = settings.strategies().size();
    if (strategies > Math.max(1, fromFile)) {
      throw InputException.of(
          "there are %s strategies, expected one, or one for each of the %s cameras",
          strategies, fromFile);
    }
    RoleReader reader = new RoleReader(settings, world.scenario().inCoverageDialect());
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      String name = world.cameras().name(camera);
      Fault fault =
          (attribute, expected) ->
              InputException.of("camera '%s': %s: expected %s", name, attribute, expected);
      CameraSpec spec = world.cameraSpec(camera);
      roles.add(reader.read(spec, camera >= fromFile, fault));
    }
  }

  /** Makes the agent of a camera. */
  Agent agent(int camera, Agent.Shared shared) {
    CameraRole role = roles.get(camera);
    AuctionSchedule schedule =
        new AuctionSchedule(role.schedule(), world.targets(), settings.historicalParameters());
    Links links = asksAlways(role) ? Links.UNREAD : links(camera, role, schedule);
    return new Agent(camera, role.limit(), schedule, role.comm().policy(), links, shared);
  }

  /** Whether a camera asks all neighbours as long as it runs, whatever its links. */
  private static boolean asksAlways(CameraRole role) {
    return role.comm().policy() == CommunicationPolicy.BROADCAST && role.bandit().isEmpty();
  }

  private Links links(int camera, CameraRole role, AuctionSchedule schedule) {
    return role.schedule().isHistorical() && settings.historicalParameters().classification()
        ? Links.byCategory(
            graph.names(), settings.historicalParameters().categories(), schedule::category)
        : links(camera, role);
  }

  private Links links(int camera, CameraRole role) {
    List<Integer> initial =
        camera < fromFile
            ? graph.of(world.cameras().name(camera), hasReverseLinks(camera))
            : List.of();
    boolean byGraph = graphIsStatic && !settings.has(Quirk.LINKS_FREEZE_BY_POLICY);
    return Links.plain(graph.names(), initial, byGraph || role.comm().freezesLinks());
  }

  /** Whether a camera is linked to those that list it, too. */
  private boolean hasReverseLinks(int camera) {
    boolean byPolicy = camera > 0 && settings.has(Quirk.LINKS_FREEZE_BY_POLICY);
    return byPolicy ? roles.get(camera - 1).comm().isFix() : graphIsStatic;
  }

  /** Makes the bandit of a camera, which draws its first numbers. */
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

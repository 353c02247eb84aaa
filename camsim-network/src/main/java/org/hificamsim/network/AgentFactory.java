package org.hificamsim.network;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.CategoryLinks;
import org.hificamsim.network.agent.InitialLinks;
import org.hificamsim.network.agent.Links;
import org.hificamsim.network.agent.NameLinks;
import org.hificamsim.network.auction.ActiveSchedule;
import org.hificamsim.network.auction.AuctionSchedule;
import org.hificamsim.network.auction.Broadcast;
import org.hificamsim.network.auction.CommunicationPolicy;
import org.hificamsim.network.auction.Fix;
import org.hificamsim.network.auction.HistoricalSchedule;
import org.hificamsim.network.auction.PassiveSchedule;
import org.hificamsim.network.auction.Smooth;
import org.hificamsim.network.auction.Stays;
import org.hificamsim.network.auction.Step;
import org.hificamsim.network.auction.Trader;
import org.hificamsim.network.bandit.BanditSolver;
import org.hificamsim.network.bandit.ScheduleSwitch;
import org.hificamsim.network.bandit.ZoomBandit;

/** Makes the members of a network as scenario and settings ask for them. */
final class AgentFactory {
  private final World world;
  private final NetworkSettings settings;
  private final NetworkStreams streams;
  private final List<AgentSetup> setups;
  private final InitialLinks graph;
  private final int fromFile;

  AgentFactory(World world, NetworkSettings settings, NetworkStreams streams) {
    this.world = world;
    this.settings = settings;
    this.streams = streams;
    setups = AgentSetups.of(world, settings);
    List<String> names =
        IntStream.range(0, world.cameras().count()).mapToObj(world.cameras()::name).toList();
    graph =
        new InitialLinks(
            names,
            settings.graph() == GraphUse.IGNORED
                ? Optional.empty()
                : world.scenario().visionGraph());
    fromFile = world.scenario().cameras().size();
  }

  /** The schedule that the camera starts with. */
  ScheduleKind schedule(int camera) {
    return setups.get(camera).schedule();
  }

  /** Makes a member; one with a bandit draws its numbers. */
  Member make(int camera, Agent.Surroundings around) {
    AgentSetup setup = setups.get(camera);
    PassiveSchedule passive = new PassiveSchedule(world.targets().count());
    Stays stays = new Stays(world.targets(), settings.historicalParameters());
    Agent agent = new Agent(camera, setup.limit(), links(camera, setup, stays), around);
    AuctionSchedule plain = setup.schedule().isActive() ? new ActiveSchedule() : passive;
    Trader trader =
        new Trader(
            agent,
            setup.schedule().isHistorical() ? new HistoricalSchedule(plain, stays) : plain,
            policy(setup.policy()),
            !settings.has(Quirk.Q14));
    if (setup.bandit().isEmpty()) {
      return new Member(agent, trader, null, null);
    }
    BanditSolver solver =
        setup.bandit().get().solver(settings.banditParameters(), streams.bandit());
    return setup.schedule() == ScheduleKind.BANDIT_ZOOM
        ? new Member(agent, trader, null, new ZoomBandit(solver, world))
        : new Member(agent, trader, switching(setup, solver, trader, passive), null);
  }

  private ScheduleSwitch switching(
      AgentSetup setup, BanditSolver solver, Trader trader, PassiveSchedule passive) {
    return new ScheduleSwitch(
        solver,
        trader,
        passive,
        inForce(setup),
        setup.schedule().isActive(),
        streams.communication());
  }

  /**
   * CamSim's number for a schedule and policy, -1 for what is no arm of its bandits (behaviour
   * 9.4).
   */
  private static int inForce(AgentSetup setup) {
    if (setup.schedule().isHistorical()) {
      return -1;
    }
    int first = setup.schedule().isActive() ? 0 : 3;
    return switch (setup.policy()) {
      case BROADCAST -> first;
      case STEP -> first + 1;
      case SMOOTH -> first + 2;
      case FIX -> -1;
    };
  }

  private Links links(int camera, AgentSetup setup, Stays stays) {
    if (setup.schedule().isHistorical() && settings.historicalParameters().classification()) {
      return new CategoryLinks(
          world.cameras().count(), settings.historicalParameters().categories(), stays::category);
    }
    return new NameLinks(
        graph.names(),
        camera < fromFile
            ? graph.of(world.cameras().name(camera), setup.reverseLinks())
            : List.of(),
        setup.frozen());
  }

  private CommunicationPolicy policy(PolicyKind kind) {
    return switch (kind) {
      case BROADCAST -> Broadcast.COUNTED;
      case SMOOTH -> new Smooth(streams.communication(), Broadcast.COUNTED);
      case STEP -> new Step(streams.communication(), Broadcast.COUNTED);
      case FIX -> new Fix(world.cameras().count());
    };
  }
}

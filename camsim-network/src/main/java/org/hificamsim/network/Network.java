package org.hificamsim.network;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.WorldObserver;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.MessageKind;
import org.hificamsim.network.agent.MessageQueue;
import org.hificamsim.network.agent.Receiver;
import org.hificamsim.network.agent.Searches;
import org.hificamsim.network.agent.Sightings;
import org.hificamsim.network.bandit.ScheduleSwitch;
import org.hificamsim.network.statistics.CameraFigures;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.network.statistics.StepTally;

/**
 * CamSim's network of cameras: who owns which target, and how targets are sold within each step
 * (sections 7 and 8). Equal arguments give equal runs.
 *
 * <p>In a step all cameras look, then all advertise, then all bid, then each settles its auctions.
 * Messages that a camera sends are delivered at the end of its turn.
 */
public final class Network implements Cooperation, WorldObserver {
  private final Cameras cameras;
  private final Sightings sightings;
  private final MessageQueue queue = new MessageQueue();
  private final Receiver receiver = this::receive;
  private final CameraErrors errors;
  private final CameraFigures figures;
  private final StepTally tally;
  private final AgentFactory factory;
  private final Agent.Surroundings around;
  private final Agent[] agents;
  private final Member[] members;
  private final ScheduleKind[] schedules;
  private int added;
  private int appeared;
  private long step;
  private StepFigures last;

  /**
   * The network at its start; it has itself told what events change in the world.
   *
   * @param world before its first step
   * @param detection gives the confidences for bids, utility and handovers
   * @throws org.hificamsim.core.InputException when a camera asks for what does not exist
   */
  public Network(World world, Detection detection, NetworkSettings settings, long seed) {
    NetworkStreams streams = NetworkStreams.of(seed);
    cameras = world.cameras();
    sightings = new Sightings(world, visibility(detection));
    errors = new CameraErrors(world, settings, streams.error());
    figures = new CameraFigures(world);
    tally = new StepTally(world, figures, sightings, queue);
    factory = new AgentFactory(world, settings, streams);
    agents = new Agent[cameras.count()];
    members = new Member[cameras.count()];
    schedules = new ScheduleKind[cameras.count()];
    BidderHashes hashes = new BidderHashes(cameras, sightings, agents, schedules);
    double[] features = new double[world.targets().count()];
    Arrays.setAll(features, target -> world.targetSpec(target).features());
    around =
        new Agent.Surroundings(
            cameras,
            features,
            sightings,
            queue,
            settings.has(Quirk.Q19) ? hashes::of : null,
            !settings.has(Quirk.Q14));
    world.scenario().cameras().forEach(camera -> cameraAdded(added));
    world.scenario().targets().forEach(target -> targetAppeared(appeared));
    world.observe(this);
  }

  /** Failures by chance. */
  @Override
  public void prepare() {
    errors.step(agents, added);
  }

  @Override
  public Visibility visibility(Detection detection) {
    return Visibility.asInCamSim(detection);
  }

  @Override
  public boolean observe(int[] detected, int[] coverage) {
    sightings.look(detected, coverage);
    return true;
  }

  /** Auctions and statistics. */
  @Override
  public void cooperate() {
    tally.begin();
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera) && members[camera].switching() != null) {
        choose(camera, members[camera].switching());
      }
    }
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera)) {
        members[camera].trader().advertise();
        queue.deliver(receiver);
      }
    }
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera)) {
        members[camera].trader().bid(sightings.visible(camera));
        queue.deliver(receiver);
      }
    }
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera)) {
        update(members[camera]);
      }
    }
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera)) {
        tally.valued(agents[camera]);
      }
    }
    last = tally.end(step++);
  }

  private void choose(int camera, ScheduleSwitch switching) {
    if (switching.select()) {
      tally.strategyChanged();
    }
    schedules[camera] = switching.isActive() ? ScheduleKind.ACTIVE : ScheduleKind.PASSIVE;
  }

  private void update(Member member) {
    Agent agent = member.agent();
    boolean switching = member.switching() != null;
    double earned = switching ? figures.utility(agent) + agent.received() - agent.paid() : 0;
    int sent = agent.sent();
    member.trader().settle();
    queue.deliver(receiver);
    figures.measure(agent);
    if (member.zooming() != null) {
      member.zooming().updated(agent, figures);
    }
    tally.attempted(sent);
    if (switching) {
      tally.banditEarned(earned);
      member.switching().feed(earned, sent);
    }
    tally.updated(agent);
  }

  private void receive(MessageKind kind, int from, int to, int target, double value) {
    agents[to].receive(kind, from, target, value);
  }

  /** The figures of the last step. */
  public StepFigures figures() {
    return last;
  }

  /** The targets that a camera owns, in the order in which it goes through them. */
  public List<Integer> owned(int camera) {
    if (agents[camera] == null) {
      return List.of();
    }
    return IntStream.range(0, agents[camera].owned().size())
        .mapToObj(agents[camera].owned()::get)
        .toList();
  }

  /** What each camera saw in the last step. */
  public Sightings sightings() {
    return sightings;
  }

  /** A new camera knows all cameras; those that are online get to know it (section 8.1). */
  @Override
  public void cameraAdded(int camera) {
    schedules[camera] = factory.schedule(camera);
    members[camera] = factory.make(camera, around);
    agents[camera] = members[camera].agent();
    for (int other = 0; other < camera; other++) {
      agents[camera].neighbours().add(other);
      if (cameras.online(other)) {
        agents[other].neighbours().add(camera);
      }
    }
    added = camera + 1;
  }

  @Override
  public void cameraFailed(int camera, int duration) {
    errors.failed(camera, duration);
  }

  /** Every camera that is online looks for a target that nobody owns yet (section 8.1). */
  @Override
  public void targetAppeared(int target) {
    appeared = target + 1;
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera)) {
        agents[camera].searches().put(target, Searches.NOBODY);
      }
    }
  }

  @Override
  public void targetVanished(int target) {
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera)) {
        sightings.forget(camera, target);
      }
    }
  }
}

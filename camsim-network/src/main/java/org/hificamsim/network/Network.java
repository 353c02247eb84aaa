package org.hificamsim.network;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.NetworkSums;
import org.hificamsim.core.engine.Observation;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.WorldObserver;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.BidderHashes;
import org.hificamsim.network.agent.MessageKind;
import org.hificamsim.network.agent.MessageQueue;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.agent.Searches;
import org.hificamsim.network.agent.Sightings;
import org.hificamsim.network.agent.TargetKeys;
import org.hificamsim.network.bandit.CameraBandit;
import org.hificamsim.network.statistics.CameraFigures;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.network.statistics.StepTally;

/**
 * CamSim's network of cameras: who owns which target, and how targets are sold within each step
 * (behaviour 7 and 8). Equal arguments give equal runs.
 *
 * <p>In a step all cameras look, then all advertise, then all bid, then each settles its auctions.
 * Messages that a camera sends are delivered at the end of its turn.
 */
public final class Network implements Cooperation, WorldObserver {
  private final Cameras cameras;
  private final Sightings sightings;
  private final Searches searches;
  private final MessageQueue queue;
  private final MessageQueue.Receiver receiver = this::receive;
  private final boolean camerasComeBack;
  private final CameraErrors errors;
  private final CameraFigures figures;
  private final StepTally tally;
  private final AgentFactory factory;
  private final Agent.Shared shared;
  private final Agent[] agents;
  private final CameraBandit[] bandits;

  /**
   * Whether a broadcast reaches all other online cameras and none of them counts it. Such a
   * broadcast is handled for all cameras at once.
   */
  private boolean broadcastsReachAll = true;

  private int addedCameras;
  private int appearedTargets;
  private long step;
  private StepFigures lastFigures;
  private StepFigures total = StepFigures.NONE;

  /**
   * Creates a network and registers it as an observer of the world. Its random streams have the
   * seed of the run, as those of the world do (behaviour 4.1).
   *
   * @param world the world before its first step
   * @param detection gives the confidences for bids, utility and handovers
   * @throws org.hificamsim.core.InputException if a camera names a schedule, policy or bandit that
   *     does not exist
   */
  public Network(World world, Detection detection, NetworkSettings settings, long seed) {
    cameras = world.cameras();
    queue = new MessageQueue(cameras.count(), world.targets().count());
    sightings = new Sightings(world, visibility(detection, seed));
    camerasComeBack = !settings.has(Quirk.FAILED_CAMERAS_STAY_OFFLINE);
    errors = new CameraErrors(world, settings, new Random(seed));
    figures = new CameraFigures(world);
    tally = new StepTally(world, figures, queue);
    factory = new AgentFactory(world, settings, new Random(seed));
    agents = new Agent[cameras.count()];
    bandits = new CameraBandit[cameras.count()];
    searches = new Searches(cameras, world.targets().count());
    BidderHashes hashes = new BidderHashes(cameras, sightings, agents);
    double[] features = new double[world.targets().count()];
    Arrays.setAll(features, target -> world.targetSpec(target).features());
    shared =
        new Agent.Shared(
            cameras,
            new TargetKeys(features),
            sightings,
            searches,
            queue,
            new Random(seed),
            settings.has(Quirk.TIES_BY_HASH_CODE) ? hashes::hash : null,
            !settings.has(Quirk.MISPRICED_SALES));
    world.scenario().cameras().forEach(camera -> cameraAdded(addedCameras));
    world.scenario().targets().forEach(target -> targetAppeared(appearedTargets));
    world.observe(this);
  }

  @Override
  public void begin(OracleView network) {
    queue.connect(network, network.channel());
  }

  /** Draws random failures. */
  @Override
  public void prepare() {
    broadcastsReachAll &= !errors.step(agents, addedCameras);
  }

  @Override
  public Visibility visibility(Detection detection, long seed) {
    return Visibility.asInCamSim(detection, seed);
  }

  @Override
  public void observe(Observation observation) {
    sightings.look(step, observation.detected(), observation.coverage(), observation.late());
  }

  /** Runs the auctions and adds up the figures of the step. */
  @Override
  public void cooperate() {
    tally.begin();
    queue.deliver(receiver);
    inTurn(this::choose);
    inTurn(camera -> agents[camera].advertise());
    inTurn(camera -> agents[camera].bid());
    inTurn(this::settleAndLearn);
    inTurn(camera -> tally.addUtility(agents[camera]));
    lastFigures = tally.end(step++);
    total = total.plus(lastFigures);
  }

  /**
   * Gives every camera that is online its turn. The compiler copies this loop into each of its
   * calls, so that no turn is a virtual call.
   */
  private void inTurn(IntConsumer turn) {
    for (int camera = 0; camera < addedCameras; camera++) {
      if (cameras.online(camera)) {
        turn.accept(camera);
        queue.deliver(receiver);
      }
    }
  }

  private int receive(MessageKind kind, int from, int to, int target, double value) {
    boolean toAll = to == MessageQueue.NEIGHBOURS;
    if (toAll && broadcastsReachAll) {
      queue.countReceivedByAll(kind, from);
      return searches.receiveAll(kind, from, target);
    }
    int receivers = 0;
    for (int camera = toAll ? 0 : to; camera < (toAll ? addedCameras : to + 1); camera++) {
      if (agents[from].reaches(camera)) {
        queue.countReceived(kind, camera);
        agents[camera].receive(kind, from, target, value);
        receivers++;
      }
    }
    return receivers;
  }

  private void choose(int camera) {
    if (bandits[camera].choose()) {
      tally.strategyChanged();
    }
  }

  /** Settles auctions, then learns and adds up figures (behaviour 7, step 8). */
  private void settleAndLearn(int camera) {
    Agent agent = agents[camera];
    double earned = bandits[camera].earned(figures);
    int attempts = agent.attempts();
    agent.settleAuctions();
    figures.measure(agent);
    bandits[camera].learn(earned, attempts, figures);
    tally.addCamera(agent, earned, attempts);
  }

  /** The number of bits of all messages sent so far. */
  public long bits() {
    return queue.bits();
  }

  /** The sums over all steps so far. */
  public StepFigures total() {
    return total;
  }

  @Override
  public NetworkSums sums() {
    return new NetworkSums(
        total.utility(),
        total.communication(),
        bits(),
        total.attempts(),
        total.handovers(),
        total.overlap(),
        total.confidence(),
        total.proportion());
  }

  /** The figures of the last step. */
  public StepFigures figures() {
    return lastFigures;
  }

  /** The targets that a camera owns, in the order in which it advertises them. */
  public List<Integer> owned(int camera) {
    return agents[camera] == null
        ? List.of()
        : IntStream.range(0, agents[camera].owned().count())
            .mapToObj(agents[camera].owned()::target)
            .toList();
  }

  /** The sightings of each camera in the last step. */
  public Sightings sightings() {
    return sightings;
  }

  /**
   * Makes all cameras neighbours of the new one, and it a neighbour of those online (behaviour
   * 8.1).
   */
  @Override
  public void cameraAdded(int camera) {
    agents[camera] = factory.agent(camera, shared);
    bandits[camera] = factory.bandit(agents[camera]);
    broadcastsReachAll &= agents[camera].schedule() != ScheduleKind.BANDIT_ZOOM;
    for (int other = 0; other < camera; other++) {
      broadcastsReachAll &= cameras.online(other);
      agents[camera].addNeighbour(other);
      if (cameras.online(other)) {
        agents[other].addNeighbour(camera);
      }
    }
    addedCameras = camera + 1;
  }

  @Override
  public void rangeChanged(int camera) {
    bandits[camera].rangeChanged();
  }

  @Override
  public void cameraFailed(int camera, int duration) {
    errors.switchedOff(camera, duration);
  }

  /**
   * Starts a search for the new target, which nobody owns, at every online camera (behaviour 8.1).
   */
  @Override
  public void targetAppeared(int target) {
    appearedTargets = target + 1;
    for (int camera = 0; camera < addedCameras; camera++) {
      if (cameras.online(camera)) {
        agents[camera].lookFor(target);
      }
    }
  }

  /**
   * Removes the target from what cameras see, except for cameras that are offline for ever
   * (behaviour 3.5 and 6.2, quirk Q6).
   */
  @Override
  public void targetVanished(int target) {
    for (int camera = 0; camera < addedCameras; camera++) {
      if (camerasComeBack || cameras.online(camera)) {
        sightings.forget(camera, target);
      }
    }
  }
}

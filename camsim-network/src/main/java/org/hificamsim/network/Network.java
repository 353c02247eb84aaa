package org.hificamsim.network;

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
  private final IntConsumer[] turns; // of each camera in a step
  private boolean alike = true; // whether all receive all that one sends, and count none of it
  private int added;
  private int appeared;
  private long step;
  private StepFigures last;
  private StepFigures total = StepFigures.NONE;

  /**
   * The network at its start; it listens to the events of the world from now on. Its random streams
   * are seeded with the run's seed, as the world's are (behaviour 4.1).
   *
   * @param world before its first step
   * @param detection gives the confidences for bids, utility and handovers
   * @throws org.hificamsim.core.InputException when a camera asks for what does not exist
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
    turns =
        new IntConsumer[] {
          this::choose,
          camera -> agents[camera].advertise(),
          camera -> agents[camera].bid(),
          this::settle,
          camera -> tally.count(agents[camera])
        };
    searches = new Searches(cameras, world.targets().count());
    BidderHashes hashes = new BidderHashes(cameras, sightings, agents);
    List<Agent.Features> features =
        IntStream.range(0, world.targets().count())
            .mapToObj(target -> new Agent.Features(world.targetSpec(target).features()))
            .toList();
    shared =
        new Agent.Shared(
            cameras,
            features,
            sightings,
            searches,
            queue,
            new Random(seed),
            settings.has(Quirk.TIES_BY_HASH_CODE) ? hashes::of : null,
            !settings.has(Quirk.MISPRICED_SALES));
    world.scenario().cameras().forEach(camera -> cameraAdded(added));
    world.scenario().targets().forEach(target -> targetAppeared(appeared));
    world.observe(this);
  }

  @Override
  public void begin(OracleView network) {
    queue.connect(network, network.channel());
  }

  /** Failures by chance. */
  @Override
  public void prepare() {
    alike &= !errors.step(agents, added);
  }

  @Override
  public Visibility visibility(Detection detection, long seed) {
    return Visibility.asInCamSim(detection, seed);
  }

  @Override
  public void observe(Observation observation) {
    sightings.look(step, observation.detected(), observation.coverage());
  }

  /** Auctions and statistics. */
  @Override
  public void cooperate() {
    tally.begin();
    queue.deliver(receiver);
    for (IntConsumer turn : turns) {
      for (int camera = 0; camera < added; camera++) {
        if (cameras.online(camera)) {
          turn.accept(camera);
          queue.deliver(receiver);
        }
      }
    }
    last = tally.end(step++);
    total = total.plus(last);
  }

  private int receive(MessageKind kind, int from, int to, int target, double value) {
    boolean toAll = to == MessageQueue.NEIGHBOURS;
    if (toAll && alike) {
      return searches.receiveAll(kind, from, target);
    }
    int receivers = 0;
    for (int camera = toAll ? 0 : to; camera < (toAll ? added : to + 1); camera++) {
      if (agents[from].reaches(camera)) {
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

  /** Settles, then learns and counts (behaviour 7, step 8). */
  private void settle(int camera) {
    Agent agent = agents[camera];
    double earned = bandits[camera].earned(figures);
    int sent = agent.sent();
    agent.settle();
    figures.measure(agent);
    bandits[camera].learn(earned, sent, figures);
    tally.settled(agent, earned, sent);
  }

  /** How many bits all messages had that were sent so far. */
  public long bits() {
    return queue.bits();
  }

  /** What the steps so far add up to. */
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
    return last;
  }

  /** The targets that a camera owns, in the order in which it goes through them. */
  public List<Integer> owned(int camera) {
    return agents[camera] == null ? List.of() : List.copyOf(agents[camera].owned());
  }

  /** What each camera saw in the last step. */
  public Sightings sightings() {
    return sightings;
  }

  /** A new camera knows all cameras; those that are online get to know it (behaviour 8.1). */
  @Override
  public void cameraAdded(int camera) {
    agents[camera] = factory.agent(camera, shared);
    bandits[camera] = factory.bandit(agents[camera]);
    alike &= agents[camera].schedule() != ScheduleKind.BANDIT_ZOOM;
    for (int other = 0; other < camera; other++) {
      alike &= cameras.online(other);
      agents[camera].meet(other);
      if (cameras.online(other)) {
        agents[other].meet(camera);
      }
    }
    added = camera + 1;
  }

  @Override
  public void cameraFailed(int camera, int duration) {
    errors.failed(camera, duration);
  }

  /** Every camera that is online looks for a target that nobody owns yet (behaviour 8.1). */
  @Override
  public void targetAppeared(int target) {
    appeared = target + 1;
    for (int camera = 0; camera < added; camera++) {
      if (cameras.online(camera)) {
        agents[camera].lookFor(target);
      }
    }
  }

  /**
   * Cameras lose sight of it; not those that are offline for ever, whose sets stay as they are
   * (behaviour 3.5 and 6.2, quirk Q6).
   */
  @Override
  public void targetVanished(int target) {
    for (int camera = 0; camera < added; camera++) {
      if (camerasComeBack || cameras.online(camera)) {
        sightings.forget(camera, target);
      }
    }
  }
}

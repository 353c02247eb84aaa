package org.hificamsim.core.engine;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.hificamsim.core.Texts;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.channel.RadioLog;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.ProcessingBudget;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.world.World;

/**
 * A run of one scenario under one detection model and one zoom policy, step by step.
 *
 * <p>A complete example, with the models and policies of {@code org.hificamsim.catalogue}:
 *
 * <pre>{@code
 * Catalogue catalogue = Catalogue.load();
 * Scenario scenario =
 *     ScenarioReader.read(Path.of("campus.xml"), catalogue.movements()::knows, System.err::println);
 * World world = new World(scenario, catalogue.movements(), 42);
 * Detection detection = Detection.of(catalogue.detection("hifi:orb-lin"));
 * ZoomPolicy policy = catalogue.policies().create("sarsa:gamma=0.9");
 * RunCoverage coverage = new RunCoverage();
 * Simulation simulation = new Simulation(world, detection, policy, 42, List.of(coverage));
 * simulation.run(1000);
 * System.out.println("performance " + coverage.performance());
 * }</pre>
 *
 * <p>Equal arguments give equal runs. One thread may use a simulation at a time.
 */
public final class Simulation {
  private final World world;
  private final StepOrder order;
  private final ZoomPolicy policy;
  private final Cooperation cooperation;
  private final StepListener[] listeners;
  private final Sight sight;
  private final LateDetections late;
  private final Observation observation;
  private final ObservedNetwork known;
  private final OracleNetwork oracle;
  private final NetworkView policyView;
  private final StepCoverage coverage;

  /** The meter of energy; null if nothing takes energy. */
  private final EnergyMeter energy;

  private final StepPhases phases = new StepPhases(this);
  private final int[] views;
  private final boolean byChance;
  private final boolean policyJumps;
  private final AimingZoomPolicy aimingPolicy;
  private boolean started;
  private long step;

  /**
   * Prepares a run without a {@link Cooperation}: cameras act by their policy alone.
   *
   * @param world the world before its first step
   * @param seed seeds the policy's generator and the luck of detections; the world has its own seed
   * @param listeners the listeners, called in this order at the end of each step
   */
  public Simulation(
      World world,
      Detection detection,
      ZoomPolicy policy,
      long seed,
      List<? extends StepListener> listeners) {
    this(world, detection, Behaviour.of(policy), seed, listeners);
  }

  /**
   * Prepares a run.
   *
   * @param world the world before its first step
   * @param seed seeds the policy's generator and the luck of detections; world and cooperation have
   *     seeds of their own
   * @param listeners the listeners, called in this order at the end of each step
   */
  public Simulation(
      World world,
      Detection detection,
      Behaviour behaviour,
      long seed,
      List<? extends StepListener> listeners) {
    this.world = world;
    this.order = world.scenario().order();
    this.policy = behaviour.policy();
    this.cooperation = behaviour.cooperation();
    this.listeners = listeners.toArray(StepListener[]::new);
    this.sight = new Sight(world, cooperation.visibility(detection, seed));
    this.late = lateDetections();
    this.observation = new Observation(world, sight, late);
    ObservedNetwork known = new ObservedNetwork(world, sight, observation);
    this.oracle = new OracleNetwork(world, sight, observation);
    ChannelModel channelModel = world.scenario().channel();
    if (!channelModel.isPerfect()) {
      Channel channel = new Channel(channelModel, known, seed);
      known.connect(channel);
      oracle.connect(channel);
    }
    this.known = known;
    this.energy =
        world.scenario().energy().isNone() ? null : new EnergyMeter(world, countMessages());
    this.policyView = policy instanceof OraclePolicy ? oracle : known;
    this.byChance = !detection.certain();
    this.policyJumps = policy.jumps();
    this.aimingPolicy = policy instanceof AimingZoomPolicy aiming ? aiming : null;
    this.coverage = new StepCoverage(world.scenario().objective());
    this.views = new int[world.cameras().count()];
    cooperation.begin(oracle);
    policy.begin(policyView, new SplittableRandom(seed));
  }

  /**
   * Returns the late detections; bounds have none, since they bound cameras that process all that
   * they see.
   */
  private LateDetections lateDetections() {
    ProcessingBudget budget = world.scenario().processing();
    return budget.isUnlimited() || policy instanceof OraclePolicy
        ? LateDetections.NONE
        : new LateDetections(world, budget);
  }

  /** Counts the bits that cameras send from now on; returns the same log at every call. */
  public RadioLog countMessages() {
    if (!known.radio().counts()) {
      RadioLog radio = new RadioLog(world.cameras().count());
      known.count(radio);
      oracle.count(radio);
    }
    return known.radio();
  }

  /**
   * Gives the next step a number, for a world that has been through the steps before it.
   *
   * @param nextStep the number of the next step, 0 or more
   * @return this simulation
   */
  public Simulation continuingAt(long nextStep) {
    step = nextStep;
    return this;
  }

  /**
   * Runs a number of steps, and then calls the listeners' {@code ended}, at every call. A run in
   * pieces calls {@link #step} instead, which never does.
   */
  public void run(long steps) {
    for (long i = 0; i < steps; i++) {
      step();
    }
    for (StepListener listener : listeners) {
      listener.ended(oracle);
    }
  }

  /**
   * Runs one step, each {@link StepPhase} in its order; the first one calls the listeners' {@code
   * started}.
   *
   * @throws IllegalStateException if {@link #phases} has left a step unfinished
   */
  public void step() {
    phases.requireWholeStep();
    fireEvents();
    moveBeforeLooking();
    decide();
    observe();
    cooperate();
    learn();
    measure();
    report();
    moveAfterLooking();
  }

  /** The phases of the steps, for callers that stop within a step. */
  public StepPhases phases() {
    return phases;
  }

  /** Fires the events, before {@link Sight#beginStep} takes in the cameras that they changed. */
  void fireEvents() {
    if (!started) {
      start();
    }
    world.fireEvents(step);
    sight.beginStep(step);
    late.beginStep();
  }

  private void start() {
    started = true;
    for (StepListener listener : listeners) {
      listener.started(oracle, policy);
    }
  }

  /** Locates the targets for the whole step, in both orders. */
  void moveBeforeLooking() {
    if (order == StepOrder.CAMSIM) {
      world.moveTargets();
    }
    cooperation.prepare();
    sight.locate();
  }

  /**
   * Lets all cameras decide from the same snapshot; then all set out for their views and move for
   * the time of one step, before they look.
   */
  void decide() {
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = oracle.view(camera);
    }
    policy.decide(policyView, views);
    for (int camera = 0; camera < views.length; camera++) {
      if (oracle.online(camera)) {
        applyView(camera, views[camera]);
      }
    }
    world.cameras().advance();
  }

  private void applyView(int camera, int view) {
    if (view < 0 || view >= oracle.views(camera)) {
      throw new IllegalStateException(
          Texts.format(
              "policy %s chose view %s for camera %s, expected 0 to %s",
              policy.name(), view, oracle.cameraName(camera), oracle.views(camera) - 1));
    }
    if (aimingPolicy != null && !Double.isNaN(aimingPolicy.pan(camera))) {
      world.cameras().aim(camera, view, aimingPolicy.pan(camera));
    } else if (policyJumps) {
      world.cameras().jumpTo(camera, view);
    } else {
      world.cameras().turnTo(camera, view);
    }
  }

  void observe() {
    cooperation.observe(observation);
    observation.addPhantoms();
  }

  void cooperate() {
    cooperation.cooperate();
  }

  void learn() {
    policy.learn(policyView);
  }

  /** Measures the step for the listeners, after the policy has learned. */
  void measure() {
    coverage.measure(oracle);
    coverage.measureScore(oracle);
    if (byChance) {
      coverage.expect(oracle);
    }
    if (energy != null) {
      energy.measure(oracle, coverage);
    }
  }

  void report() {
    for (StepListener listener : listeners) {
      listener.stepped(oracle, coverage);
    }
  }

  void moveAfterLooking() {
    if (order == StepOrder.COVERAGE) {
      world.moveTargets();
    }
    step++;
  }

  /** The network as the last phase left it, with what no camera knows. */
  public OracleView network() {
    return oracle;
  }

  /** The energy that the cameras have taken. */
  public EnergySums energy() {
    return energy == null ? EnergySums.NONE : energy.sums();
  }

  /** The energy that each camera has used, part by part; empty if nothing uses energy. */
  public Optional<EnergyMeter> energyMeter() {
    return Optional.ofNullable(energy);
  }

  /** The cooperation of the cameras. */
  public Cooperation cooperation() {
    return cooperation;
  }

  /** The coverage that the last step measured. */
  public StepCoverage coverage() {
    return coverage;
  }
}

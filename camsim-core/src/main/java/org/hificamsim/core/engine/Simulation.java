package org.hificamsim.core.engine;

import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.world.World;

/**
 * A run of one scenario under one detection model and one zoom policy, step by step.
 *
 * <p>A step is: events, (move), decide, apply zooms, observe, cooperate, reward, measure, record,
 * (move); targets move where the scenario's {@link StepOrder} says. Equal arguments give equal
 * runs.
 */
public final class Simulation {
  private final World world;
  private final StepOrder order;
  private final ZoomPolicy policy;
  private final Cooperation cooperation;
  private final StepListener[] listeners;
  private final ObservedNetwork network;
  private final StepCoverage coverage;
  private final int[] views;
  private final boolean byChance;
  private final boolean jumps;
  private final AimingZoomPolicy aiming;
  private boolean started;
  private long step;

  /** A run of cameras that work each for itself, in the caller's thread alone. */
  public Simulation(
      World world,
      Detection detection,
      ZoomPolicy policy,
      long seed,
      List<? extends StepListener> listeners) {
    this(world, detection, policy, Cooperation.NONE, seed, listeners, Workers.CALLER);
  }

  /**
   * @param cooperation what the cameras do together
   * @param seed seeds the policy's generator and the luck of detections; world and cooperation have
   *     been seeded on their own
   * @param listeners called in this order
   * @param workers who share the work of a step; results do not depend on their number
   */
  public Simulation(
      World world,
      Detection detection,
      ZoomPolicy policy,
      Cooperation cooperation,
      long seed,
      List<? extends StepListener> listeners,
      Workers workers) {
    this.world = world;
    this.cooperation = cooperation;
    this.order = world.scenario().order();
    this.policy = policy;
    this.listeners = listeners.toArray(StepListener[]::new);
    this.network = new ObservedNetwork(world, cooperation.visibility(detection, seed), workers);
    this.network.connect(world.scenario().channel(), seed);
    this.byChance = !detection.certain();
    this.jumps = policy.jumps();
    this.aiming = policy instanceof AimingZoomPolicy aims ? aims : null;
    this.coverage = new StepCoverage(world.scenario().objective());
    this.views = new int[world.cameras().count()];
    cooperation.begin(network);
    policy.begin(network, new SplittableRandom(seed));
  }

  /**
   * Counts on from a step, in a world that has been through those before.
   *
   * @param next the step that {@link #step} is to run next
   */
  public Simulation continuingAt(long next) {
    step = next;
    return this;
  }

  /** Runs this many steps, and then calls the listeners' {@code ended}. */
  public void run(long steps) {
    for (long i = 0; i < steps; i++) {
      step();
    }
    for (StepListener listener : listeners) {
      listener.ended(network);
    }
  }

  /** Runs one step; the first one calls the listeners' {@code started}. */
  public void step() {
    untilDecision();
    fromDecision();
  }

  /**
   * Runs the first half of a step: all that comes before the policy is asked. What cameras see then
   * is what they decide from. {@link #fromDecision} has to follow.
   */
  public void untilDecision() {
    if (!started) {
      start();
    }
    world.fireEvents(step);
    network.beginStep(step);
    if (order == StepOrder.CAMSIM) {
      world.moveTargets();
    }
    cooperation.prepare();
    network.locate();
  }

  /** Runs the second half of a step: decide, observe, measure. */
  public void fromDecision() {
    decide();
    fromObservation();
  }

  /** Runs the rest of a step when the cameras have decided: observe, measure. */
  public void fromObservation() {
    network.observe(cooperation);
    cooperation.cooperate();
    policy.learn(network);
    coverage.measure(network);
    coverage.measureScore(network);
    if (byChance) {
      coverage.expect(network);
    }
    for (StepListener listener : listeners) {
      listener.stepped(network, coverage);
    }
    if (order == StepOrder.COVERAGE) {
      world.moveTargets();
    }
    step++;
  }

  private void start() {
    started = true;
    for (StepListener listener : listeners) {
      listener.started(network, policy);
    }
  }

  /** The network as the last step left it. */
  public NetworkView network() {
    return network;
  }

  /** What the cameras do together. */
  public Cooperation cooperation() {
    return cooperation;
  }

  /** The coverage that the last step measured. */
  public StepCoverage coverage() {
    return coverage;
  }

  /**
   * All cameras decide from the same snapshot, then all zooms are applied: what {@link
   * #fromDecision} begins with. After it alone, {@link #fromObservation} has to follow.
   */
  public void decide() {
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = network.view(camera);
    }
    policy.decide(network, views);
    for (int camera = 0; camera < views.length; camera++) {
      if (network.online(camera)) {
        apply(camera, views[camera]);
      }
    }
    world.cameras().advance();
  }

  private void apply(int camera, int view) {
    if (view < 0 || view >= network.views(camera)) {
      throw new IllegalStateException(
          Texts.format(
              "policy %s chose view %s for camera %s, expected 0 to %s",
              policy.name(), view, network.cameraName(camera), network.views(camera) - 1));
    }
    if (aiming != null && !Double.isNaN(aiming.pan(camera))) {
      world.cameras().aim(camera, view, aiming.pan(camera));
    } else if (jumps) {
      world.cameras().jumpTo(camera, view);
    } else {
      world.cameras().turnTo(camera, view);
    }
  }
}

package org.hificamsim.worlds;

import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.observation.CameraObserver;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.engine.StepPhase;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.world.World;

/**
 * One simulation that waits for actions: between two calls its step is half done, and cameras have
 * seen what they decide from.
 *
 * <p>The first episode after a reset has the seed that it was given, so that it is the run of that
 * seed; those after it have seeds drawn from it.
 */
final class OneWorld implements StepListener {
  /** How many numbers {@link #measures} has. */
  static final int MEASURES = 3;

  private static final int STATE_OF_TARGET = 4;

  private final WorldSettings settings;
  private World world;
  private final PlayedPolicy policy;
  private final ZoomPolicy driver;
  private final Reward reward;
  private final float[] rewards;
  private final float[] measures = new float[MEASURES];
  private final int[] actions;
  private StepListener watcher = (network, coverage) -> {};
  private Simulation simulation;
  private CameraObserver observer;
  private CameraObserver like; // the first episode's observer of the first world
  private Masks masks;
  private long seed;
  private long episode;
  private int step;

  /**
   * @param first the first of the worlds; null for itself
   */
  OneWorld(WorldSettings settings, long seed, OneWorld first) {
    this.settings = settings;
    like = first == null ? null : first.like;
    world = first == null || isDrawn() ? settings.world(seed) : first.world.another(seed);
    policy = new PlayedPolicy(settings.actions(), settings.expert());
    driver =
        settings.expert() == null ? policy : OraclePolicy.wrapping(settings.expert().get(), policy);
    reward = settings.reward().get();
    int cameras = world.cameras().count();
    rewards = new float[cameras];
    actions = new int[cameras * settings.actions().numbers()];
    reset(seed);
    like = first == null && !isDrawn() ? observer : like;
    masks = new Masks(network(), settings.actions());
  }

  /** Begins the first episode of a seed. */
  void reset(long newSeed) {
    seed = newSeed;
    episode = 0;
    begin();
  }

  /** Begins the next episode. */
  void next() {
    episode++;
    begin();
  }

  private void begin() {
    long ofEpisode = episodeSeed(seed, episode);
    if (isDrawn()) {
      world = settings.world(ofEpisode);
    } else {
      world.restart(ofEpisode);
    }
    reward.begin();
    simulation =
        new Simulation(world, settings.detection(), driver, ofEpisode, List.of(this, watcher));
    step = 0;
    simulation.phases().runUntil(StepPhase.DECIDE);
    observer = observer();
  }

  private boolean isDrawn() {
    return settings.layouts() != null;
  }

  /**
   * Without layouts, all episodes of all worlds have the same cameras, as long as nothing happens
   * to them.
   */
  private CameraObserver observer() {
    return like == null
        ? new CameraObserver(network(), settings.layout())
        : new CameraObserver(network(), settings.layout(), like);
  }

  /** The seed of an episode: the first one has the world's. */
  static long episodeSeed(long seed, long episode) {
    return episode == 0
        ? seed
        : new SplittableRandom(seed + episode * 0x9E3779B97F4A7C15L).nextLong();
  }

  /** The seed of the episode. */
  long seed() {
    return episodeSeed(seed, episode);
  }

  /** Does what {@link #actions} say, up to the next decision. */
  void step() {
    policy.play(actions);
    simulation.phases().finishStep();
    simulation.phases().runUntil(StepPhase.DECIDE);
    step++;
  }

  /**
   * What the cameras know before the next decision; to be asked once for each.
   *
   * @param pairs is used meanwhile
   * @param out one camera after the other
   */
  void observe(SeenPairs pairs, float[] out) {
    observer.observe(network(), pairs, out);
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    reward.pay(network, coverage, rewards);
    measures[0] = (float) Rewards.covered(coverage);
    measures[1] = coverage.kMin();
    measures[2] = (float) coverage.score();
  }

  /** Adds a listener to the episodes that begin from now on. */
  void watch(StepListener newWatcher) {
    watcher = newWatcher;
  }

  /** Whether the episode is over. */
  boolean over() {
    return step == settings.steps();
  }

  OracleView network() {
    return simulation.network();
  }

  /** Filled in by the caller before a {@link #step}. */
  int[] actions() {
    return actions;
  }

  /** What the expert advised at the last decision. */
  int[] advice() {
    return policy.advice();
  }

  float[] rewards() {
    return rewards;
  }

  /** Of the last step: share of targets covered, k_min, and the score by the objective. */
  float[] measures() {
    return measures;
  }

  byte[] masks() {
    return masks.of(network());
  }

  /** How many numbers a state has. */
  static int stateSize(NetworkView network, ObservationLayout layout) {
    return 1 + network.cameras() * layout.ownSize() + network.targets() * STATE_OF_TARGET;
  }

  /**
   * Writes the state as numbers in [-1, 1], for critics that may know everything: how much of the
   * episode is over; of each camera what it knows of itself; of each target whether it is there,
   * its x and y as parts of the field, and the share of the cameras that detected it in the last
   * step.
   *
   * @param observations as they were observed
   */
  void writeState(float[] observations, float[] out) {
    OracleView network = simulation.network();
    Field field = settings.scenario().field();
    out[0] = (float) ((double) step / settings.steps());
    int at = 1;
    for (int camera = 0; camera < network.cameras(); camera++) {
      int from = camera * settings.layout().size();
      System.arraycopy(observations, from, out, at, settings.layout().ownSize());
      at += settings.layout().ownSize();
    }
    for (int target = 0; target < network.targets(); target++) {
      boolean present = network.present(target);
      out[at] = present ? 1 : 0;
      out[at + 1] = present ? part(network.targetX(target), field.minX(), field.width()) : 0;
      out[at + 2] = present ? part(network.targetY(target), field.minY(), field.height()) : 0;
      out[at + 3] = present ? (float) network.coverage(target) / network.cameras() : 0;
      at += STATE_OF_TARGET;
    }
  }

  private static float part(double at, double least, double length) {
    double part = (at - least) / length;
    return part >= 0 && part <= 1 ? (float) part : part > 1 ? 1 : 0;
  }
}

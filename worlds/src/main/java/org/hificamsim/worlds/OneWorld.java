package org.hificamsim.worlds;

import java.nio.ByteBuffer;
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
 * One simulation that waits for actions. Between two calls it stops before the decision of a step,
 * so that cameras have their observations.
 *
 * <p>The first episode after a reset has the given seed, so it equals the run with that seed. The
 * seeds of later episodes are derived from it.
 */
final class OneWorld implements StepListener {
  /** The length of {@link #measures}. */
  static final int MEASURES = 3;

  private static final int NUMBERS_PER_TARGET = 4;

  private final WorldSettings settings;
  private World world;
  private final PlayedPolicy policy;
  private final ZoomPolicy driver;
  private final Reward reward;
  private final float[] rewards;
  private final float[] measures = new float[MEASURES];
  private final int[] actions;
  private StepListener listener = (network, coverage) -> {};

  /** The actions of the current episode; null if they are not kept. */
  private EpisodeHistory history;

  /** The contributions of cameras; null if they are not measured. */
  private CameraDetails details;

  private Simulation simulation;
  private CameraObserver observer;

  /** The observer of the first episode of the first world, whose tables later observers share. */
  private CameraObserver sharedObserver;

  private Masks masks;
  private final long firstSeed;
  private long seed;
  private long episode;
  private int step;

  /**
   * Creates a world; all except the first begin their first episode at their first reset.
   *
   * @param first the first world; null if this is the first
   */
  OneWorld(WorldSettings settings, long seed, OneWorld first) {
    this.settings = settings;
    sharedObserver = first == null ? null : first.sharedObserver;
    if (first == null) {
      world = settings.world(seed);
    } else if (!isDrawn()) {
      world = first.world.another(seed);
    }
    policy = new PlayedPolicy(settings.actions(), settings.expert());
    driver =
        settings.expert() == null ? policy : OraclePolicy.wrapping(settings.expert().get(), policy);
    reward = settings.reward().get();
    int cameras = first == null ? world.cameras().count() : first.rewards.length;
    rewards = new float[cameras];
    actions = new int[cameras * settings.actions().numbers()];
    firstSeed = seed;
    if (first == null) {
      reset(seed);
      sharedObserver = isDrawn() ? null : observer;
    }
  }

  /** Begins the first episode with a seed. */
  void reset(long newSeed) {
    seed = newSeed;
    episode = 0;
    begin();
  }

  /** Begins the next episode. */
  void beginNext() {
    episode++;
    begin();
  }

  private void begin() {
    long episodeSeed = episodeSeed(seed, episode);
    if (isDrawn()) {
      world = settings.world(episodeSeed);
    } else if (simulation != null || episodeSeed != firstSeed) {
      world.restart(episodeSeed);
    }
    reward.begin();
    if (history != null) {
      history.clear();
    }
    simulation =
        new Simulation(world, settings.detection(), driver, episodeSeed, List.of(this, listener));
    step = 0;
    if (details != null) {
      details.begin(simulation.countMessages());
    }
    simulation.phases().runUntil(StepPhase.DECIDE);
    observer = observer();
    policy.observeWith(observer);
    if (masks == null) {
      masks = new Masks(network(), settings.actions());
    }
  }

  /** Whether each episode has a scenario that is drawn for its seed. */
  private boolean isDrawn() {
    return settings.layouts() != null;
  }

  /**
   * Creates an observer. Without layouts all episodes of all worlds start with the same cameras, so
   * they share tables.
   */
  private CameraObserver observer() {
    return sharedObserver == null
        ? new CameraObserver(network(), settings.layout())
        : new CameraObserver(network(), settings.layout(), sharedObserver);
  }

  /** Returns the seed of an episode: the seed of the world for the first, else derived from it. */
  static long episodeSeed(long seed, long episode) {
    return episode == 0
        ? seed
        : new SplittableRandom(seed + episode * 0x9E3779B97F4A7C15L).nextLong();
  }

  /** The seed of the current episode. */
  long seed() {
    return episodeSeed(seed, episode);
  }

  /** Carries out {@link #actions}, and runs up to the next decision. */
  void step() {
    if (history != null) {
      history.add(actions);
    }
    policy.play(actions);
    simulation.phases().finishStep();
    simulation.phases().runUntil(StepPhase.DECIDE);
    step++;
  }

  /**
   * Writes the observations of the cameras; to be called once before each decision.
   *
   * @param pairs a scratch object
   * @param out receives the observations, one camera after the other
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
    if (details != null) {
      details.measure(network);
    }
  }

  /** Adds a listener to the episodes that begin from now on. */
  void listen(StepListener newListener) {
    listener = newListener;
  }

  /** Keeps the actions of episodes from now on; to be called at the start of an episode. */
  void keepHistory() {
    history = new EpisodeHistory();
  }

  boolean keepsHistory() {
    return history != null;
  }

  /** Measures what each camera contributes, in episodes that begin from now on. */
  void measureDetails() {
    details = new CameraDetails(rewards.length);
  }

  /** The contributions of cameras in the last step; null if they are not measured. */
  CameraDetails details() {
    return details;
  }

  /** The number of bytes that {@link #save} writes. */
  int savedBytes() {
    return 2 * Long.BYTES + history.bytes();
  }

  /** Writes the seeds and the history of the episode. */
  void save(ByteBuffer out) {
    out.putLong(seed).putLong(episode);
    history.writeTo(out);
  }

  /**
   * Begins a saved episode.
   *
   * @return the actions that lead from its start to the saved step, one step after the other
   */
  short[] beginSaved(ByteBuffer saved) {
    seed = saved.getLong();
    episode = saved.getLong();
    begin();
    return EpisodeHistory.read(saved);
  }

  /** Returns whether the episode is over. */
  boolean isOver() {
    return step == settings.steps();
  }

  OracleView network() {
    return simulation.network();
  }

  /** The actions of the next {@link #step}, to be filled in by the caller. */
  int[] actions() {
    return actions;
  }

  /** The advice of the expert at the last decision. */
  int[] advice() {
    return policy.advice();
  }

  float[] rewards() {
    return rewards;
  }

  /** The share of targets covered, k_min, and the score of the last step. */
  float[] measures() {
    return measures;
  }

  byte[] masks() {
    return masks.compute(network());
  }

  /** The length of a state. */
  static int stateSize(NetworkView network, ObservationLayout layout) {
    return 1 + network.cameras() * layout.ownSize() + network.targets() * NUMBERS_PER_TARGET;
  }

  /**
   * Writes the state as numbers in [-1, 1], for critics that may know everything: the elapsed share
   * of the episode; for each camera, what it observes of itself; for each target, whether it is
   * present, its x and y as fractions of the field, and the share of the cameras that detected it
   * in the last step.
   *
   * @param observations the observations written by {@link #observe}
   */
  void writeState(float[] observations, float[] out) {
    OracleView network = simulation.network();
    Field field = settings.scenario().field();
    out[0] = (float) ((double) step / settings.steps());
    int offset = 1;
    for (int camera = 0; camera < network.cameras(); camera++) {
      int from = camera * settings.layout().size();
      System.arraycopy(observations, from, out, offset, settings.layout().ownSize());
      offset += settings.layout().ownSize();
    }
    for (int target = 0; target < network.targets(); target++) {
      boolean present = network.present(target);
      out[offset] = present ? 1 : 0;
      out[offset + 1] =
          present ? fraction(network.targetX(target), field.minX(), field.width()) : 0;
      out[offset + 2] =
          present ? fraction(network.targetY(target), field.minY(), field.height()) : 0;
      out[offset + 3] = present ? (float) network.coverage(target) / network.cameras() : 0;
      offset += NUMBERS_PER_TARGET;
    }
  }

  private static float fraction(double value, double least, double length) {
    double fraction = (value - least) / length;
    return fraction >= 0 && fraction <= 1 ? (float) fraction : fraction > 1 ? 1 : 0;
  }
}

package org.hificamsim.worlds;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import org.hificamsim.core.InputException;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.worlds.WorldSettings.AutoReset;

/**
 * Simulations side by side, stepped by one call and shared out among threads. Actions are read from
 * a block of memory, and what follows from them is written there; see {@link Block}.
 *
 * <p>World i begins with the seed of the reset plus i. What comes out depends on seeds and actions
 * alone, not on how many worlds or threads there are. After an error of a policy or model the
 * worlds have to be reset. One thread may call at a time.
 */
public final class Worlds implements AutoCloseable {
  private final WorldSettings settings;
  private final OneWorld[] worlds;
  private final Workers workers;
  private final Block block;
  private final ByteBuffer memory;
  private final IntBuffer actions;
  private final FloatBuffer observations;
  private final FloatBuffer finals;
  private final FloatBuffer rewards;
  private final ByteBuffer masks;
  private final ByteBuffer ends;
  private final FloatBuffer measures;
  private final FloatBuffer states;
  private final IntBuffer advice;
  private final int[] choices;
  private final int[] maskedRevision;
  private final boolean maskOften;
  private final float[][] state; // of each worker
  private final float[][] observed; // the same
  private final SeenPairs[] pairs; // the same
  private final Workers.Share stepping = shared(this::step);
  private final Workers.Share resetting = shared(this::reset);
  private final Workers.Share telling = shared(this::writeState);
  private long seed;
  private boolean restarted;

  /** What is done to each world. */
  @FunctionalInterface
  private interface Work {
    /** Does it to the i-th world in one of the workers. */
    void on(int i, int worker);
  }

  /**
   * Each worker's share of some work: the worlds of its own. Made once, so that no step allocates.
   */
  private Workers.Share shared(Work work) {
    return worker -> {
      int end = workers.first(worker + 1, worlds.length);
      for (int i = workers.first(worker, worlds.length); i < end; i++) {
        work.on(i, worker);
      }
    };
  }

  private static void check(String what, int number) {
    if (number < 1) {
      throw new InputException(number + " " + what + ", expected 1 or more");
    }
  }

  /**
   * Worlds at the beginning of their first episode.
   *
   * @param count 1 or more
   * @param threads that share the worlds, 1 or more
   * @param source makes the shared block of this many bytes
   */
  public Worlds(
      WorldSettings settings, int count, int threads, long seed, IntFunction<ByteBuffer> source) {
    check("worlds", count);
    check("threads", threads);
    this.settings = settings;
    this.seed = seed;
    OneWorld first = new OneWorld(settings, seed, null);
    NetworkView network = first.network();
    block = Block.of(count, first, settings);
    memory = source.apply(block.bytes()); // before the worlds: there may be too many
    worlds = new OneWorld[count];
    Arrays.setAll(worlds, i -> i == 0 ? first : new OneWorld(settings, seed + i, first));
    actions = block.part(memory, "actions").asIntBuffer();
    observations = block.part(memory, "observations").asFloatBuffer();
    finals = block.part(memory, "finals").asFloatBuffer();
    rewards = block.part(memory, "rewards").asFloatBuffer();
    masks = block.part(memory, "masks");
    ends = block.part(memory, "ends");
    measures = block.part(memory, "measures").asFloatBuffer();
    advice = block.part(memory, "advice").asIntBuffer();
    states = block.part(memory, "states").asFloatBuffer();
    choices = settings.actions().choices(network);
    maskedRevision = new int[count];
    maskOften = settings.actions() == ActionKind.STEPS || takesTime();
    workers = Workers.of(Math.min(threads, count));
    observed = new float[workers.count()][network.cameras() * settings.layout().size()];
    pairs = new SeenPairs[workers.count()];
    Arrays.setAll(pairs, worker -> new SeenPairs());
    state = new float[workers.count()][OneWorld.stateSize(network, settings.layout())];
    reset(seed, true);
  }

  private boolean takesTime() {
    return settings
        .scenario()
        .everyCamera()
        .anyMatch(camera -> camera.optics().filter(optics -> optics.takesTime()).isPresent());
  }

  /** The memory that all sections are in. */
  public ByteBuffer memory() {
    return memory;
  }

  /** How the memory is divided. */
  public Block block() {
    return block;
  }

  /** Of how many each number of an action is one, counted from 0. */
  public List<Integer> choices() {
    return Arrays.stream(choices).boxed().toList();
  }

  /** A world's network as it is now. */
  public OracleView network(int world) {
    return worlds[world].network();
  }

  /** Reports the steps of a world to one listener, from its next episode on. */
  public void watch(int world, StepListener listener) {
    worlds[world].watch(listener);
  }

  /** The seed of the episode that a world is in. */
  public long seed(int world) {
    return worlds[world].seed();
  }

  /**
   * Begins an episode in every world, and writes observations and masks.
   *
   * @param newSeed of the first world
   * @param fresh whether the seed counts; otherwise each world goes on to its next episode
   */
  public void reset(long newSeed, boolean fresh) {
    seed = newSeed;
    restarted = fresh;
    workers.run(resetting);
  }

  /** Begins an episode in one world, of this seed or its next one; others stay as they are. */
  public void reset(int world, long itsSeed, boolean fresh) {
    seed = itsSeed - world;
    restarted = fresh;
    reset(world, 0);
  }

  private void reset(int i, int worker) {
    if (restarted) {
      worlds[i].reset(seed + i);
    } else {
      worlds[i].next();
    }
    observe(i, observations, worker);
    writeMasks(i);
  }

  /**
   * Plays the actions in every world, and writes what follows.
   *
   * @throws InputException when an action is none, or an episode is over; nothing is stepped then
   */
  public void step() {
    checkActions();
    workers.run(stepping);
  }

  private void step(int i, int worker) {
    OneWorld world = worlds[i];
    if (world.over()) { // with NEXT_STEP
      renew(i, worker);
      return;
    }
    actions.get(i * world.actions().length, world.actions());
    world.step();
    rewards.put(i * world.rewards().length, world.rewards());
    measures.put(i * OneWorld.MEASURES, world.measures());
    advice.put(i * world.advice().length, world.advice());
    ends.put(i, (byte) (world.over() ? 1 : 0));
    if (world.over() && settings.autoReset() == AutoReset.SAME_STEP) {
      observe(i, finals, worker);
      world.next();
    }
    observe(i, observations, worker);
    if (maskOften || world.network().revision() != maskedRevision[i]) {
      writeMasks(i);
    }
  }

  private void renew(int i, int worker) {
    float[] none = worlds[i].rewards();
    Arrays.fill(none, 0);
    rewards.put(i * none.length, none);
    ends.put(i, (byte) 0);
    worlds[i].next();
    observe(i, observations, worker);
    writeMasks(i);
  }

  /** By way of arrays that all worlds of a worker share: they stay near. */
  private void observe(int i, FloatBuffer into, int worker) {
    float[] out = observed[worker];
    worlds[i].observe(pairs[worker], out);
    into.put(i * out.length, out);
  }

  private void writeMasks(int i) {
    byte[] of = worlds[i].masks();
    masks.put(i * of.length, of);
    maskedRevision[i] = worlds[i].network().revision();
  }

  private void checkActions() {
    int each = worlds[0].actions().length;
    for (int i = 0; i < worlds.length; i++) {
      if (settings.autoReset() == AutoReset.DISABLED && worlds[i].over()) {
        throw InputException.of(
            "the episode of %s steps is over, expected a reset", settings.steps());
      }
      for (int at = 0; at < each; at += choices.length) {
        checkActions(i, i * each, at);
      }
    }
  }

  private void checkActions(int world, int first, int at) {
    for (int number = 0; number < choices.length; number++) {
      int action = actions.get(first + at + number);
      int least = settings.expert() == null ? 0 : PlayedPolicy.AS_ADVISED;
      if (action < least || action >= choices[number]) {
        refuse(world, at + number, action);
      }
    }
  }

  private void refuse(int world, int at, int action) {
    throw InputException.of(
        "action %s of camera %s in world %s, expected 0 to %s",
        action,
        worlds[world].network().cameraName(at / choices.length),
        world,
        (choices[at % choices.length] - 1));
  }

  /** Writes the state of every world. */
  public void state() {
    workers.run(telling);
  }

  private void writeState(int i, int worker) {
    observations.get(i * observed[worker].length, observed[worker]);
    worlds[i].writeState(observed[worker], state[worker]);
    states.put(i * state[worker].length, state[worker]);
  }

  /** Ends the threads. */
  @Override
  public void close() {
    workers.close();
  }
}

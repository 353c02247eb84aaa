package org.hificamsim.worlds;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.BufferUnderflowException;
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
 * Several simulations, stepped by one call and distributed among threads. Actions are read from a
 * block of memory, to which the results are written; see {@link Block}.
 *
 * <p>World i begins with the seed of the reset plus i. Results depend only on seeds and actions,
 * not on the number of worlds or threads. After an exception of a policy or model the worlds have
 * to be reset. Not thread-safe.
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
  private final ByteBuffer finalMasks;
  private final ByteBuffer ends;
  private final FloatBuffer measures;
  private final FloatBuffer states;
  private final IntBuffer advice;
  private final FloatBuffer details;
  private final int[] choices;
  private final int[] maskedRevision;

  /** Whether masks may change in any step, and not only when cameras change. */
  private final boolean masksChangeOften;

  private final float[][] stateByWorker;
  private final float[][] observationsByWorker;
  private final SeenPairs[] pairsByWorker;
  private final Workers.Share stepping = divide(this::step);
  private final Workers.Share resetting = divide(this::reset);
  private final Workers.Share writingStates = divide(this::writeState);
  private long seed;
  private boolean restarted;

  /** An action on one world. */
  @FunctionalInterface
  private interface Work {
    /** Acts on the i-th world, in a worker. */
    void runOn(int i, int worker);
  }

  /**
   * Divides work on all worlds among the workers. The result is created once, so that steps do not
   * allocate.
   */
  private Workers.Share divide(Work work) {
    return worker -> {
      int end = workers.first(worker + 1, worlds.length);
      for (int i = workers.first(worker, worlds.length); i < end; i++) {
        work.runOn(i, worker);
      }
    };
  }

  private static void requirePositive(String noun, int number) {
    if (number < 1) {
      throw new InputException(number + " " + noun + ", expected 1 or more");
    }
  }

  /**
   * Creates worlds at the start of their first episode.
   *
   * @param count the number of worlds, 1 or more
   * @param threads the number of threads that share the worlds, 1 or more
   * @param seed the seed of the first world
   * @param allocator allocates the shared block of a number of bytes
   */
  public Worlds(
      WorldSettings settings,
      int count,
      int threads,
      long seed,
      IntFunction<ByteBuffer> allocator) {
    requirePositive("worlds", count);
    requirePositive("threads", threads);
    this.settings = settings;
    this.seed = seed;
    OneWorld first = new OneWorld(settings, seed, null);
    NetworkView network = first.network();
    block = Block.of(count, first, settings);
    // allocated before the worlds, since it fails if there are too many
    memory = allocator.apply(block.bytes());
    worlds = new OneWorld[count];
    workers = Workers.of(Math.min(threads, count));
    workers.run(
        divide(
            (i, worker) -> worlds[i] = i == 0 ? first : new OneWorld(settings, seed + i, first)));
    actions = block.slice(memory, "actions").asIntBuffer();
    observations = block.slice(memory, "observations").asFloatBuffer();
    finals = block.slice(memory, "finals").asFloatBuffer();
    rewards = block.slice(memory, "rewards").asFloatBuffer();
    masks = block.slice(memory, "masks");
    finalMasks = block.slice(memory, "final_masks");
    ends = block.slice(memory, "ends");
    measures = block.slice(memory, "measures").asFloatBuffer();
    advice = block.slice(memory, "advice").asIntBuffer();
    details = block.slice(memory, "details").asFloatBuffer();
    states = block.slice(memory, "states").asFloatBuffer();
    choices = settings.actions().choices(network);
    maskedRevision = new int[count];
    masksChangeOften = settings.actions() == ActionKind.STEPS || takesTime();
    observationsByWorker = new float[workers.count()][network.cameras() * settings.layout().size()];
    pairsByWorker = new SeenPairs[workers.count()];
    Arrays.setAll(pairsByWorker, worker -> new SeenPairs());
    stateByWorker = new float[workers.count()][OneWorld.stateSize(network, settings.layout())];
    reset(seed, true);
  }

  private boolean takesTime() {
    return settings
        .scenario()
        .everyCamera()
        .anyMatch(camera -> camera.optics().filter(optics -> optics.takesTime()).isPresent());
  }

  /** The memory that contains all sections. */
  public ByteBuffer memory() {
    return memory;
  }

  /** The layout of the memory. */
  public Block block() {
    return block;
  }

  /** The number of choices for each number of an action. */
  public List<Integer> choices() {
    return Arrays.stream(choices).boxed().toList();
  }

  /** The current network of a world. */
  public OracleView network(int world) {
    return worlds[world].network();
  }

  /** Sets the listener of a world, from its next episode on. */
  public void listen(int world, StepListener listener) {
    worlds[world].listen(listener);
  }

  /** The seed of the current episode of a world. */
  public long seed(int world) {
    return worlds[world].seed();
  }

  /**
   * Begins an episode in every world, and writes observations and masks.
   *
   * @param newSeed the seed of the first world
   * @param fresh whether to use the seed; otherwise each world begins its next episode
   */
  public void reset(long newSeed, boolean fresh) {
    seed = newSeed;
    restarted = fresh;
    workers.run(resetting);
  }

  /** Begins an episode in one world, with a seed or its next one; other worlds are unchanged. */
  public void reset(int world, long worldSeed, boolean fresh) {
    seed = worldSeed - world;
    restarted = fresh;
    reset(world, 0);
  }

  private void reset(int i, int worker) {
    if (restarted) {
      worlds[i].reset(seed + i);
    } else {
      worlds[i].beginNext();
    }
    writeDetails(i, worlds[i].details());
    observe(i, observations, worker);
    writeMasks(i);
  }

  /**
   * Carries out the actions in every world, and writes the results.
   *
   * @throws InputException if an action is invalid; no world is stepped then
   * @throws EpisodeOverException if an episode is over that only a reset ends
   */
  public void step() {
    checkActions();
    workers.run(stepping);
  }

  private void step(int i, int worker) {
    OneWorld world = worlds[i];
    if (world.isOver()) { // possible with AutoReset.NEXT_STEP alone
      beginNextEpisode(i, worker);
      return;
    }
    actions.get(i * world.actions().length, world.actions());
    world.step();
    rewards.put(i * world.rewards().length, world.rewards());
    measures.put(i * OneWorld.MEASURES, world.measures());
    advice.put(i * world.advice().length, world.advice());
    writeDetails(i, world.details());
    ends.put(i, (byte) (world.isOver() ? 1 : 0));
    if (world.isOver() && settings.autoReset() == AutoReset.SAME_STEP) {
      observe(i, finals, worker);
      writeMasks(i, finalMasks);
      world.beginNext();
    }
    observe(i, observations, worker);
    if (masksChangeOften || world.network().revision() != maskedRevision[i]) {
      writeMasks(i);
    }
  }

  private void beginNextEpisode(int i, int worker) {
    float[] zeros = worlds[i].rewards();
    Arrays.fill(zeros, 0);
    rewards.put(i * zeros.length, zeros);
    ends.put(i, (byte) 0);
    worlds[i].beginNext();
    writeDetails(i, worlds[i].details());
    observe(i, observations, worker);
    writeMasks(i);
  }

  /**
   * Writes observations through an array that the worlds of a worker share, so that it stays in the
   * processor's cache.
   */
  private void observe(int i, FloatBuffer into, int worker) {
    float[] out = observationsByWorker[worker];
    worlds[i].observe(pairsByWorker[worker], out);
    into.put(i * out.length, out);
  }

  private void writeDetails(int i, CameraDetails measured) {
    if (measured != null) {
      details.put(i * measured.values().length, measured.values());
    }
  }

  private void writeMasks(int i) {
    writeMasks(i, masks);
    maskedRevision[i] = worlds[i].network().revision();
  }

  private void writeMasks(int i, ByteBuffer into) {
    byte[] worldMasks = worlds[i].masks();
    into.put(i * worldMasks.length, worldMasks);
  }

  private void checkActions() {
    int numbersPerWorld = worlds[0].actions().length;
    for (int i = 0; i < worlds.length; i++) {
      if (settings.autoReset() == AutoReset.DISABLED && worlds[i].isOver()) {
        throw new EpisodeOverException(settings.steps());
      }
      for (int offset = 0; offset < numbersPerWorld; offset += choices.length) {
        checkActions(i, i * numbersPerWorld, offset);
      }
    }
  }

  private void checkActions(int world, int first, int offset) {
    for (int number = 0; number < choices.length; number++) {
      int action = actions.get(first + offset + number);
      int least = settings.expert() == null ? 0 : PlayedPolicy.AS_ADVISED;
      if (action < least || action >= choices[number]) {
        rejectAction(world, offset + number, action);
      }
    }
  }

  private void rejectAction(int world, int offset, int action) {
    throw InputException.of(
        "action %s of camera %s in world %s, expected 0 to %s",
        action,
        worlds[world].network().cameraName(offset / choices.length),
        world,
        (choices[offset % choices.length] - 1));
  }

  /** Writes the state of every world. */
  public void writeStates() {
    workers.run(writingStates);
  }

  private void writeState(int i, int worker) {
    observations.get(i * observationsByWorker[worker].length, observationsByWorker[worker]);
    worlds[i].writeState(observationsByWorker[worker], stateByWorker[worker]);
    states.put(i * stateByWorker[worker].length, stateByWorker[worker]);
  }

  /** Measures what each camera contributes; to be called before episodes are reset. */
  public void measureDetails() {
    for (OneWorld world : worlds) {
      world.measureDetails();
    }
  }

  /**
   * Keeps the actions of episodes, so that worlds can be saved; to be called before the first step.
   * They take 2 bytes for each number of an action.
   */
  public void keepHistories() {
    for (OneWorld world : worlds) {
      world.keepHistory();
    }
  }

  /**
   * Returns the shared memory and the episode of every world, so that {@link #restore} can continue
   * from here.
   *
   * @throws InputException if histories are not kept
   */
  public byte[] save() {
    requireHistories();
    int bytes = Arrays.stream(worlds).mapToInt(OneWorld::savedBytes).reduce(0, Math::addExact);
    ByteBuffer saved = ByteBuffer.allocate(Math.addExact(bytes, memory.capacity()));
    memory.get(0, saved.array(), 0, memory.capacity());
    saved.position(memory.capacity());
    for (OneWorld world : worlds) {
      world.save(saved);
    }
    return saved.array();
  }

  /**
   * Continues from a saved state. Replays the episodes, so it takes as long as the steps of the
   * saved episodes did.
   *
   * @throws InputException if the state is damaged or of other worlds, or histories are not kept;
   *     in the first case the worlds have to be reset
   */
  public void restore(byte[] state) {
    requireHistories();
    try {
      ByteBuffer saved = ByteBuffer.wrap(state);
      saved.position(memory.capacity());
      for (int i = 0; i < worlds.length; i++) {
        replay(i, worlds[i].beginSaved(saved));
      }
    } catch (BufferUnderflowException | IllegalArgumentException | IndexOutOfBoundsException e) {
      throw new InputException("the state is damaged or of other worlds", e);
    }
    memory.put(0, state, 0, memory.capacity());
  }

  private void requireHistories() {
    if (!worlds[0].keepsHistory()) {
      throw InputException.of("expected %s to save a state", setting("saves"));
    }
  }

  private void replay(int i, short[] history) {
    OneWorld world = worlds[i];
    int[] stepActions = world.actions();
    observe(i, observations, 0);
    for (int from = 0; from < history.length; from += stepActions.length) {
      for (int number = 0; number < stepActions.length; number++) {
        stepActions[number] = history[from + number];
      }
      world.step();
      observe(i, observations, 0);
    }
    writeMasks(i);
  }

  /** Stops the threads. */
  @Override
  public void close() {
    workers.close();
  }
}

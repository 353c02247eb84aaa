package org.hificamsim.python;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.worlds.EpisodeOverException;
import org.hificamsim.worlds.WorldSettings;
import org.hificamsim.worlds.Worlds;

/** A session of Python with its worlds. Not thread-safe. */
public final class Session implements AutoCloseable {
  private static final int MAX_WIDTH = 10_000;

  private final WorldSettings settings;
  private final Worlds worlds;
  private final List<EpisodePainter> painters = new ArrayList<>();

  /**
   * Opens worlds whose memory is allocated by the JVM.
   *
   * @param request a {@link Request} as JSON
   * @throws InputException if the request is invalid
   */
  public static Session open(String request) {
    return open(request, ByteBuffer::allocateDirect);
  }

  static Session open(String request, IntFunction<ByteBuffer> memory) {
    return new Session(Request.parse(request), memory);
  }

  private Session(Request request, IntFunction<ByteBuffer> memory) {
    Catalogue catalogue = Catalogue.load();
    long seed = request.settings().seed();
    settings = request.worldSettings(catalogue);
    worlds =
        new Worlds(
            settings,
            request.environment().worlds(),
            request.environment().threads(),
            seed,
            memory);
    if (request.environment().saves()) {
      worlds.keepHistories();
    }
    if (request.environment().details()) {
      worlds.measureDetails();
    }
    for (int i = 0; request.environment().paints() && i < request.environment().worlds(); i++) {
      int world = i;
      painters.add(new EpisodePainter(() -> setup(worlds.seed(world)), settings.detection()));
      worlds.listen(i, painters.get(i));
    }
    if (!painters.isEmpty() || request.environment().details()) {
      worlds.reset(seed, true);
    }
  }

  private Setup setup(long seed) {
    return Setup.of(settings.world(seed), settings.detection(), "played", seed, List.of());
  }

  /** The {@link Description} of the worlds, as JSON. */
  public String description() {
    return Description.of(worlds, settings).json();
  }

  /** The shared memory. */
  public ByteBuffer memory() {
    return worlds.memory();
  }

  /**
   * Steps all worlds.
   *
   * @throws InputException if an action is invalid
   * @throws EpisodeOverException if an episode is over that only a reset ends
   */
  public void step() {
    worlds.step();
  }

  /**
   * Begins an episode in a world, or in all worlds if it is below 0: that of a seed, or the next.
   */
  public void reset(int world, long seed, boolean fresh) {
    if (world < 0) {
      worlds.reset(seed, fresh);
    } else {
      worlds.reset(world, seed, fresh);
    }
  }

  /** Writes the states of all worlds. */
  public void state() {
    worlds.writeStates();
  }

  /** Saves all worlds. */
  public byte[] save() {
    return worlds.save();
  }

  /** Continues from what {@link #save} returned. */
  public void restore(byte[] state) {
    worlds.restore(state);
  }

  /** The seed of the current episode of the first world. */
  public long seed() {
    return worlds.seed(0);
  }

  /**
   * Paints a picture of a world.
   *
   * @throws InputException if the session was opened without pictures
   */
  public byte[] picture(int world, int width) {
    if (painters.isEmpty()) {
      throw new InputException("no pictures were asked for, expected render_mode='rgb_array'");
    }
    if (width < 1 || width > MAX_WIDTH) {
      throw new InputException("a picture " + width + " wide, expected 1 to " + MAX_WIDTH);
    }
    return painters.get(world).picture(worlds.network(world), worlds.seed(world), width);
  }

  /** Returns the message of a fault, with settings written as keyword arguments of Python. */
  public static String message(Throwable fault) {
    return fault instanceof InputException input
        ? input.message(Keywords.NOTATION)
        : fault.getMessage();
  }

  /** Stops the threads. */
  @Override
  public void close() {
    worlds.close();
  }
}

package org.hificamsim.python;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.worlds.WorldSettings;
import org.hificamsim.worlds.Worlds;

/** Worlds that Python has opened; one thread may call at a time. */
public final class Session implements AutoCloseable {
  private static final int MAX_WIDTH = 10_000;

  private final WorldSettings settings;
  private final Worlds worlds;
  private final List<Painted> painted = new ArrayList<>();

  /**
   * Opens worlds in memory of the JVM's.
   *
   * @param request JSON, see {@link Request}
   * @throws InputException when something is wrong with it
   */
  public static Session open(String request) {
    return open(request, ByteBuffer::allocateDirect);
  }

  static Session open(String request, IntFunction<ByteBuffer> memory) {
    return new Session(Request.parse(request), memory);
  }

  private Session(Request request, IntFunction<ByteBuffer> memory) {
    Catalogue catalogue = Catalogue.load();
    long seed = request.asked().seed();
    settings = request.worldSettings(catalogue);
    worlds = new Worlds(settings, request.own().worlds(), request.own().threads(), seed, memory);
    for (int i = 0; request.own().paints() && i < request.own().worlds(); i++) {
      int world = i;
      painted.add(new Painted(() -> setup(worlds.seed(world)), settings.detection()));
      worlds.watch(i, painted.get(i));
    }
    if (!painted.isEmpty()) {
      worlds.reset(seed, true);
    }
  }

  private Setup setup(long seed) {
    return Setup.of(settings.world(seed), settings.detection(), "played", seed, List.of());
  }

  /** What there is to know of the worlds, as JSON, see {@link Description}. */
  public String description() {
    return Description.of(worlds, settings).json();
  }

  /** The memory that is shared. */
  public ByteBuffer memory() {
    return worlds.memory();
  }

  /**
   * Steps all worlds.
   *
   * @throws InputException when an action is none, or an episode is over
   */
  public void step() {
    worlds.step();
  }

  /** Begins an episode in a world, of this seed or its next one; below 0 in all worlds. */
  public void reset(int world, long seed, boolean fresh) {
    if (world < 0) {
      worlds.reset(seed, fresh);
    } else {
      worlds.reset(world, seed, fresh);
    }
  }

  /** Writes the states. */
  public void state() {
    worlds.state();
  }

  /** The seed of the episode that the first world is in. */
  public long seed() {
    return worlds.seed(0);
  }

  /**
   * A picture of a world.
   *
   * @throws InputException when pictures were not asked for at first
   */
  public byte[] picture(int world, int width) {
    if (painted.isEmpty()) {
      throw new InputException("no pictures were asked for, expected render_mode='rgb_array'");
    }
    if (width < 1 || width > MAX_WIDTH) {
      throw new InputException("a picture " + width + " wide, expected 1 to " + MAX_WIDTH);
    }
    return painted.get(world).picture(worlds.network(world), worlds.seed(world), width);
  }

  /** What went wrong, with settings written as Python's keyword arguments. */
  public static String message(Throwable fault) {
    return fault instanceof InputException input
        ? input.message(Keywords.NOTATION)
        : fault.getMessage();
  }

  /** Ends the threads. */
  @Override
  public void close() {
    worlds.close();
  }
}

package org.hificamsim.core.world;

import java.util.Random;

/**
 * The random streams of a world: one generator for each purpose, each seeded with the seed of the
 * run, as in CamSim. All streams therefore give the same sequence.
 */
public final class RandomStreams {
  private final Random turn;
  private final Random move;

  /** Creates the streams of one run; equal seeds give equal streams. */
  public RandomStreams(long seed) {
    this.turn = new Random(seed);
    this.move = new Random(seed);
  }

  /** Restarts the streams as new ones with this seed. */
  void restart(long seed) {
    turn.setSeed(seed);
    move.setSeed(seed);
  }

  /** The stream for turns at the border: one double each time a move leads out of the field. */
  public Random turn() {
    return turn;
  }

  /** The stream for movements, such as the gaussians of Brownian motion. */
  public Random move() {
    return move;
  }
}

package org.hificamsim.core.world;

import java.util.Random;

/**
 * The world's random streams: independent generators, each seeded with the run's seed, as in
 * CamSim. Streams used side by side therefore give equal sequences.
 */
public final class RandomStreams {
  private final Random turn;
  private final Random move;

  /** The streams of one run; equal seeds give equal streams. */
  public RandomStreams(long seed) {
    this.turn = new Random(seed);
    this.move = new Random(seed);
  }

  /** Begins again: the same as new streams with this seed. */
  void restart(long seed) {
    turn.setSeed(seed);
    move.setSeed(seed);
  }

  /** TURN: one double each time a moved target is outside the field. */
  public Random turn() {
    return turn;
  }

  /** MOVE: the gaussians of the Brownian movements. */
  public Random move() {
    return move;
  }
}

package org.hificamsim.worlds;

/** Thrown by a step in a world whose episode is over. */
public final class EpisodeOverException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  EpisodeOverException(int steps) {
    super("the episode of " + steps + " steps is over, expected a reset");
  }
}

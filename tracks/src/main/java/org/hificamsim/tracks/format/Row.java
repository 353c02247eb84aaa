package org.hificamsim.tracks.format;

/**
 * Which column of a row between blanks has what, from 0.
 *
 * @param columns how many there are at least
 */
record Row(int frame, int target, int x, int y, int columns) {
  /** {@code frame id x z y vx vz vy}: the third position is the second one on the ground. */
  static final Row OBSMAT = new Row(0, 1, 2, 4, 8);

  /** {@code frame id x y}. */
  static final Row ETH_UCY = new Row(0, 1, 2, 3, 4);

  /** {@code id frame x y [z]}. */
  static final Row PETRACK = new Row(1, 0, 2, 3, 4);
}

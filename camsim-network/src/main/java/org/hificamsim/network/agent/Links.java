package org.hificamsim.network.agent;

/**
 * One camera's part of the vision graph: a strength for each camera that it handed targets to
 * (behaviour 8.1).
 *
 * <p>Names are numbered: cameras by their number, names in the file's graph without a camera after
 * them.
 */
public interface Links {
  /** What stands for no link. */
  double NONE = -1;

  /** The strength of the link to a name where this target is concerned, or {@link #NONE}. */
  double strength(int name, int target);

  /** The greatest strength where this target is concerned; 0 without links. */
  double strongest(int target);

  /** Notes a handover of the target to a camera. */
  void strengthen(int camera, int target);

  /** Lets every link fade, once per step. */
  void decay();

  /** Lets links fade and grow from now on, if they were frozen. */
  default void thaw() {}

  /** The number of names linked to. */
  int count();

  /** The name linked to in place {@code index}. */
  int name(int index);
}

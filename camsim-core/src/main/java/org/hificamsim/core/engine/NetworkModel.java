package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.world.World;

/**
 * A network that a run may name ({@code camsim}): makes what the cameras of each run do together.
 *
 * <p>An implementation has a public constructor without arguments and is found as a service.
 */
public interface NetworkModel {
  /** The name that a run calls it by. */
  String name();

  /**
   * Takes what follows the name.
   *
   * @throws org.hificamsim.core.InputException when it is wrong
   */
  void configure(Options options);

  /**
   * The network of one run at its start.
   *
   * @param world before its first step
   * @param seed of the run
   * @throws org.hificamsim.core.InputException when a camera asks for what does not exist
   */
  Cooperation begin(World world, Detection detection, long seed);
}

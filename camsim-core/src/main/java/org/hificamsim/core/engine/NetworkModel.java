package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.world.World;

/**
 * A network that a run can choose by name, such as {@code camsim}; makes the cooperation of each
 * run.
 *
 * <p>An implementation has a public constructor without arguments and is found as a service.
 */
public interface NetworkModel {
  /** The name by which a run chooses it. */
  String name();

  /**
   * Reads the options that follow the name.
   *
   * @throws org.hificamsim.core.InputException if an option is invalid
   */
  void configure(Options options);

  /**
   * Makes the cooperation of one run.
   *
   * @param world the world before its first step
   * @param seed the seed of the run
   * @throws org.hificamsim.core.InputException if a camera names an unknown part
   */
  Cooperation begin(World world, Detection detection, long seed);
}

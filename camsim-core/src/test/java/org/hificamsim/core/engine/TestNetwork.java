package org.hificamsim.core.engine;

import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;

/** A network whose phases a test runs one by one. */
final class TestNetwork extends OracleNetwork {
  private final Sight sight;
  private final Observation observation;

  TestNetwork(World world, Visibility visibility) {
    this(world, visibility, Double.NaN);
  }

  /**
   * @param side the side of the grid's cells, in metres; NaN to choose one
   */
  TestNetwork(World world, Visibility visibility, double side) {
    this(world, new Sight(world, visibility, side));
  }

  private TestNetwork(World world, Sight sight) {
    this(world, sight, new Observation(world, sight, LateDetections.NONE));
  }

  private TestNetwork(World world, Sight sight, Observation observation) {
    super(world, sight, observation);
    this.sight = sight;
    this.observation = observation;
  }

  void beginStep(long step) {
    sight.beginStep(step);
  }

  void locate() {
    sight.locate();
  }

  void observe() {
    observation.look();
    observation.addPhantoms();
  }

  PointGrid grid() {
    return sight.grid();
  }
}

package org.hificamsim.network.statistics;

import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;

/**
 * The area that the fields of view of two cameras have in common, opening angles included: what
 * CamSim's {@code overlap} is taken for (quirk Q11).
 */
public final class ExactOverlap implements OverlapTable.Pair {
  private final Cameras cameras;
  private final OverlapTable table;

  public ExactOverlap(World world) {
    cameras = world.cameras();
    table = new OverlapTable(world, this);
  }

  /** The sum over all pairs of cameras that are online, square metres. */
  public double sum() {
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      if (cameras.online(camera)) {
        sum = table.addPairs(camera, sum);
      }
    }
    return sum;
  }

  @Override
  public double overlap(int first, int second) {
    return SectorOverlap.of(sector(first), sector(second));
  }

  private Sector sector(int camera) {
    return new Sector(
        cameras.x(camera),
        cameras.y(camera),
        cameras.heading(camera),
        cameras.zoom(camera, 0).viewingAngle(),
        cameras.zoom(camera, cameras.level(camera)).radius());
  }
}

package org.hificamsim.core.silhouette;

import java.util.Arrays;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * The share of each target's silhouette that solid obstacles and nearer targets hide from each
 * camera, computed when it is first asked for after a {@link #begin}. Zoom and pan do not matter.
 * Safe for use by several threads between two calls of {@link #begin}.
 *
 * <p>A target that contains the camera hides nothing, and of two targets the nearer one hides the
 * other, as with {@code occlusion="targets"}.
 */
public final class HiddenShares {
  private final Cameras cameras;
  private final Targets targets;
  private final Walls walls;
  private final Silhouette silhouette = new Silhouette();

  /** The walls around each camera; null until they are needed. */
  private final WallSectors[] sectors;

  /** The targets around each camera; null until they are needed. */
  private final Crowd[] crowds;

  /** Whether each camera's crowd is up to date. */
  private final boolean[] sorted;

  /** The hidden shares by camera and target; NaN if not computed yet. */
  private final double[][] shares;

  /** Creates the shares of a world. */
  public HiddenShares(World world) {
    cameras = world.cameras();
    targets = world.targets();
    walls = new Walls(world.scenario().obstacles());
    sectors = new WallSectors[cameras.count()];
    crowds = new Crowd[cameras.count()];
    sorted = new boolean[cameras.count()];
    shares = new double[cameras.count()][];
  }

  /** Forgets all shares, since targets or cameras may have moved. */
  public synchronized void begin() {
    Arrays.fill(sorted, false);
  }

  /** Returns the share of a present target that is hidden from a camera, in [0, 1]. */
  public synchronized double share(int camera, int target) {
    if (!sorted[camera]) {
      sort(camera);
    }
    double known = shares[camera][target];
    if (Double.isNaN(known)) {
      known = compute(camera, target);
      shares[camera][target] = known;
    }
    return known;
  }

  private void sort(int camera) {
    if (crowds[camera] == null) {
      crowds[camera] = new Crowd(targets);
      shares[camera] = new double[targets.count()];
    }
    double x = cameras.x(camera);
    double y = cameras.y(camera);
    crowds[camera].around(x, y);
    Arrays.fill(shares[camera], Double.NaN);
    boolean flat = Double.isNaN(cameras.z(camera));
    if (walls.count() > 0 && (sectors[camera] == null || !sectors[camera].isFor(x, y, flat))) {
      sectors[camera] = new WallSectors(walls, x, y, flat);
    }
    sorted[camera] = true;
  }

  private double compute(int camera, int target) {
    silhouette.standAt(cameras.x(camera), cameras.y(camera), cameras.z(camera));
    silhouette.lookAt(
        targets.x(target), targets.y(target), targets.width(target), targets.height(target));
    if (!(silhouette.distance() > targets.width(target) / 2)) {
      return 0;
    }
    if (walls.count() > 0) {
      sectors[camera].addTo(silhouette, crowds[camera].bearing(target));
    }
    crowds[camera].addTo(silhouette, target);
    return silhouette.share();
  }
}

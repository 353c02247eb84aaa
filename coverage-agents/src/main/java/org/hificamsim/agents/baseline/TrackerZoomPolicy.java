package org.hificamsim.agents.baseline;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.registry.Options;

/**
 * Each camera keeps the nearest target that it sees in the middle of its picture, as large as it
 * can. It turns to the pan angle nearest to the target's direction, and takes the narrowest zoom
 * level that has the target in its angle and reach with a margin. If there is none, it keeps the
 * view through which it sees the target.
 *
 * <p>A camera that sees no target zooms out, and then sweeps its pan angles. It knows only what it
 * sees, and how far its views reach.
 */
public final class TrackerZoomPolicy extends AbstractDistributedZoomPolicy {
  private static final double MAX_MARGIN = 0.9;
  private static final int NONE = -1;

  private final double margin;
  private final int dwell;
  private final PatrolZoomPolicy.Zoom search;
  private final SeenPairs pairs = new SeenPairs();

  /** The nearest target that each camera sees, or {@link #NONE}. */
  private int[] nearestTargets = {};

  /** The distance of each camera to its nearest target, in metres. */
  private double[] distances = {};

  private PatrolZoomPolicy.Sweep[] sweeps = {};

  /** Reads the options {@code margin}, {@code dwell} and {@code search}. */
  public TrackerZoomPolicy(Options options) {
    margin =
        options.number(
            "margin", 0.2, 0, MAX_MARGIN, "share of the angle and reach kept free beyond a target");
    dwell =
        options.integer(
            "dwell",
            1,
            1,
            PatrolZoomPolicy.MAX_DWELL,
            "steps that a camera which searches stays at each pan angle");
    search =
        options.choice(
            "search",
            PatrolZoomPolicy.Zoom.WIDEST,
            "the zoom level to search with: widest, middle, narrowest");
  }

  @Override
  public String name() {
    return "tracker";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    nearestTargets = new int[network.cameras()];
    distances = new double[network.cameras()];
    sweeps = new PatrolZoomPolicy.Sweep[network.cameras()];
    Arrays.setAll(sweeps, camera -> new PatrolZoomPolicy.Sweep(dwell));
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    Arrays.fill(nearestTargets, NONE);
    network.findSeen(pairs);
    for (int i = 0; i < pairs.count(); i++) {
      consider(pairs.camera(i), pairs.target(i), network);
    }
    super.decide(network, views);
  }

  /** Compares a target with the nearest one so far; of equally near targets the first is kept. */
  private void consider(int camera, int target, NetworkView network) {
    double distance = network.distance(camera, target);
    boolean tie = distance == distances[camera] && target < nearestTargets[camera];
    if (nearestTargets[camera] == NONE || distance < distances[camera] || tie) {
      nearestTargets[camera] = target;
      distances[camera] = distance;
    }
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    return nearestTargets[camera] != NONE
        ? follow(network, camera)
        : sweeps[camera].next(network, camera, search.number(network.zooms(camera)));
  }

  /** Lets a camera that sees while it moves follow a target that comes into its picture. */
  @Override
  protected int travel(NetworkView network, int camera) {
    return nearestTargets[camera] != NONE ? follow(network, camera) : network.view(camera);
  }

  private int follow(NetworkView network, int camera) {
    double axis = network.pan(camera, network.seeing(camera));
    double direction = axis + network.bearing(camera, nearestTargets[camera]);
    int pan = PanAngles.nearest(network, camera, direction);
    double off = PanAngles.difference(network, camera, pan, direction);
    for (int zoom = 0; zoom < network.zooms(camera); zoom++) {
      int view = network.viewAt(camera, pan, zoom);
      if (fitsWithMargin(network, camera, view, off)) {
        return view;
      }
    }
    return network.seeing(camera);
  }

  private boolean fitsWithMargin(NetworkView network, int camera, int view, double off) {
    ZoomLevel zoom = network.zoom(camera, view);
    double usedShare = 1 - margin;
    return distances[camera] <= usedShare * network.reach(camera, view)
        && (zoom.allRound() || off <= usedShare * zoom.viewingAngle() / 2);
  }
}

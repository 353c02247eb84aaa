package org.hificamsim.agents.observation;

import java.util.Arrays;
import org.hificamsim.agents.voting.NearestCameras;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * Observes a network as each of its cameras knows it before a decision: what it sees where all are
 * now, and what was detected in the step before. One instance for one run, asked once before each
 * decision; a policy and an environment that ask at the same points get the same numbers.
 */
public final class CameraObserver {
  private static final int MOVING = ObservationLayout.at("moving");
  private static final int WAY = ObservationLayout.at("way");
  private static final int DETECTED = ObservationLayout.at("detected");

  private final ObservationLayout layout;
  private final int size;
  private final ViewFeatures.Standpoints standpoints;
  private final NearestCameras nearest;
  private final float[] ofCameras; // the share of all that a number is
  private final float[] ofTargets;
  private final SeenPairs pairs = new SeenPairs();
  private final int[] ways; // decisions since the camera set out
  private ViewFeatures views;
  private int revision;

  /** Of the network as it is before the first decision. */
  public CameraObserver(NetworkView network, ObservationLayout layout) {
    this(network, layout, Bounds.shares(network.cameras()), Bounds.shares(network.targets()));
  }

  private CameraObserver(
      NetworkView network, ObservationLayout layout, float[] ofCameras, float[] ofTargets) {
    this.layout = layout;
    this.ofCameras = ofCameras;
    this.ofTargets = ofTargets;
    size = layout.size();
    standpoints = new ViewFeatures.Standpoints(network);
    nearest = new NearestCameras(network, layout.neighbours());
    ways = new int[network.cameras()];
    note(network);
  }

  /**
   * Of another network of the same scenario: what both know alike is kept once.
   *
   * @param other with the same layout
   */
  public CameraObserver(NetworkView network, ObservationLayout layout, CameraObserver other) {
    this(network, layout, other.ofCameras, other.ofTargets);
    views = views.or(other.views);
  }

  private void note(NetworkView network) {
    revision = network.revision();
    nearest.update(network);
    views = new ViewFeatures(network, layout, standpoints, nearest);
  }

  /** Observes for every camera. */
  public void observe(NetworkView network, float[] out) {
    observe(network, pairs, out);
  }

  /**
   * Observes for every camera.
   *
   * @param pairs is used meanwhile
   * @param out receives the observations, one camera after the other
   */
  public void observe(NetworkView network, SeenPairs pairs, float[] out) {
    if (network.revision() != revision) {
      note(network);
    }
    boolean allOnline = true;
    for (int camera = 0; camera < ways.length; camera++) {
      ways[camera] = network.moving(camera) ? ways[camera] + 1 : 0;
      write(network, camera, out);
      allOnline &= network.online(camera);
    }
    views.copyToNeighbours(out, DETECTED);
    if (layout.targets() > 0) {
      writeSeen(network, pairs, out);
    }
    if (!allOnline) {
      clearOffline(network, out);
    }
  }

  private void write(NetworkView network, int camera, float[] out) {
    int at = camera * size;
    views.write(camera, network.view(camera), network.seeing(camera), out, at);
    int way = ways[camera];
    out[at + MOVING] = way > 0 ? 1 : 0;
    out[at + WAY] = way / (way + 1f);
    out[at + DETECTED] = share(network.detected(camera), ofTargets); // 0 while it is off
  }

  /** Writes the nearest targets that each camera sees, as many as there is room for. */
  private void writeSeen(NetworkView network, SeenPairs pairs, float[] out) {
    network.findSeen(pairs);
    pairs.sort(layout.targets());
    int camera = -1;
    int shown = 0;
    for (int pair = 0; pair < pairs.count(); pair++) {
      shown = pairs.camera(pair) == camera ? shown + 1 : 0;
      camera = pairs.camera(pair);
      if (shown < layout.targets()) {
        int at = layout.firstTarget() + shown * ObservationLayout.TARGET.size();
        writeSeen(network, pairs, pair, out, camera * size + at);
      }
    }
  }

  private void writeSeen(NetworkView network, SeenPairs pairs, int pair, float[] out, int at) {
    int camera = pairs.camera(pair);
    int target = pairs.target(pair);
    double distance = pairs.distance(pair);
    int view = network.seeing(camera);
    double perReach = views.perReach(camera, view);
    out[at] = 1;
    out[at + 1] = Bounds.signed(pairs.ahead(pair) * perReach);
    out[at + 2] = Bounds.signed(pairs.right(pair) * perReach);
    out[at + 3] =
        Bounds.share(network.targetSize(target) / distance * views.perAngle(camera, view));
    out[at + 4] = Bounds.share(network.seenConfidence(camera, target, distance));
    out[at + 5] = share(network.coverage(target), ofCameras);
  }

  /** 1 for what is more than the whole, as detections with phantoms may be. */
  private static float share(int part, float[] shares) {
    return shares[Math.min(part, shares.length - 1)];
  }

  private void clearOffline(NetworkView network, float[] out) {
    for (int camera = 0; camera < ways.length; camera++) {
      if (!network.online(camera)) {
        Arrays.fill(out, camera * size, (camera + 1) * size, 0);
      }
    }
  }
}

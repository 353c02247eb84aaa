package org.hificamsim.agents.observation;

import java.util.Arrays;
import org.hificamsim.agents.cooperative.SharedBelief;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * Observes a network as each of its cameras knows it before a decision: what the camera sees now,
 * and what was detected in the step before. Each run needs an instance of its own, which is to be
 * called once before each decision. A policy and an environment that do so get the same numbers.
 */
public final class CameraObserver {
  private static final int MOVING = ObservationLayout.at("moving");
  private static final int WAY = ObservationLayout.at("way");
  private static final int DETECTED = ObservationLayout.at("detected");

  private final ObservationLayout layout;
  private final int size;
  private final ViewRows rows;

  /** The number of cameras as a share of all, by number. */
  private final float[] cameraShares;

  /** The number of targets as a share of all, by number. */
  private final float[] targetShares;

  private final SeenPairs pairs = new SeenPairs();

  /** The number of decisions since each camera began to move. */
  private final int[] movingDecisions;

  /** The computation of the numbers of beliefs; null in a layout without belief. */
  private final BeliefFeatures belief;

  private ViewFeatures views;
  private int revision;

  /** Creates the observer of a network, before its first decision. */
  public CameraObserver(NetworkView network, ObservationLayout layout) {
    this(network, layout, Bounds.shares(network.cameras()), Bounds.shares(network.targets()));
    views = new ViewFeatures(network, rows);
  }

  private CameraObserver(
      NetworkView network, ObservationLayout layout, float[] cameraShares, float[] targetShares) {
    this.layout = layout;
    this.cameraShares = cameraShares;
    this.targetShares = targetShares;
    size = layout.size();
    rows = new ViewRows(network, layout);
    movingDecisions = new int[network.cameras()];
    belief = layout.views() == 0 ? null : new BeliefFeatures(network, layout.views());
    revision = network.revision();
  }

  /**
   * Creates the observer of another network of the same scenario, which shares equal numbers.
   *
   * @param other an observer with the same layout
   */
  public CameraObserver(NetworkView network, ObservationLayout layout, CameraObserver other) {
    this(network, layout, other.cameraShares, other.targetShares);
    views = other.views.areOf(network, rows) ? other.views : new ViewFeatures(network, rows);
  }

  private void update(NetworkView network) {
    revision = network.revision();
    rows.update(network);
    views = new ViewFeatures(network, rows);
  }

  /** Writes the observations of all cameras. */
  public void observe(NetworkView network, float[] out) {
    observe(network, pairs, out);
  }

  /**
   * Writes the observations of all cameras.
   *
   * @param pairs working memory
   * @param out receives the observations, one camera after the other
   */
  public void observe(NetworkView network, SeenPairs pairs, float[] out) {
    if (network.revision() != revision) {
      update(network);
    }
    boolean allOnline = true;
    for (int camera = 0; camera < movingDecisions.length; camera++) {
      movingDecisions[camera] = network.moving(camera) ? movingDecisions[camera] + 1 : 0;
      write(network, camera, out);
      allOnline &= network.online(camera);
    }
    views.copyToNeighbours(out, DETECTED);
    if (layout.targets() > 0) {
      writeSeen(network, pairs, out);
    }
    if (belief != null) {
      belief.write(network, out, layout.firstView(), size);
    }
    if (!allOnline) {
      clearOffline(network, out);
    }
  }

  /**
   * Lets the cameras tell each other which views they chose, if they share a belief; to be called
   * after each decision.
   *
   * @param chosen the view of each camera
   */
  public void learnChoices(NetworkView network, int[] chosen) {
    if (belief != null) {
      belief.belief().learnChoices(network, chosen);
    }
  }

  /** The belief that the cameras share; null in a layout without it. */
  public SharedBelief belief() {
    return belief == null ? null : belief.belief();
  }

  private void write(NetworkView network, int camera, float[] out) {
    int at = camera * size;
    int decisions = movingDecisions[camera];
    views.write(camera, network.view(camera), network.seeing(camera), out, at);
    out[at + MOVING] = decisions > 0 ? 1 : 0;
    out[at + WAY] = decisions / (decisions + 1f);
    out[at + DETECTED] = share(network.detected(camera), targetShares);
  }

  /** Writes the nearest targets that each camera sees, as many as the layout has. */
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
    out[at + 5] = share(network.coverage(target), cameraShares);
  }

  /** Returns the share of a count; 1 if it exceeds the total, as detections with phantoms may. */
  private static float share(int count, float[] shares) {
    return shares[Math.min(count, shares.length - 1)];
  }

  private void clearOffline(NetworkView network, float[] out) {
    for (int camera = 0; camera < movingDecisions.length; camera++) {
      if (!network.online(camera)) {
        Arrays.fill(out, camera * size, (camera + 1) * size, 0);
      }
    }
  }
}

package org.hificamsim.bridge.run;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.hificamsim.bridge.camsim.Use;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.runs.output.Detail;

/**
 * The settings of the bridge. It has nothing to do if detection, policy, tracks and out are empty.
 *
 * @param detection decides what cameras see; empty for CamSim's own rule
 * @param size the edge of the bounding box of every target, in metres, above 0
 * @param policy chooses the views of the cameras; empty if CamSim does
 * @param zooms the radii of all cameras, in metres, rising; empty for radii from the range of each
 *     camera
 * @param optics the optics of all cameras, each with its own range as its reach
 * @param objective the objective that scores a step
 * @param seed the seed of the first run; run i uses seed + i
 * @param tracks the tracks that objects follow, by their features, in the order of time
 * @param following whether it is measured how cameras follow targets
 * @param out the folder of the result files
 */
public record BridgeSettings(
    Optional<Detection> detection,
    double size,
    Optional<Policy> policy,
    List<Double> zooms,
    Optional<OpticsSpec> optics,
    Objective objective,
    int seed,
    Optional<Map<String, List<Track>>> tracks,
    Following following,
    Optional<Path> out) {
  /**
   * A policy with its options, created for each run.
   *
   * @param spec the text that selects the policy, as in the result files
   * @param maker creates the policy of a run
   */
  public record Policy(String spec, Supplier<ZoomPolicy> maker) {}

  public BridgeSettings {
    zooms = List.copyOf(zooms);
  }

  /** Returns whether any of CamSim's classes has to be changed. */
  public boolean needsWeaving() {
    return uses().size() > 1;
  }

  /** The uses of CamSim that these settings need. */
  public Set<Use> uses() {
    Set<Use> uses = EnumSet.of(Use.READ);
    detection.ifPresent(given -> uses.add(Use.DETECT));
    policy.ifPresent(given -> uses.add(Use.STEER));
    out.ifPresent(given -> uses.addAll(List.of(Use.RECORD, Use.NAME)));
    tracks.ifPresent(given -> uses.addAll(List.of(Use.TRACK, Use.NAME)));
    return uses;
  }

  /** The given detection, or CamSim's own. */
  Detection detectionOrCamSim() {
    return detection.orElseGet(() -> Detection.of(new CamSimVisibilityDetection()));
  }

  /** The views that cameras may have. */
  CameraViews cameraViews() {
    return new CameraViews(policy.isPresent(), zooms, optics);
  }

  /** The detail of the result files. */
  Detail detail() {
    return optics.isPresent() ? Detail.VIEWS : Detail.ZOOMS;
  }

  /** Returns these settings with another folder for result files, or none. */
  BridgeSettings with(Optional<Path> newOut) {
    return new BridgeSettings(
        detection, size, policy, zooms, optics, objective, seed, tracks, following, newOut);
  }
}

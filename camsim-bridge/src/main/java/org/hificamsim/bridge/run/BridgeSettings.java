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
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.runs.output.Detail;

/**
 * What the bridge is asked to do; without any of detection, policy, tracks and out it has nothing
 * to do.
 *
 * @param detection decides what cameras see; CamSim's own rule where it is missing
 * @param size edge of every target's bounding box, metres, above 0
 * @param policy chooses the cameras' views; CamSim does where it is missing
 * @param zooms radii common to all cameras, metres, rising; empty for those of each camera's range
 * @param optics of all cameras that the policy steers, each with its own range for a reach
 * @param objective what a step is scored by
 * @param seed of the first run's policy; run i uses seed + i
 * @param tracks that objects follow, by their features, in the order of time
 * @param out folder of the result files
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
    Optional<Path> out) {
  /**
   * A policy by its name and options, made for each run.
   *
   * @param spec as result files name it
   */
  public record Policy(String spec, Supplier<ZoomPolicy> maker) {}

  public BridgeSettings {
    zooms = List.copyOf(zooms);
  }

  /** Whether CamSim has to be changed at all. */
  public boolean asksForAnything() {
    return uses().size() > 1;
  }

  /** What it takes of CamSim. */
  public Set<Use> uses() {
    Set<Use> uses = EnumSet.of(Use.READ);
    detection.ifPresent(given -> uses.add(Use.DETECT));
    policy.ifPresent(given -> uses.add(Use.STEER));
    out.ifPresent(given -> uses.addAll(List.of(Use.RECORD, Use.NAME)));
    tracks.ifPresent(given -> uses.addAll(List.of(Use.TRACK, Use.NAME)));
    return uses;
  }

  /** What cameras see by: the given detection, else CamSim's own. */
  Detection seen() {
    return detection.orElseGet(() -> Detection.of(new CamSimVisibilityDetection()));
  }

  /** The views among which a camera's is chosen. */
  CameraViews views() {
    return new CameraViews(policy.isPresent(), zooms, optics);
  }

  /** What result files tell of each step. */
  Detail detail() {
    return optics.isPresent() ? Detail.VIEWS : Detail.ZOOMS;
  }

  /** The same with result files elsewhere, or nowhere. */
  BridgeSettings with(Optional<Path> newOut) {
    return new BridgeSettings(
        detection, size, policy, zooms, optics, objective, seed, tracks, newOut);
  }
}

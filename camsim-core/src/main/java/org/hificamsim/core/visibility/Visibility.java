package org.hificamsim.core.visibility;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * Decides whether a camera sees a target. The engine, CamSim's network and the agent inside CamSim
 * share this pipeline, whose steps are in {@link LevelSight}.
 *
 * <ol>
 *   <li>Reach: the target is not farther away than the zoom level's radius.
 *   <li>Angle: the target is {@linkplain LevelSight#isInAngle within the opening angle}; if cameras
 *       have heights, its {@linkplain Body body} is in the {@linkplain Footprint picture} of the
 *       lens.
 *   <li>Line of sight: obstacles between the two let some of the light through.
 *   <li>Confidence: the detection model's {@linkplain LevelSight#value value}.
 *   <li>Rule: the value times the transmittance reaches the threshold; or the {@linkplain #luck
 *       luck} of camera and target is below the chance of the value times the transmittance.
 *   <li>Clamping: the {@linkplain LevelSight#confidence confidence} is what the model {@linkplain
 *       DetectionModel#reported reports} for the value.
 * </ol>
 */
public final class Visibility {
  private final Detection detection;
  private final boolean asInCamSim;
  private final boolean certain;
  private final Luck luck;
  private final Map<LevelKey, LevelSight> levels = new ConcurrentHashMap<>();

  private record LevelKey(ZoomLevel zoom, Body body) {}

  private Visibility(Detection detection, boolean asInCamSim, long seed) {
    this.detection = detection;
    this.asInCamSim = asInCamSim;
    this.certain = detection.certain();
    this.luck = new Luck(seed, detection.rule().memory());
  }

  /** Creates the pipeline with seed 0, for detections without chance. */
  public static Visibility of(Detection detection) {
    return of(detection, 0);
  }

  /**
   * Creates the pipeline. The border of a sector belongs to it, and so does the position of the
   * camera.
   *
   * @param seed the seed of the luck in the run
   */
  public static Visibility of(Detection detection, long seed) {
    return new Visibility(detection, false, seed);
  }

  /**
   * Creates the pipeline by CamSim's rules (behaviour 6.1 and 6.2): neither the border of a sector
   * nor the position of the camera belongs to it, and a target of confidence 0 is not seen.
   *
   * @param seed the seed of the luck in the run
   */
  public static Visibility asInCamSim(Detection detection, long seed) {
    return new Visibility(
        detection.certain() ? detection.withThresholdFrom(Double.MIN_VALUE) : detection,
        true,
        seed);
  }

  /** The detection model with the threshold that this pipeline uses. */
  public Detection detection() {
    return detection;
  }

  /**
   * Returns what {@link #at(ZoomLevel, Body)} does, for a flat world.
   *
   * @param size the size of the targets, in metres
   */
  public LevelSight at(ZoomLevel zoom, double size) {
    return at(zoom, Body.flat(size));
  }

  /** Returns how a zoom level sees targets with a body; computed once for each pair. */
  public LevelSight at(ZoomLevel zoom, Body body) {
    return levels.computeIfAbsent(
        new LevelKey(zoom, body), key -> new LevelSight(detection, asInCamSim, zoom, body));
  }

  /**
   * The luck of a camera with a target in one step, in [0, 1); the same at every call; 0 under a
   * threshold.
   */
  public double luck(long step, int camera, int target) {
    return certain ? 0 : luck.draw(step, camera, target);
  }

  /** The number of phantoms that a camera reports in a step. */
  public int phantoms(long step, int camera) {
    return detection.rule().phantoms() > 0 ? detection.phantoms(luck.draw(step, camera, -1)) : 0;
  }

  /**
   * Enlarges a computed distance by more than its rounding error, so that no coordinate of two
   * points at that distance differs by more.
   *
   * @param distance the distance, in metres
   */
  public static double roundedUp(double distance) {
    return distance * (1 + 1e-9) + 1e-150; // squares of less may be 0
  }
}
